// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/radial_distribution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/measure/fluid_structure.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/measure/neighbors.hpp"
#include "hardball/measure/profiles.hpp"
#include "hardball/measure/structure_factor.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/statistics/contact_extrapolation.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/world/totals.hpp"
#include "support/crystal.hpp"
#include "support/discs.hpp"
#include "support/gas.hpp"
#include "support/measurement.hpp"

namespace hardball::static_structure_test {
namespace {

using namespace support;

// The result of a measure of so many ideal gases of the same spheres.
template <class Measure, class... Settings>
Measurement of_ideal_gases(const Box& box, const std::vector<double>& radii, std::uint64_t samples,
                           const Settings&... settings) {
  const World first = make_ideal_gas(box, radii, 0);
  Measure measure({first, Time(0)}, settings...);
  for (std::uint64_t sample = 0; sample < samples; ++sample)
    measure.sample({make_ideal_gas(box, radii, sample), Time(0)});
  return result_of(measure, {first, Time(0)});
}

// The number of neighbors closer than a distance, from g(r) in a periodic box.
double neighbors_within(const Measurement& found, const World& world, double distance) {
  const double density = static_cast<double>(world.size()) / world.box().volume();
  const std::vector<double>& r = values(found, "distance");
  const std::vector<double>& g = values(found, "g");
  const double bin_width = r[1] - r[0];
  double sum = 0;
  for (std::size_t i = 0; i < r.size() && r[i] < distance; ++i) {
    const double low = r[i] - bin_width / 2;
    const double high = r[i] + bin_width / 2;
    sum += g[i] * density * (world.box().sphere_volume(high) - world.box().sphere_volume(low));
  }
  return sum;
}

// The neighbors in all shells up to one, which lies within so many spacings squared.
struct Shells {
  Lattice lattice;
  std::size_t cells;
  std::vector<std::pair<double, double>> neighbors_within;
};

TEST(RadialDistribution, CountsTheShellsOfACrystal) {
  const std::vector<Shells> crystals{
      {face_centered_cubic(), 5, {{1.5, 12}, {2.5, 18}, {3.5, 42}, {4.5, 54}, {5.5, 78}, {6.5, 86}}},
      {hexagonal_of_discs(), 12, {{1.5, 6}, {3.5, 12}, {5.5, 18}}}};
  constexpr double kSpacing = 1.2;
  for (const Shells& crystal : crystals) {
    const World world = make_crystal(crystal.lattice, crystal.cells, kSpacing);
    const Measurement found = measured<RadialDistribution>(world);
    for (const auto& [square, neighbors] : crystal.neighbors_within)
      EXPECT_NEAR(neighbors_within(found, world, kSpacing * std::sqrt(square)), neighbors, 1e-9);
    EXPECT_EQ(quantity(found, "contact_value").value, 0) << "no gap is narrower than 0.2";
  }
}

struct IdealCase {
  std::string name;
  Box box;
  std::size_t spheres;
  double radius;
  double range;
  double bin_width;
};

class IdealGas : public ::testing::TestWithParam<IdealCase> {};

// In every box an ideal gas must have g = 1, less one pair in n: a sphere is not its own neighbor. Over 100
// bins the squares of deviations, in standard errors from 24 samples, have a mean of 23 / 21 and a standard
// deviation of about sqrt(2.6 / 100).
TEST_P(IdealGas, IsUniformInEveryBox) {
  const auto& [name, box, spheres, radius, range, bin_width] = GetParam();
  constexpr std::uint64_t kSamples = 24;
  const std::vector<double> radii(spheres, radius);
  const Measurement found = of_ideal_gases<RadialDistribution>(box, radii, kSamples, range, bin_width);
  const std::vector<double>& g = values(found, "g");
  const std::vector<double>& error = values(found, "g_error");
  const auto bins = static_cast<double>(g.size());
  ASSERT_NEAR(bins, 100, 1);
  double squares = 0;
  double mean = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double deviation = g[i] - (1 - 1 / static_cast<double>(spheres));
    squares += deviation * deviation / (error[i] * error[i]);
    mean += deviation / bins;
  }
  EXPECT_NEAR(squares / bins, 23.0 / 21, 4 * std::sqrt(2.6 / bins));
  EXPECT_NEAR(mean, 0, 5e-3);
  const Quantity& contact = quantity(found, "contact_value");
  EXPECT_NEAR(contact.value, 1, 4 * contact.error);
  EXPECT_LT(contact.error, 0.1);
}

// Radii large enough that neglecting them, or the walls, would be detected.
IdealCase in_space(const std::string& name, const std::array<Boundary, kAxes>& boundary) {
  return {name, Box(boundary, {10, 12, 14}), 1000, 0.4, 6, 0.05};
}
IdealCase in_plane(const std::string& name, const Box& box) {
  return {name, box, 600, 0.5, 3, 0.02};
}

INSTANTIATE_TEST_SUITE_P(
    Boxes, IdealGas,
    ::testing::Values(in_space("Periodic", {Boundary::periodic, Boundary::periodic, Boundary::periodic}),
                      in_space("Slit", {Boundary::wall, Boundary::periodic, Boundary::periodic}),
                      in_space("Channel", {Boundary::wall, Boundary::periodic, Boundary::wall}),
                      in_space("Walls", {Boundary::wall, Boundary::wall, Boundary::wall}),
                      in_plane("PeriodicPlane", Box::flat_periodic(14, 12)),
                      in_plane("PlaneWithWalls", Box::flat_walls(14, 12)),
                      in_plane("Strip",
                               Box({Boundary::wall, Boundary::periodic, Boundary::flat}, {12, 14, 0}))),
    [](const auto& box) { return box.param.name; });

// Of a single pair g is one over what the ideal gas has in that bin: two ordered pairs of four, and the mean
// over all directions of the fraction of positions from which a displacement does not cross a wall.
TEST(RadialDistribution, HasTheExactIdealGasBetweenWalls) {
  constexpr double kRadius = 0.25;
  constexpr double kBin = 0.04;
  World world(Box::walls({4, 5, 6}));
  world.add({.position = {1, 1, 1}, .radius = kRadius});
  world.add({.position = {1, 1, 2.85}, .radius = kRadius});
  const Measurement found = measured<RadialDistribution>(world, 5, kBin / (2 * kRadius));
  const std::vector<double>& g = values(found, "g");
  const auto bin = static_cast<std::size_t>((1.85 - 2 * kRadius) / kBin);
  const double low = 2 * kRadius + static_cast<double>(bin) * kBin;
  const Vec3 free{3.5, 4.5, 5.5};
  constexpr int kSteps = 200;
  constexpr int kShells = 10;
  double ideal = 0;
  for (int shell = 0; shell < kShells; ++shell) {
    const double r = low + (shell + 0.5) * kBin / kShells;
    double mean = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double z = (i + 0.5) / kSteps;
      for (int j = 0; j < kSteps; ++j) {
        const double angle = std::numbers::pi / 2 * (j + 0.5) / kSteps;
        const double across = std::sqrt(1 - z * z);
        mean += (1 - r * across * std::cos(angle) / free.x) * (1 - r * across * std::sin(angle) / free.y) *
                (1 - r * z / free.z) / (kSteps * kSteps);
      }
    }
    ideal += 4 * std::numbers::pi * r * r * mean * kBin / kShells / (free.x * free.y * free.z);
  }
  EXPECT_NEAR(g[bin] * 2 * ideal, 1, 1e-4);
}

