// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
// Averages over pairs of times, and the two measures computed from them.
#include "hardball/measure/time_correlation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/measure/diffusion.hpp"
#include "hardball/numbers/random.hpp"
#include "support/measurement.hpp"

namespace hardball::time_correlation_test {
namespace {

using namespace support;

void add_products(std::span<const Vec3> earlier, std::span<const Vec3> later, double* sum) {
  for (std::size_t i = 0; i < later.size(); ++i) *sum += dot(earlier[i], later[i]);
}

// Spheres on a line that never meet.
World row(std::size_t count) {
  World world(Box::periodic({1000, 10, 10}));
  for (std::size_t i = 0; i < count; ++i) world.add({{2.0 * static_cast<double>(i), 5, 5}, {}, 0.5});
  return world;
}

// A component of a vector in a series of samples: different for each sphere and tick.
double value_of(SphereId id, int tick) {
  Random random(1000 * std::uint64_t{id} + static_cast<std::uint64_t>(tick));
  return random.uniform();
}

TEST(TimeCorrelation, IsADirectSumOverItsOrigins) {
  constexpr int kTicks = 75;
  const World world = row(5);
  TimeCorrelation average({world, Time(2)}, 0.5, TimeCorrelation::kMaxSpheres, {});
  for (int tick = 0; tick <= kTicks; ++tick) {
    average.sample({world, Time(2 + 0.5 * tick)}, add_products, [&](Slot slot, Vec3* vector) {
      *vector = {value_of(world.id(slot), tick), 0, 0};
    });
  }
  const std::vector<double> lags = average.lags();
  const std::vector<int> expected_ticks = {0,  1,  2,  3,  4,  5,  6,  7,  8,  10,
                                           12, 14, 16, 20, 24, 28, 32, 40, 48, 56};
  ASSERT_EQ(lags.size(), expected_ticks.size());
  for (std::size_t lag = 0; lag < lags.size(); ++lag) {
    const int ticks = expected_ticks[lag];
    EXPECT_EQ(lags[lag], 0.5 * ticks);
    int step = 1;
    while (ticks >= 8 * step) step *= 2;
    double sum = 0;
    double count = 0;
    // The start is an origin of the finest lags only.
    for (int origin = step == 1 ? 0 : step; origin + ticks <= kTicks; origin += step) {
      for (SphereId id = 0; id < 5; ++id) {
        sum += value_of(id, origin) * value_of(id, origin + ticks);
        ++count;
      }
    }
    EXPECT_NEAR(average.at(0, lag).value, sum / count, 1e-13) << ticks;
  }
}

TEST(TimeCorrelation, IgnoresTimesBetweenItsTicksAndLinksNothingAcrossAGap) {
  const World world = row(1);
  TimeCorrelation average({world, Time(0)}, 1, 10, {});
  const auto one = [](Slot, Vec3* vector) { *vector = {1, 0, 0}; };
  for (const double time : {0.0, 1.0, 1.5, 2.0, 2.0, 20.0, 21.0})
    average.sample({world, Time(time)}, add_products, one);
  EXPECT_EQ(average.lags(), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(average.at(0, 1).value, 1);
}

TEST(TimeCorrelation, FollowsSpheresChosenEvenly) {
  const World world = row(100);
  TimeCorrelation average({world, Time(0)}, 1, 7, {});
  std::vector<SphereId> followed;
  average.sample({world, Time(0)}, add_products,
                 [&](Slot slot, Vec3* /*vector*/) { followed.push_back(world.id(slot)); });
  EXPECT_EQ(followed, (std::vector<SphereId>{0, 15, 29, 43, 58, 72, 86}));
}

TEST(TimeCorrelation, HasTheErrorOfIndependentSpheres) {
  const World world = row(4);
  TimeCorrelation average({world, Time(0)}, 1, 10, {});
  average.sample({world, Time(0)}, add_products, [&](Slot slot, Vec3* vector) {
    *vector = {std::sqrt(1.0 + slot), 0, 0};
  });
  // The mean of 1, 2, 3 and 4.
  EXPECT_NEAR(average.at(0, 0).value, 2.5, 1e-12);
  const std::array shares{-1.5 / 4, -0.5 / 4, 0.5 / 4, 1.5 / 4};
  EXPECT_NEAR(average.at(0, 0).error, std::sqrt(2) * error_of_independent(shares), 1e-12);
}

TEST(TimeCorrelation, HasTheShortLagsOfWindowsAndTheLongOnesBetweenThem) {
  const World world = row(1);
  TimeCorrelation average({world, Time(0)}, 1, 10, {});
  const auto one = [](Slot, Vec3* vector) { *vector = {1, 0, 0}; };
  for (int window = 0; window < 5; ++window) {
    for (int tick = 0; tick < 16; ++tick)
      average.sample({world, Time(64 * window + tick)}, add_products, one);
  }
  EXPECT_EQ(average.lags(), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 56, 64, 128, 192}));
}

// Two kinds fly freely in opposite directions, through the periodic boundaries many times.
World two_streams() {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 2, 2}, {3, 0, 0}, 0.5, 1});
  world.add({{1, 4, 4}, {0, 3, 0}, 0.25, 1});
  world.add({{1, 6, 8}, {-3, 0, 0}, 0.5, 1});
  world.add({{5, 8, 6}, {0, -3, 0}, 0.25, 1});
  return world;
}

