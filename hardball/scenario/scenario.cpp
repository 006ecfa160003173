// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/scenario/document.hpp"
#include "hardball/scenario/read_tables.hpp"
#include "hardball/scenario/section.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// The largest scenario file, which becomes a tree many times its size.
constexpr std::size_t kMaxBytes = std::size_t{16} << 20;

std::string number_of(std::size_t axes) {
  return axes == 2 ? "two" : "three";
}

void read_sizes(const Value& size, std::span<Scenario::Axis> box) {
  const auto is_bounded = [](const Scenario::Axis& axis) { return axis.boundary != Boundary::open; };
  const auto bounded = static_cast<std::size_t>(std::count_if(box.begin(), box.end(), is_bounded));
  const std::string remedy =
      "give " + number_of(box.size()) + " numbers, or one for each axis that is not open";
  const std::vector<Value> sizes = size.entries(remedy);
  if (sizes.size() != box.size() && sizes.size() != bounded) size.wrong_length(sizes.size(), remedy);
  auto next = sizes.begin();
  for (Scenario::Axis& axis : box) {
    if (sizes.size() == box.size() || is_bounded(axis)) axis.size = (next++)->number();
  }
}

void read_box(const Section& section, std::array<Scenario::Axis, kAxes>& all_axes) {
  const auto dimensions = section.find("dimensions");
  const std::span<Scenario::Axis> box = std::span(all_axes).first(dimensions ? dimensions->integer() : kAxes);
  for (Scenario::Axis& axis : all_axes) axis.boundary = Boundary::flat;
  const Value boundary = section.need("boundary");
  const std::string remedy =
      "give " + number_of(box.size()) + " of \"wall\", \"periodic\" and \"open\" in brackets";
  const std::vector<Value> boundaries = boundary.entries(remedy);
  if (boundaries.size() != box.size()) boundary.wrong_length(boundaries.size(), remedy);
  bool is_open = true;
  for (std::size_t axis = 0; axis < box.size(); ++axis) {
    box[axis].boundary = static_cast<Boundary>(boundaries[axis].choice());
    is_open = is_open && box[axis].boundary == Boundary::open;
  }
  if (const auto size = section.find("size")) {
    read_sizes(*size, box);
  } else if (!is_open && !section.find("packing_fraction")) {
    section.need("size", "packing_fraction");
  }
}

// The packing fraction from which the size of the box follows.
void read_packing_fraction(const Section& box, Scenario& scenario) {
  const std::optional<Value> fraction = box.find("packing_fraction");
  if (!fraction) return;
  if (box.find("size")) {
    throw Error("both size and packing_fraction are given", fraction->location(),
                "remove one of the two; with size, [[spheres]] may have packing_fraction instead of count");
  }
  const auto is_open = [](const Scenario::Axis& axis) { return axis.boundary == Boundary::open; };
  if (ranges::any_of(scenario.box, is_open)) {
    throw Error("packing_fraction is given, and the box is open along an axis", fraction->location(),
                "make all axes periodic or walls, or give size");
  }
  scenario.packing_fraction = fraction->number();
}

// Error: a packing fraction is given where it does not determine the size of the box or a number of spheres.
void check_packing_fractions(const Section& root, const Scenario& scenario) {
  const std::vector<Section> groups = root.sections("spheres");
  const bool has_surfaces = !scenario.surfaces.empty();
  const auto refuse = [](const std::string& what, const Value& fraction, const char* remedy) {
    throw Error("packing_fraction is given, and " + what, fraction.location(), remedy);
  };
  if (scenario.packing_fraction) {
    const Value fraction = root.section("box")->need("packing_fraction");
    if (groups.empty()) refuse("the spheres come from a file", fraction, "give size");
    if (has_surfaces) refuse("there are [[walls]] or [[obstacles]]", fraction, "give size");
    const auto is_listed = [](const SphereGroup& group) { return group.placement == Placement::listed; };
    if (ranges::any_of(scenario.spheres, is_listed))
      refuse("spheres have positions, which need a box of known size", fraction, "give size");
  }
  for (const Section& group : groups) {
    const std::optional<Value> fraction = group.find("packing_fraction");
    if (fraction && has_surfaces)
      refuse("[[walls]] or [[obstacles]] leave only a part of the box", *fraction, "give count");
  }
}

Vec3 read_gravity(const Section& box, std::size_t dimensions) {
  const std::optional<Value> given = box.find("gravity");
  if (!given) return {};
  const Vec3 gravity = given->vector(dimensions);
  if (gravity != Vec3{}) {
    check_positive(std::hypot(gravity.x, gravity.y, gravity.z), "the magnitude of gravity",
                   given->location());
  }
  if (dimensions == 2 && gravity.z != 0) {
    throw Error("gravity along z is " + to_text(gravity.z) + " in a box of two dimensions", given->location(),
                "make it zero, or give the box three dimensions");
  }
  return gravity;
}