TEST(RadialDistribution, DistinguishesPairsOfSpecies) {
  const Box box = Box::periodic({10, 10, 10});
  std::vector<double> radii(300, 0.2);
  radii.resize(900, 0.4);
  const Measurement found = of_ideal_gases<RadialDistribution>(box, radii, 20);
  for (const std::string pair : {"_1_1", "_1_2", "_2_2"}) {
    const std::vector<double>& g = values(found, "g" + pair);
    const std::vector<double>& error = values(found, "g" + pair + "_error");
    // The outer half of the bins, taken together.
    double sum = 0;
    double variance = 0;
    for (std::size_t i = g.size() / 2; i < g.size(); ++i) {
      sum += g[i];
      variance += error[i] * error[i];
    }
    const double bins = static_cast<double>(g.size() - g.size() / 2);
    EXPECT_NEAR(sum / bins, 1, 4 * std::sqrt(variance) / bins + 1.0 / 300) << pair;
    EXPECT_LT(4 * std::sqrt(variance) / bins, 0.02) << pair;
    const Quantity& contact = quantity(found, "contact_value" + pair);
    EXPECT_NEAR(contact.value, 1, 4 * contact.error) << pair;
    EXPECT_GT(contact.theory, 1) << pair;
  }
}

TEST(RadialDistribution, OfTwoSpheresIsOnePair) {
  World world(Box::periodic({10, 10, 10}));
  world.add({.position = {1, 1, 1}, .radius = 0.5});
  world.add({.position = {9, 1, 1}, .radius = 0.5});
  const Measurement found = measured<RadialDistribution>(world);
  EXPECT_NEAR(neighbors_within(found, world, 1.9), 0, 1e-12);
  EXPECT_NEAR(neighbors_within(found, world, 2.1), 1, 1e-12);
}