TEST(MeanSquareDisplacement, OfFreeFlightIsItsSquare) {
  const World world = two_streams();
  MeanSquareDisplacement displacement({world, Time(0)}, 0.75);
  for (int tick = 0; tick <= 40; ++tick) displacement.sample({world, Time(0.75 * tick)});
  const Measurement found = result_of(displacement, {world, Time(30)});
  const Column& lags = column(found, "lag");
  EXPECT_EQ(lags.values.front(), 0.75);
  EXPECT_EQ(lags.values.back(), 0.75 * 32);
  for (std::size_t i = 0; i < lags.values.size(); ++i) {
    const double way = 3 * lags.values[i];
    EXPECT_NEAR(values(found, "mean_square_displacement_1")[i], way * way, 1e-9 * way * way);
    EXPECT_NEAR(values(found, "mean_square_displacement_2")[i], way * way, 1e-9 * way * way);
  }
}

TEST(MeanSquareDisplacement, DoesNotCountTheDrift) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 2, 2}, {4, 1, 0}, 0.5});
  world.add({{1, 6, 8}, {4, -1, 0}, 0.5});
  MeanSquareDisplacement displacement({world, Time(0)}, 1);
  for (int tick = 0; tick <= 7; ++tick) displacement.sample({world, Time(tick)});
  const Measurement found = result_of(displacement, {world, Time(7)});
  EXPECT_NEAR(values(found, "mean_square_displacement")[6], 49, 1e-9);
  EXPECT_TRUE(std::isnan(quantity(found, "diffusion_constant").value)) << "free flight has no linear part";
}

// Steps of one radius up or down along each axis, one in each unit of time: D is half of their square.
TEST(MeanSquareDisplacement, OfARandomWalkGrowsByItsDiffusionConstant) {
  constexpr double kRadius = 0.5;
  constexpr int kSteps = 64;
  for (const Box& box : {Box::flat_periodic(1000, 1000), Box::periodic({1000, 1000, 1000})}) {
    Random random(3);
    std::vector<Vec3> places(400, 0.5 * box.size());
    const auto walkers = [&](double speed) {
      World world(box);
      for (std::size_t i = 0; i < places.size(); ++i)
        world.add({places[i], {i % 2 == 0 ? speed : -speed, 0, 0}, kRadius});
      return world;
    };
    // So fast that they would soon meet.
    const World start = walkers(1e6);
    MeanSquareDisplacement displacement({start, Time(0)}, 1);
    for (int step = 0; step <= kSteps; ++step) {
      displacement.sample({walkers(0), Time(step)});
      for (Vec3& place : places) {
        for (std::size_t axis = 0; axis < box.dimensions(); ++axis)
          place[axis] += random.uniform() < 0.5 ? kRadius : -kRadius;
      }
    }
    const Measurement found = result_of(displacement, {start, Time(kSteps)});
    const Quantity& constant = quantity(found, "diffusion_constant");
    constexpr double kExpected = kRadius * kRadius / 2;
    EXPECT_LT(constant.error, 0.1 * kExpected);
    EXPECT_NEAR(constant.value, kExpected, 4 * constant.error);
  }
}

TEST(VelocityAutocorrelation, OfFreeFlightStaysAndItsIntegralGrows) {
  const World world = two_streams();
  VelocityAutocorrelation velocities({world, Time(0)}, 0.5);
  for (int tick = 0; tick <= 20; ++tick) velocities.sample({world, Time(0.5 * tick)});
  const Measurement found = result_of(velocities, {world, Time(10)});
  const Column& lags = column(found, "lag");
  EXPECT_EQ(lags.values.front(), 0);
  for (std::size_t i = 0; i < lags.values.size(); ++i) {
    EXPECT_NEAR(values(found, "velocity_autocorrelation_1")[i], 9, 1e-12);
    EXPECT_NEAR(values(found, "diffusion_integral_2")[i], 3 * lags.values[i], 1e-12);
  }
}

// Velocities that decay as exp(-t) and places that follow them: the integral is exact at every lag, however
// far apart the samples are.
TEST(VelocityAutocorrelation, IntegratesExactlyBetweenSamples) {
  constexpr double kInterval = 4;
  const auto at = [](double time) {
    World world(Box::periodic({1000, 1000, 1000}));
    for (int i = 0; i < 4; ++i) {
      const Vec3 velocity = (i % 2 == 0 ? 1 : -1) * Vec3{std::exp(-time), 0, 0};
      const Vec3 place{500 + (i % 2 == 0 ? 1 : -1) * -std::expm1(-time), 200.0 * i + 100, 500};
      world.add({place, velocity, 0.5});
    }
    return world;
  };
  const World begin = at(0);
  VelocityAutocorrelation velocities({begin, Time(0)}, kInterval);
  for (const double time : {0.0, kInterval}) {
    const World world = at(time);
    World moved(world.box());
    // Paths that lead to these places at that time.
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const Path& path = world.path(slot);
      moved.add({path.position - time * path.velocity, path.velocity, 0.5});
    }
    velocities.sample({moved, Time(time)});
  }
  const Measurement found = result_of(velocities, {begin, Time(kInterval)});
  const double expected = (1 + std::exp(-kInterval)) / 2 * -std::expm1(-kInterval) / 3;
  EXPECT_NEAR(values(found, "diffusion_integral")[1], expected, 1e-12);
}

}  // namespace
}  // namespace hardball::time_correlation_test
