// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "hardball/describe/field.hpp"
#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/growth/growth_schedule.hpp"
#include "hardball/interaction/bounce.hpp"
#include "hardball/interaction/step_potential.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/motions/prescribed_motion.hpp"
#include "hardball/placement/radii.hpp"
#include "hardball/thermostats/thermostat.hpp"
#include "hardball/trajectory/snapshot_format.hpp"
#include "hardball/trajectory/snapshot_schedule.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// How the centers of a group's spheres are chosen.
enum class Placement {
  random,     ///< Anywhere without overlap, also with those that are listed.
  fcc,        ///< On a face-centered cubic lattice that fills the region.
  hexagonal,  ///< On a hexagonal lattice that fills a flat region.
  listed,     ///< Where SphereGroup::positions says.
};
/// The names of the placements that scenarios choose from; `listed` has none.
template <>
inline constexpr std::array<std::string_view, 3> kNames<Placement>{"random", "fcc", "hexagonal"};

/// How the velocities of a group's spheres are chosen.
enum class VelocityRule {
  mean_speed,   ///< Maxwell's distribution with this mean of |v| [L/T].
  temperature,  ///< Maxwell's distribution with this k T, m <v^2> by the dimensions [M L^2 T^-2].
  speed,        ///< All have this |v| [L/T], in random directions.
  listed,       ///< As SphereGroup::velocities says.
};
/// The keys of scenarios.
template <>
inline constexpr std::array<std::string_view, 4> kNames<VelocityRule>{"mean_speed", "temperature", "speed",
                                                                      "velocities"};

/// Spheres of one kind: a table [[spheres]] of a scenario.
struct HARDBALL_EXPORT SphereGroup {
  std::size_t dimensions = 3;  ///< Dimensions of the box: 3, or 2 for discs.
  std::size_t count = 0;
  double radius = 1;  ///< Radius of all spheres, unless radii are distributed [L].
  std::optional<RadiusDistribution> distribution;  ///< Distribution of the radii.
  std::vector<double> radii;   ///< Shape (count) once they are drawn, otherwise empty [L].
  double mass = 1;             ///< Mass of all spheres, unless there is a density, or each has its own [M].
  std::vector<double> masses;  ///< Shape (count) of spheres that have each their own, otherwise empty [M].
  std::optional<double> density;  ///< Density of the material, from which masses follow [M/L^3 or M/L^2].
  Placement placement = Placement::random;
  std::vector<Vec3> positions;  ///< Shape (count, 3) for Placement::listed, otherwise empty [L].
  VelocityRule velocity_rule = VelocityRule::speed;
  double velocity_scale = 0;          ///< What the rule prescribes; unused for VelocityRule::listed.
  std::vector<Vec3> velocities;       ///< Shape (count, 3) for VelocityRule::listed, otherwise empty [L/T].
  double rotational_temperature = 0;  ///< I <w^2> / 3 of the spins w [M L^2 T^-2].
  std::vector<Vec3> spins;            ///< Listed spins, shape (count, 3) [1/T]; empty if drawn.
  SpeciesId species = 0;              ///< An index into Scenario::species, if there are any.
  bool is_kinematic = false;          ///< Whether the mass is infinite.
  std::optional<std::size_t> motion;  ///< What drives them: an index into Scenario::motions.
  std::string where;                  ///< Location in the scenario, for messages.

  /// The radius of a sphere of the group [L].
  double radius_of(std::size_t index) const { return radii.empty() ? radius : radii[index]; }
  /// The mass of a sphere of the group [M].
  double mass_of(std::size_t index) const;
};

/// A face of the box with properties of its own: a key of the table [box.faces] of a scenario.
struct FaceDescription {
  Face face = 0;
  FaceProperties properties;
  std::string where;  ///< Location in the scenario, for messages.
};

/// A surface besides the faces of the box: a table [[walls]] of a scenario, or one position of a table
/// [[obstacles]].
struct SurfaceDescription {
  Surface surface;
  std::string where;                       ///< Location in the scenario, for messages.
  std::optional<std::size_t> motion = {};  ///< What drives it: an index into Scenario::motions.
  /// From the point of the surface to that about which torque on it is measured [L].
  Vec3 torque_offset = {};

  bool is_obstacle() const { return std::holds_alternative<Obstacle>(surface.shape()); }
};

/// A species: a table [[species]] of a scenario.
struct SpeciesDescription {
  std::string name;
  /// Moment of inertia over mass and squared radius [1]; that of uniform spheres or discs if not given.
  std::optional<double> inertia_factor;

  static constexpr auto fields() {
    return std::tuple{
        Field{"name", &SpeciesDescription::name, NumberRange::finite, "",
              "its name, by which `[[spheres]]` and `[[response.pairs]]` refer to it", "\"steel\""},
        option("moment", &SpeciesDescription::inertia_factor, NumberRange::positive, "",
               "the moment of inertia of its spheres over mass and squared radius: 2/5 for uniform "
               "spheres and 1/2 for uniform discs, if not given; 2/3 for shells",
               "0.4")};
  }
};