TEST(RadialDistribution, OfManyRadiiHasNoContact) {
  Random random(53);
  std::vector<double> radii;
  for (int i = 0; i < 200; ++i) radii.push_back(0.1 + 0.3 * random.uniform());
  const World world = make_ideal_gas(Box::periodic({10, 10, 10}), radii, 1);
  const Measurement found = measured<RadialDistribution>(world);
  EXPECT_TRUE(found.quantities.empty());
  EXPECT_FALSE(values(found, "g").empty());
}

TEST(RadialDistribution, HasNoMeaningWithoutADensity) {
  for (const Box& box : {Box::open(), Box({Boundary::open, Boundary::wall, Boundary::wall}, {0, 9, 9})}) {
    World world(box);
    world.add({.position = {2, 2, 2}});
    world.add({.position = {6, 6, 6}});
    EXPECT_TRUE(measured<RadialDistribution>(world).columns.empty());
    EXPECT_TRUE(measured<RadialDistribution>(world).quantities.empty());
  }
}

struct Shell {
  double wave_number = 0;
  double intensity = 0;
  int vectors = 0;
};

// All wave vectors of a cubic periodic box in 64 shells up to `longest`, summed sphere by sphere.
std::vector<Shell> direct_sum(const World& world, double longest) {
  std::vector<Shell> shells(64);
  const double unit = 2 * std::numbers::pi / world.box().size().x;
  const int most = static_cast<int>(longest / unit);
  for (int x = -most; x <= most; ++x) {
    for (int y = -most; y <= most; ++y) {
      for (int z = -most; z <= most; ++z) {
        const Vec3 k = unit * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        const auto index = static_cast<std::size_t>(length(k) / longest * 64);
        if (index >= shells.size() || (x == 0 && y == 0 && z == 0)) continue;
        double cosines = 0;
        double sines = 0;
        for (const Path& path : world.paths()) {
          cosines += std::cos(dot(k, path.position));
          sines += std::sin(dot(k, path.position));
        }
        shells[index].intensity += (cosines * cosines + sines * sines) / static_cast<double>(world.size());
        shells[index].wave_number += length(k);
        ++shells[index].vectors;
      }
    }
  }
  std::erase_if(shells, [](const Shell& shell) { return shell.vectors == 0; });
  for (Shell& shell : shells) {
    shell.intensity /= shell.vectors;
    shell.wave_number /= shell.vectors;
  }
  return shells;
}

void expect_direct_sum(const World& world, double longest) {
  constexpr std::size_t kAllVectors = 100;
  const Measurement found = measured<StructureFactor>(world, longest, kAllVectors);
  const std::vector<Shell> expected = direct_sum(world, longest);
  const std::vector<double>& wave_number = values(found, "wave_number");
  const std::vector<double>& value = values(found, "structure_factor");
  ASSERT_EQ(value.size(), expected.size());
  for (std::size_t shell = 0; shell < expected.size(); ++shell) {
    EXPECT_NEAR(wave_number[shell], expected[shell].wave_number, 1e-9);
    EXPECT_NEAR(value[shell], expected[shell].intensity, 1e-9 * static_cast<double>(world.size()));
  }
}

TEST(StructureFactor, IsTheSumOverAllWaveVectorsIfThereAreFew) {
  // 61 spheres do not fill the lanes of vector instructions.
  expect_direct_sum(make_gas({.count = 61, .packing_fraction = 0.1, .seed = 54}), 5);
  expect_direct_sum(make_crystal(simple_cubic(), 4, 1.1), 8);
}

TEST(StructureFactor, OfACrystalHasBraggPeaksAndNothingElse) {
  const World world = make_crystal(simple_cubic(), 4, 1.1);
  const Measurement found = measured<StructureFactor>(world, 8, 100);
  const std::vector<double>& wave_number = values(found, "wave_number");
  const std::vector<double>& value = values(found, "structure_factor");
  const double unit = 2 * std::numbers::pi / 1.1;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const double place = wave_number[i] / unit;
    if (place < 0.95) {
      EXPECT_NEAR(value[i], 0, 1e-9) << place;
    }
    if (std::fabs(place - 1) < 1e-9) {
      EXPECT_NEAR(value[i], 64, 1e-9);
    }
  }
  EXPECT_GT(quantity(found, "highest_peak").value, 10);
}

