// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/collision_rate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool has_walls(const Box& box) {
  return box.is_wall(0) || box.is_wall(1) || box.is_wall(2);
}

}  // namespace

CollisionRate::CollisionRate(const Scene& scene)
    : species_(scene.species()),
      theory_(scene.fluid()),
      motion_(scene.motion()),
      spheres_(static_cast<double>(scene.world().size())),
      has_walls_(has_walls(scene.world().box())),
      begin_(scene.now()),
      last_(scene.now()),
      contacts_(kPairs + species_.size() * species_.size()) {}

std::size_t CollisionRate::pair_bin(std::size_t a, std::size_t b) const {
  return kPairs + std::min(a, b) * species_.size() + std::max(a, b);
}

void CollisionRate::advance(const Time& now) {
  contacts_.close_sample(duration(last_, now));
  last_ = now;
}

void CollisionRate::note(const Contact& contact) {
  if (contact.is_collision()) {
    contacts_.put(kCollisions, 1);
    contacts_.put(pair_bin(species_.of(contact.first), species_.of(contact.second)), 1);
  } else {
    contacts_.put(kWalls, 1);
  }
  advance(contact.time);
}

void CollisionRate::sample(const Scene& scene) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  double sum = 0;
  world.for_each_by_id([&](Slot slot) { sum += length(world.path(slot).velocity); });
  speed_.add(sum / static_cast<double>(world.size()));
}

Measurement CollisionRate::result(const Scene& scene) const {
  Measurement found{.name = std::string(kName),
                    .title = "Collision rate",
                    .formula =
                        "w = 2 collisions / (N t); free time 1 / w, free path <|v|> / w; theory: "
                        "w = (6 / sqrt(pi)) (Z - 1) sqrt(kT / m) / diameter",
                    .source =
                        "Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, sections 5.2 "
                        "and 16.2"};
  CollisionRate up_to_now = *this;
  up_to_now.advance(scene.now());
  const BlockAverage& contacts = up_to_now.contacts_;
  const double temperature = is_energy_conserved(motion_, scene.motion()) ? motion_.temperature() : kNone;
  const double expected = theory_.collision_rate(temperature);
  const double elapsed = duration(begin_, scene.now());
  const auto add = [&](std::string name, const char* unit, const FunctionOfMeans& quantity, double theory) {
    const Estimate estimate = contacts.estimate(quantity);
    // Without a collision there is no free time.
    const double value = std::isfinite(estimate.value) ? estimate.value : kNone;
    found.quantities.push_back({std::move(name), unit, value, estimate.error, theory});
  };
  found.quantities.push_back(
      {.name = "collisions", .unit = "1", .value = std::round(contacts.mean(kCollisions) * elapsed)});
  if (has_walls_) {
    found.quantities.push_back(
        {.name = "wall_contacts", .unit = "1", .value = std::round(contacts.mean(kWalls) * elapsed)});
  }
  using Means = std::span<const double>;
  const auto rate = [&](Means means) { return 2 * means[kCollisions] / spheres_; };
  const auto wall_rate = [&](Means means) { return means[kWalls] / spheres_; };
  add("collision_rate", "T^-1", rate, expected);
  add(
      "mean_free_time", "T", [&](Means means) { return 1 / rate(means); }, 1 / expected);
  const double speed = speed_.mean();
  add(
      "mean_free_path", "L", [&](Means means) { return speed / rate(means); },
      theory_.mean_speed(temperature) / expected);
  if (has_walls_) {
    add("wall_rate", "T^-1", wall_rate, kNone);
  }
  for (std::size_t a = 0; species_.size() > 1 && a < species_.size(); ++a) {
    for (std::size_t b = a; b < species_.size(); ++b) {
      // Of two alike both have had a collision.
      const double per_sphere = (a == b ? 2 : 1) / static_cast<double>(species_.count(a));
      add(
          "collision_rate" + species_.suffix(a) + species_.suffix(b), "T^-1",
          [&](Means means) { return per_sphere * means[pair_bin(a, b)]; },
          theory_.collision_rate(a, b, temperature));
    }
  }
  found.columns = {{"time", "T", ColumnRole::argument, contacts.middles()},
                   {"collision_rate", "T^-1", ColumnRole::value, contacts.history(rate)}};
  if (has_walls_) {
    found.columns.push_back({"wall_rate", "T^-1", ColumnRole::value, contacts.history(wall_rate)});
  }
  for (double& time : found.columns.front().values) time += begin_.value();
  return found;
}

}  // namespace hardball
