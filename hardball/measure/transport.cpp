// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/transport.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hardball/measure/diffusion.hpp"
#include "hardball/measure/reasons.hpp"
#include "hardball/measure/sampling_schedule.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {
namespace {

using Rates = CollectiveMoment::Sums;

// What a moment gains per time by the flight of one sphere, and by one collision.
using FlightOf = void (*)(const TransportConditions&, double mass, const Vec3& velocity, std::size_t species,
                          Rates& rates);
using TransferOf = void (*)(const TransportConditions&, const Contact& contact, Rates& jump);

using Theory = double (FluidTheory::*)(double temperature) const;

// A coefficient: how its moment is made, and what is known about it.
struct Kind {
  const char* quantity;
  const char* unit;
  Rates weights;  // of squares; those in two dimensions differ
  Rates weights_of_discs;
  bool has_mean = false;
  FlightOf flight;
  TransferOf transfer;
  // By which the slope is multiplied.
  double (*scale)(const TransportConditions&, double temperature);
  // Enskog's theory, what is expected, and by which fraction that may be off; null without a theory.
  Theory enskog = nullptr;
  Theory expected = nullptr;
  double tolerance = 0;
};

void no_transfer(const TransportConditions&, const Contact&, Rates&) {}

Vec3 momentum_of_second(const Contact& contact) {
  return contact.second_mass * (contact.after.second - contact.before.second);
}

// xy, xz, yz, and half the differences of xx, yy and zz: of the square of each in turn an isotropic fluid has
// as much.
void add_deviator(const Vec3& a, const Vec3& b, Rates& sums) {
  sums[0] += (a.x * b.y + a.y * b.x) / 2;
  sums[1] += (a.x * b.z + a.z * b.x) / 2;
  sums[2] += (a.y * b.z + a.z * b.y) / 2;
  sums[3] += (a.x * b.x - a.y * b.y) / 2;
  sums[4] += (a.y * b.y - a.z * b.z) / 2;
  sums[5] += (a.z * b.z - a.x * b.x) / 2;
}

void shear_flight(const TransportConditions&, double mass, const Vec3& velocity, std::size_t, Rates& rates) {
  add_deviator(mass * velocity, velocity, rates);
}
void shear_transfer(const TransportConditions&, const Contact& contact, Rates& jump) {
  add_deviator(momentum_of_second(contact), contact.separation, jump);
}

void compression_flight(const TransportConditions& conditions, double mass, const Vec3& velocity, std::size_t,
                        Rates& rates) {
  rates[0] += mass * dot(velocity, velocity) / conditions.dimensions;
}
void compression_transfer(const TransportConditions& conditions, const Contact& contact, Rates& jump) {
  jump[0] += dot(momentum_of_second(contact), contact.separation) / conditions.dimensions;
}

void heat_flight(const TransportConditions&, double mass, const Vec3& velocity, std::size_t, Rates& rates) {
  const double energy = mass * dot(velocity, velocity) / 2;
  for (std::size_t axis = 0; axis < kAxes; ++axis) rates[axis] += energy * velocity[axis];
}
void heat_transfer(const TransportConditions& conditions, const Contact& contact, Rates& jump) {
  const Vec3 mean = 0.5 * (contact.before.second + contact.after.second) - conditions.motion.drift;
  const double energy = dot(momentum_of_second(contact), mean);
  for (std::size_t axis = 0; axis < kAxes; ++axis) jump[axis] += energy * contact.separation[axis];
}

void mixing_flight(const TransportConditions& conditions, double, const Vec3& velocity, std::size_t species,
                   Rates& rates) {
  const SpeciesList& all = conditions.species;
  const double factor = species == 0 ? all.fraction(1) : -all.fraction(0);
  for (std::size_t axis = 0; axis < kAxes; ++axis) rates[axis] += factor * velocity[axis];
}

double per_volume_and_temperature(const TransportConditions& conditions, double temperature) {
  return 1 / (2 * conditions.volume * temperature);
}
double of_heat(const TransportConditions& conditions, double temperature) {
  return 1 / (2 * conditions.volume * temperature * temperature);
}
double of_mixing(const TransportConditions& conditions, double) {
  const SpeciesList& all = conditions.species;
  const auto spheres = static_cast<double>(all.count(0) + all.count(1));
  return 1 / (2 * spheres * all.fraction(0) * all.fraction(1));
}

constexpr double kThird = 1.0 / 3;

// By the number of the coefficient.
constexpr std::array<Kind, 4> kKinds{{
    {.quantity = "viscosity",
     .unit = "M L^-1 T^-1",
     .weights = {0.2, 0.2, 0.2, 2.0 / 15, 2.0 / 15, 2.0 / 15},
     .weights_of_discs = {0.5, 0, 0, 0.5, 0, 0},
     .flight = shear_flight,
     .transfer = shear_transfer,
     .scale = per_volume_and_temperature,
     .enskog = &FluidTheory::enskog_viscosity,
     .expected = &FluidTheory::viscosity,
     .tolerance = FluidTheory::kViscosityTolerance},
    {.quantity = "bulk_viscosity",
     .unit = "M L^-1 T^-1",
     .weights = {1},
     .weights_of_discs = {1},
     .has_mean = true,
     .flight = compression_flight,
     .transfer = compression_transfer,
     .scale = per_volume_and_temperature,
     .enskog = &FluidTheory::enskog_bulk_viscosity,
     .expected = &FluidTheory::enskog_bulk_viscosity,
     .tolerance = FluidTheory::kBulkViscosityTolerance},
    {.quantity = "thermal_conductivity",
     .unit = "L^-1 T^-1",
     .weights = {kThird, kThird, kThird},
     .weights_of_discs = {0.5, 0.5},
     .flight = heat_flight,
     .transfer = heat_transfer,
     .scale = of_heat,
     .enskog = &FluidTheory::enskog_thermal_conductivity,
     .expected = &FluidTheory::enskog_thermal_conductivity,
     .tolerance = FluidTheory::kThermalConductivityTolerance},
    {.quantity = "mutual_diffusion_constant",
     .unit = "L^2 T^-1",
     .weights = {kThird, kThird, kThird},
     .weights_of_discs = {0.5, 0.5},
     .flight = mixing_flight,
     .transfer = no_transfer,
     .scale = of_mixing},
}};

constexpr const Kind& kind_of(Coefficient coefficient) {
  return kKinds[static_cast<std::size_t>(coefficient)];
}

// After this many mean free times what is left of correlations decays slowly. The velocities of single
// spheres stay correlated longer than collective ones: at high density they change the slope by another
// percent after the least time, which matters in runs long enough to resolve it.
struct FreeTimes {
  double least;
  double wanted;
};
constexpr FreeTimes kFreeTimesOfAll{8, 8};
constexpr FreeTimes kFreeTimesOfOne{16, 32};

std::string obstacle_of(const Scene& scene) {
  const World& world = scene.world();
  if (!world.box().is_all(Boundary::periodic)) return "transport is measured where all axes are periodic";
  if (!world.surfaces().empty() || !world.motion().is_straight())
    return "transport is measured without walls and gravity";
  if (world.has_steps()) return "transport is measured without potentials of steps";
  if (world.interactions().has_passing() || world.kinematic_count() > 0)
    return "transport is measured of spheres that all deflect each other";
  if (!world.interactions().are_elastic()) return "transport is measured of elastic spheres";
  if (world.size() < 2 || !(scene.thermal_motion().energy > 0)) return "nothing moves";
  return "";
}

// The curve, what it ends in, and where that was read. `scale`: by which slopes are multiplied.
void add_coefficient(Measurement& found, const MomentLags& lags, const TransportConditions& conditions,
                     const Scene& scene, const FreeTimes& free_times, double scale, Quantity quantity,
                     double enskog) {
  std::vector<double> times;
  std::vector<Estimate> slopes;
  for (std::size_t level = 0; level < lags.levels(); ++level) {
    const Estimate slope = lags.slope(level);
    if (std::isnan(slope.value)) continue;
    times.push_back(lags.lag(level));
    slopes.push_back(scale * slope);
  }
  quantity.reason = conditions.objection(scene);
  MomentLags::Plateau plateau;
  if (quantity.reason.empty()) {
    plateau = lags.plateau(free_times.least * conditions.mean_free_time,
                           free_times.wanted * conditions.mean_free_time);
    quantity.reason = plateau.reason;
    quantity.value = scale * plateau.slope.value;
    quantity.error = scale * plateau.slope.error;
    require_not_negative(quantity);
  }
  add_with_enskog(found, quantity, enskog);
  if (plateau.lag > 0) found.add(quantity.name + "_lag", "T", Estimate{plateau.lag}).reason = kLagChosen;
  found.is_logarithmic_in_argument = true;
  if (times.empty()) return;
  found.add_argument("lag", "T", std::move(times));
  found.add(quantity.name, quantity.unit, slopes);
}

}  // namespace

