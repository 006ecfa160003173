/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/// The C API of Hardball: C99 and later, C++, and every language that calls C. docs/c.md introduces it.
///
/// - A function that can fail returns an hb_status, and writes its results only if that is HB_OK.
///   hb_last_error then says what is wrong, where, and what to do instead. No exception leaves the library.
/// - Worlds and simulations are owned by the caller and freed by hb_world_free and hb_free. A simulation is
///   used by one thread at a time. Functions that take it as const may run at once.
/// - Structs that describe something begin with `struct_size` and are initialized by a macro of theirs, such
///   as HB_SPHERE_INIT. They may grow: a program that was compiled with an older header has a smaller
///   struct_size, and gets the defaults of what it does not know. Structs of results without a struct_size
///   never change.
/// - Arrays are described by hb_array: a pointer, a stride in bytes, a type. So they may be the fields of
///   structs of the caller's own.
/// - Units are the caller's: lengths [L], times [T], masses [M]; [1] marks plain numbers.
#ifndef HARDBALL_H
#define HARDBALL_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/// The version of the binary interface: it counts up when programs must be compiled again.
#define HB_ABI 1

#if defined(__GNUC__)
#define HB_API __attribute__((visibility("default")))
#else
#define HB_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* --- library -------------------------------------------------------------------------------------- */

/// How a call has ended.
typedef int32_t hb_status;
enum {
  HB_OK = 0,
  HB_BAD_INPUT = 1,         ///< An argument is refused; nothing has changed.
  HB_RUN_FAILED = 2,        ///< A run cannot continue; the state is that after the last contact.
  HB_BROKEN_INVARIANT = 3,  ///< A bug in Hardball, or a stop function that threw an exception.
  HB_NO_MEMORY = 4
};

/// What has failed; no string is ever NULL.
typedef struct hb_error {
  const char* message;  ///< All of it, in one line.
  const char* problem;  ///< What is wrong.
  const char* where;    ///< Where: file:line:column, or an argument; empty if there is no such place.
  const char* remedy;   ///< What would be accepted; empty if nothing can be done.
} hb_error;

/// The HB_ABI of the library, which a program compares with that of its header.
HB_API uint32_t hb_abi(void);
/// The version of the library, such as "0.2.0".
HB_API const char* hb_version(void);
/// The last failure in this thread, valid until the next one in this thread; its strings are empty before the
/// first.
HB_API const hb_error* hb_last_error(void);

/* --- numbers and names ---------------------------------------------------------------------------- */

/// Identifies a sphere for its whole life; ids count up from zero, and are never reused.
typedef uint32_t hb_id;
/// The id of no sphere.
#define HB_NO_ID UINT32_MAX
/// A coefficient or a temperature that is not given.
#define HB_ABSENT (-1.0)

/// The type of the numbers in an array.
typedef int32_t hb_type;
enum { HB_F64 = 0, HB_F32 = 1, HB_U32 = 2, HB_U64 = 3 };

/// Rows of one or three numbers that the library writes. Error: data is NULL although there are rows; rows
/// overlap.
typedef struct hb_array {
  void* data;        ///< The first row; it need not be aligned.
  ptrdiff_t stride;  ///< From each row to the next, in bytes.
  hb_type type;
} hb_array;

/// Rows of one or three numbers that the library reads; a stride of zero gives all rows the value of the
/// first.
typedef struct hb_const_array {
  const void* data;  ///< The first row; NULL for the defaults.
  ptrdiff_t stride;  ///< From each row to the next, in bytes.
  hb_type type;
} hb_const_array;
/// An array that is not given.
#define HB_NO_ARRAY \
  { NULL, 0, HB_F64 }

/// What a sphere touches or meets.
typedef int32_t hb_kind;
enum {
  HB_KIND_NONE = 0,  ///< Nothing.
  HB_KIND_COLLISION = 1,
  HB_KIND_WALL = 2  ///< A face of the box or a surface.
};

/* --- worlds: a setting with spheres, before they move --------------------------------------------- */