// |sum of n random phases|^2 / n has mean 1 and standard deviation 1.
TEST(StructureFactor, OfAnIdealGasIsOne) {
  const Box box = Box::periodic({9, 11, 13});
  const std::vector<double> radii(500, 0.5);
  constexpr std::uint64_t kSamples = 40;
  const Measurement found = of_ideal_gases<StructureFactor>(box, radii, kSamples);
  const std::vector<double>& value = values(found, "structure_factor");
  const std::vector<double>& error = values(found, "structure_factor_error");
  double mean = 0;
  double squares = 0;
  const auto shells = static_cast<double>(value.size());
  EXPECT_GT(shells, 55);
  for (std::size_t i = 0; i < value.size(); ++i) {
    mean += value[i] / shells;
    squares += (value[i] - 1) * (value[i] - 1) / (error[i] * error[i]) / shells;
  }
  // At least 300 vectors in 40 samples; and 39 / 37 for the mean square, with its deviation over 60 shells.
  EXPECT_NEAR(mean, 1, 4 / std::sqrt(300.0 * kSamples));
  EXPECT_NEAR(squares, 39.0 / 37, 4 * std::sqrt(2.3 / 60));
}

TEST(StructureFactor, UsesPeriodicAxesOnly) {
  // Rows along x, in which spheres are 1.25 apart; along y and z they are anywhere.
  World rows(Box({Boundary::periodic, Boundary::wall, Boundary::open}, {20, 20, 0}));
  for (int i = 0; i < 16; ++i) {
    rows.add({.position = {1.25 * i, 1 + 1.1 * i, -3.7 * i * i}, .radius = 0.5});
  }
  const Measurement found = measured<StructureFactor>(rows, 12);
  const Quantity& peak = quantity(found, "highest_peak");
  EXPECT_NEAR(peak.value, 16, 1e-9);
  const double order = quantity(found, "highest_peak_wave_number").value * 1.25 / (2 * std::numbers::pi);
  EXPECT_NEAR(order, std::round(order), 1e-9);

  World walls(Box::walls({20, 20, 20}));
  walls.add({.position = {5, 5, 5}});
  EXPECT_TRUE(measured<StructureFactor>(walls).columns.empty());
}

// The phases stored along an axis are bounded, whatever the ratio of the box to the spheres.
TEST(StructureFactor, NeedsLittleMemoryForTinySpheres) {
  World world(Box::periodic({2, 2e3, 2}));
  for (const double x : {0.1, 0.7, 1.3}) world.add({{x, x, x}, {1, 0, 0}, 1e-9, 1});
  const Scene scene(world, Time(0));
  StructureFactor factor(scene);
  EXPECT_LT(factor.sample_cost(), 1e7);
  factor.sample(scene);
  const Measurement found = result_of(factor, scene);
  for (const double value : found.columns[1].values) EXPECT_TRUE(std::isfinite(value));
}

struct Reference {
  Lattice lattice;
  std::size_t cells;
  double neighbors;
  double bonds;
  double order_four;
  double order_six;
  double tolerance;
  bool is_flat = false;
};

// Source: Steinhardt, Nelson and Ronchetti, Phys. Rev. B 28 (1983) 784, figure 2; five digits after Mickel et
// al., J. Chem. Phys. 138 (2013) 044501, table I. Of discs the order of their own symmetry is one.
std::vector<Reference> crystals() {
  return {{face_centered_cubic(), 4, 12, 12, 0.19094, 0.57452, 6e-6},
          {hexagonal_close_packing(), 4, 12, 12, 0.09722, 0.48476, 6e-6},
          {body_centered_cubic(), 4, 8, 14, 0.03637, 0.51069, 6e-6},
          {simple_cubic(), 4, 6, 6, 0.76376, 0.35355, 6e-6},
          {hexagonal_of_discs(), 12, 6, 6, 0, 1, 1e-12, true},
          {square_of_discs(), 12, 4, 4, 1, 0, 1e-12, true}};
}

TEST(BondOrder, OfCrystalsHasThePublishedValues) {
  for (const Reference& crystal : crystals()) {
    const Measurement found = measured<BondOrder>(make_crystal(crystal.lattice, crystal.cells, 1.1));
    EXPECT_EQ(quantity(found, "mean_bonds").value, crystal.bonds);
    for (const std::string name : {crystal.is_flat ? "Psi" : "Q", crystal.is_flat ? "mean_psi" : "mean_q"}) {
      EXPECT_NEAR(quantity(found, name + "4").value, crystal.order_four, crystal.tolerance);
      EXPECT_NEAR(quantity(found, name + "6").value, crystal.order_six, crystal.tolerance);
    }
    const std::vector<double>& density = values(found, crystal.is_flat ? "psi6_density" : "q6_density");
    EXPECT_EQ(density[std::min<std::size_t>(static_cast<std::size_t>(crystal.order_six * 100), 99)], 100);
  }
}

