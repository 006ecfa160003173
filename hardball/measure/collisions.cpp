// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/collisions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "hardball/measure/reasons.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

// Along any direction in the space of all velocities, scaled by the square roots of the masses, the motion of
// an isolated system has one component, u, distributed as (1 - u^2 / 2E)^((f - 3) / 2): uniform on a sphere
// in f dimensions. Pairs meet in proportion to it. For large f this is Rayleigh's distribution, u exp(-u^2 /
// 2kT) / kT.
class MeetingSpeed {
 public:
  explicit MeetingSpeed(const ThermalMotion& motion)
      : twice_energy_(2 * motion.energy), freedom_(motion.degrees_of_freedom) {}

  double mean() const {
    const double gammas = std::exp(std::lgamma((freedom_ + 1) / 2) - std::lgamma(freedom_ / 2));
    return std::sqrt(twice_energy_ * std::numbers::pi) / freedom_ * gammas;
  }
  double mean_square() const { return 2 * twice_energy_ / (freedom_ + 1); }
  /// The probability of less than `u`.
  double below(double u) const {
    const double share = std::min(u * u / twice_energy_, 1.0);
    return 1 - std::exp((freedom_ - 1) / 2 * std::log1p(-share));
  }

 private:
  double twice_energy_;
  double freedom_;
};

double reduced_mass(const SpeciesList& species, std::size_t a, std::size_t b) {
  return species.mass(a) * species.mass(b) / (species.mass(a) + species.mass(b));
}

// Wide enough for all but one in 10^7 of the lightest pair.
double histogram_width(const World& world, const ThermalMotion& motion) {
  constexpr double kDeviations = 6;
  double lightest = std::numeric_limits<double>::infinity();
  for (Slot slot = 0; slot < world.size(); ++slot) lightest = std::min(lightest, world.mass(slot));
  const double width = kDeviations * std::sqrt(motion.temperature() * 2 / lightest);
  return width > 0 ? width : 1;
}

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

void CollisionRate::record(const Contact& contact) {
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

void CollisionRate::add_results(const Scene& scene, Measurement& found) const {
  CollisionRate up_to_now = *this;
  up_to_now.advance(scene.now());
  const BlockAverage& whole = up_to_now.contacts_;
  const FunctionOfMeans rate = [&](Means means) { return 2 * means[kCollisions] / spheres_; };
  const FunctionOfMeans wall_rate = [&](Means means) { return means[kWalls] / spheres_; };
  const Transient transient = find_transient(whole, std::array{rate}, scene.settled());
  transient.note_in(found);
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
    const Estimate estimate = per_sphere * contacts.histogram(bin, 1).front();
    add(std::move(name), "T^-1", estimate, theory);
    return estimate;
  };
  found.add("collisions", "1", Estimate{whole.total(kCollisions)}).reason = kCounted;
  if (has_walls_) found.add("wall_contacts", "1", Estimate{whole.total(kWalls)}).reason = kCounted;
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
  found.add("collision_rate", "T^-1", whole.history(rate));
  if (has_walls_) found.add("wall_rate", "T^-1", whole.history(wall_rate));
  if (theory_.is_ideal() && transient.is_over) leave_quantities_open(found, kVelocitiesOfTheStart);
}

ImpactSpeeds::ImpactSpeeds(const Scene& scene)
    : species_(scene.species()),
      motion_(scene.thermal_motion()),
      begin_(scene.now()),
      width_(histogram_width(scene.world(), motion_) / kBins),
      bins_per_speed_(1 / width_),
      average_(kPairs + species_.size() * species_.size()) {}

void ImpactSpeeds::record(const Contact& contact) {
  if (!contact.is_collision() || contact.step.happens()) return;
  const double speed = contact.impact_speed();
  const double bin = speed * bins_per_speed_;
  if (bin < kBins) average_.put(static_cast<std::size_t>(bin), 1);
  average_.put(kSpeed, speed);
  average_.put(kSpeedSquare, speed * speed);
  average_.put(kPairs + species_.of(contact.first) * species_.size() + species_.of(contact.second), 1);
  average_.close_sample(duration(begin_, contact.time));
}

void ImpactSpeeds::add_results(const Scene& scene, Measurement& found) const {
  const MeetingSpeed theory(motion_);
  const BlockAverage average = without_transient(average_, std::array{mean_of(kSpeed)}, scene, found);
  // The sum over pairs of species, weighted by their collisions, of a function of their reduced mass.
  const bool is_equilibrium = scene.has_equilibrium(motion_);
  const auto over_pairs = [&](const auto& of_mass) {
    double sum = 0;
    for (std::size_t a = 0; a < species_.size(); ++a) {
      for (std::size_t b = 0; b < species_.size(); ++b) {
        const double share = average.mean(kPairs + a * species_.size() + b);
        if (share != 0) sum += share * of_mass(reduced_mass(species_, a, b));
      }
    }
    return is_equilibrium && average_.samples() > 0 ? sum : kNoNumber;
  };
  found.add("mean_impact_speed", "L T^-1", average.ratio(kSpeed),
            over_pairs([&](double mass) { return theory.mean() / std::sqrt(mass); }));
  found.add("mean_square_impact_speed", "L^2 T^-2", average.ratio(kSpeedSquare),
            over_pairs([&](double mass) { return theory.mean_square() / mass; }));
  const auto edge = [this](std::size_t bin) { return static_cast<double>(bin) * width_; };
  found.add_argument("impact_speed", "L T^-1",
                     tabulated(kBins, [&](std::size_t bin) { return (edge(bin) + edge(bin + 1)) / 2; }));
  found.add("probability_density", "L^-1 T", average.histogram(0, kBins) / width_,
            tabulated(kBins, [&](std::size_t bin) {
              return over_pairs([&](double mass) {
                const auto below = [&](double speed) { return theory.below(speed * std::sqrt(mass)); };
                return (below(edge(bin + 1)) - below(edge(bin))) / width_;
              });
            }));
  if (scene.fluid().is_ideal() && found.is_transient_over) {
    leave_quantities_open(found, kVelocitiesOfTheStart);
  }
}

}  // namespace hardball