void read_shear(const Section& box, Scenario& scenario) {
  const std::optional<Value> rate = box.find("shear_rate");
  const std::optional<Value> offset = box.find("shear_offset");
  if (rate) scenario.shear.rate = rate->number();
  if (offset) scenario.shear.offset = offset->number();
  scenario.is_shear_offset_given = offset.has_value();
  if (rate || offset) scenario.shear_where = (rate ? rate : offset)->location();
}

void read_start_velocities(const Section& start, Scenario& scenario) {
  start.refuse_both("mean_speed", "temperature");
  const std::optional<Value> mean_speed = start.find("mean_speed");
  const std::optional<Value> temperature = start.find("temperature");
  if (!mean_speed && !temperature) return;
  scenario.start_velocity_rule = mean_speed ? VelocityRule::mean_speed : VelocityRule::temperature;
  scenario.start_velocity_scale = (mean_speed ? mean_speed : temperature)->number();
}

void read_start(const Section& root, Scenario& scenario) {
  const std::vector<Section> groups = root.sections("spheres");
  const std::filesystem::path folder = std::filesystem::path(scenario.name).parent_path();
  const std::optional<Section> start = root.section("start");
  if (start) {
    if (!groups.empty()) {
      throw Error("both [[spheres]] and [start] are given", start->location(), "remove one of the two");
    }
    const Value file = start->need("file");
    scenario.start_file = folder / file.text();
    try {
      format_of(*scenario.start_file);
    } catch (const Error& error) {
      throw Error("file is \"" + shortened(file.text()) + "\", and " + error.problem(), file.location(),
                  error.remedy());
    }
    read_start_velocities(*start, scenario);
    const std::optional<Value> shrink = start->find("shrink");
    scenario.shrinks_start = shrink && shrink->truth();
    return;
  }
  if (groups.empty()) throw Error("there are no spheres", scenario.name, "add [[spheres]] or [start]");
  for (const Section& group : groups) scenario.spheres.push_back(read_spheres(group, folder, scenario));
}

ThermostatKind read_thermostat(const Section& section) {
  const Value kind = section.need("kind");
  static_cast<void>(kind.choice());
  return *from_description<ThermostatKind>(kind.text(),
                                           [&](const auto& field) { return read_field(section, field); });
}

GrowthRules read_growth(const Section& section) {
  GrowthRules rules;
  section.read_fields(rules);
  return made_at(section.location(), [&] { return GrowthSchedule(rules).rules(); });
}

void read_output(const Section& section, OutputDescription& output) {
  section.read_fields(output);
  section.refuse_both("snapshots_every", "snapshots_per_decade");
  section.refuse_both("snapshots_every", "snapshots_every_contacts");
  section.refuse_both("snapshots_per_decade", "snapshots_every_contacts");
  if (output.first_snapshot && !output.snapshots_per_decade) {
    throw Error("first_snapshot is given without snapshots_per_decade",
                section.need("first_snapshot").location(),
                "add snapshots_per_decade = 10, say, or remove it");
  }
  if (output.snapshots_per_decade) section.need("first_snapshot");
  const bool is_never = output.snapshots().is_never();
  if (is_never && !output.trajectory.empty()) {
    throw Error("trajectory is given, but no snapshots are taken", section.need("trajectory").location(),
                "add snapshots_every, snapshots_per_decade or snapshots_every_contacts");
  }
  if (!is_never && output.trajectory.empty()) output.trajectory = {SnapshotFormat::extended_xyz};
}

void read_measures(const Section& section, MeasureSettings& measures) {
  if (const auto names = section.find("names")) {
    measures.names.clear();
    for (const Value& name : names->entries("give names in brackets, such as [\"pressure\"] or [\"all\"]")) {
      name.choice();
      measures.names.push_back(name.text());
    }
  }
  section.read_fields(measures);
}

// By default measures are taken where nothing excludes them.
void leave_out_measures(const Section& root, Scenario& scenario) {
  if (goes_with(Feature::measures, scenario.features())) return;
  const std::optional<Section> measures = root.section("measures");
  const std::optional<Value> names = measures ? measures->find("names") : std::nullopt;
  if (names && !scenario.measures.names.empty())
    check_exclusions(Feature::measures, scenario.features(), names->location());
  scenario.measures.names.clear();
}

