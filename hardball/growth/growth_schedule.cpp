// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/growth/growth_schedule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/numbers/cube_root.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/world/setting.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

constexpr const char* kWhere = "growth";

// The most that sizes change in an epoch: cells are made for the largest, and more would cost candidates.
constexpr double kLargestStep = 0.02;
// Below these packing fractions no such step is too large: nothing jams.
constexpr double kDilute = 0.45;
constexpr double kDiluteDiscs = 0.6;
// The most that the logarithm of the energy is to change.
constexpr double kHeating = 0.6;
// How much larger than the last a step may be.
constexpr double kWidening = 4;

// Where spheres are packed more tightly, coordinates and times do not resolve their gaps.
constexpr double kMostCompressibility = 1e13;

// What sets the rate: lengths and times of the thermal motion.
struct Scales {
  double diameter = 0;  // the mean of twice the base radius [L]
  double speed = 0;     // sqrt(kT/m) [L/T]
};

Scales scales_of(const World& world, const Time& moment) {
  ExactSum diameter;
  ExactSum mass;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    diameter += 2 * world.base_radius(slot);
    mass += world.mass(slot);
  }
  const auto spheres = static_cast<double>(world.size());
  const double dimensions = world.box().dimensions() == 2 ? 2 : 3;
  return {diameter.value() / spheres,
          std::sqrt(2 * kinetic_energy(world, moment) / (dimensions * mass.value()))};
}

// Whether nothing can be near jamming: few spheres, and those between walls, may jam at any density.
bool is_dilute(const World& world, double packing_fraction) {
  constexpr std::size_t kMany = 32;
  return packing_fraction < (world.box().is_flat() ? kDiluteDiscs : kDilute) && !has_walls(world) &&
         world.size() >= kMany;
}

// Whether the time between the contacts of a sphere is more than rounding: a sphere that is locked among
// walls exerts no pressure on others.
bool are_resolved(const Time& moment, double between_contacts) {
  constexpr double kFewest = 8;
  return between_contacts > kFewest * (std::nextafter(moment.high, kNever.high) - moment.high);
}

double root_of(const Box& box, double volume_ratio) {
  return box.is_flat() ? std::sqrt(volume_ratio) : cube_root(volume_ratio);
}

// d ln E / d ln s of spheres that grow, without walls.
double steepness_at(double compressibility) {
  return 2 * std::max(0.0, compressibility - 1);
}

}  // namespace

GrowthSchedule::GrowthSchedule(const GrowthRules& rules) : rules_(rules) {
  if (rules.rate == 0 || !std::isfinite(rules.rate)) {
    throw Error("the rate is " + to_text(rules.rate), kWhere, "give a finite number that is not zero");
  }
  if (rules.rate < 0 || rules.until_packing_fraction < std::numeric_limits<double>::infinity())
    check_positive(rules.until_packing_fraction, "packing_fraction", kWhere);
  if (!(rules.until_compressibility > 1)) {
    throw Error("the compressibility is " + to_text(rules.until_compressibility), kWhere,
                "give a number above one");
  }
}

void GrowthSchedule::note_begin(const Tally& tally, const Time& now) {
  ++epochs_;
  begin_ = now;
  virial_ = tally.virial();
  growth_work_ = tally.growth_work();
  energy_integral_ = tally.energy_integral(now);
  collisions_ = tally.collisions() + tally.wall_contacts();
}

// Energies that double take some .6 / rate contacts of each sphere. Few spheres, and those next to walls, may
// lock so suddenly that the epoch is planned beyond that: then contacts would follow each other ever faster.
std::uint64_t GrowthSchedule::contacts_left(const Tally& tally, std::size_t spheres) const {
  constexpr double kDoublings = 4;
  constexpr double kAnyway = 64;
  if (state_ != State::growing) return std::numeric_limits<std::uint64_t>::max();
  const double most = static_cast<double>(spheres) * (kAnyway + 0.6 * kDoublings / std::fabs(rules_.rate));
  const std::uint64_t done = tally.collisions() + tally.wall_contacts() - collisions_;
  constexpr double kCountable = 1e18;
  const auto allowed = static_cast<std::uint64_t>(std::min(most, kCountable));
  return allowed > done ? allowed - done : 0;
}

