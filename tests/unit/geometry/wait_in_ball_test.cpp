// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/wait_in_ball.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hardball/numbers/random.hpp"

namespace hardball::wait_in_ball_test {
namespace {

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 v{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    if (const double size = length(v); size > 0.1 && size < 1) return (1 / size) * v;
  }
}

// A center in a ball, and how it moves.
struct Start {
  Vec3 position, velocity;
  double radius, gravity;
};

Start random_start(Random& random) {
  const double radius = std::exp(between(random, -3, 3));
  return {radius * between(random, 0, 1) * random_direction(random),
          std::exp(between(random, -6, 3)) * random_direction(random), radius,
          std::exp(between(random, -4, 2))};
}

template <class Real>
double falling_wait(const Start& start) {
  const auto real = [](double number) { return static_cast<Real>(number); };
  return falling_wait_in_ball(
      real(dot(start.position, start.position)), real(dot(start.position, start.velocity)),
      real(dot(start.velocity, start.velocity)), real(start.gravity), real(start.radius));
}

double farthest_until(const Start& start, const Vec3& gravity, double wait) {
  double farthest = 0;
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = wait * i / kSteps;
    farthest = std::max(farthest, length(start.position + t * start.velocity + t * t / 2 * gravity));
  }
  return farthest;
}

TEST(WaitInBall, OfAStraightPathEndsAtTheEdge) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const auto [position, velocity, radius, gravity] = random_start(random);
    const double wait = wait_in_ball(Motion(), position, velocity, radius);
    EXPECT_NEAR(length(position + wait * velocity), radius, 1e-9 * radius);
  }
  EXPECT_TRUE(std::isinf(wait_in_ball(Motion(), {0.5, 0, 0}, {}, 1)));
}

TEST(WaitInBall, OfAFallingPointEndsBeforeTheEdge) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const Start start = random_start(random);
    const Vec3 gravity = start.gravity * random_direction(random);
    EXPECT_LE(farthest_until(start, gravity, falling_wait<double>(start)), (1 + 1e-12) * start.radius);
    EXPECT_LE(farthest_until(start, gravity, falling_wait<float>(start)), (1 + 1e-6) * start.radius)
        << "single precision errs by less than lists allow for";
  }
}

TEST(WaitInBall, OfAFallingPointIsLong) {
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    Start start = random_start(random);
    start.position = 0.5 * start.position;
    // It could not leave sooner if it moved straight away from the middle, and fell that way.
    const double room = start.radius - length(start.position);
    const double speed = length(start.velocity);
    const double least = 2 * room / (speed + std::sqrt(speed * speed + 2 * start.gravity * room));
    EXPECT_GE(falling_wait<double>(start), (1 - 1e-12) * least);
    EXPECT_GE(falling_wait<float>(start), (1 - 1e-5) * least);
  }
}

TEST(WaitInBall, OfAPointThatBeginsToFallIsFinite) {
  EXPECT_DOUBLE_EQ(falling_wait_in_ball(0.0, 0.0, 0.0, 2.0, 1.0), 1) << "the way to the edge is g t^2 / 2";
}

}  // namespace
}  // namespace hardball::wait_in_ball_test
