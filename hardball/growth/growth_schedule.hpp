// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <tuple>

#include "hardball/describe/field.hpp"
#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/geometry/growth.hpp"
#include "hardball/measure/tally.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// How spheres are to grow, or to shrink.
struct GrowthRules {
  /// The rate of the mean diameter over the thermal speed, sqrt(kT/m) [1]; negative where spheres shrink.
  /// Collisions heat spheres that grow: the rate rises with their speed, and whenever that has doubled, all
  /// velocities are halved. Spheres that shrink cool: whenever their speed has halved, all velocities are
  /// doubled.
  double rate = 0.01;
  /// Growth ends when all spheres together fill this fraction of the accessible volume [1]; infinity for
  /// never, which is for spheres that grow alone: others would be points in a finite time.
  double until_packing_fraction = std::numeric_limits<double>::infinity();
  /// Growth ends when PV/NkT, averaged over an epoch, exceeds this [1], and in any case when gaps have become
  /// so small that times do not resolve them.
  double until_compressibility = std::numeric_limits<double>::infinity();

  static constexpr auto fields() {
    return std::tuple{
        option("rate", &GrowthRules::rate,
               "the rate at which the mean diameter grows, over the thermal speed √(kT/m); negative if the "
               "spheres shrink",
               "0.01", "0.01"),
        option(
            "packing_fraction", &GrowthRules::until_packing_fraction, NumberRange::positive, "",
            "the fraction of the volume at which growth ends; spheres that shrink need it; if not given, "
            "growth ends where the largest sphere just fits the box and its walls, or by `compressibility`",
            "0.6"),
        option("compressibility", &GrowthRules::until_compressibility, NumberRange::positive, "",
               "PV/NkT, averaged over some collisions, beyond which growth ends", "1e4")};
  }
  friend bool operator==(const GrowthRules&, const GrowthRules&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.rate, self.until_packing_fraction, self.until_compressibility);
  }
};

/// An epoch, and what velocities are multiplied by when it begins: a power of two, which rounds nothing.
struct GrowthEpoch {
  Growth growth;
  double speed_factor = 1;
};

/// The epochs of a growth: each ends before spheres could jam in it, and before their temperature has
/// doubled. It is all a function of sums over the contacts so far, so that the history stays the same for
/// every engine. Source: docs/decisions/0033-growth-is-a-motion.md.
class HARDBALL_EXPORT GrowthSchedule {
 public:
  enum class State : std::uint8_t {
    measuring,      ///< Sizes are constant for a moment: how dense the spheres are is found out.
    growing,        ///< Spheres grow or shrink.
    reached,        ///< The packing fraction wanted is reached; sizes are constant from here on.
    over_pressure,  ///< The compressibility wanted is reached; sizes are constant from here on.
    no_room,        ///< The largest sphere just fits the box and its walls; sizes are constant from here on.
  };

  /// Error: the rate is zero or not finite; a limit is not positive, or lies where growth does not lead.
  explicit GrowthSchedule(const GrowthRules& rules);

  const GrowthRules& rules() const { return rules_; }
  State state() const { return state_; }
  bool is_over() const { return state_ >= State::reached; }
  /// PV/NkT of the last epoch in which there were contacts [1], walls not counted; NaN before.
  double compressibility() const { return compressibility_; }
  /// How often an epoch has begun.
  std::uint64_t epochs() const { return epochs_; }
  /// The energy that halving velocities has given to the spheres: negative, as it takes it [M L^2 T^-2].
  double energy() const { return energy_; }
  void note_energy(double given) { energy_ += given; }

  /// Begins in a world as it is at `now`, and returns the first epoch. Where spheres may be dense, sizes are
  /// constant at first, to find out `compressibility`, PV/NkT [1]; give it if it is known. Cost: O(n). Error:
  /// the spheres are at rest; they fill more of the volume than wanted, or, where they shrink, less; there is
  /// no volume to be filled.
  Growth begin(const World& world, const Tally& tally, const Time& now,
               std::optional<double> compressibility = {});
  /// When the epoch ends [T]; infinity when growth is over.
  double next() const { return end_; }
  /// The number of further contacts, far more than expected, after which spheres jam within the epoch: it
  /// must be ended.
  std::uint64_t contacts_left(const Tally& tally, std::size_t spheres) const;
  /// Ends the epoch with the contacts that round to the same double as `moment`, if it lasts longer.
  void end_by(const Time& moment) {
    if (!(moment.high < end_)) return;
    end_ = moment.high;
    is_last_ = false;
  }
  /// The epoch that begins at `moment`, which rounds to next(). Cost: O(n).
  GrowthEpoch act(const World& world, const Tally& tally, const Time& moment);

 private:
  friend class Persistence;
  GrowthSchedule() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.rules_, self.state_, self.target_, self.at_target_, self.speed_, self.end_, self.wait_,
            self.step_, self.is_last_, self.epochs_, self.energy_, self.compressibility_, self.virial_,
            self.growth_work_, self.energy_integral_, self.collisions_, self.begin_);
  }
  bool restored() const { return state_ <= State::no_room; }

  void note_begin(const Tally& tally, const Time& now);
  Growth measure(const World& world, const Time& moment, double wait);
  GrowthEpoch grow(const World& world, const Time& moment, double steepness);
  Growth stop(const Time& moment, double scale, State state);

  GrowthRules rules_;
  State state_ = State::measuring;
  double target_ = 0;  // scale; infinite or zero for none
  State at_target_ = State::reached;
  double speed_ = 0;  // thermal, at the begin
  double end_ = std::numeric_limits<double>::infinity();
  double wait_ = 0;  // the duration of the epoch, while measuring
  double step_ = 0;  // by which fraction sizes change in the epoch
  bool is_last_ = false;
  std::uint64_t epochs_ = 0;
  double energy_ = 0;
  double compressibility_ = std::numeric_limits<double>::quiet_NaN();
  // Of the tally when the epoch began.
  double virial_ = 0;
  double growth_work_ = 0;
  double energy_integral_ = 0;
  std::uint64_t collisions_ = 0;
  Time begin_;
};

template <>
inline constexpr std::array<std::string_view, 5> kNames<GrowthSchedule::State>{
    "measuring", "growing", "reached", "over_pressure", "no_room"};

}  // namespace hardball