TransportConditions::TransportConditions(const Scene& scene)
    : obstacle(obstacle_of(scene)),
      motion(scene.thermal_motion()),
      theory(scene.fluid()),
      species(scene.species()),
      volume(scene.world().box().volume()),
      dimensions(static_cast<double>(scene.world().box().dimensions())),
      mean_free_time(hardball::mean_free_time(scene.statistics())),
      begin(scene.now()) {}

std::string TransportConditions::objection(const Scene& scene) const {
  if (!obstacle.empty()) return obstacle;
  if (dimensions == 2) return "in two dimensions it grows with the size of the system";
  if (!scene.has_equilibrium(motion)) return "the energy has changed since the start";
  return "";
}

template <Coefficient kCoefficient>
CollectiveTransport<kCoefficient>::CollectiveTransport(const Scene& scene, double base) : conditions_(scene) {
  const Kind& kind = kind_of(kCoefficient);
  const SpeciesList& species = conditions_.species;
  if (conditions_.obstacle.empty() && kCoefficient == Coefficient::thermal_conductivity &&
      !species.is_one_kind())
    conditions_.obstacle = "the thermal conductivity is measured of spheres of one kind";
  if (conditions_.obstacle.empty() && kCoefficient == Coefficient::mutual_diffusion && species.size() != 2)
    conditions_.obstacle = "mutual diffusion is measured of two species";
  const Rates& weights = conditions_.dimensions == 2 ? kind.weights_of_discs : kind.weights;
  const double free_time = expected_pace(scene.statistics()).free_time;
  const double interval = conditions_.obstacle.empty() ? irrational_from(base * free_time) : 1;
  moment_ = CollectiveMoment(
      scene.now(), MomentLags(interval, std::vector<double>(weights.begin(), weights.end()), kind.has_mean));
  if (!conditions_.obstacle.empty()) return;
  const World& world = scene.world();
  world.for_each_by_id([&](Slot slot) {
    contribute(world.mass(slot), world.velocity(slot, scene.now()), species.of(world.id(slot)), 1);
  });
}

