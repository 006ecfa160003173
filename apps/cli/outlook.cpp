// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/outlook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "apps/cli/start.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_surfaces.hpp"
#include "hardball/scenario/radii.hpp"
#include "hardball/scenario/velocities.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/kinetic_theory.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/tuning/size_classes.hpp"
#include "hardball/world/random.hpp"

namespace hardball::cli {
namespace {

constexpr std::size_t kManySpheres = 1'000'000;
constexpr std::size_t kSampled = 20'000;

// Whether the spheres of a group are known without those before them.
bool can_be_sampled(const SphereGroup& group) {
  const bool are_read = group.distribution && group.distribution->kind == RadiusDistribution::Kind::file;
  return group.positions.empty() && group.velocities.empty() && group.spins.empty() && !are_read;
}

// Some spheres of each group.
std::vector<SphereGroup> sample(const Scenario& scenario) {
  const double share = static_cast<double>(kSampled) / static_cast<double>(sphere_count(scenario));
  Random random(scenario.seed);
  std::vector<SphereGroup> groups = scenario.spheres;
  for (SphereGroup& group : groups) {
    const double count = std::round(share * static_cast<double>(group.count));
    group.count = static_cast<std::size_t>(std::max(1.0, count));
    group.placement = Placement::random;
    if (!group.distribution) continue;
    group.radii = draw_radii(*group.distribution, group.count, random);
    group.distribution.reset();
  }
  return groups;
}

Box box_of(const Scenario& scenario) {
  std::array<Boundary, kAxes> boundary{};
  Vec3 size;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    boundary[axis] = scenario.box[axis].boundary;
    size[axis] = scenario.box[axis].size.value_or(0);
  }
  return {boundary, size};
}

// What the radii and speeds of a sample say of all spheres, each group counting as often as it has spheres.
Moments moments_of_all(const Scenario& scenario, std::span<const SphereGroup> sampled) {
  Moments moments;
  moments.box = box_of(scenario);
  moments.spheres = sphere_count(scenario);
  moments.radius_power = {};
  Random random(scenario.seed);
  const std::vector<Vec3> velocities = draw_velocities(sampled, false, random);
  std::size_t next = 0;
  for (std::size_t k = 0; k < sampled.size(); ++k) {
    const double weight = static_cast<double>(scenario.spheres[k].count) /
                          (static_cast<double>(sampled[k].count) * static_cast<double>(moments.spheres));
    for (std::size_t i = 0; i < sampled[k].count; ++i, ++next) {
      const double radius = sampled[k].radius_of(i);
      double power = weight;
      for (double& sum : moments.radius_power) {
        sum += power;
        power *= radius;
      }
      moments.largest_radius = std::max(moments.largest_radius, radius);
      moments.mean_speed += weight * length(velocities[next]);
    }
  }
  return moments;
}

double content(const Moments& moments) {
  const double spheres = static_cast<double>(moments.spheres);
  return spheres * (moments.is_flat() ? std::numbers::pi * moments.radius_power[2]
                                      : 4 * std::numbers::pi / 3 * moments.radius_power[3]);
}

// Where the spheres are placed: in the box, between surfaces, and along the other axes as far as they fill a
// tenth.
Vec3 extent_of(const Scenario& scenario, const Moments& moments) {
  constexpr double kOpenPackingFraction = 0.1;
  const std::vector<Surface> surfaces = make_surfaces(scenario, moments.box);
  Vec3 extent;
  double free = content(moments) / kOpenPackingFraction;
  int open = 0;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const Interval between = interval_between(surfaces, axis);
    const double low = std::max(between.low, scenario.box[axis].size ? 0 : between.low);
    extent[axis] = std::min(between.high, scenario.box[axis].size.value_or(between.high)) - low;
    if (std::isfinite(extent[axis])) {
      free /= extent[axis];
    } else {
      ++open;
    }
  }
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    if (!std::isfinite(extent[axis])) extent[axis] = std::pow(free, 1.0 / open);
  }
  return extent;
}

// The spheres of `groups` in a periodic box, with nothing else.
Scenario sampled_scenario(const Scenario& scenario, std::vector<SphereGroup> groups, double edge) {
  Scenario sampled = scenario;
  sampled.spheres = std::move(groups);
  sampled.walls.clear();
  sampled.obstacles.clear();
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    sampled.box[axis] = {Boundary::periodic, edge};
  }
  return sampled;
}