Growth GrowthSchedule::begin(const World& world, const Tally& tally, const Time& now,
                             std::optional<double> compressibility) {
  const double present = packing_fraction(world, now);
  const bool ends = std::isfinite(rules_.until_packing_fraction);
  if (ends && !(present > 0)) {
    throw Error("there is no volume that the spheres could fill", kWhere,
                "give the box walls or periods, or no packing fraction to grow to");
  }
  if (ends &&
      (rules_.rate > 0 ? present > rules_.until_packing_fraction : present < rules_.until_packing_fraction)) {
    throw Error("the spheres fill " + to_text(present) + " of the volume, and are to " +
                    (rules_.rate > 0 ? "grow" : "shrink") + " to " + to_text(rules_.until_packing_fraction),
                kWhere, "reverse the rate, or give another packing fraction");
  }
  const Scales scales = scales_of(world, now);
  if (!(scales.speed > 0)) {
    throw Error("the spheres are at rest, and the rate is relative to their speed", kWhere,
                "give them a temperature");
  }
  const double scale = world.motion().scale_at(now);
  target_ = std::numeric_limits<double>::infinity();
  if (ends) target_ = scale * root_of(world.box(), rules_.until_packing_fraction / present);
  constexpr double kRounding = 1 - 0x1p-30;
  const double room = kRounding * largest_fitting_radius(world.box(), world.surfaces()) *
                      world.motion().largest_scale() / world.largest_radius();
  at_target_ = target_ < room ? State::reached : State::no_room;
  if (rules_.rate > 0) target_ = std::max(scale, std::min(target_, room));
  note_begin(tally, now);
  speed_ = scales.speed;
  step_ = kLargestStep;
  if (compressibility) return grow(world, now, steepness_at(*compressibility)).growth;
  if (is_dilute(world, present)) return grow(world, now, 0).growth;
  constexpr double kShortest = 0x1p-40;
  return measure(world, now, kShortest * scale * scales.diameter / scales.speed);
}

// Near jamming contacts follow each other so closely that growth of any given amount may never end. So
// windows of constant sizes, each longer than the last, find out first how often they come.
Growth GrowthSchedule::measure(const World& world, const Time& moment, double wait) {
  state_ = State::measuring;
  wait_ = wait;
  end_ = std::max(rounded_down(moment) + wait, std::nextafter(moment.high, kNever.high));
  return {moment, kNever, world.motion().scale_at(moment), 0};
}

GrowthEpoch GrowthSchedule::act(const World& world, const Tally& tally, const Time& moment) {
  const double energy = tally.energy_integral(moment) - energy_integral_;
  const double virial = tally.virial() - virial_;
  const double gained = tally.growth_work() - growth_work_;
  const std::uint64_t contacts = tally.collisions() + tally.wall_contacts() - collisions_;
  const double elapsed = duration(begin_, moment);
  if (contacts > 0) compressibility_ = 1 + virial / (2 * energy);
  note_begin(tally, moment);
  const double scale = world.motion().scale_at(moment);
  if (state_ == State::measuring) {
    const Scales scales = scales_of(world, moment);
    const double flight = scale * scales.diameter / scales.speed;
    constexpr double kLonger = 32;
    if (contacts < world.size() && wait_ < flight)
      return {measure(world, moment, std::min(kLonger * wait_, flight))};
    return grow(world, moment, contacts > 0 ? steepness_at(compressibility_) : 0);
  }
  // The growth of the energy by that of the sizes: what walls do counts, too.
  const double change = std::fabs(world.motion().growth().rate) * elapsed / scale;
  const double steepness = std::fabs(gained) * elapsed / (energy * change);
  if (is_last_) return {stop(moment, target_, at_target_)};
  if (compressibility_ > std::min(rules_.until_compressibility, kMostCompressibility) ||
      !are_resolved(moment, elapsed / (static_cast<double>(contacts) / static_cast<double>(world.size()))))
    return {stop(moment, scale, State::over_pressure)};
  return grow(world, moment, steepness);
}

// An epoch in which sizes change as little as the energy allows, `steepness` being d ln E / d ln s.
GrowthEpoch GrowthSchedule::grow(const World& world, const Time& moment, double steepness) {
  state_ = State::growing;
  const Scales scales = scales_of(world, moment);
  const double scale = world.motion().scale_at(moment);
  // Not even for a moment: the largest sphere may touch its own image already.
  if (scale == target_) return {stop(moment, target_, at_target_)};
  double factor = 1;
  while (factor * scales.speed >= 2 * speed_) factor /= 2;
  while (factor * scales.speed < speed_ / 2) factor *= 2;
  const double rate = rules_.rate * factor * scales.speed / scales.diameter;
  step_ = std::min({kLargestStep, kWidening * step_, kHeating / steepness});
  const double to_target = std::fabs(target_ - scale);
  is_last_ = step_ * scale >= to_target;
  const double wait = (is_last_ ? to_target : step_ * scale) / std::fabs(rate);
  const double shortest = std::nextafter(moment.high, kNever.high);
  end_ = std::max(rounded_down(moment) + wait, shortest);
  if (end_ == shortest && !is_last_) return {stop(moment, scale, State::over_pressure), factor};
  check_moment(Time(end_), kWhere);
  return {{moment, Time(end_), scale, rate}, factor};
}

Growth GrowthSchedule::stop(const Time& moment, double scale, State state) {
  state_ = state;
  end_ = kNever.high;
  return {moment, kNever, scale, 0};
}

}  // namespace hardball
