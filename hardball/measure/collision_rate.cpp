// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/collision_rate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "hardball/measure/reasons.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/statistics/qualification.hpp"
#include "hardball/statistics/transient.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

constexpr const char* kCount = "it is a count of this run";

}  // namespace

CollisionRate::CollisionRate(const Scene& scene)
    : species_(scene.species()),
      theory_(scene.fluid()),
      motion_(scene.thermal_motion()),
      spheres_(static_cast<double>(scene.world().size())),
      has_walls_(scene.world().box().is_any(Boundary::wall)),
      begin_(scene.now()),
      last_(scene.now()),
      contacts_(kPairs + species_.size() * species_.size()) {}

std::size_t CollisionRate::pair_bin(std::size_t a, std::size_t b) const {
  return kPairs + std::min(a, b) * species_.size() + std::max(a, b);
}

void CollisionRate::advance(const Time& now) {
  contacts_.close_sample(duration(begin_, now), duration(last_, now));
  last_ = now;
}

void CollisionRate::note(const Contact& contact) {
  if (contact.step.happens()) return advance(contact.time);
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
  std::size_t rank = 0;
  world.for_each_by_id([&](Slot slot) {
    const Vec3 velocity = peculiar_velocity(world, slot, scene.now());
    const double square = dot(velocity, velocity);
    double* const sums = speed_.open_bins(0, group_of(rank++));
    sums[kSpeed] += std::sqrt(square);
    sums[kSquare] += world.mass(slot) * square;
    ++sums[kSpheres];
  });
  speed_.close_sample(duration(begin_, scene.now()));
}

Measurement CollisionRate::result(const Scene& scene) const {
  Measurement found{.name = std::string(kName),
                    .title = "Collision rate",
                    .formula =
                        R"($\omega = 2 c / (N t)$ of $c$ collisions; mean free time $1 / \omega$, path )"
                        R"($\langle v \rangle / \omega$; theory: $\omega = \frac{2 d}{\sqrt{\pi}} (Z - 1) )"
                        R"(\frac{1}{\sigma} \sqrt{kT / m}$ for diameters $\sigma$ in $d$ dimensions)",
                    .source =
                        "Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, sections 5.2 "
                        "and 16.2"};
  CollisionRate up_to_now = *this;
  up_to_now.advance(scene.now());
  const BlockAverage& whole = up_to_now.contacts_;
  using Means = std::span<const double>;
  const FunctionOfMeans rate = [&](Means means) { return 2 * means[kCollisions] / spheres_; };
  const FunctionOfMeans wall_rate = [&](Means means) { return means[kWalls] / spheres_; };
  const Transient transient = find_transient(whole, std::array{rate}, scene.settled());
  const BlockAverage contacts = transient.left_out_of(whole);
  const BlockAverage speeds = transient.left_out_of(speed_);
  const bool is_conserved = is_energy_conserved(motion_, scene.thermal_motion());
  const double temperature = is_conserved ? motion_.temperature() : kNoNumber;
  const double expected = theory_.collision_rate(temperature);
  const auto add = [&](std::string name, const char* unit, const Estimate& estimate, double theory) {
    const double expectation = std::isfinite(theory) ? theory : kNoNumber;
    found.add(std::move(name), unit, estimate, expectation, theory_.tolerance() * expectation);
  };
  const auto add_rate = [&](std::string name, std::size_t bin, double per_sphere, double theory) {
    const Estimate rate = per_sphere * contacts.histogram(bin, 1).front();
    add(std::move(name), "T^-1", rate, theory);
    return rate;
  };
  found.add("collisions", "1", {whole.total(kCollisions)}).reason = kCount;
  if (has_walls_) found.add("wall_contacts", "1", {whole.total(kWalls)}).reason = kCount;
  const Estimate per_time = add_rate("collision_rate", kCollisions, 2 / spheres_, expected);
  // Without a collision there is no mean free time; from a few it is poorly known, as a reciprocal is not
  // symmetric.
  constexpr double kWell = 0.2;
  Estimate free_time;
  if (per_time.value > 0) free_time.value = 1 / per_time.value;
  if (per_time.error < kWell * per_time.value) {
    free_time.error = per_time.error * free_time.value * free_time.value;
  }
  add("mean_free_time", "T", free_time, 1 / expected);
  const Estimate speed = mean_speed(speeds, kSpeed, kSquare, kSpheres, is_conserved);
  add("mean_free_path", "L", speed * free_time, theory_.mean_speed(temperature) / expected);
  if (has_walls_) add_rate("wall_rate", kWalls, 1 / spheres_, kNoNumber);
  for (std::size_t a = 0; species_.size() > 1 && a < species_.size(); ++a) {
    for (std::size_t b = a; b < species_.size(); ++b) {
      // Of two spheres of the same species both have collided.
      add_rate("collision_rate" + species_.suffix(a) + species_.suffix(b), pair_bin(a, b),
               (a == b ? 2 : 1) / static_cast<double>(species_.count(a)),
               theory_.collision_rate(a, b, temperature));
    }
  }
  found.add_argument("time", "T", whole.middles(begin_.value()));
  found.add_values("collision_rate", "T^-1", whole.history(rate));
  if (has_walls_) found.add_values("wall_rate", "T^-1", whole.history(wall_rate));
  transient.note_in(found);
  if (theory_.is_ideal()) {
    for (Quantity& quantity : found.quantities) leave_open(quantity, kVelocitiesOfTheStart);
  }
  return found;
}

bool CollisionRate::restored() const {
  return contacts_.has(kPairs + species_.size() * species_.size()) && speed_.has(3, kSphereGroups);
}

bool CollisionRate::matches(const World& world) const {
  return species_.matches(world);
}

}  // namespace hardball
