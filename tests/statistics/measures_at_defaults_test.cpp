// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// All measures as they are taken by default, of fluids of few and many spheres, dilute and dense, in short
// and long runs: against theory, and against each other in runs with other seeds.
//
// The table of all cases takes some ten minutes on one core:
// physics_tests --gtest_also_run_disabled_tests --gtest_filter='MeasuresAtDefaults.*'
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/statistics/agreement.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball::measures_at_defaults_test {
namespace {

struct Fluid {
  std::size_t spheres;
  double packing_fraction;
};

// In equilibrium.
World start(const Fluid& fluid, std::uint64_t seed) {
  constexpr double kDensestRandom = 0.3;
  constexpr double kDense = 0.4;
  support::Gas gas{.count = fluid.spheres, .packing_fraction = fluid.packing_fraction, .seed = seed};
  if (gas.packing_fraction > kDensestRandom) {
    const double per_edge = std::ceil(std::cbrt(static_cast<double>(gas.count)) - 1e-9);
    gas.count = static_cast<std::size_t>(std::lround(per_edge * per_edge * per_edge));
    gas.start = support::Start::simple_cubic;
  }
  return support::settled(support::make_gas(gas), gas.packing_fraction > kDense ? 200 : 40);
}

// Measured for so many mean free times.
std::vector<Measurement> measured(const World& world, double length) {
  Simulation simulation(world);
  Measures measures;
  simulation.run_until(length * mean_free_time(Scene(world, Time(0)).statistics()), measures);
  measures.sample_the_rest(simulation.world(), simulation.now());
  return measures.results(simulation.world(), simulation.now());
}

std::string text_of(const Fluid& fluid, double length) {
  return std::to_string(fluid.spheres) + " spheres at " + std::to_string(fluid.packing_fraction) + " for " +
         std::to_string(length);
}

// The farthest of all numbers from theory [errors].
double expect_agreement(const std::vector<Measurement>& found, const std::string& which) {
  const Agreement agreement(found);
  for (const FarNumber& far : agreement.far()) {
    ADD_FAILURE() << which << ": " << far.quantity << " (" << far.title << ")";
  }
  double farthest = 0;
  for (const Measurement& measurement : found) {
    for (const Quantity& quantity : measurement.quantities) {
      farthest = std::fmax(farthest, deviation(quantity));
      // What is missing is said to be.
      if (quantity.name.starts_with("diffusion_constant") || quantity.name.starts_with("highest_peak")) {
        EXPECT_EQ(std::isnan(quantity.value) || std::isnan(quantity.error), !quantity.reason.empty())
            << which << ": " << quantity.name;
      }
    }
  }
  return farthest;
}

// Of two independent runs, those that are farther apart than chance allows.
double expect_equal(const std::vector<Measurement>& one, const std::vector<Measurement>& other,
                    const std::string& which) {
  std::vector<Measurement> differences = one;
  for (std::size_t m = 0; m < one.size(); ++m) {
    for (std::size_t q = 0; q < one[m].quantities.size(); ++q) {
      Quantity& difference = differences[m].quantities[q];
      difference.theory = other[m].quantities[q].value;
      difference.tolerance = 0;
      difference.error = std::hypot(difference.error, other[m].quantities[q].error);
    }
  }
  return expect_agreement(differences, which + " twice");
}

// Runs of these lengths, each with two seeds.
void expect_consistent(const Fluid& fluid, const std::vector<double>& lengths) {
  const World first = start(fluid, 1);
  const World second = start(fluid, 2);
  for (const double length : lengths) {
    const std::string which = text_of(fluid, length);
    const std::vector<Measurement> one = measured(first, length);
    const std::vector<Measurement> other = measured(second, length);
    support::record(which + ": farthest from theory",
                    std::fmax(expect_agreement(one, which), expect_agreement(other, which)));
    support::record(which + ": farthest apart", expect_equal(one, other, which));
  }
}

TEST(MeasuresAtDefaults, OfFewSpheresAreRight) {
  expect_consistent({100, 0.02}, {5, 100});
  expect_consistent({100, 0.3}, {5, 100});
}

// Lags beyond the memory of velocities would make the diffusion constant 7.8, with an error of 0.1.
TEST(MeasuresAtDefaults, OfAGasOf500SpheresAreRight) {
  expect_consistent({500, 0.1}, {5, 300});
}

TEST(MeasuresAtDefaults, OfADenseFluidAreRight) {
  expect_consistent({100, 0.49}, {20, 500});
}

class MeasuresOf : public testing::TestWithParam<std::size_t> {};

TEST_P(MeasuresOf, ShortAndUsualRunsAreRightAtEveryDensity) {
  for (const double packing_fraction : {0.02, 0.1, 0.3, 0.49}) {
    expect_consistent({GetParam(), packing_fraction}, {5, 100});
  }
}

INSTANTIATE_TEST_SUITE_P(Spheres, MeasuresOf, testing::Values(100, 500, 4000));

// The same with more spheres and longer runs, which takes long: prints every number.
TEST(MeasuresAtDefaults, DISABLED_AreRightEverywhere) {
  for (const std::size_t spheres : {100U, 500U, 4000U, 100000U}) {
    for (const double packing_fraction : {0.02, 0.1, 0.3, 0.49}) {
      const Fluid fluid{spheres, packing_fraction};
      const std::vector<double> lengths = spheres < 1000     ? std::vector<double>{5, 100, 2000}
                                          : spheres < 100000 ? std::vector<double>{5, 100, 1000}
                                                             : std::vector<double>{2, 20, 80};
      std::vector<World> starts;
      for (std::uint64_t seed = 1; seed <= (spheres < 1000 ? 6U : 2U); ++seed) {
        starts.push_back(start(fluid, seed));
      }
      for (const double length : lengths) {
        const std::string which = text_of(fluid, length);
        std::vector<Measurement> before;
        for (const World& world : starts) {
          const std::vector<Measurement> found = measured(world, length);
          expect_agreement(found, which);
          if (!before.empty()) expect_equal(before, found, which);
          for (const Measurement& measurement : found) {
            for (const Quantity& quantity : measurement.quantities) {
              std::printf("%7zu %5.2f %6g %-26s %-32s %12.6g %10.2g %12.6g %6.2f %s\n", spheres,
                          packing_fraction, length, measurement.name.c_str(), quantity.name.c_str(),
                          quantity.value, quantity.error, quantity.theory, deviation(quantity),
                          quantity.reason.c_str());
            }
          }
          before = found;
        }
        std::fflush(stdout);
      }
    }
  }
}

}  // namespace
}  // namespace hardball::measures_at_defaults_test