// The edge of a box in which the groups have a packing fraction that random placement reaches at once.
double edge_of_sample(std::span<const SphereGroup> groups, std::size_t dimensions, double packing_fraction) {
  double volume = 0;
  double largest = 0;
  for (const SphereGroup& group : groups) {
    for (std::size_t i = 0; i < group.count; ++i) {
      const double radius = group.radius_of(i);
      volume += std::numbers::pi * radius * radius * (dimensions == 2 ? 1 : 4 * radius / 3);
      largest = std::max(largest, radius);
    }
  }
  constexpr double kEasilyReached = 0.35;
  constexpr double kLeastDiameters = 3;
  return std::max(
      std::pow(volume / std::min(packing_fraction, kEasilyReached), 1.0 / static_cast<double>(dimensions)),
      kLeastDiameters * 2 * largest);
}

// The engine that so many spheres would get, where the sample alone might get another.
std::string engine_for(const Options& options, const Moments& moments) {
  if (options.engine != "auto" || options.cell_edge != "auto" || are_sizes_spread(moments))
    return options.engine;
  const UnitCosts costs;
  const double edge = optimal_cell_edge(moments, costs);
  const double cells = cost_rate(expected_counts(moments, edge), costs_with_memory(moments, costs));
  const double slack = optimal_slack(moments, costs);
  const double lists = cost_rate(expected_neighbor_counts(moments, slack), costs);
  return name_of(lists < cells ? EngineKind::neighbors : EngineKind::cells);
}

bool loses_energy(const BounceRules& rules) {
  if (rules.elastic_below > 0 || rules.contact_duration > 0) return false;
  const auto* constant = std::get_if<ConstantRestitution>(&rules.restitution);
  return !constant || constant->value < 1;
}

bool loses_energy(const Scenario& scenario) {
  const auto has_rule = scenario.bounce.elastic_below > 0 || scenario.bounce.contact_duration > 0;
  const auto has_lossy_wall = [&](const auto& walls) {
    return !has_rule &&
           std::ranges::any_of(walls, [](const auto& wall) { return wall.restitution.value_or(1) < 1; });
  };
  return loses_energy(scenario.bounce) || has_lossy_wall(scenario.walls) ||
         has_lossy_wall(scenario.obstacles) ||
         std::ranges::any_of(scenario.pairs, [](const PairDescription& pair) {
           return pair.fate == Fate::bounce && loses_energy(pair.bounce);
         });
}

// Whether walls exchange energy with spheres, or a thermostat does.
bool are_kept_moving(const Scenario& scenario) {
  const auto drives = [](const WallDescription& wall) {
    return wall.temperature.value_or(0) > 0 || wall.amplitude > 0 || wall.velocity != Vec3{};
  };
  return scenario.thermostat || std::ranges::any_of(scenario.walls, drives) ||
         std::ranges::any_of(scenario.obstacles,
                             [](const auto& obstacle) { return obstacle.temperature.value_or(0) > 0; });
}

bool is_round(const WallDescription& wall) {
  return wall.shape != WallDescription::Shape::plane;
}

// Whether spheres that fall come to lie on something.
bool has_floor(const Scenario& scenario) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (scenario.gravity[axis] != 0 && scenario.box[axis].boundary == Boundary::wall) return true;
  }
  return scenario.gravity != Vec3{} && std::ranges::any_of(scenario.walls, [&](const WallDescription& wall) {
           return is_round(wall) || dot(wall.direction, scenario.gravity) < 0;
         });
}

bool has_walls(const Scenario& scenario) {
  return !scenario.walls.empty() || !scenario.obstacles.empty() ||
         std::ranges::any_of(scenario.box, [](const auto& axis) { return axis.boundary == Boundary::wall; });
}

// Whether all spheres pass through each other, as far as species tell.
bool do_all_pass(const Scenario& scenario) {
  if (scenario.spheres.empty() || scenario.species.empty()) return false;
  std::set<std::pair<SpeciesId, SpeciesId>> passing;
  for (const PairDescription& pair : scenario.pairs) {
    if (pair.fate == Fate::pass && pair.second) passing.insert(std::minmax(pair.first, *pair.second));
  }
  for (const SphereGroup& a : scenario.spheres) {
    for (const SphereGroup& b : scenario.spheres) {
      const bool is_one_sphere = &a == &b && a.count == 1;
      if (!is_one_sphere && !passing.contains(std::minmax(a.species, b.species))) return false;
    }
  }
  return true;
}