/// What lies at the two ends of the box along one axis.
typedef int32_t hb_boundary;
enum {
  HB_BOUNDARY_WALL = 0,      ///< Hard faces at 0 and at the size.
  HB_BOUNDARY_PERIODIC = 1,  ///< Spheres that leave at one end enter at the other.
  HB_BOUNDARY_OPEN = 2,      ///< Space is unbounded.
  HB_BOUNDARY_FLAT = 3       ///< The axis z does not exist: spheres are discs.
};

/// The shape of a surface.
typedef int32_t hb_shape;
enum {
  HB_SHAPE_PLANE = 0,     ///< Spheres move on one side of it.
  HB_SHAPE_CYLINDER = 1,  ///< A tube in which spheres move.
  HB_SHAPE_SPHERE = 2,    ///< A hollow sphere in which spheres move.
  HB_SHAPE_OBSTACLE = 3,  ///< A sphere that spheres bounce off, and that nothing deflects.
  HB_SHAPE_CONE = 4,      ///< A funnel in which spheres move.
  HB_SHAPE_PILLAR = 5     ///< A pillar around which spheres move.
};

/// A wall or an obstacle.
typedef struct hb_surface {
  size_t struct_size;
  double point[3];     ///< A point of the plane or on the axis, the apex or the center, at time zero [L].
  double normal[3];    ///< Plane: a vector of any length, toward the spheres.
  double axis[3];      ///< Cylinder, pillar, cone, from its apex: a vector of any length along the axis.
  double radius;       ///< Cylinder, pillar, sphere, obstacle [L].
  double slope;        ///< Cone: its radius over the distance from its apex [1].
  double velocity[3];  ///< The velocity of the whole surface [L/T].
  double amplitude;    ///< Plane: how far it oscillates along its normal [L]; zero if it does not.
  double frequency;    ///< Plane: that of the oscillation [1/T].
  double restitution;  ///< [1]; HB_ABSENT for that of the setting.
  double temperature;  ///< k T of a thermal wall [M L^2 T^-2]; HB_ABSENT for a wall that reflects.
  uint64_t seed;       ///< Seed of a thermal wall's random numbers.
  hb_shape shape;
  /// How rough it is, from -1, smooth, to 1 [1]; HB_ABSENT for a smooth wall.
  double tangential_restitution;
} hb_surface;
#define HB_SURFACE_INIT                                                                                  \
  {                                                                                                      \
    sizeof(hb_surface), {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0, {0, 0, 0}, 0, 0, HB_ABSENT, HB_ABSENT, 0, \
        HB_SHAPE_PLANE, HB_ABSENT                                                                        \
  }

/// What surrounds the spheres: by default, open space.
typedef struct hb_setting {
  size_t struct_size;
  double size[3];              ///< The edges of the box [L]; ignored along open and flat axes.
  double gravity[3];           ///< The acceleration of all spheres [L/T^2].
  double restitution;          ///< The coefficient of all contacts [1]; one is elastic.
  double elastic_below;        ///< Slower impacts are elastic [L/T].
  const hb_surface* surfaces;  ///< Walls and obstacles besides the faces of the box, numbered from 6 on.
  size_t surface_count;
  hb_boundary boundary[3];
} hb_setting;
#define HB_SETTING_INIT                                        \
  {                                                            \
    sizeof(hb_setting), {0, 0, 0}, {0, 0, 0}, 1, 0, NULL, 0, { \
      HB_BOUNDARY_OPEN, HB_BOUNDARY_OPEN, HB_BOUNDARY_OPEN     \
    }                                                          \
  }

/// One sphere.
typedef struct hb_sphere {
  size_t struct_size;
  double position[3];     ///< Center [L]; in a periodic box, folded into it.
  double velocity[3];     ///< [L/T]
  double radius;          ///< [L]
  double mass;            ///< [M]; HUGE_VAL for a kinematic sphere, which no collision deflects.
  double spin[3];         ///< Angular velocity [1/T].
  double inertia_factor;  ///< Moment of inertia over mass and squared radius [1].
  uint32_t species;       ///< From 0 to 255.
} hb_sphere;
#define HB_SPHERE_INIT \
  { sizeof(hb_sphere), {0, 0, 0}, {0, 0, 0}, 1, 1, {0, 0, 0}, 0.4, 0 }

/// Many spheres: an array of each quantity, of which all but the positions may be HB_NO_ARRAY.
typedef struct hb_spheres {
  size_t struct_size;
  size_t count;
  hb_const_array positions;        ///< Three numbers in each row [L].
  hb_const_array velocities;       ///< Three numbers in each row [L/T].
  hb_const_array radii;            ///< [L]
  hb_const_array masses;           ///< [M]
  hb_const_array spins;            ///< Three numbers in each row [1/T].
  hb_const_array inertia_factors;  ///< [1]
  hb_const_array species;          ///< HB_U32.
} hb_spheres;
#define HB_SPHERES_INIT                                                                                  \
  {                                                                                                      \
    sizeof(hb_spheres), 0, HB_NO_ARRAY, HB_NO_ARRAY, HB_NO_ARRAY, HB_NO_ARRAY, HB_NO_ARRAY, HB_NO_ARRAY, \
        HB_NO_ARRAY                                                                                      \
  }

/// A setting and the spheres in it.
typedef struct hb_world hb_world;

/// Makes a world without spheres. Error: a number out of range; a surface that does not fit the box.
HB_API hb_status hb_world_new(const hb_setting* setting, hb_world** out);
/// Frees a world; NULL is ignored.
HB_API void hb_world_free(hb_world* world);
/// Adds a sphere; `id` may be NULL. Overlaps are found by hb_start. Error: a number out of range; a center
/// closer to a wall than the radius.
HB_API hb_status hb_world_add(hb_world* world, const hb_sphere* sphere, hb_id* id);
/// Adds spheres, whose ids are consecutive from `first_id` on, which may be NULL. Error, and none is added:
/// as for one.
HB_API hb_status hb_world_add_many(hb_world* world, const hb_spheres* spheres, hb_id* first_id);
/// How many spheres a world has; zero for NULL.
HB_API size_t hb_world_size(const hb_world* world);

/* --- simulations: spheres in motion --------------------------------------------------------------- */

/// How collisions are found. The choice changes the speed and never the motion.
typedef int32_t hb_engine;
enum {
  HB_ENGINE_AUTO = 0,       ///< The fastest for the world.
  HB_ENGINE_CELLS = 1,      ///< The cell grid.
  HB_ENGINE_NEIGHBORS = 2,  ///< A neighbor list for each sphere.
  HB_ENGINE_ALL_PAIRS = 3,  ///< Every sphere against every other: slow, and obviously correct.
  HB_ENGINE_PAPER = 4       ///< The algorithm of the 1997 paper to the letter.
};

/// How a simulation is computed.
typedef struct hb_options {
  size_t struct_size;
  double cell_edge;  ///< Edge of the cells [L]; zero if the library chooses and adapts it.
  uint32_t threads;  ///< How many work on one system; zero for as many as pay.
  hb_engine engine;
} hb_options;
#define HB_OPTIONS_INIT \
  { sizeof(hb_options), 0, 1, HB_ENGINE_AUTO }

/// Spheres in motion.
typedef struct hb_simulation hb_simulation;

/// Starts a copy of a world at time zero; `options` may be NULL. Error: spheres overlap or reach through a
/// wall; invalid options.
HB_API hb_status hb_start(const hb_world* world, const hb_options* options, hb_simulation** out);
/// Starts what a scenario describes, with its thermostat and growth; docs/scenarios.md describes the format.
/// `name` stands for the file in errors, and files that the text names are relative to it. Each override is a
/// string key=value, such as "run.seed=2". `options` and `until` may be NULL; `until` receives the end of the
/// run, HUGE_VAL if the scenario gives none [T]. Error, with its line and column as the place: the text is no
/// scenario; a value is refused.
HB_API hb_status hb_start_scenario(const char* text, const char* name, const char* const* overrides,
                                   size_t override_count, const hb_options* options, hb_simulation** out,
                                   double* until);
/// A copy with a future of its own; it keeps contacts if the original does. Cost: O(n).
HB_API hb_status hb_copy(const hb_simulation* simulation, hb_simulation** out);
/// The whole state as bytes, which are valid until the next hb_save or hb_free of this simulation. Cost:
/// O(n).
HB_API hb_status hb_save(hb_simulation* simulation, const void** bytes, size_t* byte_count);
/// A simulation that continues to the same history, in one thread, from the bytes of this version of the
/// library or of an earlier one, written in any language. Error: the bytes are damaged, or of a later
/// version.
HB_API hb_status hb_load(const void* bytes, size_t byte_count, hb_simulation** out);
/// Lets this many threads work on the simulation from now on, zero for as many as pay. Error: as for
/// hb_start.
HB_API hb_status hb_set_threads(hb_simulation* simulation, uint32_t threads);
/// Frees a simulation; NULL is ignored.
HB_API void hb_free(hb_simulation* simulation);

/* --- runs ----------------------------------------------------------------------------------------- */

/// Returns whether a run shall stop: asked when it begins and some hundred times a second, in the thread that
/// runs. It may query the simulation, but not change or run it.
typedef int hb_stop(void* context);

/// The limits of a run, which stops at whichever comes first.
typedef struct hb_limits {
  size_t struct_size;
  double until;       ///< [T]
  uint64_t contacts;  ///< Collisions and wall contacts of this run.
  uint64_t steps;     ///< Events of any kind: a bound on the work.
  hb_stop* stop;      ///< NULL if nothing stops the run.
  void* context;      ///< What `stop` is called with.
} hb_limits;
#define HB_LIMITS_INIT \
  { sizeof(hb_limits), HUGE_VAL, UINT64_MAX, UINT64_MAX, NULL, NULL }

/// Why a run stopped.
typedef int32_t hb_run_status;
enum {
  HB_RUN_TIME_REACHED = 0,
  HB_RUN_CONTACTS_REACHED = 1,
  HB_RUN_STEPS_REACHED = 2,
  HB_RUN_STOPPED = 3  ///< By the stop function.
};

/// Runs to `time` [T], events at that time included. How a run is split does not change the history. Error:
/// the time is in the past, not a number, or finite and beyond 1e120.
HB_API hb_status hb_run_until(hb_simulation* simulation, double time);
/// Runs until the first of the limits is reached; `out` may be NULL. Error: as for hb_run_until.
HB_API hb_status hb_run(hb_simulation* simulation, const hb_limits* limits, hb_run_status* out);

/// What has become of the bodies of a contact.
typedef int32_t hb_outcome;
enum {
  HB_OUTCOME_BOUNCE = 0,
  HB_OUTCOME_PASS = 1,  ///< Spheres pass through each other, on unchanged paths.
  HB_OUTCOME_MERGE = 2  ///< Two spheres have become one, the first.
};

/// A collision or a wall contact: bodies touch at one moment, so that none begins or ends.
typedef struct hb_contact {
  double time;  ///< [T]
  hb_kind kind;
  hb_outcome outcome;
  hb_id first;      ///< The sphere; of a collision, that with the lower id.
  uint32_t second;  ///< The id of the other sphere, or the number of the wall.
  uint32_t first_species;
  uint32_t second_species;  ///< Zero for a wall.
  double point[3];          ///< Where the surfaces touch [L].
  double normal[3];         ///< The unit vector from the first body toward the second [1].
  double first_before[3];   ///< Velocity of the first body before the contact [L/T].
  double second_before[3];  ///< Velocity of the second body before the contact [L/T].
  double first_after[3];    ///< Velocity of the first body after the contact [L/T].
  double second_after[3];   ///< Velocity of the second body after the contact [L/T].
  double impulse[3];        ///< The momentum that the first body gained [M L/T].
  double impact_speed;      ///< The speed at which the surfaces met, along the normal [L/T].
} hb_contact;

/// Whether runs keep their contacts from now on: at first they do not, which costs nothing.
HB_API hb_status hb_keep_contacts(hb_simulation* simulation, int keep);
/// The contacts of the last run, in order, valid until the next run. None for NULL, and where `*count` is
/// zero.
HB_API const hb_contact* hb_contacts(const hb_simulation* simulation, size_t* count);

/* --- state ---------------------------------------------------------------------------------------- */

/// The present time [T]; NaN for NULL.
HB_API double hb_time(const hb_simulation* simulation);
/// How many spheres there are; zero for NULL.
HB_API size_t hb_size(const hb_simulation* simulation);
/// The edges of the box [L], zero along open and flat axes, and what lies at its ends. Either may be NULL.
HB_API hb_status hb_get_box(const hb_simulation* simulation, double size[3], hb_boundary boundary[3]);
/// The hash of all contacts so far: equal histories have equal hashes, in every language. Zero for NULL.
HB_API uint64_t hb_hash(const hb_simulation* simulation);
/// How many collisions there have been; zero for NULL.
HB_API uint64_t hb_collisions(const hb_simulation* simulation);
/// How many wall contacts there have been; zero for NULL.
HB_API uint64_t hb_wall_contacts(const hb_simulation* simulation);
/// One if a sphere has this id, otherwise zero; zero for NULL.
HB_API int hb_contains(const hb_simulation* simulation, hb_id id);

/// What hb_read reads.
typedef int32_t hb_field;
enum {
  HB_FIELD_ID = 0,        ///< HB_U32.
  HB_FIELD_POSITION = 1,  ///< Three numbers: the center now, folded into a periodic box [L].
  HB_FIELD_VELOCITY = 2,  ///< Three numbers [L/T].
  HB_FIELD_RADIUS = 3,    ///< [L]
  HB_FIELD_MASS = 4,      ///< [M]
  HB_FIELD_SPIN = 5,      ///< Three numbers [1/T].
  HB_FIELD_SPECIES = 6,   ///< HB_U32.
  HB_FIELD_USER_DATA = 7  ///< HB_U64.
};

/// Reads one field of the spheres with these ids, or if `ids` is NULL, of all in the order of ids, exactly as
/// it is now. Numbers are HB_F64 or HB_F32 unless the field says otherwise. Error: no sphere has an id;
/// without ids, `count` is not hb_size; another type.
HB_API hb_status hb_read(const hb_simulation* simulation, hb_field field, const hb_id* ids, size_t count,
                         hb_array out);
/// Reads the centers that spheres would have at `time` if they met nothing from now on [L], as hb_read reads
/// those of now: what a display shows between two frames. They are exact up to the next contact of a sphere,
/// beyond which it appears to enter what it hits. Error: as for hb_read; `time` is before hb_time, not a
/// number, or beyond 1e120.
HB_API hb_status hb_extrapolate(const hb_simulation* simulation, double time, const hb_id* ids, size_t count,
                                hb_array out);
/// Reads one sphere as it is now, as much of it as out->struct_size says. Error: no sphere has this id.
HB_API hb_status hb_get_sphere(const hb_simulation* simulation, hb_id id, hb_sphere* out);

/// Sums over all spheres but kinematic ones.
typedef struct hb_totals {
  size_t struct_size;
  double energy;             ///< Kinetic, rotational and potential [M L^2 T^-2].
  double kinetic_energy;     ///< [M L^2 T^-2]
  double rotational_energy;  ///< [M L^2 T^-2]
  double momentum[3];        ///< [M L/T]
  double mass;               ///< [M]
} hb_totals;
#define HB_TOTALS_INIT \
  { sizeof(hb_totals), 0, 0, 0, {0, 0, 0}, 0 }

/// Sums over the spheres now, as much of them as out->struct_size says. Cost: O(n).
HB_API hb_status hb_get_totals(const hb_simulation* simulation, hb_totals* out);
/// Attaches a number to a sphere, zero at first, which hb_read reads, and whose bits are the groups of
/// hb_mask. Error: no sphere has this id.
HB_API hb_status hb_set_user_data(hb_simulation* simulation, hb_id id, uint64_t data);

/* --- edits between runs --------------------------------------------------------------------------- */

/// Changes the velocity of a sphere [L/T]. Error: no sphere has this id; a number that is not finite.
HB_API hb_status hb_change_velocity(hb_simulation* simulation, hb_id id, const double velocity[3]);
/// Changes many velocities, whatever the order of ids. Error, and none is changed: as for one; an id is given
/// twice.
HB_API hb_status hb_change_velocities(hb_simulation* simulation, size_t count, const hb_id* ids,
                                      hb_const_array velocities);
/// Adds a sphere; `id` may be NULL. Error: as for hb_world_add; it overlaps another sphere; spheres grow, or
/// are measured or recorded.
HB_API hb_status hb_add(hb_simulation* simulation, const hb_sphere* sphere, hb_id* id);
/// Removes a sphere. Error: no sphere has this id; spheres grow, or are measured or recorded.
HB_API hb_status hb_remove(hb_simulation* simulation, hb_id id);

/* --- queries, which change nothing, and answer HB_KIND_NONE if there is nothing ------------------- */

/// A contact in the future.
typedef struct hb_future_contact {
  double time;      ///< [T]; HUGE_VAL if there is none.
  hb_id first;      ///< The sphere; HB_NO_ID for one that is not in the simulation.
  uint32_t second;  ///< The id of the other sphere, or the number of the wall.
  hb_kind kind;
} hb_future_contact;

/// Which bodies a query looks for: by default, all.
typedef struct hb_mask {
  size_t struct_size;
  const uint32_t* species;  ///< Spheres of these species; of all species if `species_count` is zero.
  size_t species_count;
  uint64_t groups;  ///< Spheres whose user data has a bit in common with it; all spheres if all bits are set.
  int32_t walls;    ///< Whether walls are looked for: zero if they are not.
} hb_mask;
#define HB_MASK_INIT \
  { sizeof(hb_mask), NULL, 0, UINT64_MAX, 1 }

/// What a ray hits.
typedef struct hb_ray_hit {
  double distance;   ///< From the origin of the ray [L]; HUGE_VAL if it hits nothing.
  double point[3];   ///< Folded into a periodic box [L].
  double normal[3];  ///< The unit vector out of the body [1].
  uint32_t body;     ///< The id of the sphere, or the number of the wall.
  hb_kind kind;
} hb_ray_hit;

/// The nearest body.
typedef struct hb_clearance {
  double distance;  ///< Between the surfaces; negative where they overlap; HUGE_VAL if there is no body [L].
  uint32_t body;    ///< The id of the sphere, or the number of the wall.
  hb_kind kind;
} hb_clearance;

/// The next contact of all, up to `until` [T], without executing it. It runs the engine ahead, which changes
/// the work and not the history. Error: `until`, as for hb_run_until.
HB_API hb_status hb_next_contact(hb_simulation* simulation, double until, hb_future_contact* out);
/// The contacts of the next `duration` [T], in order, up to `most`, without executing them; they are valid
/// until the next call of this function or of hb_free. Error: a duration that is negative or not finite.
HB_API hb_status hb_contacts_within(hb_simulation* simulation, double duration, uint64_t most,
                                    const hb_contact** out, size_t* count);
/// What a sphere would hit first up to `until` [T] if it had this velocity [L/T], and no other changed its
/// motion. Error: no sphere has this id; a number out of range; the box is periodic and `until` infinite.
HB_API hb_status hb_first_contact(const hb_simulation* simulation, hb_id id, const double velocity[3],
                                  double until, hb_future_contact* out);
/// What a sphere would hit first up to `until` [T] if it were added. Error: as for hb_first_contact and
/// hb_world_add.
HB_API hb_status hb_first_contact_if_added(const hb_simulation* simulation, const hb_sphere* sphere,
                                           double until, hb_future_contact* out);
/// What each ray hits first now, up to `most` [L] from its origin, in out[0] to out[count - 1]. Directions
/// have any length; `mask` may be NULL. This many threads, at least one, share the rays, whose results do not
/// depend on it. Error: a number out of range; the box is periodic and `most` infinite; there are no threads.
HB_API hb_status hb_rays(const hb_simulation* simulation, size_t count, hb_const_array origins,
                         hb_const_array directions, double most, const hb_mask* mask, uint32_t threads,
                         hb_ray_hit* out);
/// All that a ray enters now, up to `most` [L] from its origin, in the order of distances: it passes through
/// spheres and obstacles, and ends at the first other wall. `*count` is how many there are, of which `out`
/// receives the first `capacity`. `mask` may be NULL. Error: as for hb_rays.
HB_API hb_status hb_ray_hits(const hb_simulation* simulation, const double origin[3],
                             const double direction[3], double most, const hb_mask* mask, hb_ray_hit* out,
                             size_t capacity, size_t* count);
/// The body nearest to each point now, in out[0] to out[count - 1]; `mask` may be NULL. Error: a number out
/// of range.
HB_API hb_status hb_clearances(const hb_simulation* simulation, size_t count, hb_const_array points,
                               const hb_mask* mask, hb_clearance* out);
/// The body nearest to a sphere now, from surface to surface; `mask` may be NULL. Error: no sphere has this
/// id.
HB_API hb_status hb_clearance_of(const hb_simulation* simulation, hb_id id, const hb_mask* mask,
                                 hb_clearance* out);
/// The spheres that overlap a ball around `center` with this radius [L] now, in the order of ids; those that
/// only touch it do not. `*count` is how many there are, of which `out` receives the first `capacity`.
/// `mask`, whose walls do not matter, may be NULL. Error: a number out of range; a negative radius.
HB_API hb_status hb_overlap_ball(const hb_simulation* simulation, const double center[3], double radius,
                                 const hb_mask* mask, hb_id* out, size_t capacity, size_t* count);
/// The spheres that overlap the box from the corner `low` to the corner `high` [L] now, as hb_overlap_ball
/// finds those in a ball. Error: a number out of range; `low` lies above `high`; it is larger than a periodic
/// box.
HB_API hb_status hb_overlap_box(const hb_simulation* simulation, const double low[3], const double high[3],
                                const hb_mask* mask, hb_id* out, size_t capacity, size_t* count);

/* --- measures and recordings, which change no history --------------------------------------------- */

/// Whether runs measure from now on, and anew: what the scenario names in [measures], and without a scenario
/// all but transport. At first they do not. Measures are neither copied nor saved with a simulation. As long
/// as runs measure, spheres can be neither added nor removed.
HB_API hb_status hb_keep_measures(hb_simulation* simulation, int keep);
/// What runs have measured, as a JSON array with an object for each measure; docs/c.md has its members.
/// The text ends in a zero, which `*byte_count` leaves out, and is valid until the next call of this function
/// or of hb_free; `byte_count` may be NULL. What is measured does not depend on when it is read. Cost: for
/// most measures O(n). Error: runs do not measure.
HB_API hb_status hb_get_measures(hb_simulation* simulation, const char** json, size_t* byte_count);
/// Records runs from now on in a file, which `hardball view` shows; an earlier recording ends. Recordings are
/// neither copied nor saved with a simulation. As long as runs are recorded, spheres can be neither added nor
/// removed. Error: the file cannot be written; a shape cannot be recorded.
HB_API hb_status hb_begin_recording(hb_simulation* simulation, const char* path);
/// Completes the file up to the last contact, so that readers see it; `byte_count`, how long it is then, may
/// be NULL. Each call adds the state of all spheres to the file. Error: nothing is recorded. HB_RUN_FAILED:
/// the file cannot be written.
HB_API hb_status hb_flush_recording(hb_simulation* simulation, uint64_t* byte_count);
/// Ends the recording at the present time, and does nothing if there is none; hb_free ends it at the last
/// contact. HB_RUN_FAILED: as for hb_flush_recording.
HB_API hb_status hb_end_recording(hb_simulation* simulation);

#ifdef __cplusplus
}
#endif

#endif
