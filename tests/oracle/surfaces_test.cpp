// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// When a sphere on a line or a parabola touches a surface, found by plain geometry with 113 bits: the
// distance from the surface is followed in small steps, and where it falls below the radius, bisected.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>

#include "hardball/numbers/random.hpp"
#include "hardball/surfaces/surface.hpp"
#include "support/effort.hpp"

namespace hardball::surfaces_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Quads = std::array<Quad, kAxes>;

Quad dot(const Quads& a, const Vec3& b) {
  return a[0] * b.x + a[1] * b.y + a[2] * b.z;
}

// Distance of the center from the surface, less the radius, at the time `t` after the start of the path.
using Gap = std::function<Quad(const Quad& t)>;

struct Case {
  Surface surface;
  Motion motion;
  Path path;
  double radius;
  Gap gap;

  // Of the sphere, at the time `t` after the start of the path.
  Quad radius_at(const Quad& t) const {
    const Growth& growth = motion.growth();
    const Quad since = Quad(path.time.high) + Quad(path.time.low) + t - Quad(growth.begin.high);
    return Quad(radius) * (Quad(growth.scale) + Quad(growth.rate) * since);
  }
};

Quads center(const Case& given, const Quad& t, const Vec3& point, const Vec3& velocity) {
  Quads place;
  const Quad now = Quad(given.path.time.high) + Quad(given.path.time.low) + t;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    place[axis] = Quad(given.path.position[axis]) + t * Quad(given.path.velocity[axis]) +
                  t * t / 2 * Quad(given.motion.gravity()[axis]) - Quad(point[axis]) -
                  now * Quad(velocity[axis]);
  }
  return place;
}

