// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Discs in equilibrium, fluid and crystal, compared with published simulations and with theory.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/measure/neighbors.hpp"
#include "hardball/measure/profiles.hpp"
#include "hardball/measure/radial_distribution.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/discs.hpp"
#include "support/effort.hpp"
#include "support/measurement.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::discs_test {
namespace {

using namespace support;

constexpr double kPi = std::numbers::pi;

// A published Z of the fluid at a density n sigma^2. Source: Kolafa and Rottner, Mol. Phys. 104 (2006) 3435,
// table 1, molecular dynamics.
struct Published {
  double density;
  double compressibility;
};

class FluidOfDiscs : public testing::TestWithParam<Published> {};

// With N collisions the relative errors of Z - 1 and of the rate are about 1 / sqrt(N), as if collisions were
// independent, and four are allowed; impact speeds have Rayleigh's distribution, with deviations of 0.52 and
// 1 over sqrt(N) of their mean and mean square. Finitely many discs differ by about 1 / n.
TEST_P(FluidOfDiscs, HasPressureRateAndImpactSpeedsOfTheory) {
  constexpr std::size_t kDiscs = 2 * 45 * 45;
  constexpr std::uint64_t kCollisions = 1000000;
  const double packing = kPi / 4 * GetParam().density;
  Simulation simulation(support::settled(support::make_discs(kDiscs, packing, 71), packing > 0.5 ? 150 : 40));
  Measures measures({.names = {"pressure", "collision_rate", "velocity_distribution", "impact_speeds"}});
  simulation.run({.contacts = kCollisions}, measures);
  const auto n = static_cast<double>(kDiscs);
  const auto collisions = static_cast<double>(kCollisions);
  const double statistical = 4 / std::sqrt(collisions);
  const Tally& tally = simulation.tally();

  const double excess = (GetParam().compressibility - 1) * n / (n - 1);
  const double measured = tally.compressibility(simulation.now()) - 1;
  support::record("relative_error_of_excess", measured / excess - 1);
  EXPECT_NEAR(measured / excess, 1, statistical + 1e-3);
  // Z = 1 + pi / 2 n sigma^2 chi and w = 2 sqrt(pi) n sigma chi.
  const double rate = 2 * collisions / (n * simulation.time());
  EXPECT_NEAR(rate / (4 / std::sqrt(kPi) * measured), 1, statistical + 1 / n);

  const support::FixedEnergy theory(n, 2 * (n - 1));
  EXPECT_NEAR(tally.impact_speed_sum() / collisions / theory.mean_impact_speed(), 1, 0.52 * statistical);
  EXPECT_NEAR(tally.impact_speed_square_sum() / collisions / theory.mean_square_impact_speed(), 1,
              statistical);

  const std::vector<Measurement> found = measures.results(simulation.world(), simulation.now());
  const Quantity& z = quantity(named(found, "pressure"), "compressibility");
  EXPECT_NEAR((z.theory - 1) / excess, 1, 1 / n);
  EXPECT_NEAR(z.value - 1, measured, 1e-9);
  const Measurement rates = named(found, "collision_rate");
  EXPECT_NEAR(quantity(rates, "collision_rate").theory / rate, 1, statistical + 1e-3);
  const Quantity& path = quantity(rates, "mean_free_path");
  EXPECT_NEAR(path.value / path.theory, 1, statistical + 3e-3);
  const Quantity& speed = quantity(named(found, "impact_speeds"), "mean_impact_speed");
  EXPECT_NEAR(speed.theory, theory.mean_impact_speed(), 1e-9);
  const Measurement velocities = named(found, "velocity_distribution");
  for (const char* name : {"speed_kurtosis", "mean_speed"}) {
    const Quantity& each = quantity(velocities, name);
    EXPECT_LT(std::fabs(each.value - each.theory), 5 * each.error + 1e-3 * each.theory) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Density, FluidOfDiscs,
                         testing::Values(Published{0.4, 2.1514393}, Published{0.6, 3.663691},
                                         Published{0.7, 5.082362}, Published{0.8, 7.476491}),
                         [](const auto& each) {
                           return "Percent" + std::to_string(std::lround(100 * each.param.density));
                         });

// Discs of two sizes, against the equation of state of Santos, Yuste and Lopez de Haro, which agrees with
// simulations to a few parts in 1000 at this ratio.
TEST(MixtureOfDiscs, AgreesWithItsEquationOfState) {
  constexpr std::size_t kDiscs = 4000;
  const Box box = Box::flat_periodic(60, 60);
  const Vec3 size{60, 60, 0};
  Random random(72);
  std::vector<double> radii;
  for (std::size_t i = 0; i < kDiscs; ++i) radii.push_back(i < kDiscs / 2 ? 0.5 : 0.25);
  const std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, random, "mixture");
  const std::vector<Vec3> velocities = support::thermal_velocities_in_plane(kDiscs, random);
  World world(box);
  for (std::size_t i = 0; i < kDiscs; ++i) world.add({centers[i], velocities[i], radii[i], 1});
  Simulation simulation(support::settled(world, 40));
  Measures measures({.names = {"pressure", "collision_rate"}});
  simulation.run({.contacts = 600000}, measures);
  const std::vector<Measurement> found = measures.results(simulation.world(), simulation.now());
  const Quantity& z = quantity(named(found, "pressure"), "compressibility");
  support::record("relative_error_of_excess", (z.value - 1) / (z.theory - 1) - 1);
  EXPECT_NEAR((z.value - 1) / (z.theory - 1), 1, 4 / std::sqrt(600000.0) + 3e-3);
  for (const char* pair : {"collision_rate_1_1", "collision_rate_1_2", "collision_rate_2_2"}) {
    const Quantity& rate = quantity(named(found, "collision_rate"), pair);
    // The contact value of a single pair is known less well than their sum.
    EXPECT_NEAR(rate.value / rate.theory, 1, 0.03) << pair;
  }
}

// The density of discs at contact with a disc, and with a wall: both follow from the pressure.
TEST(StructureOfDiscs, HasTheContactValuesOfThePressure) {
  constexpr double kPacking = 0.45;
  Simulation simulation(support::settled(support::make_discs(2000, kPacking, 73), 40));
  RadialDistribution pairs({simulation.world(), simulation.now()});
  NearestNeighbor gaps({simulation.world(), simulation.now()});
  for (int i = 0; i < 400; ++i) {
    simulation.run_contacts(1000);
    pairs.sample({simulation.world(), simulation.now()});
    gaps.sample({simulation.world(), simulation.now()});
  }
  const Scene scene(simulation.world(), simulation.now());
  const Quantity contact = quantity(result_of(pairs, scene), "contact_value");
  const double expected = (simulation.tally().compressibility(simulation.now()) - 1) / (2 * kPacking);
  support::record("contact_value", contact.value / expected);
  EXPECT_LT(contact.error, 0.02 * expected);
  EXPECT_NEAR(contact.value, expected, 4 * contact.error + 2e-3 * expected);
  EXPECT_NEAR(contact.theory / expected, 1, 0.01);
  // By scaled-particle theory for the space around a disc, good to some parts in 100.
  const Quantity gap = quantity(result_of(gaps, scene), "mean_gap");
  support::record("mean_gap", gap.value / gap.theory);
  EXPECT_NEAR(gap.value / gap.theory, 1, 4 * gap.error / gap.theory + 0.01);
}

TEST(StructureOfDiscs, HasThePressureOfTheWallsAtContact) {
  Simulation simulation(support::settled(support::make_discs(1000, 0.4, 74, Boundary::wall), 20));
  DensityProfiles measure({simulation.world(), simulation.now()});
  for (int i = 0; i < 3000; ++i) {
    simulation.run_contacts(250);
    measure.sample({simulation.world(), simulation.now()});
  }
  const Quantity pressure =
      quantity(result_of(measure, {simulation.world(), simulation.now()}), "pressure_at_walls");
  const double expected = simulation.tally().wall_pressure(simulation.world().box(), simulation.now());
  support::record("pressure_at_walls", pressure.value / expected);
  EXPECT_LT(pressure.error, 0.03 * expected);
  EXPECT_NEAR(pressure.value, expected, 4 * pressure.error + 2e-3 * expected);
}

// The crystal keeps most of its order of directions, the fluid has none. The equation of state of the crystal
// is that of Alder, Hoover and Young, J. Chem. Phys. 49 (1968) 3688, good to some parts in 1000.
TEST(CrystalOfDiscs, HasHexaticOrderAndItsPressure) {
  const auto order_at = [](double packing_fraction, double* compressibility) {
    Simulation simulation(support::settled(support::make_discs(2 * 40 * 40, packing_fraction, 75), 150));
    BondOrder measure({simulation.world(), simulation.now()});
    for (int i = 0; i < 40; ++i) {
      simulation.run_contacts(10000);
      measure.sample({simulation.world(), simulation.now()});
    }
    if (compressibility) *compressibility = simulation.tally().compressibility(simulation.now());
    return quantity(result_of(measure, {simulation.world(), simulation.now()}), "Psi6").value;
  };
  EXPECT_LT(order_at(0.6, nullptr), 0.1);
  double compressibility = 0;
  const double order = order_at(0.8, &compressibility);
  support::record("psi6", order);
  EXPECT_GT(order, 0.9);
  EXPECT_LT(order, 1);
  const double alpha = kClosePackingOfDiscs / 0.8 - 1;
  const double expected = 2 / alpha + 1.90 + 0.67 * alpha + 1.5 * alpha * alpha;
  support::record("relative_error", compressibility / expected - 1);
  EXPECT_NEAR(compressibility / expected, 1, 5e-3);
}

}  // namespace
}  // namespace hardball::discs_test
