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

/// At equal intervals all velocities are scaled so that the temperature is exact: that of the measure
/// `temperature`, 2 E / f, with E relative to the common drift along axes without external forces. The
/// drift stays, and with it the momentum of a periodic box. Spheres without relative motion do not change. In
/// a sheared box all of it is relative to the flow.
///
/// With slabs, velocities are relative to the mean in each slab across y: to the actual flow, whose profile
/// may be unknown or not linear. Source: Woodcock, Chem. Phys. Lett. 10 (1971) 257; Evans and Morriss, Phys.
/// Rev. Lett. 56 (1986) 2172.
class HARDBALL_EXPORT Rescale {
 public:
  static constexpr std::string_view kName = "rescale";
  static constexpr std::string_view kMeaning = "all velocities are scaled";
  static constexpr auto fields() {
    return std::tuple{
        temperature_field(&Rescale::temperature), every_field(&Rescale::every),
        Field<std::size_t (Rescale::*)() const>{
            .name = "slabs",
            .get = &Rescale::slabs,
            .meaning =
                "the number of slabs across y, each of which keeps its mean velocity: velocities are scaled "
                "relative to it, whatever the profile of the flow. If not given, they are scaled relative to "
                "the mean of all spheres and to the flow of the box",
            .example = "10",
            .is_required = false,
            .least = 1,
            .most = 10000}};
  }

  /// `temperature` is k T [M L^2 T^-2]; `every` [T] the interval; `slabs` their number, zero for none. Error:
  /// temperature or interval is not positive.
  Rescale(double temperature, double every, std::size_t slabs = 0);

  double temperature() const { return temperature_; }
  double every() const { return times_.every(); }
  std::size_t slabs() const { return slabs_; }

  /// Starts at `now` [T]. Error: there are slabs, and the box is open along y.
  void begin(const World& world, double now, std::uint64_t seed);
  double next() const { return times_.next(); }
  /// Appends the new velocities in the order of ids, and advances to the next time. Cost: O(n).
  void act(const World& world, const Time& moment, std::vector<NewVelocity>& changes);

 private:
  friend class Persistence;
  Rescale() : Rescale(1, 1) {}
  static void persist(auto& archive, auto& self) { archive(self.temperature_, self.times_, self.slabs_); }

  void act_in_slabs(const World& world, const Time& moment, std::vector<NewVelocity>& changes) const;

  double temperature_;
  Intervals times_;
  std::size_t slabs_ = 0;
};

}  // namespace hardball