Quad norm(const Quads& a) {
  return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

Case make_case(Random& random, int shape, bool falls, bool moves, bool grows) {
  const auto vector = [&random](double scale) {
    return scale * Vec3{random.normal(), random.normal(), random.normal()};
  };
  const Vec3 direction = random.direction();
  const Vec3 point = vector(0.3);
  const Vec3 velocity = moves && shape != 1 ? vector(0.1) : Vec3{};
  Case made{Surface(Plane({1, 0, 0}), {}),
            Motion(falls ? vector(1) : Vec3{}),
            {vector(0.5), vector(1), Time(10 * random.uniform(), 1e-18 * random.normal())},
            0.05 + 0.2 * random.uniform(),
            {}};
  if (grows) {
    made.motion = Motion();
    // The epoch begins with the path, or earlier.
    const double begin = made.path.time.high - random.uniform();
    made.motion.set_growth(
        {Time(begin), Time(begin + 10), 0.5 + random.uniform(), 0.6 * random.uniform() - 0.1});
  }
  if (shape == 0) {
    made.surface = Surface(Plane(direction), point - 2 * direction, velocity);
    made.gap = [=, &made](const Quad& t) {
      return dot(center(made, t, point - 2 * direction, velocity), direction) - made.radius_at(t);
    };
  } else if (shape == 1) {
    const double amplitude = 0.3;
    const double frequency = 0.2 + 2 * random.uniform();
    made.surface = Surface(OscillatingPlane(direction, amplitude, frequency), point - 2 * direction);
    made.gap = [=, &made](const Quad& t) {
      const Quad now = Quad(made.path.time.high) + Quad(made.path.time.low) + t;
      const Quad phase = 2 * boost::math::constants::pi<Quad>() * Quad(frequency) * now;
      return dot(center(made, t, point - 2 * direction, {}), direction) - made.radius_at(t) -
             Quad(amplitude) * sin(phase);
    };
  } else if (shape == 2) {
    made.surface = Surface(Cylinder(direction, 3), point, velocity);
    made.gap = [=, &made](const Quad& t) {
      Quads place = center(made, t, point, velocity);
      const Quad along = dot(place, direction);
      for (std::size_t axis = 0; axis < kAxes; ++axis) place[axis] -= along * Quad(direction[axis]);
      return Quad(3) - made.radius_at(t) - norm(place);
    };
  } else if (shape == 3) {
    made.surface = Surface(HollowSphere(3), point, velocity);
    made.gap = [=, &made](const Quad& t) {
      return Quad(3) - made.radius_at(t) - norm(center(made, t, point, velocity));
    };
  } else if (shape == 4) {
    const double slope = 0.3 + random.uniform();
    const Vec3 apex = point - 3 / slope * direction;
    made.surface = Surface(Cone(direction, slope), apex, velocity);
    made.gap = [=, &made](const Quad& t) {
      Quads place = center(made, t, apex, velocity);
      const Quad along = dot(place, direction);
      for (std::size_t axis = 0; axis < kAxes; ++axis) place[axis] -= along * Quad(direction[axis]);
      return (along * Quad(slope) - norm(place)) / sqrt(1 + Quad(slope) * Quad(slope)) - made.radius_at(t);
    };
  } else if (shape == 5) {
    const Vec3 aside = part_across(random.direction(), direction);
    const Vec3 far = point + 2 / length(aside) * aside;
    made.surface = Surface(Pillar(direction, 0.9), far, velocity);
    made.gap = [=, &made](const Quad& t) {
      Quads place = center(made, t, far, velocity);
      const Quad along = dot(place, direction);
      for (std::size_t axis = 0; axis < kAxes; ++axis) place[axis] -= along * Quad(direction[axis]);
      return norm(place) - Quad(0.9) - made.radius_at(t);
    };
  } else {
    const Vec3 far = point + 2 * random.direction();
    made.surface = Surface(Obstacle(0.9), far, velocity);
    made.gap = [=, &made](const Quad& t) {
      return norm(center(made, t, far, velocity)) - Quad(0.9) - made.radius_at(t);
    };
  }
  return made;
}

// The first time at which the gap closes, up to `end`; negative if none is seen.
Quad first_closure(const Gap& gap, double end, int steps) {
  Quad before = 0;
  for (int i = 1; i <= steps; ++i) {
    const Quad t = Quad(end) * i / steps;
    if (gap(t) <= 0) {
      Quad low = before;
      Quad high = t;
      for (int step = 0; step < 110; ++step) {
        const Quad middle = (low + high) / 2;
        (gap(middle) > 0 ? low : high) = middle;
      }
      return high;
    }
    before = t;
  }
  return -1;
}

class SurfaceContact : public testing::TestWithParam<int> {};

TEST_P(SurfaceContact, AgreesWithPlainGeometryTo113Bits) {
  Random random(static_cast<std::uint64_t>(100 + GetParam()));
  int contacts = 0;
  int misses = 0;
  constexpr double kEnd = 6;
  constexpr int kSteps = 400;
  for (int i = 0; i < static_cast<int>(support::cases(1000)); ++i) {
    Case given = make_case(random, GetParam(), i % 2 == 0, i % 3 == 0, i % 5 == 0);
    if (given.gap(0) <= 0) continue;
    const Time contact = given.surface.contact_time(given.motion, given.path, given.radius);
    const Quad expected = first_closure(given.gap, kEnd, kSteps);
    const double wait = contact == kNever ? 2 * kEnd : duration(given.path.time, contact);
    if (expected < 0) {
      // A graze between two steps.
      if (wait < kEnd) {
        EXPECT_LT(abs(given.gap(Quad(wait))), 1e-4) << i;
      }
      ++misses;
      continue;
    }
    ++contacts;
    const Quad found =
        (Quad(contact.high) - Quad(given.path.time.high)) + (Quad(contact.low) - Quad(given.path.time.low));
    if (found < expected && abs(given.gap(found)) < 1e-14) continue;  // a graze that the steps missed
    // How fast the gap closes decides what an error of the distance means; rounding errors of unit vectors
    // and of places are errors of the distance.
    const Quad step = Quad(1e-9);
    const Quad speed = abs(given.gap(expected + step) - given.gap(expected - step)) / (2 * step);
    ASSERT_LT(abs(found - expected), Quad(4e-16) * expected + Quad(4e-15) / speed) << i;
    // Nothing but the path enters, and it is free before.
    ASSERT_LE(given.surface.free_until(given.motion, given.path, given.radius, given.path.time),
              contact.high);
  }
  EXPECT_GT(contacts, static_cast<int>(support::cases(25)));
  if (GetParam() == 0 || GetParam() == 5) {
    EXPECT_GT(misses, 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Shape, SurfaceContact, testing::Range(0, 7));

}  // namespace
}  // namespace hardball::surfaces_test
