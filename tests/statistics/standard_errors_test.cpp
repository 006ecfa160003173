// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Whether the standard errors of measures are honest: counts, among many independent runs of one state, short
// and long, those farther than two errors from the mean over all runs.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/record.hpp"

namespace hardball::standard_errors_test {
namespace {

using namespace support;

constexpr std::size_t kRuns = 200;

World mixture(std::uint64_t seed) {
  constexpr std::size_t kSmall = 80;
  constexpr std::size_t kLarge = 20;
  constexpr double kLargeDiameter = 2;
  constexpr double kPacking = 0.2;
  Random random(seed);
  std::vector<double> radii(kSmall, kDiameter / 2);
  std::vector<double> masses(kSmall, 1);
  radii.resize(kSmall + kLarge, kLargeDiameter / 2);
  masses.resize(kSmall + kLarge, kLargeDiameter * kLargeDiameter * kLargeDiameter);
  const double worth = kSmall + kLarge * masses.back();
  const double edge = std::cbrt(worth * std::numbers::pi / 6 / kPacking);
  const Box box = Box::periodic({edge, edge, edge});
  const std::vector<Vec3> centers = place_randomly(box, {{}, box.size()}, radii, random, "mixture");
  const std::vector<Vec3> velocities = thermal_velocities(masses, random);
  World world(box);
  for (std::size_t i = 0; i < radii.size(); ++i) world.add({centers[i], velocities[i], radii[i], masses[i]});
  return world;
}

struct State {
  std::string name;
  std::function<World(std::uint64_t seed)> start;
  double restitution = 1;
};

const std::vector<State>& states() {
  static const std::vector<State> kStates{
      {"dilute",
       [](std::uint64_t seed) { return make_gas({.count = 100, .packing_fraction = 0.02, .seed = seed}); }},
      {"dense",
       [](std::uint64_t seed) {
         return make_gas({.count = 125, .packing_fraction = 0.4, .seed = seed, .start = Start::simple_cubic});
       }},
      {"walls",
       [](std::uint64_t seed) {
         return make_gas({.count = 100, .packing_fraction = 0.2, .seed = seed, .boundary = Boundary::wall});
       }},
      {"mixture", mixture},
      {"cooling",
       [](std::uint64_t seed) { return make_gas({.count = 100, .packing_fraction = 0.1, .seed = seed}); },
       0.9},
  };
  return kStates;
}

// In mean free times.
struct Length {
  double run;
  double between_samples;
};

// The results of all runs for a quantity, or for a bin of a column.
struct Found {
  std::vector<double> values;
  std::vector<double> errors;
};

struct Count {
  double outside = 0;  // farther than two errors
  double known = 0;    // with an error
  double all = 0;
};

using Findings = std::map<std::string, std::vector<Found>>;

void note(std::vector<Found>& bins, std::size_t bin, double value, double error) {
  if (bins.size() <= bin) bins.resize(bin + 1);
  bins[bin].values.push_back(value);
  bins[bin].errors.push_back(error);
}

Findings findings(const State& state, const Length& length) {
  Findings found;
  for (std::size_t run = 0; run < kRuns; ++run) {
    Simulation simulation(interacting(settled(state.start(1000 + run), 15), Restitution(state.restitution)));
    const double free_time = mean_free_time(Scene(simulation.world(), simulation.now()).statistics());
    Measures measures({.every = length.between_samples * free_time});
    simulation.run_until(length.run * free_time, measures);
    for (const Measurement& measurement : measures.results(simulation.world(), simulation.now())) {
      for (const Quantity& quantity : measurement.quantities) {
        note(found[measurement.name + "." + quantity.name], 0, quantity.value, quantity.error);
      }
      for (std::size_t k = 1; k < measurement.columns.size(); ++k) {
        if (measurement.columns[k].role != ColumnRole::error) continue;
        const Column& value = measurement.columns[k - 1];
        for (std::size_t bin = 0; bin < value.values.size(); ++bin) {
          note(found[measurement.name + "/" + value.name], bin, value.values[bin],
               measurement.columns[k].values[bin]);
        }
      }
    }
  }
  return found;
}

// Bins that differ among runs by more than this, relative to their mean, hold few counts, for which "two
// errors" has no fixed percentage; they are farther off in fewer runs than others.
constexpr double kFewCounts = 0.45;

Count count(const std::vector<Found>& bins) {
  Count total;
  for (const Found& found : bins) {
    double mean = 0;
    double values = 0;
    for (const double value : found.values) {
      if (std::isnan(value)) continue;
      mean += value;
      ++values;
    }
    mean /= values;
    double variance = 0;
    for (const double value : found.values) {
      if (!std::isnan(value)) variance += (value - mean) * (value - mean) / (values - 1);
    }
    // What does not vary, such as a temperature at fixed energy, needs no error.
    const double deviation = std::sqrt(variance);
    if (!(deviation > 1e-9 * std::fabs(mean))) continue;
    if (bins.size() > 1 && deviation > kFewCounts * std::fabs(mean)) continue;
    for (std::size_t run = 0; run < found.values.size(); ++run) {
      ++total.all;
      if (std::isnan(found.errors[run])) continue;
      ++total.known;
      if (std::fabs(found.values[run] - mean) > 2 * found.errors[run]) ++total.outside;
    }
  }
  return total;
}

std::string measure_of(const std::string& name) {
  return name.substr(0, name.find_first_of("./"));
}

// The fraction outside must be 3 to 7%. Of 200 runs 7% lie outside with a deviation of sqrt(0.07 0.93 / 200),
// 1.8%; of 600 numbers checked, some thirty for each state and length of the runs, the last is beyond 3.3
// deviations. The bins of a column are correlated, and their mean is known no better than one of them. A run
// without an error is not outside.
const double kMaxOfOne = 0.07 + 3.3 * std::sqrt(0.07 * 0.93 / kRuns);
// The mean over all numbers of a measure in all five states is known as well as that of 1000 runs: 2.5
// deviations.
const double kMaxOfMeasure = 0.07 + 2.5 * std::sqrt(0.07 * 0.93 / (5 * kRuns));
const double kLeastOfMeasure = 0.03 - 2.5 * std::sqrt(0.03 * 0.97 / (5 * kRuns));

// Errors that docs/measures.md calls too large.
bool is_conservative(const std::string& measure) {
  return measure == "mean_square_displacement" || measure == "velocity_autocorrelation";
}

void expect_honest(const Length& length) {
  struct Mean {
    double sum = 0;
    double count = 0;
    double value() const { return sum / count; }
  };
  std::map<std::string, Mean> of_measure;
  Mean of_all;
  for (const State& state : states()) {
    for (const auto& [name, bins] : findings(state, length)) {
      const Count found = count(bins);
      if (found.known == 0) continue;
      EXPECT_LT(found.outside, kMaxOfOne * found.all) << state.name << " " << name;
      // Where few runs have an error, those that do are not representative.
      if (found.known < 0.9 * found.all) continue;
      Mean& mean = of_measure[measure_of(name)];
      mean.sum += found.outside / found.known;
      ++mean.count;
    }
  }
  for (const auto& [measure, mean] : of_measure) {
    record(measure, mean.value());
    EXPECT_LT(mean.value(), kMaxOfMeasure) << measure;
    if (is_conservative(measure)) continue;
    EXPECT_GT(mean.value(), kLeastOfMeasure) << measure;
    of_all.sum += mean.value();
    ++of_all.count;
  }
  record("all", of_all.value());
  EXPECT_GT(of_all.value(), 0.03);
  EXPECT_LT(of_all.value(), 0.07);
}

TEST(StandardErrors, AreHonestInShortRuns) {
  expect_honest({.run = 2, .between_samples = 0.5});
}

TEST(StandardErrors, AreHonestInLongRuns) {
  expect_honest({.run = 100, .between_samples = 2});
}

}  // namespace
}  // namespace hardball::standard_errors_test