template <Coefficient kCoefficient>
void CollectiveTransport<kCoefficient>::contribute(double mass, const Vec3& velocity, std::size_t species,
                                                   double sign) {
  Rates flight{};
  kind_of(kCoefficient).flight(conditions_, mass, velocity - conditions_.motion.drift, species, flight);
  for (std::size_t k = 0; k < flight.size(); ++k) moment_.rates[k] += sign * flight[k];
}

template <Coefficient kCoefficient>
void CollectiveTransport<kCoefficient>::record(const Contact& contact) {
  if (!conditions_.obstacle.empty() || !contact.is_collision()) return;
  moment_.advance(contact.time);
  const std::size_t first = conditions_.species.of(contact.first);
  const std::size_t second = conditions_.species.of(contact.second);
  contribute(contact.first_mass, contact.before.first, first, -1);
  contribute(contact.first_mass, contact.after.first, first, 1);
  contribute(contact.second_mass, contact.before.second, second, -1);
  contribute(contact.second_mass, contact.after.second, second, 1);
  Rates jump{};
  kind_of(kCoefficient).transfer(conditions_, contact, jump);
  moment_.jump(jump);
}

template <Coefficient kCoefficient>
void CollectiveTransport<kCoefficient>::record(const VelocityChange& change) {
  if (!conditions_.obstacle.empty()) return;
  moment_.advance(change.time);
  const std::size_t species = conditions_.species.of(change.sphere);
  contribute(change.mass, change.before, species, -1);
  contribute(change.mass, change.after, species, 1);
}

