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
#include "hardball/scenario/settling_heap.hpp"
#include "hardball/theory.hpp"

namespace hardball::cli {
namespace {

// Whether a rule keeps spheres that lose energy from meeting infinitely often.
bool is_bounded(const BounceRules& rules) {
  return rules.elastic_below > 0 || rules.contact_duration > 0 || rules.settle_under > 0;
}

// Whether spheres may lose energy by infinitely many contacts.
bool may_collapse(const Scenario& scenario) {
  if (!is_bounded(scenario.bounce)) return loses_energy(scenario);
  return std::ranges::any_of(scenario.pairs, [](const PairDescription& pair) {
    return pair.outcome == ContactOutcome::bounce && loses_energy(pair.bounce) && !is_bounded(pair.bounce);
  });
}

bool has_walls(const Scenario& scenario) {
  return !scenario.surfaces.empty() ||
         std::ranges::any_of(scenario.box, [](const auto& axis) { return axis.boundary == Boundary::wall; });
}

// Whether all spheres pass through each other, judging by their species.
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
  const Extent room = room_between(make_surfaces(scenario, box));
  std::string axes;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const bool has_low = std::isfinite(room.low[axis]);
    const bool has_high = std::isfinite(room.high[axis]);
    const double gravity = scenario.gravity[axis];
    const bool is_held = (has_low || gravity > 0) && (has_high || gravity < 0);
    if (!box.is_open(axis) || (is_held && (has_low || has_high))) continue;
    axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
  }
  return axes;
}

// Why there will be no contact at all, if that is certain.
std::optional<std::string> why_nothing_touches(const Scenario& scenario, const GasStatistics& statistics) {
  const bool falls = scenario.gravity != Vec3{};
  if (statistics.mean_speed == 0 && !are_kept_moving(scenario)) {
    if (!falls) return "nothing moves";
    if (!has_walls(scenario)) return "all spheres fall alike, and there is nothing for them to hit";
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
  const double until = *scenario.run.until;
  if (const auto reason = why_nothing_touches(scenario, statistics)) {
    warnings.push_back(*reason + ": there will be no contact");
  } else if (statistics.mean_speed > 0 && !are_kept_moving(scenario) && scenario.gravity == Vec3{}) {
    const double spheres = static_cast<double>(statistics.spheres);
    const double contacts = spheres * until * (0.5 / mean_free_time(statistics) + wall_rate(statistics));
    const bool is_known = scenario.surfaces.empty() && !scenario.has_steps();
    if (is_known && contacts < 1) {
      warnings.push_back(fmt::format("only {:.2g} contacts are expected until then", contacts));
    }
  }
  const std::string axes = open_axes(scenario, statistics.box);
  const double apart =
      std::max({statistics.extent.x, statistics.extent.y, statistics.extent.z}) / statistics.mean_speed;
  if (!axes.empty() && statistics.spheres > 1 && apart < until && scenario.bonds.empty()) {
    warnings.push_back(
        fmt::format("the space is open along {}: after a time of {:.2g} the spheres have flown apart and "
                    "hardly ever collide",
                    axes, apart));
  }
  const bool is_pressed = comes_to_rest(scenario) && !scenario.settles;
  if (is_pressed && scenario.bounce.elastic_below > 0 && scenario.bounce.contact_duration == 0) {
    warnings.push_back(
        "elastic_below alone does not bound the number of contacts of spheres that gravity presses together: "
        "leave out settle = false, or give contact_duration");
  }
  if (!may_collapse(scenario)) return warnings;
  const char* when = are_kept_moving(scenario) ? "may end" : "ends";
  const char* unless = "by inelastic collapse, unless settle or contact_duration is set in [response]";
  if (has_floor(scenario)) {
    warnings.push_back(
        fmt::format("spheres that lose energy come to rest under gravity: the run {} {}", when, unless));
  } else if (std::ranges::any_of(scenario.surfaces, is_round)) {
    warnings.push_back(fmt::format("spheres that lose energy end up sliding along round walls: the run {} {}",
                                   when, unless));
  }
  return warnings;
}

}  // namespace hardball::cli