TEST(Coordination, OfCrystalsIsThatOfTheirLattices) {
  for (const Reference& crystal : crystals()) {
    const Measurement found = measured<Coordination>(make_crystal(crystal.lattice, crystal.cells, 1.1));
    EXPECT_EQ(quantity(found, "mean_neighbors").value, crystal.neighbors);
    EXPECT_EQ(values(found, "fraction").back(), 1);
    EXPECT_EQ(values(found, "neighbors").back(), crystal.neighbors);
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
    return measured<BondOrder>(world);
  };
  const Measurement straight = turned(0, 0);
  for (const double angle : {0.4, 2.5}) {
    const Measurement found = turned(angle, 1.3 * angle);
    for (const char* name : {"Q4", "Q6", "mean_q4", "mean_q6"}) {
      EXPECT_NEAR(quantity(found, name).value, quantity(straight, name).value, 1e-12) << name;
    }
  }
}

TEST(BondOrder, OfAPairIsOne) {
  World world;
  world.add({.position = {0, 0, 0}, .radius = 1});
  world.add({.position = {1, 2, -1.5}, .radius = 1});
  world.add({.position = {40, 0, 0}, .radius = 1});
  const Measurement found = measured<BondOrder>(world);
  EXPECT_NEAR(quantity(found, "Q4").value, 1, 1e-12);
  EXPECT_NEAR(quantity(found, "Q6").value, 1, 1e-12);
  EXPECT_NEAR(quantity(found, "mean_bonds").value, 2.0 / 3, 1e-12);
  // Spheres without bonds do not count.
  EXPECT_NEAR(quantity(found, "mean_q6").value, 1, 1e-12);
}

TEST(BondOrder, OfManyRandomBondsGoesToZero) {
  const World world = make_ideal_gas(Box::periodic({12, 12, 12}), std::vector<double>(3000, 0.5), 56);
  const Measurement found = measured<BondOrder>(world);
  const double bonds = 3000 * quantity(found, "mean_bonds").value / 2;
  EXPECT_GT(bonds, 10000);
  // Squared, Q6 is the sum of 13 squares with a mean of 1 / 13 over the bonds each: its deviation is
  // sqrt(2 / 13) of the mean.
  const double square = std::pow(quantity(found, "Q6").value, 2) * bonds;
  EXPECT_NEAR(square, 1, 4 * std::sqrt(2.0 / 13));
}

// Coordination and the gaps of nearest neighbors, on states that can be counted by hand.

TEST(Coordination, ScalesWithTheRadiiOfBothSpheres) {
  World world;
  world.add({.position = {0, 0, 0}, .radius = 1});
  world.add({.position = {4.7, 0, 0}, .radius = 3});   // 1.175 times the sum of radii
  world.add({.position = {0, 2.45, 0}, .radius = 1});  // 1.225 times
  const Measurement found = measured<Coordination>(world);
  const std::vector<double>& fraction = values(found, "fraction");
  ASSERT_EQ(fraction.size(), 2U);
  EXPECT_DOUBLE_EQ(fraction[0], 1.0 / 3);
  EXPECT_DOUBLE_EQ(fraction[1], 2.0 / 3);
  EXPECT_DOUBLE_EQ(quantity(found, "mean_neighbors").value, 2.0 / 3);
}

TEST(NearestNeighbor, OfACrystalIsItsSpacing) {
  const Measurement found = measured<NearestNeighbor>(make_crystal(face_centered_cubic(), 4, 1.1));
  EXPECT_NEAR(quantity(found, "mean_gap").value, 0.1, 1e-12);
  const std::vector<double>& gap = values(found, "gap");
  const std::vector<double>& density = values(found, "probability_density");
  const double width = gap[1] - gap[0];
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const bool holds_it = std::fabs(gap[i] - 0.1) < width / 2;
    EXPECT_NEAR(density[i], holds_it ? 1 / width : 0, 1e-9);
  }
}

TEST(NearestNeighbor, IsTheOneWhoseSurfaceIsNearest) {
  World world(Box::periodic({20, 20, 20}));
  world.add({.position = {19, 1, 1}, .radius = 0.5});
  world.add({.position = {2, 1, 1}, .radius = 0.5});   // gaps of 2 to the first, across the boundary,
  world.add({.position = {2, 6, 1}, .radius = 3.75});  // and of 0.75 to the second
  const Measurement found = measured<NearestNeighbor>(world);
  const double diagonal = std::sqrt(9.0 + 25) - 4.25;
  EXPECT_NEAR(quantity(found, "mean_gap").value, (diagonal + 0.75 + 0.75) / 3, 1e-12);
}

