// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/placement/radii.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::radii_test {
namespace {

using namespace support;
using Kind = RadiusDistribution::Kind;

RadiusDistribution between(Kind kind, double min, double max) {
  RadiusDistribution distribution;
  distribution.kind = kind;
  distribution.min = min;
  distribution.max = max;
  distribution.where = "gas.toml:7:10";
  return distribution;
}

RadiusDistribution powerlaw(double exponent, double min, double max) {
  RadiusDistribution distribution = between(Kind::powerlaw, min, max);
  distribution.exponent = exponent;
  return distribution;
}

RadiusDistribution lognormal(double mean, double sigma, double min = 1e-60, double max = 1e60) {
  RadiusDistribution distribution = between(Kind::lognormal, min, max);
  distribution.mean = mean;
  distribution.sigma = sigma;
  return distribution;
}

RadiusDistribution discrete(std::vector<double> values, std::vector<double> weights) {
  RadiusDistribution distribution;
  distribution.kind = Kind::discrete;
  distribution.values = std::move(values);
  distribution.weights = std::move(weights);
  return distribution;
}

RadiusDistribution of_file(const std::filesystem::path& file) {
  RadiusDistribution distribution;
  distribution.kind = Kind::file;
  distribution.file = file;
  distribution.where = "gas.toml:7:10";
  return distribution;
}

std::vector<double> draw(const RadiusDistribution& distribution, std::size_t count, std::uint64_t seed = 3) {
  Random random(seed);
  return draw_radii(distribution, count, random);
}

// The largest distance of the sample's cumulative distribution from the one given, in units of 1/sqrt(count).
// Beyond 1.95 with a probability of 0.001 (Kolmogorov).
double kolmogorov(std::vector<double> sample, const std::function<double(double)>& cumulative) {
  std::ranges::sort(sample);
  const auto count = static_cast<double>(sample.size());
  double farthest = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double expected = cumulative(sample[i]);
    farthest = std::max(
        {farthest, expected - static_cast<double>(i) / count, static_cast<double>(i + 1) / count - expected});
  }
  return farthest * std::sqrt(count);
}

TEST(DrawRadii, FollowsTheUniformDistribution) {
  const auto cumulative = [](double r) { return (r - 0.5) / 1.5; };
  EXPECT_LT(kolmogorov(draw(between(Kind::uniform, 0.5, 2), 20000), cumulative), 1.95);
}

TEST(DrawRadii, FollowsTheLognormalDistribution) {
  const auto cumulative = [](double r) {
    return std::erfc(-(std::log(r / 2) + 0.3 * 0.3 / 2) / 0.3 / std::sqrt(2)) / 2;
  };
  EXPECT_LT(kolmogorov(draw(lognormal(2, 0.3), 20000), cumulative), 1.95);
  const double low = cumulative(1.5);
  const double high = cumulative(3);
  const std::vector<double> truncated = draw(lognormal(2, 0.3, 1.5, 3), 20000);
  EXPECT_GE(std::ranges::min(truncated), 1.5);
  EXPECT_LE(std::ranges::max(truncated), 3);
  EXPECT_LT(kolmogorov(truncated, [&](double r) { return (cumulative(r) - low) / (high - low); }), 1.95);
}

TEST(DrawRadii, LognormalHasTheMeanThatIsGiven) {
  double sum = 0;
  for (const double radius : draw(lognormal(2, 0.5), 100000)) sum += radius;
  // The standard deviation of a radius is mean * sqrt(exp(sigma^2) - 1); five of that of the mean.
  EXPECT_NEAR(sum / 100000, 2, 5 * 2 * std::sqrt((std::exp(0.25) - 1) / 100000));
}

TEST(DrawRadii, FollowsPowerLaws) {
  for (const double exponent : {-1000.0, -4.0, -2.5, -1.000001, -1.0, -0.999999, 0.0, 2.0, 1000.0}) {
    const double a = exponent + 1;
    const auto cumulative = [&](double r) {
      if (std::fabs(a) < 1e-5) return std::log(r / 0.5) / std::log(6);
      if (a > 0) return (std::pow(r / 3, a) - std::pow(0.5 / 3, a)) / (1 - std::pow(0.5 / 3, a));
      return (1 - std::pow(r / 0.5, a)) / (1 - std::pow(3 / 0.5, a));
    };
    const std::vector<double> radii = draw(powerlaw(exponent, 0.5, 3), 20000);
    EXPECT_GE(std::ranges::min(radii), 0.5);
    EXPECT_LE(std::ranges::max(radii), 3);
    EXPECT_LT(kolmogorov(radii, cumulative), 1.95) << exponent;
  }
  EXPECT_EQ(draw(powerlaw(-3, 2, 2), 3), std::vector<double>(3, 2));
}

TEST(DrawRadii, GivesDiscreteRadiiExactlyInRandomOrder) {
  const std::vector<double> radii = draw(discrete({3, 1, 2}, {1, 2, 4}), 1000);
  // Shares of 142.86, 285.71 and 571.43: the largest remainders are those of the first two.
  EXPECT_EQ(std::ranges::count(radii, 3), 143);
  EXPECT_EQ(std::ranges::count(radii, 1), 286);
  EXPECT_EQ(std::ranges::count(radii, 2), 571);
  EXPECT_NEAR(static_cast<double>(std::count(radii.begin(), radii.begin() + 500, 2)), 285.5, 50);
  EXPECT_EQ(draw(discrete({3, 1}, {1, 1}), 1), std::vector<double>{3});
  EXPECT_EQ(draw(discrete({3, 1}, {1, 1e-9}), 2), (std::vector<double>{3, 3}));
}

