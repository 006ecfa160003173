// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/step_attempts.hpp"

#include <cmath>
#include <numbers>

#include "hardball/measure/energy_gain.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {
namespace {

constexpr const char* kUnitOfEnergy = "M L^2 T^-2";

}  // namespace

StepAttempts::StepAttempts(const Scene& scene)
    : motion_(scene.thermal_motion()),
      total_energy_(energy(scene.world(), scene.now())),
      spheres_(static_cast<double>(scene.world().size())),
      begin_(scene.now()),
      last_(scene.now()),
      kinetic_(motion_.energy),
      potential_(step_energy(scene.world())),
      start_(potential_) {
  const StepTable& steps = scene.world().interactions().steps();
  std::size_t bins = kSteps;
  for (std::size_t number = 0; number < steps.size(); ++number) {
    first_bins_.push_back(bins);
    bins += kCounts * steps[static_cast<StepTable::Number>(number)].steps();
  }
  average_ = BlockAverage(bins);
}

void StepAttempts::advance(const Time& now) {
  const double elapsed = duration(last_, now);
  last_ = now;
  const double gained = potential_ - start_;
  double* const bins = average_.open_bins(0);
  bins[kPotential] += gained * elapsed;
  bins[kPotentialSquare] += gained * gained * elapsed;
  bins[kKinetic] += kinetic_ * elapsed;
  average_.close_sample(duration(begin_, now), elapsed);
}

void StepAttempts::record(const Contact& contact) {
  if (contact.step.happens()) {
    const std::size_t bin = bin_of(contact.step.potential, contact.step.step);
    const std::size_t direction = contact.step.is_outward ? kComeOut : kComeIn;
    average_.put(bin + direction, 1);
    if (contact.step.passes) average_.put(bin + direction + 1, 1);
  }
  advance(contact.time);
  potential_ += contact.step.gain();
  kinetic_ += energy_gain(contact.first_mass, contact.before.first, contact.after.first);
  if (contact.is_collision())
    kinetic_ += energy_gain(contact.second_mass, contact.before.second, contact.after.second);
}

void StepAttempts::record(const VelocityChange& change) {
  advance(change.time);
  is_driven_ = true;
  kinetic_ += energy_gain(change.mass, change.before, change.after);
}

void StepAttempts::add_results(const Scene& scene, Measurement& found) const {
  StepAttempts up_to_now = *this;
  up_to_now.advance(scene.now());
  const BlockAverage& whole = up_to_now.average_;
  const FunctionOfMeans energy = [this](Means means) { return (start_ + means[kPotential]) / spheres_; };
  const BlockAverage average = without_transient(whole, std::array{energy}, scene, found);
  found.add("potential_energy", kUnitOfEnergy, average.estimate(energy));
  add_heat_capacity(scene, average, found);
  const StepTable& steps = scene.world().interactions().steps();
  for (std::size_t number = 0; number < first_bins_.size(); ++number) {
    const StepPotential& potential = steps[static_cast<StepTable::Number>(number)];
    for (std::size_t step = 0; step < potential.steps(); ++step) {
      std::string suffix;
      if (first_bins_.size() > 1) suffix += "_" + std::to_string(number + 1);
      if (potential.steps() > 1 || !suffix.empty()) suffix += "_" + std::to_string(step + 1);
      add_step(scene, average, number, step, suffix, found);
    }
  }
  found.add_argument("time", "T", whole.middles(begin_.value()));
  found.add("potential_energy", kUnitOfEnergy, whole.history(energy));
}

