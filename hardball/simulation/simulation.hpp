// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/domains/sphere_transfer.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/window_counters.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/execution/collapse_guard.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/growth/growth_schedule.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/measure/contact_sums.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/memory/value_pointer.hpp"
#include "hardball/motions/driven_motion.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/queries/queries.hpp"
#include "hardball/run/activity.hpp"
#include "hardball/run/actors.hpp"
#include "hardball/run/engine_options.hpp"
#include "hardball/run/observer.hpp"
#include "hardball/simulation/body_mask.hpp"
#include "hardball/simulation/sphere_handle.hpp"
#include "hardball/thermostats/thermostat.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/block.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/place_edit.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/velocity_change.hpp"
#include "hardball/world/velocity_edit.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

class EngineManager;
class Measures;
class UserData;

/// Spheres in motion: the interface to Hardball.
///
/// Every collision happens at its exact time and in order. The history does not depend on the options, on how
/// a run is split, or on queries in between. Copies are independent, and share only what their observers,
/// listeners and responses refer to.
///
/// Several processes may share a simulation, each with the spheres in a part of the box. Then all of them
/// call the same members in the same order, with the same arguments, and get the same results; observers and
/// listeners are called in all of them. A process holds all spheres, too, once the world has been requested,
/// as measures, thermostats, growth and edits do.
class HARDBALL_EXPORT Simulation {
 public:
  /// Starts at the latest time at which a sphere was added to the world, or zero. Spheres added earlier have
  /// moved freely until then and start a new path there; to continue a history, copy the simulation. Reports
  /// the progress of the set-up to `on_progress`. Error: spheres that overlap or reach through a wall at the
  /// start; invalid options (see EngineOptions).
  explicit Simulation(World world, const EngineOptions& options = {}, const OnProgress& on_progress = {});
  /// Starts a world that each of several processes has in full. `processes` must outlive the simulation;
  /// `threads` is per process. Error, in all processes: spheres that overlap or reach through a wall; invalid
  /// options; something that they cannot share: merging spheres, potentials of steps, a sheared box, a
  /// response that is a function; an engine other than cells and neighbors; a box that is too small for this
  /// many processes.
  Simulation(World world, const EngineOptions& options, Processes& processes,
             const OnProgress& on_progress = {});
  /// Starts a world of which each process brings some of the spheres, with their ids; all are brought once.
  /// No process holds them all until somebody asks for the world. Error: as for the constructor.
  static Simulation from_parts(World part, const EngineOptions& options, Processes& processes);
  Simulation(const Simulation&);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(const Simulation&);
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Sets a listener, called after every collision and wall contact: the contact has been executed, and
  /// time() is its time. If it throws, the run ends after that contact, and the simulation can be run
  /// further.
  ///
  /// The listener may query, copy and edit the simulation: change_velocity, change_velocities, add, remove,
  /// on_contact, respond_with. An edit takes effect before any other event, simultaneous ones included, so
  /// the history is the same for every engine. The listener must not move, assign to or destroy the
  /// simulation. Error, from the call in question: it runs the simulation, asks for future contacts or
  /// positions, or edits it during a run with measures.
  void on_contact(Function<void(const Contact&)> listener);

  /// Sets the observer of the run, which replaces an earlier one. It is called with each contact before a
  /// listener is, but perhaps when later contacts have happened already: with several threads that costs much
  /// less than a listener. If an observer throws, the run ends, perhaps after further contacts, which the
  /// observer does not see. Called with a contact, it must not query the simulation, except for world() when
  /// two spheres have merged; in its other functions it may. Error, from the call in question: it runs or
  /// edits the simulation.
  void observe(Observer observer);

  /// Replaces the response, which returns the velocities after a contact; see Response. Error, from running:
  /// the bodies still approach with the velocities returned; a velocity is not finite or exceeds 1e60; the
  /// response runs or edits the simulation. The contact has then not happened.
  void respond_with(Function<Velocities(const Contact&)> response);
  /// Replaces the response by one that changes spins, or merges spheres. It is also asked whether a sphere
  /// that has merged also merges with those that it overlaps, which may recede; if not, its result is
  /// ignored.
  void respond_with(Function<Outcome(const Contact&)> response);
  /// Replaces the response of the world permanently: unlike functions, a table is saved. Spheres that pass
  /// through each other continue to do so. Error: other species pass in the table.
  void respond_with(const ResponseTable& table);
  /// Restores the response of the world, instead of a function.
  void respond_with(std::nullptr_t);
  /// Whether the response is a function.
  bool has_custom_response() const { return static_cast<bool>(world().interactions().function()); }

