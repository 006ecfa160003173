// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/cube_root.hpp"
#include "hardball/world/world.hpp"

namespace hardball {
namespace {

double disc_area(std::span<const SphereGroup> groups) {
  double squares = 0;
  for (const SphereGroup& group : groups) {
    for (std::size_t i = 0; i < group.count; ++i) squares += group.radius_of(i) * group.radius_of(i);
  }
  return std::numbers::pi * squares;
}

SphereGroup one_of(SphereGroup group) {
  group.count = 1;
  return group;
}

// Error: too many radii are to be drawn for reading a scenario quickly.
void check_draws(const Scenario& scenario) {
  constexpr std::size_t kMost = 10'000'000;
  for (const SphereGroup& group : scenario.spheres) {
    if (!group.distribution || group.count <= kMost) continue;
    throw Error(
        "the box follows from the radii of " + to_text(group.count) + " spheres, which are distributed",
        group.where,
        "give the box a size instead of a packing_fraction, or at most " + to_text(kMost) + " spheres");
  }
}

}  // namespace

std::vector<SphereGroup> groups_with_radii(const Scenario& scenario, Random& random) {
  std::vector<SphereGroup> groups = scenario.spheres;
  for (SphereGroup& group : groups) {
    if (group.distribution) group.radii = draw_radii(*group.distribution, group.count, random);
  }
  return groups;
}

double sphere_volume(std::span<const SphereGroup> groups) {
  if (groups.front().dimensions == 2) return disc_area(groups);
  double volume = 0;
  for (const SphereGroup& group : groups) {
    if (group.radii.empty()) {
      volume += static_cast<double>(group.count) * 4 * std::numbers::pi / 3 * group.radius * group.radius *
                group.radius;
    }
    for (const double radius : group.radii) volume += 4 * std::numbers::pi / 3 * radius * radius * radius;
  }
  return volume;
}

std::size_t count_for(double packing_fraction, const SphereGroup& group,
                      const std::array<Scenario::Axis, kAxes>& box, const std::string& where) {
  double volume = 1;
  for (std::size_t axis = 0; axis < group.dimensions; ++axis) {
    if (!box[axis].size) {
      throw Error("the number of spheres follows from the packing fraction, and the box has no size", where,
                  "give the box a size, or give count");
    }
    volume *= *box[axis].size;
  }
  const SphereGroup one = one_of(group);
  const double count = std::floor(packing_fraction * volume / sphere_volume({&one, 1}) + 0.5);
  constexpr double kMost = std::numeric_limits<SphereId>::max() - 1.0;
  if (count > kMost) {
    throw Error(
        "it takes " + to_text(count) + " spheres to fill " + to_text(packing_fraction) + " of the box", where,
        "give larger spheres, or a smaller box: there can be " + to_text(kMost));
  }
  return static_cast<std::size_t>(std::max(1.0, count));
}

void fit_box(Scenario& scenario) {
  if (!scenario.packing_fraction) return;
  check_draws(scenario);
  Random random(scenario.run.seed);
  double spheres = 0;
  for (const SphereGroup& group : groups_with_radii(scenario, random)) {
    if (group.radii.empty()) {
      const SphereGroup one = one_of(group);
      spheres += static_cast<double>(group.count) * sphere_volume({&one, 1});
    } else {
      spheres += sphere_volume({&group, 1});
    }
  }
  const double volume = spheres / *scenario.packing_fraction;
  const double edge = scenario.dimensions() == 2 ? std::sqrt(volume) : cube_root(volume);
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) scenario.box[axis].size = edge;
}

}  // namespace hardball
