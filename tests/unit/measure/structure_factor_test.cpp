// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/structure_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "support/crystal.hpp"
#include "support/gas.hpp"
#include "support/measurement.hpp"

namespace hardball::structure_factor_test {
namespace {

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
  StructureFactor measure({world, Time(0)}, longest, kAllVectors);
  measure.sample({world, Time(0)});
  const Measurement found = measure.result({world, Time(0)});
  const std::vector<Shell> expected = direct_sum(world, longest);
  const std::vector<double>& wave_number = support::column(found, "wave_number").values;
  const std::vector<double>& value = support::column(found, "structure_factor").values;
  ASSERT_EQ(value.size(), expected.size());
  for (std::size_t shell = 0; shell < expected.size(); ++shell) {
    EXPECT_NEAR(wave_number[shell], expected[shell].wave_number, 1e-9);
    EXPECT_NEAR(value[shell], expected[shell].intensity, 1e-9 * static_cast<double>(world.size()));
  }
}

TEST(StructureFactor, IsTheSumOverAllWaveVectorsIfThereAreFew) {
  // 61 spheres do not fill the lanes of vector instructions.
  expect_direct_sum(support::make_gas({.count = 61, .packing_fraction = 0.1, .seed = 54}), 5);
  expect_direct_sum(support::make_crystal(support::simple_cubic(), 4, 1.1), 8);
}

TEST(StructureFactor, OfACrystalHasBraggPeaksAndNothingElse) {
  const World world = support::make_crystal(support::simple_cubic(), 4, 1.1);
  StructureFactor measure({world, Time(0)}, 8, 100);
  measure.sample({world, Time(0)});
  const Measurement found = measure.result({world, Time(0)});
  const std::vector<double>& wave_number = support::column(found, "wave_number").values;
  const std::vector<double>& value = support::column(found, "structure_factor").values;
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
  EXPECT_GT(support::quantity(found, "highest_peak").value, 10);
}

// |sum of n random phases|^2 / n has mean 1 and standard deviation 1.
TEST(StructureFactor, OfAnIdealGasIsOne) {
  const Box box = Box::periodic({9, 11, 13});
  const std::vector<double> radii(500, 0.5);
  const World first = support::make_ideal_gas(box, radii, 0);
  StructureFactor measure({first, Time(0)});
  constexpr std::uint64_t kSamples = 40;
  for (std::uint64_t sample = 0; sample < kSamples; ++sample) {
    measure.sample({support::make_ideal_gas(box, radii, sample), Time(0)});
  }
  const Measurement found = measure.result({first, Time(0)});
  const std::vector<double>& value = support::column(found, "structure_factor").values;
  const std::vector<double>& error = support::column(found, "structure_factor_error").values;
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
  StructureFactor measure({rows, Time(0)}, 12);
  measure.sample({rows, Time(0)});
  const Measurement found = measure.result({rows, Time(0)});
  const Quantity& peak = support::quantity(found, "highest_peak");
  EXPECT_NEAR(peak.value, 16, 1e-9);
  const double order =
      support::quantity(found, "highest_peak_wave_number").value * 1.25 / (2 * std::numbers::pi);
  EXPECT_NEAR(order, std::round(order), 1e-9);

  World walls(Box::walls({20, 20, 20}));
  walls.add({.position = {5, 5, 5}});
  StructureFactor nothing({walls, Time(0)});
  nothing.sample({walls, Time(0)});
  EXPECT_TRUE(nothing.result({walls, Time(0)}).columns.empty());
}

// The phases stored along an axis are bounded, whatever the ratio of the box to the spheres.
TEST(StructureFactor, NeedsLittleMemoryForTinySpheres) {
  World world(Box::periodic({2, 2e3, 2}));
  for (const double x : {0.1, 0.7, 1.3}) world.add({{x, x, x}, {1, 0, 0}, 1e-9, 1});
  const Scene scene(world, Time(0));
  StructureFactor factor(scene);
  EXPECT_LT(factor.sample_cost(), 1e7);
  factor.sample(scene);
  const Measurement found = factor.result(scene);
  for (const double value : found.columns[1].values) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace hardball::structure_factor_test
