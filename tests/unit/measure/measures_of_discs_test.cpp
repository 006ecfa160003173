// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Measures in two dimensions, on arrangements whose results are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/measure/bond_order.hpp"
#include "hardball/measure/contact_extrapolation.hpp"
#include "hardball/measure/coordination.hpp"
#include "hardball/measure/density_profiles.hpp"
#include "hardball/measure/fluid_structure.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/measure/radial_distribution.hpp"
#include "hardball/measure/structure_factor.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/world/totals.hpp"
#include "support/crystal.hpp"
#include "support/discs.hpp"
#include "support/measurement.hpp"

namespace hardball::measures_of_discs_test {
namespace {

using support::column;
using support::quantity;

template <class Measure>
Measurement measured(const World& world) {
  Measure measure({world, Time(0)});
  measure.sample({world, Time(0)});
  return measure.result({world, Time(0)});
}

// Discs of diameter one at 1.1 from their nearest neighbors.
World crystal_of_discs(bool is_hexagonal) {
  const double height = is_hexagonal ? std::sqrt(3.0) : 1;
  World world(Box::flat_periodic(1.1 * 12, 1.1 * 12 * height));
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      world.add({.position = {1.1 * x, 1.1 * height * y, 0}, .radius = 0.5});
      if (is_hexagonal)
        world.add({.position = {1.1 * (x + 0.5), 1.1 * height * (y + 0.5), 0}, .radius = 0.5});
    }
  }
  return world;
}

TEST(BondOrderOfDiscs, IsOneForTheirCrystals) {
  const Measurement hexagonal = measured<BondOrder>(crystal_of_discs(true));
  EXPECT_EQ(quantity(hexagonal, "mean_bonds").value, 6);
  EXPECT_NEAR(quantity(hexagonal, "Psi6").value, 1, 1e-12);
  EXPECT_NEAR(quantity(hexagonal, "mean_psi6").value, 1, 1e-12);
  EXPECT_NEAR(quantity(hexagonal, "Psi4").value, 0, 1e-12);
  EXPECT_EQ(column(hexagonal, "psi6_density").values.back(), 100);
  const Measurement square = measured<BondOrder>(crystal_of_discs(false));
  EXPECT_EQ(quantity(square, "mean_bonds").value, 4);
  EXPECT_NEAR(quantity(square, "Psi4").value, 1, 1e-12);
  EXPECT_NEAR(quantity(square, "Psi6").value, 0, 1e-12);
  EXPECT_EQ(quantity(measured<Coordination>(crystal_of_discs(true)), "mean_neighbors").value, 6);
}

TEST(RadialDistributionOfDiscs, CountsTheShellsOfACrystal) {
  const World world = crystal_of_discs(true);
  const double density = static_cast<double>(world.size()) / world.box().volume();
  const Measurement found = measured<RadialDistribution>(world);
  const std::vector<double>& r = column(found, "distance").values;
  const std::vector<double>& g = column(found, "g").values;
  const auto within = [&](double distance) {
    double sum = 0;
    for (std::size_t i = 0; i < r.size() && r[i] < distance; ++i) {
      const double low = r[i] - 0.01;
      const double high = r[i] + 0.01;
      sum += g[i] * density * std::numbers::pi * (high * high - low * low);
    }
    return sum;
  };
  EXPECT_NEAR(within(1.5), 6, 1e-9);
  EXPECT_NEAR(within(2.05), 12, 1e-9);
  EXPECT_NEAR(within(2.5), 18, 1e-9);
}

// An ideal gas has g = 1 in every box, less one pair in n. Over 100 bins the squares of deviations, in
// standard errors from 24 samples, have a mean of 23 / 21 and a standard deviation of about sqrt(2.6 / 100).
TEST(RadialDistributionOfDiscs, OfAnIdealGasIsOne) {
  const std::vector<double> radii(600, 0.5);
  for (const Box& box : {Box::flat_periodic(14, 12), Box::flat_walls(14, 12),
                         Box({Boundary::wall, Boundary::periodic, Boundary::flat}, {12, 14, 0})}) {
    RadialDistribution measure({support::make_ideal_gas(box, radii, 1000), Time(0)}, 3);
    for (std::uint64_t sample = 0; sample < 24; ++sample) {
      measure.sample({support::make_ideal_gas(box, radii, sample), Time(static_cast<double>(sample + 1))});
    }
    const Measurement found = measure.result({support::make_ideal_gas(box, radii, 0), Time(25)});
    const std::vector<double>& g = column(found, "g").values;
    const std::vector<double>& error = column(found, "g_error").values;
    double squares = 0;
    double mean = 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
      squares += (g[i] - 1 + 1.0 / 600) * (g[i] - 1 + 1.0 / 600) / (error[i] * error[i]);
      mean += g[i];
    }
    const auto bins = static_cast<double>(g.size());
    ASSERT_GT(bins, 90);
    EXPECT_NEAR(mean / bins, 1, 0.005);
    EXPECT_LT(squares / bins, 2);
  }
}

TEST(ContactExtrapolationOfDiscs, IsExactForCubics) {
  const ContactExtrapolation contact(0.3, 1, 2);
  ContactExtrapolation::Bins means{};
  const auto integral = [](double x) {  // of (1 + x) (5 - 30 x + 80 x^2)
    return 5 * x - 25 * x * x / 2 + 50 * x * x * x / 3 + 20 * x * x * x * x;
  };
  for (std::size_t bin = 0; bin < means.size(); ++bin) {
    const double low = static_cast<double>(bin) * contact.bin_width();
    const double high = low + contact.bin_width();
    const double area = (high - low) * (1 + (low + high) / 2);
    means[bin] = (integral(high) - integral(low)) / area;
  }
  EXPECT_NEAR(contact.at_contact(means), 5, 1e-9);
}