/// What two species do at contacts: a table [[response.pairs]] of a scenario.
struct PairDescription {
  ContactOutcome outcome = ContactOutcome::bounce;
  SpeciesId first = 0;
  std::optional<SpeciesId> second;  ///< None for walls.
  BounceRules bounce;               ///< If they bounce.
};

/// A potential of steps: a table [[potentials]] of a scenario.
struct PotentialDescription {
  /// The species; none for all pairs that no other potential names.
  std::optional<std::pair<SpeciesId, SpeciesId>> between;
  StepRules rules;
};

/// Spheres that are tied together: a table [[bonds]] of a scenario.
struct BondsDescription {
  std::vector<std::pair<SphereId, SphereId>> pairs;
  std::optional<std::filesystem::path> file;  ///< A file with the pairs, instead of `pairs`.
  StepRules rules;
  std::string where;  ///< Location in the scenario, for messages.
};

/// A motion of kinematic spheres and walls: a table [[motions]] of a scenario.
struct HARDBALL_EXPORT MotionDescription {
  std::string name;
  std::optional<PrescribedMotion> motion;     ///< None where it is a table in a file.
  std::optional<std::filesystem::path> file;  ///< The table of keyframes.
  bool repeats = false;                       ///< Whether the table does.
  double tolerance = 0;                       ///< [L]
  double stop_pressure = 0;                   ///< [M L^-1 T^-2]; zero if it does not stop.
  double stop_interval = 0;                   ///< [T]
  std::string where;                          ///< Location in the scenario, for messages.

  /// The motion itself; reads the file. Error: see read_keyframes and Keyframes.
  PrescribedMotion made(std::size_t dimensions) const;
};

/// The run: the table [run] of a scenario.
struct RunDescription {
  std::optional<double> until;  ///< When it ends at the latest [T].
  /// The run ends sooner when the errors of all quantities with these names are below these numbers, each in
  /// the unit of its quantity.
  NamedNumbers until_error;
  std::uint64_t seed = 1;

  static constexpr auto fields() {
    return std::tuple{
        option("until", &RunDescription::until, NumberRange::not_negative, "T",
               "when the run ends; `--until` takes precedence", "10.0"),
        option("until_error", &RunDescription::until_error, NumberRange::positive, {},
               "the run ends before `until` when the standard errors of these quantities are below these "
               "numbers, each in the unit of its quantity",
               "{ compressibility = 0.02 }"),
        option("seed", &RunDescription::seed,
               "the seed of the random numbers for radii, placement, velocities and the thermostat; "
               "`--seed` takes precedence",
               "1", "1")
            .within(0, std::numeric_limits<std::int64_t>::max())};
  }
};

/// The files that are written: the table [output] of a scenario.
struct HARDBALL_EXPORT OutputDescription {
  std::optional<std::filesystem::path> directory;
  std::optional<double> snapshots_every;              ///< [T]
  std::optional<std::uint64_t> snapshots_per_decade;  ///< Goes with first_snapshot.
  std::optional<double> first_snapshot;               ///< [T]
  std::optional<std::uint64_t> snapshots_every_contacts;
  std::vector<SnapshotFormat> trajectory;  ///< Formats; none if no snapshots are taken.
  bool event_log = false;
  bool recording = false;
  double checkpoint_every = 60;       ///< Seconds of wall time.
  std::vector<double> checkpoint_at;  ///< [T]
  bool report = true;                 ///< Where there is a directory.

  /// When snapshots are taken.
  SnapshotSchedule snapshots() const;

  /// The formats of trajectories, in the order of SnapshotFormat.
  static constexpr std::array<std::string_view, 5> kFormats{"xyz", "xyz.zst", "gsd", "lammps", "vtp"};

  static constexpr auto fields() {
    using enum NumberRange;
    using Output = OutputDescription;
    return std::tuple{
        option("directory", &Output::directory,
               "the directory of the files; `--out` takes precedence; without either, no files are written",
               "\"out\""),
        option("snapshots_every", &Output::snapshots_every, positive, "T",
               "interval of the snapshots in the trajectory; none are taken unless this, "
               "`snapshots_per_decade` or `snapshots_every_contacts` is given",
               "0.5"),
        option("snapshots_per_decade", &Output::snapshots_per_decade,
               "or: how many snapshots are taken while the time grows tenfold, evenly in its logarithm, from "
               "`first_snapshot` on",
               "10")
            .within(1, 1000),
        option("first_snapshot", &Output::first_snapshot, positive, "T",
               "goes with `snapshots_per_decade`: the time of the first snapshot after that of the start",
               "0.001"),
        option("snapshots_every_contacts", &Output::snapshots_every_contacts,
               "or: how many collisions and wall contacts lie between two snapshots", "10000")
            .within(1, std::numeric_limits<std::int64_t>::max()),
        option("trajectory", &Output::trajectory,
               "the format of the trajectory: `trajectory.xyz`, `trajectory.xyz.zst`, `trajectory.gsd`, "
               "`trajectory.lammpstrj` or `trajectory.pvd`",
               "\"gsd\"", "\"xyz\"")
            .one_of(kFormats),
        option("event_log", &Output::event_log, "whether to write `events.npy`", "true", "false"),
        option("recording", &Output::recording,
               "whether to write `recording.hbr`, for the [viewer](viewer.md)", "true", "false"),
        option("checkpoint_every", &Output::checkpoint_every, positive, "",
               "seconds of wall time between checkpoints, from which `hardball resume` resumes", "600",
               "60.0"),
        option("checkpoint_at", &Output::checkpoint_at, finite, "T",
               "times at which a checkpoint is also written; each is kept as `checkpoints/T.hbc`",
               "[10.0, 100.0]"),
        option("report", &Output::report, "whether to write `report.html`", "false", "true")};
  }
};

