// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/motions/keyframes.hpp"
#include "hardball/scenario/nearest_name.hpp"
#include "hardball/scenario/read_tables.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

Vec3 read_axis(const Section& section, std::size_t dimensions) {
  const std::optional<Value> axis = section.find("axis");
  if (!axis) return dimensions == 2 ? Vec3{0, 0, 1} : direction_of(section.need("axis"), "axis", dimensions);
  return direction_of(*axis, "axis", kAxes);
}

// Where a motion along lines stops before its end.
void read_stop(const Section& section, MotionDescription& motion) {
  if (const auto pressure = section.find("stop_pressure")) {
    motion.stop_pressure = pressure->number();
    motion.stop_interval = section.need("stop_interval").number();
  } else if (const auto interval = section.find("stop_interval")) {
    throw Error("there is no stop_pressure", interval->location(),
                "add the pressure at which the motion stops, or remove stop_interval");
  }
}

MotionDescription read_motion(const Section& section, const std::filesystem::path& folder,
                              std::size_t dimensions) {
  const std::string kind = section.need("kind").text();
  static_cast<void>(section.need("kind").choice());
  const std::string name = section.need("name").text();
  const std::string where = section.location();
  const std::optional<Value> tolerance = section.find("tolerance");
  MotionDescription motion;
  motion.name = name;
  motion.where = where;
  if (kind == Keyframes::kName) {
    motion.file = folder / section.need("file").text();
    if (const auto repeat = section.find("repeat")) motion.repeats = repeat->truth();
    if (tolerance) motion.tolerance = tolerance->number();
    read_stop(section, motion);
    return motion;
  }
  const double frequency = section.need("frequency").number();
  motion.tolerance = section.need("tolerance").number();
  if (kind == Rotation::kName) {
    const Vec3 point = section.need("point").vector(dimensions);
    const Vec3 axis = read_axis(section, dimensions);
    motion.motion =
        made_at(where, [&] { return PrescribedMotion::rotation(point, axis, frequency, motion.tolerance); });
    return motion;
  }
  read_stop(section, motion);
  const Vec3 direction = direction_of(section.need("direction"), "direction", dimensions);
  const double amplitude = section.need("amplitude").number();
  motion.motion = made_at(where, [&] {
    return PrescribedMotion::oscillation(direction, amplitude, frequency, motion.tolerance);
  });
  return motion;
}

}  // namespace

std::vector<MotionDescription> read_motions(const Section& root, const std::filesystem::path& folder,
                                            std::size_t dimensions) {
  std::vector<MotionDescription> motions;
  for (const Section& section : root.sections("motions")) {
    MotionDescription motion = read_motion(section, folder, dimensions);
    if (ranges::find(motions, motion.name, &MotionDescription::name) != motions.end()) {
      throw Error("there are two motions \"" + shortened(motion.name) + "\"", section.need("name").location(),
                  "give each a name of its own");
    }
    motions.push_back(std::move(motion));
  }
  return motions;
}

PrescribedMotion MotionDescription::made(std::size_t dimensions) const {
  if (motion) return *motion;
  std::vector<Keyframe> rows = read_keyframes(*file, dimensions);
  return made_at(file->string(),
                 [&] { return PrescribedMotion::keyframes(std::move(rows), repeats, tolerance); });
}

std::size_t motion_named(const Value& name, const std::vector<MotionDescription>& motions) {
  const std::string wanted = name.text();
  const auto found = ranges::find(motions, wanted, &MotionDescription::name);
  if (found != motions.end()) return static_cast<std::size_t>(found - motions.begin());
  std::vector<std::string_view> names;
  for (const MotionDescription& each : motions) names.push_back(each.name);
  throw Error("there is no motion \"" + shortened(wanted) + "\"", name.location(),
              names.empty() ? "add [[motions]] with this name" : suggestion(wanted, names, '"'));
}

void check_motions(const Scenario& scenario) {
  for (const SphereGroup& group : scenario.spheres) {
    if (group.is_kinematic && !group.motion)
      check_exclusions(Feature::undriven, scenario.features(), group.where);
  }
  for (std::size_t k = 0; k < scenario.motions.size(); ++k) {
    const MotionDescription& motion = scenario.motions[k];
    const auto is_driven = [&](const auto& body) { return body.motion == k; };
    const bool drives_spheres = ranges::any_of(scenario.spheres, is_driven);
    if (!drives_spheres && ranges::none_of(scenario.surfaces, is_driven)) {
      throw Error("the motion \"" + shortened(motion.name) + "\" drives nothing", motion.where,
                  "add motion = \"" + motion.name + "\" to [[spheres]] or [[walls]], or remove it");
    }
    if (drives_spheres && scenario.gravity != Vec3{} && motion.tolerance == 0) {
      throw Error(
          "the motion \"" + shortened(motion.name) + "\" has no tolerance, and there is gravity",
          motion.where,
          "give the distance up to which spheres may leave its straight lines, such as tolerance = 1e-6");
    }
  }
}

}  // namespace hardball
