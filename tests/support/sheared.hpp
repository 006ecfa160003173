// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "hardball/errors/error.hpp"
#include "hardball/interaction/bounce.hpp"
#include "hardball/interaction/merging.hpp"
#include "hardball/interaction/passing.hpp"
#include "hardball/interaction/response_table.hpp"
#include "hardball/numbers/random.hpp"
#include "support/random_world.hpp"

namespace hardball::support {

/// Makes small worlds in sheared boxes: two and three dimensions, boxes from a few diameters to many, slow
/// and fast shear in both directions, mixtures, and all kinds of contacts. Spheres are placed by trial
/// against all images of all others.
class ShearedWorldMaker {
 public:
  explicit ShearedWorldMaker(std::uint64_t seed) : random_(seed ^ 0x5ea7), seed_(seed) {}

  RandomWorld make() {
    choose_box();
    RandomWorld made;
    World world(box_);
    choose_response(world);
    const std::size_t wanted = 2 + below(chance(0.2) ? 90 : 40);
    for (std::size_t tries = 0; tries < 20 * wanted && world.size() < wanted; ++tries) try_sphere(world);
    made.world = std::move(world);
    made.restitution = restitution_;
    made.until = 3 * box_.size().x / (speed_ + std::fabs(box_.images().speed()));
    made.name = "sheared world " + to_text(seed_) + ": " + to_text(made.world.size()) + " spheres in " +
                to_text(box_.size().x / radius_ / 2) + " x " + to_text(box_.size().y / radius_ / 2) +
                " diameters, " + to_text(box_.images().speed() / speed_) + " times as fast";
    return made;
  }

 private:
  bool chance(double probability) { return random_.uniform() < probability; }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }
  double between(double low, double high) { return low + random_.uniform() * (high - low); }

  void choose_box() {
    is_flat_ = chance(0.3);
    radius_ = chance(0.7) ? 0.5 : std::ldexp(between(1, 2), static_cast<int>(below(60)) - 30);
    speed_ = chance(0.7) ? 1 : std::ldexp(between(1, 2), static_cast<int>(below(60)) - 30);
    // Small boxes leave no room for cells.
    const double usual = std::array{3.0, 7.0, 12.0, 25.0}[below(4)];
    const auto size = [&] { return 2 * radius_ * usual * between(0.7, 1.4); };
    const Boundary across = std::array{Boundary::periodic, Boundary::wall, Boundary::open}[below(3)];
    box_ = Box({Boundary::periodic, Boundary::periodic, is_flat_ ? Boundary::flat : across},
               {size(), size(), is_flat_ ? 0 : size()});
    Shear shear;
    if (chance(0.95)) {
      const double relative = std::pow(10, between(-2, 1.5));
      shear.rate = (chance(0.5) ? 1 : -1) * relative * speed_ / box_.size().y;
    }
    if (chance(0.5)) shear.offset = between(-3, 3) * box_.size().x;
    if (chance(0.1)) shear.offset *= 1e6;
    if (!shear.is_present()) shear.offset = 0.3 * box_.size().x;
    box_.set_shear(shear);
  }

  void choose_response(World& world) {
    restitution_ = chance(0.6) ? 1 : between(0.3, 1);
    BounceRules rules{.restitution = ConstantRestitution{restitution_}};
    if (restitution_ < 1) rules.elastic_below = 0.01 * speed_;
    is_rough_ = chance(0.2);
    if (is_rough_) rules.tangential_restitution = between(-1, 1);
    ResponseTable table;
    for (SpeciesId a = 0; a < 2; ++a) {
      table.set_wall(a, Bounce(rules));
      for (SpeciesId b = 0; b <= a; ++b) table.set(a, b, Bounce(rules));
    }
    if (chance(0.1)) table.set(1, 1, Passing());
    if (chance(0.1)) table.set(0, 1, Merging());
    world.set_interactions(table);
    has_kinematic_ = chance(0.15);
  }

  void try_sphere(World& world) {
    Sphere sphere;
    const Vec3 extent{box_.size().x, box_.size().y,
                      is_flat_                       ? 0
                      : std::isfinite(box_.size().z) ? box_.size().z
                                                     : 4 * radius_};
    sphere.radius = chance(0.7) ? radius_ : radius_ * between(0.3, 1);
    for (std::size_t axis = 0; axis < kAxes; ++axis) sphere.position[axis] = extent[axis] * random_.uniform();
    if (box_.is_wall(2)) sphere.position.z = between(sphere.radius, extent.z - sphere.radius);
    sphere.velocity = speed_ * random_.direction();
    if (is_flat_) sphere.velocity.z = 0;
    if (chance(0.7)) sphere.velocity.x += box_.flow_speed(sphere.position.y);
    if (chance(0.05)) sphere.velocity = {};
    sphere.mass = chance(0.8) ? 1 : between(0.1, 10);
    sphere.species = static_cast<SpeciesId>(below(2));
    if (is_rough_ && chance(0.5)) sphere.spin = {0, 0, speed_ / radius_ * between(-1, 1)};
    if (has_kinematic_ && chance(0.1)) sphere.mass = std::numeric_limits<double>::infinity();
    for (Slot other = 0; other < world.size(); ++other) {
      if (reaches(world, sphere, other)) return;
    }
    world.add(sphere);
  }

  // Whether a sphere would overlap any image of another at time zero.
  bool reaches(const World& world, const Sphere& sphere, Slot other) const {
    const double reach = 1.0001 * (sphere.radius + world.base_radius(other));
    const Vec3 apart = world.position(other, Time(0)) - sphere.position;
    const Vec3& size = box_.size();
    const double slid = std::remainder(box_.shear().offset, size.x);
    const int layers = box_.is_periodic(2) ? 2 : 0;
    for (int along = -3; along <= 3; ++along) {
      for (int above = -2; above <= 2; ++above) {
        for (int beside = -layers; beside <= layers; ++beside) {
          const Vec3 image =
              apart + Vec3{along * size.x + above * slid, above * size.y, beside == 0 ? 0 : beside * size.z};
          if (length(image) < reach) return true;
        }
      }
    }
    return false;
  }

  Random random_;
  std::uint64_t seed_;
  bool is_flat_ = false;
  bool is_rough_ = false;
  bool has_kinematic_ = false;
  double radius_ = 0.5;
  double speed_ = 1;
  double restitution_ = 1;
  Box box_;
};

inline RandomWorld make_sheared_world(std::uint64_t seed) {
  return ShearedWorldMaker(seed).make();
}

}  // namespace hardball::support