TEST(DensityProfilesOfDiscs, AddUpToTheDiscs) {
  const Box box = Box::flat_walls(7, 9);
  const std::vector<double> radii{0.25, 1, 0.5, 0.5, 0.75};
  const World world = support::make_ideal_gas(box, radii, 3);
  const Measurement found = measured<DensityProfiles>(world);
  const std::vector<double>& position = column(found, "position").values;
  const double width = position[1] - position[0];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::string name = axis == 0 ? "x" : "y";
    double discs = 0;
    double area = 0;
    for (std::size_t bin = 0; bin < position.size(); ++bin) {
      const double low = static_cast<double>(bin) * width;
      if (low >= box.size()[axis] * (1 - 1e-9)) continue;
      const double slab = std::min(width, box.size()[axis] - low) * box.face_area(axis);
      discs += column(found, "number_density_" + name).values[bin] * slab;
      area += column(found, "packing_fraction_" + name).values[bin] * slab;
    }
    EXPECT_NEAR(discs, 5, 1e-9);
    EXPECT_NEAR(area, sphere_volume(world, Time(0)), 1e-9);
  }
  EXPECT_EQ(column(found, "number_density_x").unit, "L^-2");
  EXPECT_EQ(quantity(found, "pressure_at_walls").unit, "M T^-2");
  EXPECT_THROW(column(found, "number_density_z"), std::out_of_range);
}

TEST(WallForcesOnDiscs, ArePerLength) {
  const World world(Box::flat_walls(7, 9), {0, -1, 0},
                    {Surface(Obstacle(2), {3, 4, 0}), Surface(Plane({1, 0, 0}), {0.1, 0, 0})});
  EXPECT_EQ(wall_area(world, face_of(0, true)), 9);
  EXPECT_EQ(wall_area(world, face_of(1, false)), 7);
  EXPECT_DOUBLE_EQ(wall_area(world, kFaces), 4 * std::numbers::pi);
  EXPECT_EQ(wall_area(world, kFaces + 1), 9);
  EXPECT_EQ(measured_walls(world).size(), 6U);
}

TEST(StructureFactorOfDiscs, HasWavesInThePlaneAndNoTheory) {
  const Measurement found = measured<StructureFactor>(crystal_of_discs(true));
  EXPECT_GT(column(found, "wave_number").values.size(), 30U);
  EXPECT_THROW(column(found, "structure_factor_theory"), std::out_of_range);
  // The lattice scatters with all its discs or not at all.
  for (const double value : column(found, "structure_factor").values) EXPECT_LE(value, 288 + 1e-9);
}

// Enskog's rate and diffusion, written out for so many discs that a box of fixed energy is no different.
TEST(FluidTheoryOfDiscs, HasEnskogsRateAndDiffusion) {
  constexpr double kDiscs = 20000;
  const World world = support::make_discs(static_cast<std::size_t>(kDiscs), 0.3, 1);
  const FluidTheory theory(world, SpeciesList(world));
  ASSERT_TRUE(theory.holds());
  const double density = kDiscs / world.box().volume();
  const double contact = (fluid_compressibility_of_discs(0.3) - 1) / 0.6;
  EXPECT_NEAR(theory.contact_value(0, 0) / contact, 1, 1 / kDiscs);
  const double rate = 2 * std::sqrt(std::numbers::pi * 2) * density * contact;
  EXPECT_NEAR(theory.collision_rate(2) / rate, 1, 1 / kDiscs);
  EXPECT_NEAR(theory.mean_speed(2) / std::sqrt(std::numbers::pi), 1, 1 / kDiscs);
  EXPECT_NEAR(theory.enskog_diffusion(2), std::sqrt(2 / std::numbers::pi) / (2 * density * contact), 1e-9);
  EXPECT_TRUE(std::isnan(theory.diffusion(2)));
  EXPECT_FALSE(FluidTheory(support::make_discs(200, 0.72, 1), SpeciesList(world)).holds());
}

// The gap between points is distributed as exp(-pi n r^2).
TEST(NearestNeighborOfDiscs, IsThatOfPointsInADiluteGas) {
  constexpr double kPacking = 1e-6;
  const double distance = 600;
  EXPECT_NEAR(nearest_neighbor_beyond(kPacking, distance, 2), std::exp(-4 * kPacking * distance * distance),
              2e-3);
  EXPECT_EQ(nearest_neighbor_beyond(0.5, 1, 2), 1);
}

TEST(MeasuresOfDiscs, NameNothingAlongZ) {
  const World world = support::make_discs(100, 0.3, 2);
  Simulation simulation(world);
  Measures measures({.names = {"all"}});
  simulation.run({.contacts = 2000}, measures);
  for (const Measurement& found : measures.results(simulation.world(), simulation.now())) {
    for (const Quantity& each : found.quantities) {
      EXPECT_EQ(each.name.find("_z"), std::string::npos) << each.name;
      EXPECT_NE(each.unit, "M L^-1 T^-2") << each.name;
      EXPECT_EQ(each.unit.find("L^-3"), std::string::npos) << each.name;
    }
    for (const Column& each : found.columns) {
      EXPECT_EQ(each.name.find("_z"), std::string::npos) << each.name;
      EXPECT_EQ(each.unit.find("L^-3"), std::string::npos) << each.name;
    }
  }
}

}  // namespace
}  // namespace hardball::measures_of_discs_test
