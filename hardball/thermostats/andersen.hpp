// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/thermostats/thermostat_fields.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Every sphere gets a new velocity from Maxwell's distribution, as if a heat bath had hit it, at the times
/// of a Poisson process of its own; in a sheared box, relative to the flow. Elastic spheres so sample the
/// canonical ensemble. Total momentum is not conserved. Source: Andersen, J. Chem. Phys. 72 (1980) 2384.
class HARDBALL_EXPORT Andersen {
 public:
  static constexpr std::string_view kName = "andersen";
  static constexpr std::string_view kMeaning =
      "each sphere gets a new velocity from Maxwell's distribution at random times of its own";
  static constexpr auto fields() {
    return std::tuple{temperature_field(&Andersen::temperature),
                      Field{"rate", &Andersen::rate, NumberRange::positive, "1/T",
                            "how often a sphere gets a new velocity, on average", "0.5"}};
  }

  /// `temperature` is k T [M L^2 T^-2]; `rate` that of each sphere's events [1/T]. Error: one is not
  /// positive.
  Andersen(double temperature, double rate);

  double temperature() const { return temperature_; }
  double rate() const { return rate_; }

  /// Starts with the spheres of a world, at `now` [T]. Cost: O(n).
  void begin(const World& world, double now, std::uint64_t seed);
  /// A sphere has been added. Cost: O(log n).
  void add(SphereId sphere, double now);
  /// A sphere has been removed. Cost: O(n).
  void remove(SphereId sphere);

  /// When the next event happens [T]; infinity if there are no spheres.
  double next() const;
  /// Appends the new velocity of the next event, the one with the lowest id at that time, and moves on to the
  /// one after it. Cost: O(log n).
  void act(const World& world, const Time& moment, std::vector<NewVelocity>& changes);

 private:
  friend class Persistence;
  Andersen() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.temperature_, self.rate_, self.seed_, self.due_);
  }
  bool restored() const;

  // An event of a sphere, the `count`-th, counted from one.
  struct Due {
    double time = 0;
    SphereId sphere = 0;
    std::uint64_t count = 0;
    static void persist(auto& archive, auto& self) { archive(self.time, self.sphere, self.count); }
  };

  static bool is_later(const Due& a, const Due& b) {
    return a.time != b.time ? a.time > b.time : a.sphere > b.sphere;
  }
  double wait(Random& random) const;

  double temperature_;
  double rate_;
  std::uint64_t seed_ = 0;
  std::vector<Due> due_;  // one for each sphere; a heap, the earliest first
};

}  // namespace hardball