TEST(NearestNeighbor, OfOneSphereIsNobody) {
  World world;
  EXPECT_TRUE(measured<NearestNeighbor>(world).columns.empty());
  world.add({});
  EXPECT_TRUE(measured<NearestNeighbor>(world).columns.empty());
}

// A sphere of radius 1 across the upper end of one periodic axis and the lower end of another, in slabs 0.5
// thick.
TEST(DensityProfiles, SliceASphereExactly) {
  World world(Box::periodic({6, 4, 5}));
  world.add({.position = {5.75, 0.5, 2.25}, .radius = 1});
  const Measurement found = measured<DensityProfiles>(world, 0.5);
  EXPECT_EQ(values(found, "position").size(), 12U);
  const std::vector<double>& along_x = values(found, "packing_fraction_x");
  const std::vector<double>& number_x = values(found, "number_density_x");
  // Of the unit ball between planes a and b from its center: pi ((b - b^3 / 3) - (a - a^3 / 3)).
  const auto slice = [](double a, double b) {
    return std::numbers::pi * ((b - b * b * b / 3) - (a - a * a * a / 3));
  };
  const double slab = 0.5 * 4 * 5;
  EXPECT_NEAR(along_x[11], slice(-0.25, 0.25) / slab, 1e-12);
  EXPECT_NEAR(along_x[10], slice(-0.75, -0.25) / slab, 1e-12);
  EXPECT_NEAR(along_x[9], slice(-1, -0.75) / slab, 1e-12);
  EXPECT_NEAR(along_x[8], 0, 1e-12);
  EXPECT_NEAR(along_x[0], slice(0.25, 0.75) / slab, 1e-12);
  EXPECT_NEAR(along_x[1], slice(0.75, 1) / slab, 1e-12);
  EXPECT_NEAR(number_x[11], 1 / slab, 1e-12);
  EXPECT_EQ(number_x[10], 0);
  // The shorter axes have fewer slabs.
  const std::vector<double>& along_y = values(found, "packing_fraction_y");
  EXPECT_NEAR(along_y[0], slice(-0.5, 0) / (0.5 * 30), 1e-12);
  EXPECT_NEAR(along_y[7], slice(-1, -0.5) / (0.5 * 30), 1e-12);
  EXPECT_TRUE(std::isnan(along_y[8]));
}

TEST(DensityProfiles, AddUpToTheSpheres) {
  const Box slit({Boundary::wall, Boundary::periodic, Boundary::wall}, {7.1, 9.3, 8.2});
  for (const World& world : {make_ideal_gas(slit, std::vector<double>(50, 0.7), 55),
                             make_ideal_gas(Box::flat_walls(7, 9), {0.25, 1, 0.5, 0.5, 0.75}, 3)}) {
    const Measurement found = measured<DensityProfiles>(world, 0.13);
    const std::vector<double>& position = values(found, "position");
    const double width = position[1] - position[0];
    for (std::size_t axis = 0; axis < world.box().dimensions(); ++axis) {
      const std::string name = kAxisNames[axis];
      const double size = world.box().size()[axis];
      double spheres = 0;
      double volume = 0;
      for (std::size_t bin = 0; bin < position.size(); ++bin) {
        const double low = static_cast<double>(bin) * width;
        if (low >= size * (1 - 1e-9)) continue;
        const double slab = std::min(width, size - low) * world.box().face_area(axis);
        spheres += values(found, "number_density_" + name)[bin] * slab;
        volume += values(found, "packing_fraction_" + name)[bin] * slab;
      }
      EXPECT_NEAR(spheres, static_cast<double>(world.size()), 1e-9) << name;
      EXPECT_NEAR(volume, sphere_volume(world, Time(0)), 1e-9) << name;
    }
  }
}

TEST(DensityProfilesOfDiscs, ArePerArea) {
  const Measurement found =
      measured<DensityProfiles>(make_ideal_gas(Box::flat_walls(7, 9), {0.25, 1, 0.5}, 3));
  EXPECT_EQ(column(found, "number_density_x").unit, "L^-2");
  EXPECT_EQ(quantity(found, "pressure_at_walls").unit, "M T^-2");
  EXPECT_THROW(column(found, "number_density_z"), std::out_of_range);
}

