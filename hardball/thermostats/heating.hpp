// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/thermostats/intervals.hpp"
#include "hardball/thermostats/thermostat_fields.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// White noise, as which a driven granular gas is often modeled: at equal intervals each component of each
/// velocity gets a normal random kick of variance strength * every. The mean kick is subtracted, so that the
/// total momentum stays; for n equal spheres this lowers the variance by one part in n.
/// Source: Williams and MacKintosh, Phys. Rev. E 54 (1996) R9; van Noije and Ernst, Granular Matter 1 (1998)
/// 57.
class HARDBALL_EXPORT Heating {
 public:
  static constexpr std::string_view kName = "heating";
  static constexpr std::string_view kMeaning = "all velocities get random kicks";
  static constexpr auto fields() {
    return std::tuple{
        Field{"strength", &Heating::strength, NumberRange::positive, "L²/T³",
              "how fast the kicks raise the mean square of each component of the velocities", "0.1"},
        every_field(&Heating::every)};
  }

  /// `strength` is d<v_x^2> / dt [L^2 T^-3], the same along y and z; `every` [T] the interval, short
  /// compared with the time between collisions for noise that is white to them. Error: one is not positive.
  Heating(double strength, double every);

  double strength() const { return strength_; }
  double every() const { return times_.every(); }

  /// Starts at `now` [T].
  void begin(const World& /*world*/, double now, std::uint64_t seed) {
    times_.begin(now);
    seed_ = seed;
  }
  double next() const { return times_.next(); }
  /// Appends the new velocities in the order of ids, and advances to the next time. Cost: O(n).
  void act(const World& world, const Time& moment, std::vector<NewVelocity>& changes);

 private:
  friend class Persistence;
  Heating() : Heating(1, 1) {}
  static void persist(auto& archive, auto& self) { archive(self.strength_, self.times_, self.seed_); }

  double strength_;
  Intervals times_;
  std::uint64_t seed_ = 0;
};

}  // namespace hardball