// From the fluctuations of the kinetic energy, if the total one is conserved.
void StepAttempts::add_heat_capacity(const Scene& scene, const BlockAverage& average,
                                     Measurement& found) const {
  constexpr double kRounding = 1e-9;
  const double scale = motion_.energy + std::fabs(total_energy_);
  const double energy = hardball::energy(scene.world(), scene.now());
  const bool is_conserved = std::fabs(energy - total_energy_) <= kRounding * scale &&
                            scene.world().interactions().table().restitution() == 1.0 && !is_driven_;
  if (!is_conserved) {
    found.add("heat_capacity", "1", Estimate()).reason = "the total energy is not conserved";
    return;
  }
  const double freedom = motion_.degrees_of_freedom;
  found.add("heat_capacity", "1", average.estimate([&](Means means) {
    const double variance = means[kPotentialSquare] - means[kPotential] * means[kPotential];
    const double kinetic = means[kKinetic];
    return freedom / 2 / (1 - freedom / 2 * variance / (kinetic * kinetic)) / spheres_;
  }));
}

void StepAttempts::add_step(const Scene& scene, const BlockAverage& average, std::size_t potential,
                            std::size_t step, const std::string& suffix, Measurement& found) const {
  const StepPotential& rules =
      scene.world().interactions().steps()[static_cast<StepTable::Number>(potential)];
  const std::size_t bin = bin_of(potential, step);
  const double freedom = motion_.degrees_of_freedom;
  const Estimate kinetic = average.ratio(kKinetic);
  const double temperature = 2 * kinetic.value / freedom;
  const auto level_inside = static_cast<StepPotential::Level>(rules.steps() - step);
  const bool is_end = rules.is_tether() && step + 1 == rules.steps();
  const auto add_direction = [&](const char* direction, std::size_t come, double rise) {
    found.add(std::string("rate_") + direction + suffix, "T^-1", 2 * average.ratio(bin + come) / spheres_);
    if (!(rise > 0) || is_end) return;
    // The share with a normal energy above the rise; less with few degrees of freedom.
    const double x = rise / temperature;
    const double theory = std::exp(-x);
    const std::string name = std::string("passed_") + direction + suffix;
    constexpr double kMinPassed = 30;
    if (average.total(bin + come + 1) < kMinPassed) {
      found.add(name, "1", Estimate()).reason = "fewer than 30 have passed";
    } else {
      found.add(name, "1", average.ratio(bin + come + 1, bin + come), theory,
                2 * (x + x * x) / freedom * theory);
    }
  };
  const auto level_outside = static_cast<StepPotential::Level>(level_inside - 1);
  if (!is_end) add_direction("inward", kComeIn, rules.rise(level_outside, false));
  add_direction("outward", kComeOut, is_end ? 0 : rules.rise(level_inside, true));
  // Where all spheres are alike, the rates give the densities on both sides.
  const SpeciesList& species = scene.species();
  if (rules.is_tether() || !species.is_one_kind()) return;
  const double distance = rules.rules().steps[step].ratio * 2 * species.radius(0);
  const bool is_flat = scene.world().box().is_flat();
  const double shell = is_flat ? 2 * std::numbers::pi * distance : 4 * std::numbers::pi * distance * distance;
  const double density = (spheres_ - 1) / scene.world().box().volume();
  const double mass = species.mass(0);
  const double pairs = shell * density / 2;
  const auto add_density = [&](const char* side, std::size_t come) {
    // The mean speed inwards of the normal component of the relative velocity is sqrt(kT / pi m), half of
    // its magnitude.
    found.add(std::string("g_") + side + suffix, "1", average.estimate([&](Means means) {
      const double speed =
          mean_over_normal(freedom) * std::sqrt(2 * means[kKinetic] / freedom / (std::numbers::pi * mass));
      return means[bin + come] / (spheres_ * pairs * speed);
    }));
  };
  if (std::isfinite(density) && density > 0 && scene.world().box().is_all(Boundary::periodic)) {
    add_density("outside", kComeIn);
    add_density("inside", kComeOut);
  }
}

bool StepAttempts::restored() const {
  return !first_bins_.empty() && first_bins_.front() == kSteps && average_.bins() > first_bins_.back() &&
         average_.groups() == 1;
}

}  // namespace hardball
