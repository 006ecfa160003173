// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What callers ask for without changing anything.
#include <algorithm>
#include <exception>
#include <thread>

#include "hardball/errors/error.hpp"
#include "hardball/run/engine_manager.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/simulation/user_data.hpp"

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
        mask.species.empty() || std::ranges::find(mask.species, world.species(slot)) != mask.species.end();
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
  std::vector<std::exception_ptr> failures(std::min(threads, std::max<std::size_t>(1, origins.size())));
  const auto work = [&](std::size_t part) {
    try {
      const std::size_t end = origins.size() * (part + 1) / failures.size();
      for (std::size_t i = origins.size() * part / failures.size(); i < end; ++i)
        hits[i] = hardball::ray(spheres, now_, origins[i], directions[i], most, filter);
    } catch (...) {
      failures[part] = std::current_exception();
    }
  };
  std::vector<std::jthread> others;
  for (std::size_t part = 1; part < failures.size(); ++part) others.emplace_back(work, part);
  work(0);
  others.clear();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return hits;
}

}  // namespace hardball
