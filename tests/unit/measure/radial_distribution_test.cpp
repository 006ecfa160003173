// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/radial_distribution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/crystal.hpp"
#include "support/measurement.hpp"

namespace hardball::radial_distribution_test {
namespace {

// The number of neighbors closer than a distance, from g(r) in a periodic box.
double neighbors_within(const Measurement& found, double density, double bin_width, double distance) {
  const std::vector<double>& r = support::column(found, "distance").values;
  const std::vector<double>& g = support::column(found, "g").values;
  double sum = 0;
  for (std::size_t i = 0; i < r.size() && r[i] < distance; ++i) {
    const double low = r[i] - bin_width / 2;
    const double high = r[i] + bin_width / 2;
    sum += g[i] * density * 4 * std::numbers::pi / 3 * (high * high * high - low * low * low);
  }
  return sum;
}

TEST(RadialDistribution, CountsTheShellsOfACrystal) {
  const double spacing = 1.2;
  const World world = support::make_crystal(support::face_centered_cubic(), 5, spacing);
  const double density = 500 / world.box().volume();
  RadialDistribution measure({world, Time(0)});
  measure.sample({world, Time(0)});
  const Measurement found = measure.result({world, Time(0)});
  const std::array<double, 6> expected{12, 6, 24, 12, 24, 8};
  double before = 0;
  for (std::size_t shell = 0; shell < expected.size(); ++shell) {
    const double between = spacing * std::sqrt(static_cast<double>(shell) + 1.5);
    const double within = neighbors_within(found, density, 0.02, between);
    EXPECT_NEAR(within - before, expected[shell], 1e-9);
    before = within;
  }
  EXPECT_EQ(support::quantity(found, "contact_value").value, 0) << "no gap is narrower than 0.2";
}

struct IdealCase {
  std::string name;
  std::array<Boundary, kAxes> boundary;
};

class IdealGas : public ::testing::TestWithParam<IdealCase> {};

// In every box an ideal gas must have g = 1, less one pair in n: a sphere is not its own neighbor. Over 100
// bins the squares of deviations, in standard errors from 24 samples, have a mean of 23 / 21 and a standard
// deviation of about sqrt(2.6 / 100).
TEST_P(IdealGas, IsUniformInEveryBox) {
  const auto [name, boundary] = GetParam();
  constexpr std::size_t kSpheres = 1000;
  constexpr int kSamples = 24;
  const Box box(boundary, {10, 12, 14});
  // Radii large enough that neglecting them, or the walls, would be detected.
  const std::vector<double> radii(kSpheres, 0.4);
  World first = support::make_ideal_gas(box, radii, 0);
  RadialDistribution measure({first, Time(0)}, 6, 0.05);
  for (int sample = 0; sample < kSamples; ++sample) {
    measure.sample({support::make_ideal_gas(box, radii, static_cast<std::uint64_t>(sample)), Time(0)});
  }
  const Measurement found = measure.result({first, Time(0)});
  const std::vector<double>& g = support::column(found, "g").values;
  const std::vector<double>& error = support::column(found, "g_error").values;
  ASSERT_EQ(g.size(), 100U);
  double squares = 0;
  double mean = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double deviation = g[i] - (1 - 1.0 / kSpheres);
    squares += deviation * deviation / (error[i] * error[i]);
    mean += deviation / static_cast<double>(g.size());
  }
  EXPECT_NEAR(squares / 100, 23.0 / 21, 4 * std::sqrt(0.026));
  EXPECT_NEAR(mean, 0, 5e-3);
  const Quantity& contact = support::quantity(found, "contact_value");
  EXPECT_NEAR(contact.value, 1, 4 * contact.error);
  EXPECT_LT(contact.error, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Boxes, IdealGas,
    ::testing::Values(IdealCase{"Periodic", {Boundary::periodic, Boundary::periodic, Boundary::periodic}},
                      IdealCase{"Slit", {Boundary::wall, Boundary::periodic, Boundary::periodic}},
                      IdealCase{"Channel", {Boundary::wall, Boundary::periodic, Boundary::wall}},
                      IdealCase{"Walls", {Boundary::wall, Boundary::wall, Boundary::wall}}),
    [](const auto& box) { return box.param.name; });

// Of a single pair g is one over what the ideal gas has in that bin: two ordered pairs of four, and the mean
// over all directions of the fraction of positions from which a displacement does not cross a wall.
TEST(RadialDistribution, HasTheExactIdealGasBetweenWalls) {
  constexpr double kRadius = 0.25;
  constexpr double kBin = 0.04;
  World world(Box::walls({4, 5, 6}));
  world.add({.position = {1, 1, 1}, .radius = kRadius});
  world.add({.position = {1, 1, 2.85}, .radius = kRadius});
  RadialDistribution measure({world, Time(0)}, 5, kBin / (2 * kRadius));
  measure.sample({world, Time(0)});
  const Measurement found = measure.result({world, Time(0)});
  const std::vector<double>& g = support::column(found, "g").values;
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
  const World first = support::make_ideal_gas(box, radii, 0);
  RadialDistribution measure({first, Time(0)});
  for (std::uint64_t sample = 0; sample < 20; ++sample) {
    measure.sample({support::make_ideal_gas(box, radii, sample), Time(0)});
  }
  const Measurement found = measure.result({first, Time(0)});
  for (const std::string pair : {"_1_1", "_1_2", "_2_2"}) {
    const std::vector<double>& g = support::column(found, "g" + pair).values;
    const std::vector<double>& error = support::column(found, "g" + pair + "_error").values;
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
    const Quantity& contact = support::quantity(found, "contact_value" + pair);
    EXPECT_NEAR(contact.value, 1, 4 * contact.error) << pair;
    EXPECT_GT(contact.theory, 1) << pair;
  }
}

TEST(RadialDistribution, OfTwoSpheresIsOnePair) {
  World world(Box::periodic({10, 10, 10}));
  world.add({.position = {1, 1, 1}, .radius = 0.5});
  world.add({.position = {9, 1, 1}, .radius = 0.5});
  RadialDistribution measure({world, Time(0)});
  measure.sample({world, Time(0)});
  const Measurement found = measure.result({world, Time(0)});
  EXPECT_NEAR(neighbors_within(found, 2 / 1000.0, 0.02, 1.9), 0, 1e-12);
  EXPECT_NEAR(neighbors_within(found, 2 / 1000.0, 0.02, 2.1), 1, 1e-12);
}

TEST(RadialDistribution, OfManyRadiiHasNoContact) {
  Random random(53);
  std::vector<double> radii;
  for (int i = 0; i < 200; ++i) radii.push_back(0.1 + 0.3 * random.uniform());
  const World world = support::make_ideal_gas(Box::periodic({10, 10, 10}), radii, 1);
  RadialDistribution measure({world, Time(0)});
  measure.sample({world, Time(0)});
  const Measurement found = measure.result({world, Time(0)});
  EXPECT_TRUE(found.quantities.empty());
  EXPECT_FALSE(support::column(found, "g").values.empty());
}

TEST(RadialDistribution, HasNoMeaningWithoutADensity) {
  for (const Box& box : {Box::open(), Box({Boundary::open, Boundary::wall, Boundary::wall}, {0, 9, 9})}) {
    World world(box);
    world.add({.position = {2, 2, 2}});
    world.add({.position = {6, 6, 6}});
    RadialDistribution measure({world, Time(0)});
    measure.sample({world, Time(0)});
    EXPECT_TRUE(measure.result({world, Time(0)}).columns.empty());
    EXPECT_TRUE(measure.result({world, Time(0)}).quantities.empty());
  }
}

}  // namespace
}  // namespace hardball::radial_distribution_test