Scenario read_scenario(const Document& document) {
  Scenario scenario;
  scenario.name = document.name();
  const Section root(document);
  const std::optional<Section> box = root.section("box");
  if (!box) {
    throw Error("table [box] is missing", document.name(),
                "add [box] with size = [10.0, 10.0, 10.0] and boundary = [\"wall\", \"wall\", \"wall\"]");
  }
  read_box(*box, scenario.box);
  read_packing_fraction(*box, scenario);
  scenario.gravity = read_gravity(*box, scenario.dimensions());
  read_shear(*box, scenario);
  scenario.species = read_species(root);
  const std::filesystem::path folder = std::filesystem::path(scenario.name).parent_path();
  scenario.motions = read_motions(root, folder, scenario.dimensions());
  read_start(root, scenario);
  scenario.faces = read_faces(*box, scenario.dimensions());
  scenario.surfaces = read_surfaces(root, folder, scenario);
  check_motions(scenario);
  check_packing_fractions(root, scenario);
  read_response(root, scenario);
  read_potentials(root, scenario);
  if (const auto thermostat = root.section("thermostat")) scenario.thermostat = read_thermostat(*thermostat);
  if (const auto growth = root.section("growth")) scenario.growth = read_growth(*growth);
  read_settling(root, scenario);
  if (const auto run = root.section("run")) run->read_fields(scenario.run);
  if (const auto output = root.section("output")) read_output(*output, scenario.output);
  if (const auto measures = root.section("measures")) read_measures(*measures, scenario.measures);
  for (std::uint32_t k = 0; k < scenario.surfaces.size(); ++k) {
    const Vec3& offset = scenario.surfaces[k].torque_offset;
    if (offset != Vec3{}) scenario.measures.torque_about.emplace_back(k, offset);
  }
  const auto is_listed = [](const SphereGroup& group) { return group.placement == Placement::listed; };
  scenario.measures.is_start_placed =
      scenario.measures.from == 0 && !scenario.start_file && !ranges::all_of(scenario.spheres, is_listed);
  const auto is_random = [](const SphereGroup& group) {
    return group.placement == Placement::random || group.rotational_temperature > 0;
  };
  scenario.measures.is_energy_random = !scenario.start_file && ranges::any_of(scenario.spheres, is_random);
  leave_out_measures(root, scenario);
  if (!scenario.run.until_error.empty() && scenario.measures.names.empty()) {
    throw Error("run.until_error is given, and nothing is measured",
                root.section("run")->find("until_error")->location(),
                "name measures in [measures], or remove it");
  }
  fit_box(scenario);
  return scenario;
}

}  // namespace

double Scenario::restitution() const {
  const auto* const constant = std::get_if<ConstantRestitution>(&bounce.restitution);
  const bool is_alike = constant && pairs.empty() && !merges && !bounce.tangential_restitution;
  return is_alike ? constant->value : std::numeric_limits<double>::quiet_NaN();
}

Features Scenario::features() const {
  const auto merge = [](const PairDescription& pair) { return pair.outcome == ContactOutcome::merge; };
  Features features;
  features.add(Feature::flat, dimensions() == 2);
  features.add(Feature::gravity, gravity != Vec3{});
  features.add(Feature::growth, growth.has_value());
  features.add(Feature::shear, shear.is_present());
  features.add(Feature::steps, has_steps());
  features.add(Feature::merging, merges || ranges::any_of(pairs, merge));
  features.add(Feature::kinematic, ranges::any_of(spheres, &SphereGroup::is_kinematic));
  features.add(Feature::motions, !motions.empty());
  features.add(Feature::undriven, ranges::any_of(spheres, [](const SphereGroup& group) {
                 return group.is_kinematic && !group.motion;
               }));
  return features;
}

SnapshotSchedule OutputDescription::snapshots() const {
  if (snapshots_every) return SnapshotSchedule::every(*snapshots_every);
  if (snapshots_per_decade)
    return SnapshotSchedule::logarithmic(first_snapshot.value(), *snapshots_per_decade);
  if (snapshots_every_contacts) return SnapshotSchedule::every_contacts(*snapshots_every_contacts);
  return {};
}

double SphereGroup::mass_of(std::size_t index) const {
  if (is_kinematic) return std::numeric_limits<double>::infinity();
  if (!masses.empty()) return masses[index];
  if (!density) return mass;
  const double radius_of_it = radius_of(index);
  if (dimensions == 2) return *density * std::numbers::pi * radius_of_it * radius_of_it;
  return *density * (4 * std::numbers::pi / 3) * radius_of_it * radius_of_it * radius_of_it;
}

Scenario load_scenario(const std::filesystem::path& path, std::span<const std::string> overrides) {
  std::ifstream in(path, std::ios::binary);
  // On some systems a directory can be opened, and only reading it fails.
  if (!in || std::filesystem::is_directory(path)) {
    throw Error("the file cannot be read", path.string(), "name a scenario file");
  }
  // A device or a pipe may be endless.
  std::string text;
  std::array<char, 1 << 16> piece;
  while (text.size() <= kMaxBytes && (in.read(piece.data(), piece.size()) || in.gcount() > 0)) {
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (text.size() > kMaxBytes) {
    throw Error("the file is larger than 16 MiB", path.string(),
                "describe many spheres in groups, or in a file named in [start]");
  }
  return parse_scenario(text, path.string(), overrides);
}

Scenario parse_scenario(std::string_view text, const std::string& name,
                        std::span<const std::string> overrides) {
  Document document(name, text);
  for (const std::string& override_text : overrides) document.apply_override(override_text);
  Scenario scenario = read_scenario(document);
  scenario.text = text;
  return scenario;
}

}  // namespace hardball