  /// Replaces the thermostat, which starts now; none by default. It acts at its own times, each time after
  /// all contacts that round to the same double as that time, or an earlier one, and before all others: the
  /// state at that time has the velocities after the action. With a thermostat a run never ends by itself:
  /// give a finite time or a number of contacts that will happen. Cost: O(n). Error: as for change_velocity.
  void set_thermostat(std::optional<Thermostat> thermostat);
  const std::optional<Thermostat>& thermostat() const { return actors_.thermostat.thermostat; }

  /// Lets a motion drive kinematic spheres and surfaces from now on. Each chord begins at a time of its own,
  /// after all contacts that round to the same double as that time, or an earlier one, and before all others.
  /// With a motion a run seldom ends by itself: give a finite time or a number of contacts that will happen.
  /// Cost: that of a collision for each sphere, now and for each chord; O(n) for each chord of a surface.
  /// Error, and nothing changes: a feature excludes prescribed motions; another motion drives one of these;
  /// see DrivenMotion::begin. Error of the run: see DrivenMotion::act.
  void drive(DrivenMotion motion);
  /// Ends all motions: spheres and surfaces keep the velocities that they have.
  void stop_driving();
  /// The motions that have begun, in that order.
  std::span<const DrivenMotion> motions() const { return actors_.motions.schedule.motions(); }
  /// The work that one of them has done on spheres since the start, also before it began, through the bodies
  /// that it drives [M L^2 T^-2].
  double work_of(const DrivenMotion& motion) const;

  /// Adds an actor of your own, such as another thermostat, which changes velocities at times of its own; see
  /// Actor. It is not saved: add it again, as it was, after loading. Error: the pointer is null; the actor
  /// would act before now; a response or an observer calls this.
  void add_actor(std::unique_ptr<Actor> actor);

  /// Lets all spheres grow from now on, or shrink, until they fill as much as the rules say; replaces a
  /// growth that is not over. The epochs of the growth begin at times of their own, each after all contacts
  /// that round to the same double as that time, or an earlier one; at some of them all velocities are halved
  /// or doubled. `compressibility`, PV/NkT [1], saves the time to find it out where spheres are dense. Cost:
  /// O(n) now and for each epoch. Error: see World::set_growth and GrowthSchedule.
  void grow(const GrowthRules& rules, std::optional<double> compressibility = {});
  /// Ends a growth: from now on spheres keep the sizes that they have, as if nothing had ever grown. Measures
  /// need this, also after growth has reached its end. Cost: O(n).
  void stop_growing();
  /// The growth that has begun last, and may be over; none after stop_growing.
  const std::optional<GrowthSchedule>& growth() const { return actors_.growth.schedule; }

  /// Runs to `time` [T], events at that time included. Error: `time` is in the past, NaN, or finite and
  /// beyond 1e120.
  void run_until(double time) { run({.until = Time(time)}); }
  /// Runs to `time` [T], and takes `measures`; see Measures.
  void run_until(double time, Measures& measures) { run({.until = Time(time)}, measures); }
  /// Runs until `count` contacts have happened, but not beyond `until` [T]; returns how many happened. If
  /// spheres may never meet again, in open space or a periodic box, give a finite time. The operating range
  /// ends at 1e120, and with it any run.
  std::uint64_t run_contacts(std::uint64_t count, double until = std::numeric_limits<double>::infinity());
  /// Runs until the first of the limits is reached. Error: RunLimits::until, as for run_until.
  RunStatus run(const RunLimits& limits) { return run_with(limits, nullptr); }
  /// Runs until the first of the limits is reached, and takes `measures`. Error: spheres have been added or
  /// removed since the measures began, or merge.
  RunStatus run(const RunLimits& limits, Measures& measures);

