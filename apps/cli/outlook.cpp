// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/outlook.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/start.hpp"
#include "hardball/error.hpp"
#include "hardball/placement.hpp"
#include "hardball/random.hpp"
#include "hardball/scenario.hpp"
#include "hardball/scenario/make_surfaces.hpp"
#include "hardball/scenario/velocities.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/tuning/size_classes.hpp"

namespace hardball::cli {
namespace {

constexpr std::size_t kManySpheres = 1'000'000;
constexpr std::size_t kSampled = 20'000;

std::size_t sphere_count(const Scenario& scenario) {
  std::size_t count = 0;
  for (const SphereGroup& group : scenario.spheres) count += group.count;
  return count;
}

// Whether the spheres of a group are known without those before them.
bool can_be_sampled(const SphereGroup& group) {
  const bool are_read = group.distribution && group.distribution->kind == RadiusDistribution::Kind::file;
  return group.positions.empty() && group.velocities.empty() && group.spins.empty() && !are_read;
}

// Some spheres of each group.
std::vector<SphereGroup> sample(const Scenario& scenario) {
  const double share = static_cast<double>(kSampled) / static_cast<double>(sphere_count(scenario));
  Random random(scenario.run.seed);
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

// What the radii and speeds of a sample say of all spheres, each group counting as often as it has spheres.
GasStatistics statistics_of_all(const Scenario& scenario, std::span<const SphereGroup> sampled) {
  GasStatistics statistics;
  statistics.box = make_box(scenario);
  statistics.spheres = sphere_count(scenario);
  statistics.radius_power = {};
  Random random(scenario.run.seed);
  const std::vector<Vec3> velocities = draw_velocities(sampled, false, random);
  std::size_t next = 0;
  for (std::size_t k = 0; k < sampled.size(); ++k) {
    const double weight = static_cast<double>(scenario.spheres[k].count) /
                          (static_cast<double>(sampled[k].count) * static_cast<double>(statistics.spheres));
    for (std::size_t i = 0; i < sampled[k].count; ++i, ++next) {
      const double radius = sampled[k].radius_of(i);
      double power = weight;
      for (double& sum : statistics.radius_power) {
        sum += power;
        power *= radius;
      }
      statistics.largest_radius = std::max(statistics.largest_radius, radius);
      statistics.mean_speed += weight * length(velocities[next]);
    }
  }
  return statistics;
}

double content(const GasStatistics& statistics) {
  const double spheres = static_cast<double>(statistics.spheres);
  return spheres * (statistics.is_flat() ? std::numbers::pi * statistics.radius_power[2]
                                         : 4 * std::numbers::pi / 3 * statistics.radius_power[3]);
}

// Where the spheres are placed: in the box, between surfaces, and along the other axes as far as they fill a
// tenth.
Vec3 extent_of(const Scenario& scenario, const GasStatistics& statistics) {
  const std::vector<Surface> surfaces = make_surfaces(scenario, statistics.box);
  const Extent room = room_between(surfaces);
  Vec3 extent;
  double free = content(statistics) / kOpenPackingFraction;
  int open = 0;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const double low = std::max(room.low[axis], scenario.box[axis].size ? 0 : room.low[axis]);
    extent[axis] = std::min(room.high[axis], scenario.box[axis].size.value_or(room.high[axis])) - low;
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
  sampled.surfaces.clear();
  sampled.bonds.clear();
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

// The engine that all spheres would get; the sample alone might get another.
std::string engine_for(const EngineChoice& choice, const GasStatistics& statistics) {
  if (choice.engine != "auto" || choice.cell_edge != "auto" || are_sizes_spread(statistics))
    return choice.engine;
  const UnitCosts costs;
  const bool has_lists = best_skin(statistics, costs).cost < best_cell_edge(statistics, costs).cost;
  return std::string(name_of(has_lists ? EngineKind::neighbors : EngineKind::cells));
}

}  // namespace

Outlook look_ahead(const EngineChoice& choice, const Scenario& scenario, bool is_quiet) {
  if (sphere_count(scenario) <= kManySpheres || !std::ranges::all_of(scenario.spheres, can_be_sampled)) {
    Start start = set_up(choice, scenario, is_quiet);
    const GasStatistics statistics = gas_statistics(start.simulation.world(), start.simulation.now());
    return {start.options, std::move(start.simulation), statistics, false, std::move(start.notes)};
  }
  const std::vector<SphereGroup> groups = sample(scenario);
  GasStatistics statistics = statistics_of_all(scenario, groups);
  statistics.extent = extent_of(scenario, statistics);
  if (statistics.packing_fraction() > 1) {
    throw Error("a packing fraction of " + to_text(statistics.packing_fraction()) + " cannot exist",
                scenario.spheres.front().where, "enlarge the box or shrink the spheres");
  }
  const double edge = edge_of_sample(groups, scenario.dimensions(), statistics.packing_fraction());
  EngineChoice its_choice = choice;
  its_choice.engine = engine_for(choice, statistics);
  Start start = set_up(its_choice, sampled_scenario(scenario, groups, edge), is_quiet);
  return {start.options, std::move(start.simulation), statistics, true};
}

}  // namespace hardball::cli