// Centers uniform over the space they can reach touch the walls as densely as they fill it.
TEST(DensityProfiles, KnowTheDensityAtTheWalls) {
  const Box box({Boundary::wall, Boundary::periodic, Boundary::wall}, {7, 9, 8});
  std::vector<double> radii(300, 0.25);
  radii.resize(600, 0.5);
  const Measurement found = of_ideal_gases<DensityProfiles>(box, radii, 640);
  const Quantity& density = quantity(found, "density_at_walls");
  // Along x, the free lengths of centers are 6.5 and 6; along z, 7.5 and 7. Walls are weighted by area.
  const double across_x = 300 / (9 * 8.0) * (1 / 6.5 + 1 / 6.0);
  const double across_z = 300 / (9 * 7.0) * (1 / 7.5 + 1 / 7.0);
  EXPECT_NEAR(density.value, (8 * across_x + 7 * across_z) / 15, 4 * density.error);
  EXPECT_LT(density.error, 0.04 * density.value);
}

TEST(DensityProfiles, TurnItIntoAPressureByTheSpeedTowardsTheWalls) {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::periodic}, {6, 6, 6}));
  world.add({.position = {1, 2, 2}, .velocity = {3, 50, 0}, .radius = 1, .mass = 2});
  const Measurement found = measured<DensityProfiles>(world, 0.1);
  const double density = quantity(found, "density_at_walls").value;
  EXPECT_GT(density, 0);
  EXPECT_DOUBLE_EQ(quantity(found, "pressure_at_walls").value, density * 2 * 9);
}

TEST(DensityProfiles, HaveNoMeaningInOpenSpace) {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {6, 6, 0}));
  world.add({.position = {1, 2, 2}});
  EXPECT_TRUE(measured<DensityProfiles>(world, 0.1).columns.empty());
  EXPECT_TRUE(measured<DensityProfiles>(world, 0.1).quantities.empty());
}

TEST(PercusYevick, HasTheCompressibilityOfTheLongestWaves) {
  for (const double p : {0.05, 0.2, 0.45}) {
    const double expected = std::pow(1 - p, 4) / std::pow(1 + 2 * p, 2);
    EXPECT_NEAR(percus_yevick_structure_factor(p, 0) / expected, 1, 1e-3) << p;
    EXPECT_NEAR(percus_yevick_structure_factor(p, 0.1) / expected, 1, 0.02) << p;
  }
}

// To first order in the density the direct correlation function is -1 within the diameter.
TEST(PercusYevick, OfADiluteGasIsThatOfLoneObstacles) {
  constexpr double kPacking = 1e-6;
  for (const double q : {0.5, 3.0, 7.0, 15.0}) {
    const double expected = 1 - 24 * kPacking * (std::sin(q) - q * std::cos(q)) / (q * q * q);
    EXPECT_NEAR((percus_yevick_structure_factor(kPacking, q) - 1) / (expected - 1), 1, 1e-4) << q;
  }
}

TEST(PercusYevick, AgreesWithNumericalIntegration) {
  constexpr double kPacking = 0.3;
  const double constant = std::pow(1 + 2 * kPacking, 2) / std::pow(1 - kPacking, 4);
  const double linear = -std::pow(1 + kPacking / 2, 2) / std::pow(1 - kPacking, 4);
  for (const double q : {0.7, 4.0, 7.1, 19.0}) {
    constexpr int kSteps = 100000;
    double direct = 0;
    for (int step = 0; step < kSteps; ++step) {
      const double x = (step + 0.5) / kSteps;
      direct -= 24 * kPacking / kSteps * x * std::sin(q * x) / q *
                (constant + 6 * kPacking * linear * x + kPacking / 2 * constant * x * x * x);
    }
    EXPECT_NEAR(percus_yevick_structure_factor(kPacking, q), 1 / (1 - direct), 1e-7) << q;
  }
}

TEST(NearestNeighbor, OfADiluteGasIsThatOfPoints) {
  constexpr double kPacking = 1e-4;
  EXPECT_EQ(nearest_neighbor_beyond(kPacking, 1), 1);
  // The expected number of centers in the shell between the diameter and the distance.
  const double expected = std::exp(-8 * kPacking * (1000 - 1));
  EXPECT_NEAR(nearest_neighbor_beyond(kPacking, 10) / expected, 1, 1e-3);
}

// Just outside contact the density of neighbors is that of the fluid times the contact value.
TEST(NearestNeighbor, HasTheSlopeOfTheContactValueAtContact) {
  constexpr double kPacking = 0.3;
  constexpr double kStep = 1e-6;
  const double contact_value = (1 - kPacking / 2) / std::pow(1 - kPacking, 3);
  const double lost = (1 - nearest_neighbor_beyond(kPacking, 1 + kStep)) / kStep;
  EXPECT_NEAR(lost / (24 * kPacking * contact_value), 1, 1e-4);
}