// The axes along which nothing holds spheres together.
std::string open_axes(const Scenario& scenario, const Box& box) {
  const std::vector<Surface> surfaces = make_surfaces(scenario, box);
  std::string axes;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const Interval between = interval_between(surfaces, axis);
    const double gravity = scenario.gravity[axis];
    const bool is_held =
        (std::isfinite(between.low) || gravity > 0) && (std::isfinite(between.high) || gravity < 0);
    if (!box.is_open(axis) || (is_held && (std::isfinite(between.low) || std::isfinite(between.high))))
      continue;
    axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
  }
  return axes;
}

// Why there will be no contact at all, if that is certain.
std::optional<std::string> why_nothing_touches(const Scenario& scenario, const Moments& moments) {
  const bool falls = scenario.gravity != Vec3{};
  if (moments.mean_speed == 0 && !are_kept_moving(scenario)) {
    if (!falls) return "nothing moves";
    if (!has_walls(scenario)) return "all spheres fall alike, and nothing is in their way";
  }
  if (has_walls(scenario)) return std::nullopt;
  if (moments.spheres == 1 && !box_of(scenario).is_all(Boundary::periodic))
    return "there is one sphere, and no wall";
  if (do_all_pass(scenario)) return "all spheres pass through each other, and there are no walls";
  return std::nullopt;
}

}  // namespace

std::size_t sphere_count(const Scenario& scenario) {
  std::size_t count = 0;
  for (const SphereGroup& group : scenario.spheres) count += group.count;
  return count;
}

Outlook look_ahead(const Options& options, const Scenario& scenario) {
  if (sphere_count(scenario) <= kManySpheres || !std::ranges::all_of(scenario.spheres, can_be_sampled)) {
    Start start = set_up(options, scenario);
    const Moments moments = moments_of(start.simulation.world(), start.simulation.now());
    return {start.options, std::move(start.simulation), moments, false};
  }
  const std::vector<SphereGroup> groups = sample(scenario);
  Moments moments = moments_of_all(scenario, groups);
  moments.extent = extent_of(scenario, moments);
  if (moments.packing_fraction() > 1) {
    throw Error("a packing fraction of " + to_text(moments.packing_fraction()) + " cannot exist",
                scenario.spheres.front().where, "enlarge the box or shrink the spheres");
  }
  const double edge = edge_of_sample(groups, scenario.dimensions(), moments.packing_fraction());
  Options its_options = options;
  its_options.engine = engine_for(options, moments);
  Start start = set_up(its_options, sampled_scenario(scenario, groups, edge));
  return {start.options, std::move(start.simulation), moments, true};
}

std::vector<std::string> warnings_of(const Scenario& scenario, const Moments& moments) {
  std::vector<std::string> warnings;
  const double until = *scenario.until;
  if (const auto reason = why_nothing_touches(scenario, moments)) {
    warnings.push_back(*reason + ": there will be no contact");
  } else if (moments.mean_speed > 0 && !are_kept_moving(scenario) && scenario.gravity == Vec3{}) {
    const double spheres = static_cast<double>(moments.spheres);
    const double contacts = spheres * until * (0.5 / mean_free_time(moments) + wall_rate(moments));
    const bool is_known = scenario.walls.empty() && scenario.obstacles.empty();
    if (is_known && contacts < 1) {
      warnings.push_back(fmt::format("only {:.2g} contacts are expected until then", contacts));
    }
  }
  const std::string axes = open_axes(scenario, moments.box);
  const double apart = std::max({moments.extent.x, moments.extent.y, moments.extent.z}) / moments.mean_speed;
  if (!axes.empty() && moments.spheres > 1 && apart < until) {
    warnings.push_back(fmt::format(
        "the space is open along {}: after a time of {:.2g} the spheres have flown apart and hardly meet",
        axes, apart));
  }
  if (!loses_energy(scenario)) return warnings;
  const char* when = are_kept_moving(scenario) ? "may end" : "ends";
  const char* unless = "by inelastic collapse, unless elastic_below or contact_duration is set in [response]";
  if (has_floor(scenario)) {
    warnings.push_back(
        fmt::format("spheres that lose energy come to rest under gravity: the run {} {}", when, unless));
  } else if (std::ranges::any_of(scenario.walls, is_round)) {
    warnings.push_back(
        fmt::format("spheres that lose energy come to slide along round walls: the run {} {}", when, unless));
  }
  return warnings;
}

}  // namespace hardball::cli