TEST(DrawRadii, ReadsAFile) {
  const ScratchFolder folder;
  write_text(folder / "radii.txt", "0.5\n1e-1\r\n2\n");
  EXPECT_EQ(draw(of_file(folder / "radii.txt"), 3), (std::vector<double>{0.5, 0.1, 2}));
  write_text(folder / "radii.txt", "0.5\n1e-1\n2");
  EXPECT_EQ(draw(of_file(folder / "radii.txt"), 3), (std::vector<double>{0.5, 0.1, 2}));
}

std::string error_of(const RadiusDistribution& distribution, std::size_t count) {
  return refusal_of([&] { draw(distribution, count); });
}

TEST(DrawRadii, ExplainsWhatIsWrong) {
  const ScratchFolder folder;
  const std::string file = (folder / "radii.txt").string();
  const auto expect_error = [](const std::string& error, const std::string& where, const std::string& what) {
    EXPECT_NE(error.find(where), std::string::npos) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  };
  expect_error(error_of(of_file(file), 3), "gas.toml:7:10", "cannot be read");
  expect_error(error_of(of_file(folder.path()), 3), "gas.toml:7:10", "cannot be read");
  write_text(file, "0.5\n1\n");
  expect_error(error_of(of_file(file), 3), file, "holds 2 radii");
  expect_error(error_of(of_file(file), 1), file, "holds more than 1 radii");
  for (const std::string line : {"one", "", "1 2", " 1"}) {
    write_text(file, "0.5\n" + line + "\n2\n");
    expect_error(error_of(of_file(file), 3), file + ":2", "is not a number");
  }
  for (const std::string line : {"0", "-1", "nan", "inf"}) {
    write_text(file, "0.5\n" + line + "\n2\n");
    expect_error(error_of(of_file(file), 3), file + ":2", "radius is ");
  }
  expect_error(error_of(lognormal(1, 0.1, 5, 6), 3), "gas.toml:7:10", "none is between");
}

// The same on every platform: FNV-1a of the bits of the radii.
std::uint64_t hash_of(const std::vector<double>& radii) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double radius : radii) hash = (hash ^ std::bit_cast<std::uint64_t>(radius)) * 0x100000001b3;
  return hash;
}

TEST(DrawRadii, GivesTheSameBitsEverywhere) {
  EXPECT_EQ(hash_of(draw(between(Kind::uniform, 0.5, 2), 1000)), 0xfc65686aa1a436a6U);
  EXPECT_EQ(hash_of(draw(lognormal(2, 0.3, 1, 4), 1000)), 0xab741fb41e49f8aaU);
  EXPECT_EQ(hash_of(draw(powerlaw(-2.5, 0.5, 3), 1000)), 0x64132f70e477a33eU);
  EXPECT_EQ(hash_of(draw(powerlaw(2, 0.5, 3), 1000)), 0xd2cb8a6519f99383U);
  EXPECT_EQ(hash_of(draw(discrete({3, 1, 2}, {1, 2, 4}), 1000)), 0x0d8b3b178b17a745U);
}

TEST(SpreadRadii, EachStandsForAnEqualShareAndTheMeanIsThatOfTheDistribution) {
  for (const std::size_t count : {1U, 2U, 7U, 500U}) {
    Random random(3);
    std::vector<double> radii = spread_radii(between(Kind::uniform, 20, 50), count, random);
    std::ranges::sort(radii);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += radii[i];
      EXPECT_GE(radii[i], 20 + 30.0 * static_cast<double>(i) / static_cast<double>(count) - 1e-12);
      EXPECT_LE(radii[i], 20 + 30.0 * static_cast<double>(i + 1) / static_cast<double>(count) + 1e-12);
    }
    EXPECT_NEAR(sum / static_cast<double>(count), 35, 1e-12);
  }
}

// The mean of r^e between 1 and 4, with a = e + 1: a (4^(a + 1) - 1) / ((a + 1) (4^a - 1)).
TEST(SpreadRadii, PowersHaveTheirMeanWithinTheirRange) {
  for (const double exponent : {-60.0, -3.0, -2.0, -1.0, -0.5, 0.0, 2.0, 60.0}) {
    const double a = exponent + 1;
    double mean = a * (std::pow(4, a + 1) - 1) / ((a + 1) * (std::pow(4, a) - 1));
    if (a == 0) mean = 3 / std::log(4);
    if (a == -1) mean = std::log(4) / (1 - 0.25);
    for (const std::size_t count : {1U, 2U, 3U, 400U}) {
      Random random(5);
      const std::vector<double> radii = spread_radii(powerlaw(exponent, 1, 4), count, random);
      double sum = 0;
      for (const double radius : radii) {
        sum += radius;
        EXPECT_GE(radius, 1);
        EXPECT_LE(radius, 4);
      }
      EXPECT_NEAR(sum / static_cast<double>(count), mean, 1e-11) << exponent << " " << count;
    }
  }
}

}  // namespace
}  // namespace hardball::radii_test
