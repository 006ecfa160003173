// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// All measures as they are taken by default, of fluids of few and many spheres, dilute and dense, in short
// and long runs: against theory, and where there is none, against each other in runs with other seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/tuning/kinetic_theory.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball {
namespace {

struct Case {
  std::size_t spheres;
  double packing_fraction;
  std::vector<double> lengths;  // of runs [mean free times]
  std::size_t runs;             // with different seeds
};

World start(const Case& state, std::uint64_t seed) {
  constexpr double kDensestRandom = 0.3;
  support::Gas gas{.count = state.spheres, .packing_fraction = state.packing_fraction, .seed = seed};
  if (gas.packing_fraction > kDensestRandom) {
    const double per_edge = std::ceil(std::cbrt(static_cast<double>(gas.count)) - 1e-9);
    gas.count = static_cast<std::size_t>(std::lround(per_edge * per_edge * per_edge));
    gas.start = support::Start::simple_cubic;
  }
  return support::settled(support::make_gas(gas), 50);
}

struct Found {
  std::vector<double> values;
  std::vector<double> errors;
  double theory = 0;
  double tolerance = 0;
};

std::map<std::string, Found> found_in(const Case& state, double length) {
  std::map<std::string, Found> all;
  for (std::size_t run = 0; run < state.runs; ++run) {
    Simulation simulation(start(state, 1 + run));
    Measures measures;
    simulation.run_until(length * mean_free_time(Scene(simulation.world(), Time(0)).moments()), measures);
    measures.sample_the_rest(simulation.world(), simulation.now());
    for (const Measurement& measurement : measures.results(simulation.world(), simulation.now())) {
      for (const Quantity& quantity : measurement.quantities) {
        Found& found = all[measurement.name + "." + quantity.name];
        found.values.push_back(quantity.value);
        found.errors.push_back(quantity.error);
        found.theory = quantity.theory;
        found.tolerance = quantity.tolerance;
      }
    }
  }
  return all;
}

void show(const Case& state, double length) {
  for (const auto& [name, found] : found_in(state, length)) {
    double sum = 0;
    double squares = 0;
    double errors = 0;
    double known = 0;
    double worst = 0;
    for (std::size_t i = 0; i < found.values.size(); ++i) {
      if (!(found.errors[i] > 1e-12 * std::fabs(found.values[i]))) continue;
      ++known;
      sum += found.values[i];
      squares += found.values[i] * found.values[i];
      errors += found.errors[i] * found.errors[i];
      const double far = std::fmax(std::fabs(found.values[i] - found.theory) - found.tolerance, 0);
      worst = std::fmax(worst, far / found.errors[i]);
    }
    const double mean = sum / known;
    const double error = std::sqrt(errors / known);
    const double scatter = known > 1 ? std::sqrt((squares - known * mean * mean) / (known - 1)) : std::nan("");
    std::printf(
        "%7zu %5.2f %7g %-55s %12.6g %10.3g %12.6g  worst %6.2f  mean %6.2f  scatter %5.2f  known %g/%zu\n",
        state.spheres, state.packing_fraction, length, name.c_str(), mean, error, found.theory, worst,
        (mean - found.theory) / error * std::sqrt(known), scatter / error, known, found.values.size());
  }
}

TEST(MeasuresAtDefaults, DISABLED_Table) {
  const char* const only = std::getenv("HARDBALL_SPHERES");
  for (const std::size_t spheres : {100U, 500U, 4000U, 100000U}) {
    if (only && std::to_string(spheres) != only) continue;
    const std::vector<double> lengths = spheres < 1000     ? std::vector<double>{5, 100, 2000}
                                        : spheres < 100000 ? std::vector<double>{5, 100, 1000}
                                                           : std::vector<double>{2, 20, 80};
    const std::size_t runs = spheres < 1000 ? 12 : spheres < 100000 ? 6 : 2;
    for (const double packing_fraction : {0.02, 0.1, 0.3, 0.49}) {
      for (const double length : lengths) show({spheres, packing_fraction, lengths, runs}, length);
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace hardball
