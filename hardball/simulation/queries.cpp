// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What callers ask for without changing anything.
#include <algorithm>

#include "hardball/errors/error.hpp"
#include "hardball/run/engine_manager.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/simulation/user_data.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/standard/share_work.hpp"

namespace hardball {

SphereSearch Simulation::search() const {
  return {world(), manager_->engine().search_parts(now_), moving_};
}

BodyFilter Simulation::filter_of(const BodyMask& mask) const {
  BodyFilter filter;
  filter.walls = mask.walls;
  const bool are_all_groups = mask.groups == BodyMask().groups;
  if (mask.species.empty() && are_all_groups) return filter;
  filter.spheres = [this, mask, are_all_groups](const World& world, Slot slot) {
    const bool is_of_species =
        mask.species.empty() || ranges::find(mask.species, world.species(slot)) != mask.species.end();
    return is_of_species && (are_all_groups || (user_data_->get(world.id(slot)) & mask.groups) != 0);
  };
  return filter;
}

std::vector<std::optional<RayHit>> Simulation::rays(std::span<const Vec3> origins,
                                                    std::span<const Vec3> directions, double most,
                                                    const BodyMask& mask, std::size_t threads) const {
  constexpr const char* kWhere = "rays";
  if (origins.size() != directions.size()) {
    throw Error(
        "there are " + to_text(origins.size()) + " origins and " + to_text(directions.size()) + " directions",
        kWhere, "give as many directions as origins");
  }
  if (threads == 0) throw Error("there are no threads", kWhere, "give one or more");
  std::vector<std::optional<RayHit>> hits(origins.size());
  const SphereSearch spheres = search();
  const BodyFilter filter = filter_of(mask);
  const std::size_t parts = std::min(threads, std::max<std::size_t>(1, origins.size()));
  share_work(parts, parts, [&](std::size_t part) {
    const std::size_t end = origins.size() * (part + 1) / parts;
    for (std::size_t i = origins.size() * part / parts; i < end; ++i)
      hits[i] = hardball::ray(spheres, now_, origins[i], directions[i], most, filter);
  });
  return hits;
}

}  // namespace hardball
