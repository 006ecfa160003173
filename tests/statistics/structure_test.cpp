// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The structure of the fluid against its equation of state, its pressure, and the theories of its
// correlations.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hardball/measure/neighbors.hpp"
#include "hardball/measure/profiles.hpp"
#include "hardball/measure/radial_distribution.hpp"
#include "hardball/measure/structure_factor.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/measurement.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::structure_test {
namespace {

using namespace support;

// Calls sample(scene) so many times, with so many collisions per sphere on average between two.
template <class Sample>
void watch(Simulation& simulation, int samples, double collisions_per_sphere, const Sample& sample) {
  const double contacts = collisions_per_sphere * static_cast<double>(simulation.size()) / 2;
  for (int i = 0; i < samples; ++i) {
    simulation.run_contacts(static_cast<std::uint64_t>(contacts));
    sample({simulation.world(), simulation.now()});
  }
}

// Z - 1 = 4 phi g(contact): the pressure of the same run, from its collisions, and the equation of state. The
// cubic fit errs by 0.1% at most, a finite number of spheres by about 1 / n; the error of the measured Z - 1
// is a seventh of that of g.
TEST(RadialDistribution, HasTheContactValueOfThePressure) {
  constexpr double kPacking = 0.3;
  constexpr std::size_t kSpheres = 2000;
  Simulation simulation(settled(make_gas({.count = kSpheres, .packing_fraction = kPacking, .seed = 61}), 40));
  RadialDistribution measure({simulation.world(), simulation.now()});
  watch(simulation, 300, 1, [&](const Scene& scene) { measure.sample(scene); });
  const Measurement found = result_of(measure, {simulation.world(), simulation.now()});
  const Quantity& contact = quantity(found, "contact_value");
  const double from_pressure = (simulation.tally().compressibility(simulation.now()) - 1) / (4 * kPacking);
  const double expected = (fluid_compressibility(kPacking) - 1) / (4 * kPacking);
  record("contact_value", contact.value);
  record("error", contact.error);
  record("from_pressure", from_pressure);
  EXPECT_NEAR(contact.theory, expected, expected / kSpheres);
  EXPECT_LT(contact.error, 0.01 * expected);
  const double bias = (1e-3 + 1.0 / kSpheres) * expected;
  EXPECT_NEAR(contact.value, from_pressure, 4 * contact.error + bias);
  EXPECT_NEAR(contact.value, expected, 4 * contact.error + bias);
  // Farther than four diameters away the fluid has forgotten the sphere, but for a few parts in 1000.
  const std::vector<double>& distance = column(found, "distance").values;
  const std::vector<double>& g = column(found, "g").values;
  double far = 0;
  double bins = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    if (distance[i] < 4) continue;
    far += g[i];
    ++bins;
  }
  EXPECT_GT(bins, 40);
  EXPECT_NEAR(far / bins, 1, 3e-3);
}

// At a packing fraction of 0.2 Percus and Yevick are low by 1.6% at the longest wavelengths, as the
// compressibility shows, and closer elsewhere.
TEST(StructureFactor, AgreesWithPercusAndYevickAtPackingFraction20) {
  Simulation simulation(settled(make_gas({.count = 2000, .packing_fraction = 0.2, .seed = 62}), 20));
  StructureFactor measure({simulation.world(), simulation.now()});
  watch(simulation, 320, 2, [&](const Scene& scene) { measure.sample(scene); });
  const Measurement found = result_of(measure, {simulation.world(), simulation.now()});
  const std::vector<double>& value = column(found, "structure_factor").values;
  const std::vector<double>& error = column(found, "structure_factor_error").values;
  const std::vector<double>& theory = column(found, "structure_factor_theory").values;
  ASSERT_GT(value.size(), 55U);
  double mean = 0;
  double variance = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    EXPECT_NEAR(value[i], theory[i], 4 * error[i] + 0.02 * theory[i]) << "shell " << i;
    mean += value[i] / theory[i] - 1;
    variance += error[i] * error[i] / (theory[i] * theory[i]);
  }
  mean /= static_cast<double>(value.size());
  const double mean_error = std::sqrt(variance) / static_cast<double>(value.size());
  record("mean_deviation", mean);
  record("error", mean_error);
  EXPECT_LT(mean_error, 0.005);
  EXPECT_NEAR(mean, 0, 4 * mean_error + 0.005);
  EXPECT_LT(value.front(), 0.3) << "a fluid is stiff";
}

// Torquato's formula agrees with simulations to some parts in 1000.
TEST(NearestNeighbor, AgreesWithTorquatoAtPackingFraction20) {
  Simulation simulation(settled(make_gas({.count = 2000, .packing_fraction = 0.2, .seed = 63}), 20));
  NearestNeighbor measure({simulation.world(), simulation.now()});
  watch(simulation, 200, 2, [&](const Scene& scene) { measure.sample(scene); });
  const Quantity gap = quantity(result_of(measure, {simulation.world(), simulation.now()}), "mean_gap");
  record("relative_deviation", gap.value / gap.theory - 1);
  EXPECT_LT(gap.error, 0.003 * gap.theory);
  EXPECT_NEAR(gap.value, gap.theory, 4 * gap.error + 0.005 * gap.theory);
}

// The pressure on a wall is kT times the density of centers that touch it. Both are means over the same run;
// the pressure, to which every contact adds, is the better known.
TEST(DensityProfiles, HaveThePressureOfTheWallsAtContact) {
  const World start =
      make_gas({.count = 1000, .packing_fraction = 0.2, .seed = 64, .boundary = Boundary::wall});
  Simulation simulation(settled(start, 20));
  DensityProfiles measure({simulation.world(), simulation.now()});
  watch(simulation, 3000, 0.5, [&](const Scene& scene) { measure.sample(scene); });
  const Quantity pressure =
      quantity(result_of(measure, {simulation.world(), simulation.now()}), "pressure_at_walls");
  const double expected = simulation.tally().wall_pressure(simulation.world().box(), simulation.now());
  record("pressure_at_walls", pressure.value);
  record("error", pressure.error);
  record("wall_pressure", expected);
  EXPECT_LT(pressure.error, 0.015 * expected);
  EXPECT_NEAR(pressure.value, expected, 4 * pressure.error + 2e-3 * expected);
}

// A fluid has no bonds in common directions: Q6 of all bonds is one over the square root of their number, up
// to their correlations. The crystal at a packing fraction of 0.6 keeps most of the 0.575 of its lattice.
TEST(BondOrder, DistinguishesTheCrystalFromTheFluid) {
  const auto order = [](double packing_fraction, Start start) {
    Simulation simulation(settled(
        make_gas({.count = 2048, .packing_fraction = packing_fraction, .seed = 65, .start = start}), 20));
    BondOrder measure({simulation.world(), simulation.now()});
    watch(simulation, 20, 1, [&](const Scene& scene) { measure.sample(scene); });
    return quantity(result_of(measure, {simulation.world(), simulation.now()}), "Q6").value;
  };
  EXPECT_LT(order(0.3, Start::random), 0.04);
  const double crystal = order(0.6, Start::fcc);
  EXPECT_GT(crystal, 0.45);
  EXPECT_LT(crystal, 0.575);
}

}  // namespace
}  // namespace hardball::structure_test