/// A description of a run: the contents of a scenario file, each value checked by itself.
struct HARDBALL_EXPORT Scenario {
  /// The box along an axis.
  struct Axis {
    Boundary boundary = Boundary::open;
    /// Length of the box; along an open axis, of the interval from 0 on in which spheres are placed [L].
    /// None along a flat axis.
    std::optional<double> size;
  };

  std::string name;  ///< The file, for messages.
  std::string text;  ///< Contents of the file, without overrides.
  std::array<Axis, kAxes> box;
  /// The fraction of the volume that the spheres fill, from which fit_box has made the sizes of the box [1];
  /// none where they are given.
  std::optional<double> packing_fraction;
  /// 2 if the box is flat.
  std::size_t dimensions() const { return box[2].boundary == Boundary::flat ? 2 : 3; }
  Vec3 gravity;                                     ///< [L/T^2]
  Shear shear;                                      ///< Shear of the box.
  bool is_shear_offset_given = false;               ///< Otherwise it is the tilt of a start file's box.
  std::string shear_where;                          ///< For messages.
  std::vector<FaceDescription> faces;               ///< Faces of the box with properties of their own.
  std::vector<SurfaceDescription> surfaces;         ///< Walls, then obstacles, each in the order of the file.
  std::vector<SphereGroup> spheres;                 ///< In the order of ids.
  std::optional<std::filesystem::path> start_file;  ///< A file with snapshots, instead of `spheres`.
  /// How velocities are drawn for a start file that has none: by the mean speed or the temperature.
  std::optional<VelocityRule> start_velocity_rule;
  double start_velocity_scale = 0;  ///< What that rule prescribes.
  /// Whether all radii of a start file are multiplied by the largest factor at which no spheres overlap.
  bool shrinks_start = false;
  std::vector<SpeciesDescription> species;  ///< Named by their index; none if all spheres are alike.
  BounceRules bounce;                       ///< Rules of all contacts that `pairs` does not name.
  /// Whether spheres come to rest in a heap, and the run then only waits for its end.
  bool settles = false;
  bool merges = false;  ///< Whether all spheres that `pairs` does not name merge.
  std::vector<PairDescription> pairs;
  std::vector<PotentialDescription> potentials;
  std::vector<BondsDescription> bonds;
  std::vector<MotionDescription> motions;    ///< Prescribed motions; each drives something.
  std::optional<ThermostatKind> thermostat;  ///< The thermostat; its seed is that of the run.
  std::optional<GrowthRules> growth;         ///< Growth of all spheres, from the start on.
  RunDescription run;
  OutputDescription output;
  MeasureSettings measures;  ///< Settings of all measures if the scenario has no table [measures].

  /// The constant coefficient of restitution of all contacts of smooth spheres [1]; NaN if they have none.
  double restitution() const;
  /// The features that spheres, the box, gravity, growth and rules of contacts other than roughness and
  /// passing have.
  Features features() const;
  /// Whether there are potentials of steps.
  bool has_steps() const { return !potentials.empty() || !bonds.empty(); }
};

/// Reads a scenario file. A start file is named relative to the scenario file, an output directory relative
/// to the current directory.
///
/// Each of `overrides` is a string key=value that replaces a value or adds one, as in `run.until=5` or
/// `spheres.0.count=10`. Values are written as in TOML; the quotes around a plain word may be left out.
/// Error, with file:line:column or `--set key` as its place: the file cannot be read; it is not TOML; a key
/// is unknown, missing or contradicts another; a value has the wrong type or is out of range.
HARDBALL_EXPORT Scenario load_scenario(const std::filesystem::path& path,
                                       std::span<const std::string> overrides = {});

/// Reads a scenario from a text, as load_scenario does; `name` stands for the file in messages and in the
/// path of the start file.
HARDBALL_EXPORT Scenario parse_scenario(std::string_view text, const std::string& name,
                                        std::span<const std::string> overrides = {});

/// Gives the box the edge at which the spheres fill the packing fraction of the scenario; changes nothing
/// where there is none. load_scenario has done this: call it again after changing the groups, or the seed
/// where radii are distributed. Cost: O(n) where radii are distributed. Error: see draw_radii; more than ten
/// million radii of a group would have to be drawn.
HARDBALL_EXPORT void fit_box(Scenario& scenario);

}  // namespace hardball