template <Coefficient kCoefficient>
void CollectiveTransport<kCoefficient>::add_results(const Scene& scene, Measurement& found) const {
  const Kind& kind = kind_of(kCoefficient);
  const MomentLags lags = conditions_.obstacle.empty() ? moment_.lags_at(scene.now()) : moment_.lags();
  const double temperature = conditions_.motion.temperature();
  const auto value_of = [&](Theory theory) {
    return theory == nullptr ? kNoNumber : (conditions_.theory.*theory)(temperature);
  };
  const double expected = value_of(kind.expected);
  const double scale = conditions_.obstacle.empty() ? kind.scale(conditions_, temperature) : kNoNumber;
  add_coefficient(
      found, lags, conditions_, scene, kFreeTimesOfAll, scale,
      {.name = kind.quantity, .unit = kind.unit, .theory = expected, .tolerance = kind.tolerance * expected},
      value_of(kind.enskog));
}

template class CollectiveTransport<Coefficient::viscosity>;
template class CollectiveTransport<Coefficient::bulk_viscosity>;
template class CollectiveTransport<Coefficient::thermal_conductivity>;
template class CollectiveTransport<Coefficient::mutual_diffusion>;

SelfDiffusion::SelfDiffusion(const Scene& scene, double interval) : conditions_(scene) {
  constexpr std::size_t kMostFollowed = 1000;
  if (conditions_.obstacle.empty() && !conditions_.species.is_one_kind())
    conditions_.obstacle = "diffusion is measured of spheres of one kind";
  const std::size_t spheres = scene.world().size();
  const std::size_t followed = conditions_.obstacle.empty() ? std::min(spheres, kMostFollowed) : 0;
  for (std::size_t k = 0; k < followed; ++k) ranks_.push_back(k * spheres / followed);
  centers_.resize(followed);
  lags_ = MomentLags(interval, std::vector<double>(kAxes * followed, 1.0 / static_cast<double>(followed)));
}

void SelfDiffusion::sample(const Scene& scene) {
  if (ranks_.empty()) return;
  const double elapsed = duration(conditions_.begin, scene.now());
  // Sums of times are rounded.
  constexpr double kRounding = 1e-6;
  const double late = elapsed - static_cast<double>(samples_) * lags_.base();
  if (std::fabs(late) > kRounding * lags_.base()) return;
  std::vector<double> increment(kAxes * ranks_.size());
  for (std::size_t k = 0; k < ranks_.size(); ++k) {
    const Vec3 center = scene.unfolded_center(scene.world().slot_of_rank(ranks_[k]));
    const Vec3 moved = center - centers_[k] - lags_.base() * conditions_.motion.drift;
    for (std::size_t axis = 0; axis < kAxes; ++axis) increment[kAxes * k + axis] = moved[axis];
    centers_[k] = center;
  }
  if (samples_ > 0) lags_.add(increment, elapsed);
  ++samples_;
}

void SelfDiffusion::add_results(const Scene& scene, Measurement& found) const {
  const FluidTheory& theory = conditions_.theory;
  const double temperature = conditions_.motion.temperature();
  const double expected = theory.diffusion(temperature);
  add_coefficient(found, lags_, conditions_, scene, kFreeTimesOfOne, 1 / (2 * conditions_.dimensions),
                  {.name = "diffusion_constant",
                   .unit = "L^2 T^-1",
                   .theory = expected,
                   .tolerance = FluidTheory::kDiffusionTolerance * expected},
                  theory.enskog_diffusion(temperature));
  const Vec3& size = scene.world().box().size();
  const double missing = theory.diffusion_missing(temperature);
  if (size.x == size.y && size.y == size.z && !std::isnan(missing)) {
    Quantity infinite = found.quantities.front();
    infinite.name = "diffusion_constant_of_infinite_system";
    infinite.value += missing;
    infinite.theory += missing;
    found.quantities.push_back(std::move(infinite));
  }
}

bool SelfDiffusion::matches(const World& world) const {
  return conditions_.species.matches(world) &&
         ranges::all_of(ranks_, [&](std::size_t rank) { return rank < world.size(); });
}

}  // namespace hardball