  /// The next collision or wall contact up to `until` [T], without executing it. In a periodic box spheres
  /// may never meet: then give a finite time. Error: `until`, as for run_until. Cost: that of the events that
  /// a run would handle up to then; the next run does not repeat them unless edits follow.
  std::optional<NextContact> next_contact(double until = std::numeric_limits<double>::infinity());
  /// The contacts of the next `duration` [T], in order, up to `most`, without interference: those that run()
  /// would pass to the listener. Error: `duration` is negative, NaN, infinite or beyond 1e120; it is called
  /// by the response; errors of the run. Cost: that of the run and of rewinding it; called by the listener,
  /// plus an O(n) copy.
  std::vector<Contact> contacts_within(double duration,
                                       std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

  /// What a sphere would hit first up to `until` [T] if it had this velocity [L/T], and no other changed its
  /// motion; see first_contact (queries.hpp). Error and cost: as there, as of the queries that follow. They
  /// look at all spheres in engines without cells, in several processes, and after next_contact and
  /// positions_at until the simulation has run on.
  std::optional<NextContact> first_contact(SphereId id, const Vec3& velocity, double until) const {
    return hardball::first_contact(search(), now_, id, velocity, Time(until));
  }
  /// What a sphere that is not among them would hit first up to `until` [T].
  std::optional<NextContact> first_contact(const Sphere& sphere, double until) const {
    return hardball::first_contact(search(), now_, sphere, Time(until));
  }
  /// What a ray hits first now, up to `most` [L] from its origin; see ray (queries.hpp).
  std::optional<RayHit> ray(const Vec3& origin, const Vec3& direction, double most,
                            const BodyMask& mask = {}) const {
    return hardball::ray(search(), now_, origin, direction, most, filter_of(mask));
  }
  /// What each of many rays hits first now, in their order; shape (count). `threads` of them work. Error: as
  /// for ray; there are not as many directions as origins.
  std::vector<std::optional<RayHit>> rays(std::span<const Vec3> origins, std::span<const Vec3> directions,
                                          double most, const BodyMask& mask = {},
                                          std::size_t threads = 1) const;
  /// All that a ray enters now, in the order of distances; see ray_hits (queries.hpp).
  std::vector<RayHit> ray_hits(const Vec3& origin, const Vec3& direction, double most,
                               const BodyMask& mask = {}) const {
    return hardball::ray_hits(search(), now_, origin, direction, most, filter_of(mask));
  }
  /// The sphere or wall nearest to a point now, or to a sphere; see clearance (queries.hpp).
  std::optional<Clearance> clearance(const Vec3& point, const BodyMask& mask = {}) const {
    return hardball::clearance(search(), now_, point, filter_of(mask));
  }
  std::optional<Clearance> clearance(SphereId id, const BodyMask& mask = {}) const {
    return hardball::clearance(search(), now_, id, filter_of(mask));
  }
  /// The spheres that overlap a ball of this radius [L], or a box, now, in the order of ids; see overlap
  /// (queries.hpp).
  std::vector<SphereId> overlap(const Vec3& center, double radius, const BodyMask& mask = {}) const {
    return hardball::overlap(search(), now_, center, radius, filter_of(mask));
  }
  std::vector<SphereId> overlap(const Extent& extent, const BodyMask& mask = {}) const {
    return hardball::overlap(search(), now_, extent, filter_of(mask));
  }

  /// The spheres that are now inside of a step of their potential with one, in the order of ids; see
  /// partners_of (step_levels.hpp).
  std::vector<SphereId> partners(SphereId id) const { return partners_of(world(), id); }

  double time() const { return now_.value(); }  ///< [T]
  const Time& now() const { return now_; }

  /// Center now [L], folded into a periodic box. Error: no sphere has this id.
  Vec3 position(SphereId id) const;
  /// [L/T] Error: no sphere has this id.
  Vec3 velocity(SphereId id) const;
  /// All centers now [L], in the order of ids, folded into a periodic box. Shape (size, 3).
  std::vector<Vec3> positions() const;
  /// All centers at `time` [L], which is finite, not in the past and not after the next contact, nor after
  /// the thermostat acts or an epoch of growth begins. Error: any other time.
  std::vector<Vec3> positions_at(double time);

  /// Changes the velocity of a sphere [L/T], now. Error: no such sphere; a number that is NaN, infinite or
  /// out of range. Cost: that of a collision; when it follows next_contact or positions_at, as of these.
  void change_velocity(SphereId id, const Vec3& velocity);
  /// Changes many velocities, in the order of ids, whatever their order here; on an Error, none is changed.
  /// Error: as for one; a sphere is given twice. Cost: at most that of as many collisions.
  void change_velocities(std::span<const VelocityEdit> edits);
  /// Changes many velocities between runs with `measures`, which treat it as the action of a thermostat; see
  /// Measures.
  void change_velocities(std::span<const VelocityEdit> edits, Measures& measures);
  /// Puts spheres elsewhere, with other velocities, now; on an Error, nothing changes. Cost: O(n log n).
  /// Error: no such sphere, or one is given twice; a motion drives it; a number that is NaN, infinite or out
  /// of range; spheres overlap, or reach through a wall; spheres grow, or there are potentials of steps; the
  /// simulation is running.
  void put(std::span<const PlaceEdit> edits);
  /// Adds a sphere, now. Cost: that of a collision, amortized; O(n) for the first of a larger radius than all
  /// others. Error: spheres grow; see World::add; it overlaps another sphere.
  SphereId add(const Sphere& sphere);
  /// Removes a sphere, now. Cost: that of a collision. Error: spheres grow; no sphere has this id.
  void remove(SphereId id);

  /// A handle on a sphere. Error: no sphere has this id.
  SphereHandle sphere(SphereId id);
  /// Whether a sphere has this id. Cost: O(log n).
  bool contains(SphereId id) const { return world().contains(id); }
  /// A number that the caller attaches to a sphere, zero at first. Copies have their own; a sphere that
  /// absorbs another keeps its own. Error: no sphere has this id. Cost: O(log n).
  std::uint64_t user_data(SphereId id) const;
  void set_user_data(SphereId id, std::uint64_t data);

  /// The whole state as bytes, from which `load` makes a simulation that continues to the same history: paths
  /// as they are stored, the clock, the hash, the tally, the thermostat, the user data, the options.
  /// Listeners and custom responses are not saved; set them again. Error: called by the response or a
  /// velocity listener. Cost: O(n).
  std::string save() const;
  /// A simulation from the bytes of `save`, by this version of the library or an earlier one; `where` names
  /// the bytes in errors. Error: they are damaged, or not from `save`, or of a later version. Cost: that of a
  /// new simulation, without its audit.
  static Simulation load(std::string_view bytes, const std::string& where = "the saved simulation",
                         Processes& processes = one_process());

  /// Spheres whose ids are from k * kBlock on, before (k + 1) * kBlock, are the k-th block, which belongs to
  /// process k % Processes::size().
  static constexpr std::size_t kBlock = std::size_t{1} << 16;
  /// How many blocks there are.
  std::size_t blocks_of_spheres() const;
  /// The spheres of the blocks of this process, each block in the order of ids. Cost: O(n / processes), and
  /// all spheres are sent.
  std::vector<std::vector<SphereTransfer>> own_blocks() const;
  /// What is needed to continue, besides the spheres: the same bytes for any number of processes.
  std::string save_without_spheres() const;
  /// A block of spheres as bytes.
  static std::string saved_block(const std::vector<SphereTransfer>& block);
  /// Continues from what save_without_spheres has returned, and from blocks of which each process brings
  /// some, whatever it was that saved them; `where` names the bytes in errors. Error: they are damaged; as
  /// for from_parts.
  static Simulation load_blocks(std::string_view saved, const std::vector<std::string>& blocks,
                                const std::string& where, Processes& processes, std::size_t threads = 1);

  /// All spheres. In several threads or processes they are gathered when this is called. Cost, then:
  /// O(contacts since the last call), at first O(n).
  const World& world() const;
  /// The world with its box, walls, interactions and motion; its spheres may be missing or out of date.
  const World& setting() const;
  std::size_t size() const;
  /// Sums over the spheres at the present time. Cost: O(n).
  Totals totals() const;
  /// A check of all spheres; see audit. Cost: O(n log n).
  Audit audit() const;
  /// How many spheres each species has, up to the highest one. Cost: O(n).
  std::vector<std::size_t> species_counts() const;
  /// Whether some spheres have spun; see World::has_spins.
  bool has_spins() const;
  /// The box that holds all spheres; from 0 to 1 if there are none [L]. Cost: O(n).
  Extent extent() const;
  /// Calls visit(world, slot) for each sphere that this process has; see EngineBase.
  void for_each_sphere(const Function<void(const World&, Slot)>& visit) const;

  /// The processes that share the simulation.
  Processes& processes() const;

  const EngineOptions& options() const;
  /// Lets this many threads work on the simulation from now on; see EngineOptions::threads. A loaded
  /// simulation has one thread. Cost: O(n). Error: as for EngineOptions::threads.
  void set_threads(std::size_t threads);
  /// The blocks into which the box is divided [L], one for each domain (docs/parallel.md): a sphere belongs
  /// to the domain in whose block it is, up to the end of a window. Blocks change when spheres or cells have
  /// changed much. One block, all of the box, if one thread works alone. Cost: O(blocks).
  std::vector<Block> blocks() const;
  /// The windows of time that the domains have run since the simulation was made or loaded; with one domain
  /// there are none.
  WindowCounters windows() const;
  Counters counters() const;
  /// Hash of all contacts so far, see EventLogHash.
  std::uint64_t event_log_hash() const { return sums_.hash.value(); }
  const Tally& tally() const { return sums_.tally; }
  /// Both.
  const ContactSums& sums() const { return sums_; }
  /// The engine in use, never `automatic`.
  EngineKind engine() const;
  /// Edges of a cell along each axis [L], a corner of one lying at the origin; zero if the engine has no
  /// cells.
  Vec3 cell_edges() const;
  /// Mean edge of the cells [L]; zero if the engine has none.
  double cell_edge() const;
  /// Radius of the ball in which a sphere moves before its list of neighbors changes [L]; zero if there are
  /// no lists.
  double skin() const;
  std::size_t memory_bytes() const;
  /// Checks all structures; throws BrokenInvariant. Cost: that of predicting all candidate pairs.
  void validate() const;

 private:
  struct Saved;

  Simulation();
  static Time latest_change(const World& world);
  void begin_loaded(const EngineOptions& options, EngineKind kind, Counters counters, const World& world,
                    const std::string& where, Processes& processes);
  void start_parts(World part, const std::optional<Time>& moment, const CollapseGuard& counts);
  RunStatus run_with(const RunLimits& limits, Measures* measures);
  void on_every_contact(const Contact& contact, Measures* measures);
  void log(const Contact& contact, Measures* measures);
  void note_merger(const Contact& contact, const Measures* measures);
  void take_next_listener();
  void call_listener(const Contact& contact, Activity::Kind activity);
  std::uint64_t act(const Time& moment, Measures* measures);
  void carry_out(const Action& action, const Time& moment);
  void tell_of_motion(const Action& action, const Time& moment);
  void begin_epoch(const Action& action, Actor& actor, const Time& moment, Measures* measures);
  void note_removed(SphereId id);
  void look_ahead(const Time& until, std::uint64_t most, const Function<void(const Contact&)>& observe);
  void look_ahead_in_copy(const Time& until, std::uint64_t most,
                          const Function<void(const Contact&)>& observe) const;
  void edit_velocities(std::span<const VelocityEdit> edits, Measures* measures);
  void tell_of_changes(const Time& moment, std::span<const NewVelocity> changes, Measures* measures);
  void tell_of_epoch(const Growth& epoch);
  SphereSearch search() const;
  BodyFilter filter_of(const BodyMask& mask) const;
  void check_idle(const char* what) const;
  void check_editable(const char* what) const;
  void check_not_growing(const char* what) const;
  void check_not_past(const Time& time) const;
  void check_driven();

  ValuePointer<EngineManager> manager_;  // with the engine
  Time now_;
  ContactSums sums_;
  ValuePointer<UserData> user_data_;
  Actors actors_;
  LazyMovingSpheres moving_;
  Observer observer_;
  Function<void(const Contact&)> listener_;
  std::optional<Function<void(const Contact&)>> next_listener_;  // set by the listener itself
  Activity activity_;
  bool are_driven_ = false;      // all kinematic spheres where there is gravity, as far as is known
  bool is_rescheduled_ = false;  // when an actor acts next has changed during a stretch of a run
};

}  // namespace hardball
