// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "hardball/scenario/make_surfaces.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball::cli {
namespace {

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
  return loses_energy(scenario.bounce) || has_lossy_wall(scenario.faces) || has_lossy_wall(scenario.walls) ||
         has_lossy_wall(scenario.obstacles) ||
         std::ranges::any_of(scenario.pairs, [](const PairDescription& pair) {
           return pair.outcome == ContactOutcome::bounce && loses_energy(pair.bounce);
         });
}

// Whether walls exchange energy with spheres, or a thermostat does.
bool are_kept_moving(const Scenario& scenario) {
  const auto is_warm = [](const auto& wall) { return wall.temperature.value_or(0) > 0; };
  const auto moves = [](const auto& wall) { return wall.velocity != Vec3{}; };
  const auto oscillates = [](const WallDescription& wall) { return wall.amplitude > 0; };
  const auto any = [](const auto& walls, const auto&... drive) {
    return std::ranges::any_of(walls, [&](const auto& wall) { return (drive(wall) || ...); });
  };
  return scenario.thermostat || any(scenario.faces, is_warm, moves) ||
         any(scenario.walls, is_warm, moves, oscillates) || any(scenario.obstacles, is_warm);
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
    if (pair.outcome == ContactOutcome::pass && pair.second)
      passing.insert(std::minmax(pair.first, *pair.second));
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
std::optional<std::string> why_nothing_touches(const Scenario& scenario, const GasStatistics& statistics) {
  const bool falls = scenario.gravity != Vec3{};
  if (statistics.mean_speed == 0 && !are_kept_moving(scenario)) {
    if (!falls) return "nothing moves";
    if (!has_walls(scenario)) return "all spheres fall alike, and nothing is in their way";
  }
  if (has_walls(scenario)) return std::nullopt;
  if (statistics.spheres == 1 && !statistics.box.is_all(Boundary::periodic))
    return "there is one sphere, and no wall";
  if (do_all_pass(scenario)) return "all spheres pass through each other, and there are no walls";
  return std::nullopt;
}

}  // namespace

std::vector<std::string> warnings_of(const Scenario& scenario, const GasStatistics& statistics) {
  std::vector<std::string> warnings;
  const double until = *scenario.until;
  if (const auto reason = why_nothing_touches(scenario, statistics)) {
    warnings.push_back(*reason + ": there will be no contact");
  } else if (statistics.mean_speed > 0 && !are_kept_moving(scenario) && scenario.gravity == Vec3{}) {
    const double spheres = static_cast<double>(statistics.spheres);
    const double contacts = spheres * until * (0.5 / mean_free_time(statistics) + wall_rate(statistics));
    const bool is_known = scenario.walls.empty() && scenario.obstacles.empty() && !scenario.has_steps();
    if (is_known && contacts < 1) {
      warnings.push_back(fmt::format("only {:.2g} contacts are expected until then", contacts));
    }
  }
  const std::string axes = open_axes(scenario, statistics.box);
  const double apart =
      std::max({statistics.extent.x, statistics.extent.y, statistics.extent.z}) / statistics.mean_speed;
  if (!axes.empty() && statistics.spheres > 1 && apart < until && scenario.bonds.empty()) {
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
    warnings.push_back(fmt::format("spheres that lose energy end up sliding along round walls: the run {} {}",
                                   when, unless));
  }
  return warnings;
}

}  // namespace hardball::cli
