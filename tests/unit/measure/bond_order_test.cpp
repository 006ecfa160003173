// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/bond_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/crystal.hpp"
#include "support/measurement.hpp"

namespace hardball::bond_order_test {
namespace {

Measurement measured(const World& world) {
  BondOrder measure({world, Time(0)});
  measure.sample({world, Time(0)});
  return measure.result({world, Time(0)});
}

struct Reference {
  support::Lattice lattice;
  double bonds;
  double q4;
  double q6;
};

// Source: Steinhardt, Nelson and Ronchetti, Phys. Rev. B 28 (1983) 784, figure 2; five digits after Mickel et
// al., J. Chem. Phys. 138 (2013) 044501, table I.
TEST(BondOrder, OfCrystalsHasThePublishedValues) {
  const std::vector<Reference> crystals{{support::face_centered_cubic(), 12, 0.19094, 0.57452},
                                        {support::hexagonal_close_packing(), 12, 0.09722, 0.48476},
                                        {support::body_centered_cubic(), 14, 0.03637, 0.51069},
                                        {support::simple_cubic(), 6, 0.76376, 0.35355}};
  for (const Reference& crystal : crystals) {
    const Measurement found = measured(support::make_crystal(crystal.lattice, 4, 1.1));
    EXPECT_EQ(support::quantity(found, "mean_bonds").value, crystal.bonds);
    EXPECT_NEAR(support::quantity(found, "Q4").value, crystal.q4, 6e-6);
    EXPECT_NEAR(support::quantity(found, "Q6").value, crystal.q6, 6e-6);
    EXPECT_NEAR(support::quantity(found, "mean_q4").value, crystal.q4, 6e-6);
    EXPECT_NEAR(support::quantity(found, "mean_q6").value, crystal.q6, 6e-6);
    const std::vector<double>& density = support::column(found, "q6_density").values;
    EXPECT_EQ(density[static_cast<std::size_t>(crystal.q6 * 100)], 100);
  }
}

TEST(BondOrder, DoesNotDependOnOrientation) {
  // Five spheres about one, arranged without symmetry.
  const std::vector<Vec3> bonds{
      {1, 0.1, 0.2}, {-0.3, 1, 0.1}, {0.2, -0.9, 0.4}, {-0.8, -0.3, -0.7}, {0.1, 0.3, 1}};
  const auto turned = [&](double angle, double tilt) {
    World world;
    world.add({.position = {0, 0, 0}, .radius = 0.5});
    for (const Vec3& bond : bonds) {
      const Vec3 unit = 1.2 / length(bond) * bond;
      const Vec3 about_z{unit.x * std::cos(angle) - unit.y * std::sin(angle),
                         unit.x * std::sin(angle) + unit.y * std::cos(angle), unit.z};
      world.add({.position = {about_z.x, about_z.y * std::cos(tilt) - about_z.z * std::sin(tilt),
                              about_z.y * std::sin(tilt) + about_z.z * std::cos(tilt)},
                 .radius = 0.5});
    }
    return measured(world);
  };
  const Measurement straight = turned(0, 0);
  for (const double angle : {0.4, 2.5}) {
    const Measurement found = turned(angle, 1.3 * angle);
    for (const char* name : {"Q4", "Q6", "mean_q4", "mean_q6"}) {
      EXPECT_NEAR(support::quantity(found, name).value, support::quantity(straight, name).value, 1e-12)
          << name;
    }
  }
}

TEST(BondOrder, OfAPairIsOne) {
  World world;
  world.add({.position = {0, 0, 0}, .radius = 1});
  world.add({.position = {1, 2, -1.5}, .radius = 1});
  world.add({.position = {40, 0, 0}, .radius = 1});
  const Measurement found = measured(world);
  EXPECT_NEAR(support::quantity(found, "Q4").value, 1, 1e-12);
  EXPECT_NEAR(support::quantity(found, "Q6").value, 1, 1e-12);
  EXPECT_NEAR(support::quantity(found, "mean_bonds").value, 2.0 / 3, 1e-12);
  // Spheres without bonds do not count.
  EXPECT_NEAR(support::quantity(found, "mean_q6").value, 1, 1e-12);
}

TEST(BondOrder, OfManyRandomBondsGoesToZero) {
  const World world =
      support::make_ideal_gas(Box::periodic({12, 12, 12}), std::vector<double>(3000, 0.5), 56);
  const Measurement found = measured(world);
  const double bonds = 3000 * support::quantity(found, "mean_bonds").value / 2;
  EXPECT_GT(bonds, 10000);
  // Squared, Q6 is the sum of 13 squares with a mean of 1 / 13 over the bonds each: its deviation is
  // sqrt(2 / 13) of the mean.
  const double square = std::pow(support::quantity(found, "Q6").value, 2) * bonds;
  EXPECT_NEAR(square, 1, 4 * std::sqrt(2.0 / 13));
}

}  // namespace
}  // namespace hardball::bond_order_test