TEST(FluidPackingFraction, IsKnownOfEqualSpheresInAPeriodicBox) {
  const auto packing = [](double packing_fraction, Boundary boundary) {
    const World world = make_gas({.count = 64, .packing_fraction = packing_fraction, .boundary = boundary});
    return fluid_packing_fraction({world, Time(0)});
  };
  EXPECT_NEAR(packing(0.2, Boundary::periodic), 0.2, 1e-12);
  EXPECT_TRUE(std::isnan(packing(0.2, Boundary::wall)));
  EXPECT_TRUE(std::isnan(packing(0.2, Boundary::open)));
  const World frozen = make_gas({.count = 108, .packing_fraction = 0.5, .start = Start::fcc});
  EXPECT_TRUE(std::isnan(fluid_packing_fraction({frozen, Time(0)})));
  World mixture(Box::periodic({9, 9, 9}));
  mixture.add({.position = {1, 1, 1}, .radius = 1});
  mixture.add({.position = {5, 5, 5}, .radius = 2});
  EXPECT_TRUE(std::isnan(fluid_packing_fraction({mixture, Time(0)})));
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The means of a density over bins, weighted with (radius + gap)^2, by the midpoint rule.
template <class Density>
ContactExtrapolation::Bins means(const ContactExtrapolation& contact, double radius, const Density& density) {
  constexpr int kSteps = 1000;
  ContactExtrapolation::Bins means{};
  for (std::size_t bin = 0; bin < means.size(); ++bin) {
    double sum = 0;
    double weights = 0;
    for (int step = 0; step < kSteps; ++step) {
      const double gap = (static_cast<double>(bin) + (step + 0.5) / kSteps) * contact.bin_width();
      const double weight = std::isinf(radius) ? 1 : (radius + gap) * (radius + gap);
      sum += weight * density(gap);
      weights += weight;
    }
    means[bin] = sum / weights;
  }
  return means;
}

TEST(ContactExtrapolation, IsExactForCubics) {
  const auto cubic = [](double gap) { return 5 - 30 * gap + 80 * gap * gap - 90 * gap * gap * gap; };
  for (const double radius : {1.0, 0.3, kInfinity}) {
    const ContactExtrapolation contact(0.3, radius, 3);
    EXPECT_NEAR(contact.at_contact(means(contact, radius, cubic)), 5, 1e-5) << radius;
  }
}

// As steep as the pair density of the fluid at freezing, which falls by the factor exp(-8 gap / diameter).
TEST(ContactExtrapolation, FollowsTheSteepestFluid) {
  const ContactExtrapolation contact(ContactExtrapolation::kReach, 1, 3);
  const auto steep = [](double gap) { return 5.7 * std::exp(-8 * gap); };
  EXPECT_NEAR(contact.at_contact(means(contact, 1, steep)) / 5.7, 1, 1e-3);
}

TEST(ContactExtrapolation, KnowsTheBinOfAGap) {
  const ContactExtrapolation contact(0.3, kInfinity, 3);
  EXPECT_DOUBLE_EQ(contact.bin_width(), 0.02);
  EXPECT_EQ(contact.bin(0.01), 0U);
  EXPECT_EQ(contact.bin(0.05), 2U);
  EXPECT_EQ(contact.bin(-1e-15), 0U) << "an overlap by rounding";
  EXPECT_EQ(contact.bin(-0.01), ContactExtrapolation::kBins);
  EXPECT_EQ(contact.bin(0.299), 14U);
  EXPECT_EQ(contact.bin(0.3), ContactExtrapolation::kBins);
}

// Measures in two dimensions, on arrangements whose results are known.

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
  const Measurement found = measured<StructureFactor>(make_crystal(hexagonal_of_discs(), 12, 1.1));
  EXPECT_GT(values(found, "wave_number").size(), 30U);
  EXPECT_THROW(column(found, "structure_factor_theory"), std::out_of_range);
  // The lattice scatters with all its discs or not at all.
  for (const double value : values(found, "structure_factor")) EXPECT_LE(value, 288 + 1e-9);
}

// Enskog's rate and diffusion, written out for so many discs that a box of fixed energy is no different.
TEST(FluidTheoryOfDiscs, HasEnskogsRateAndDiffusion) {
  constexpr double kDiscs = 20000;
  const World world = make_discs(static_cast<std::size_t>(kDiscs), 0.3, 1);
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
  EXPECT_FALSE(FluidTheory(make_discs(200, 0.72, 1), SpeciesList(world)).holds());
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
  const World world = make_discs(100, 0.3, 2);
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
}  // namespace hardball::static_structure_test
