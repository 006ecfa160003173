// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/polynomial.hpp"

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/cone.hpp"
#include "hardball/surfaces/oscillating_plane.hpp"
#include "hardball/surfaces/sine.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/walls.hpp"
#include "support/effort.hpp"

namespace hardball::surfaces_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

constexpr double kForever = std::numeric_limits<double>::infinity();

Polynomial make(const std::vector<double>& coefficients) {
  Polynomial p;
  for (std::size_t i = 0; i < coefficients.size(); ++i) p.coefficients[i] = {coefficients[i], 0};
  return p;
}

// The coefficients of a (t - r_1) (t - r_2) ..., rounded.
Polynomial with_roots(double a, const std::vector<double>& roots) {
  std::vector<double> coefficients{a};
  for (const double root : roots) {
    coefficients.push_back(0);
    for (std::size_t i = coefficients.size(); i-- > 1;)
      coefficients[i] = coefficients[i - 1] - root * coefficients[i];
    coefficients[0] *= -root;
  }
  return make(coefficients);
}

Quad value_of(const Polynomial& p, const Quad& t) {
  Quad value = 0;
  for (std::size_t i = Polynomial::kMaxDegree + 1; i-- > 0;) {
    value = value * t + Quad(p.coefficients[i].high) + Quad(p.coefficients[i].low);
  }
  return value;
}

TEST(Polynomial, HasItsValueDegreeAndDerivative) {
  const Polynomial p = make({1, -2, 3, 0.5});
  EXPECT_EQ(p(2).high, 1 - 4 + 12 + 4);
  EXPECT_EQ(p.degree(), 3U);
  EXPECT_EQ(p.derivative()(2).high, -2 + 12 + 6);
  EXPECT_EQ(make({}).degree(), 0U);
}

TEST(EarliestDescent, IsWhereTheGapCloses) {
  EXPECT_EQ(earliest_descent(make({1, -2})), 0.5);
  EXPECT_EQ(earliest_descent(make({1, 2})), kForever);
  EXPECT_EQ(earliest_descent(make({2, -3, 1})), 1) << "the first of the roots 1 and 2";
  EXPECT_EQ(earliest_descent(make({-2, 3, -1})), 2) << "overlapping, it opens at 1 and closes at 2";
  EXPECT_EQ(earliest_descent(make({1, -2, 1})), kForever) << "it only grazes";
  EXPECT_EQ(earliest_descent(with_roots(1, {1, 2, 3, 4})), 1);
  EXPECT_EQ(earliest_descent(with_roots(-1, {1, 2, 3, 4})), 2);
  EXPECT_EQ(earliest_descent(with_roots(-1, {-1, -2, -3, 4})), 4);
  EXPECT_EQ(earliest_descent(with_roots(1, {-1, -2, -3, -4})), kForever);
  EXPECT_EQ(earliest_descent(with_roots(-1, {-1, -2, 8})), 8);
}

TEST(EarliestDescent, IsAtOnceIfClosedAndClosing) {
  EXPECT_EQ(earliest_descent(make({0, -1})), 0);
  EXPECT_EQ(earliest_descent(make({-1, -1, 5})), 0);
  EXPECT_EQ(earliest_descent(make({0, 0, -1})), 0) << "at rest, and pressed";
  EXPECT_EQ(earliest_descent(make({0, 0, 0, 0, -1})), 0);
  EXPECT_EQ(earliest_descent(make({0, 0, 1})), kForever);
  EXPECT_EQ(earliest_descent(make({0, 0})), kForever);
  EXPECT_EQ(earliest_descent(make({0, 0, 0, 1, -1})), 1);
}

TEST(EarliestDescent, IsAtTheTurnOfAGapThatStaysClosed) {
  EXPECT_EQ(earliest_descent(make({-2, 2, -1})), 1);
  EXPECT_EQ(earliest_descent(make({-4, 4, 0, 0, -1})), 1);
}

// A search in small steps with 113 bits, and bisection; nothing if the result depends on rounding.
struct Reference {
  bool is_clear = true;
  Quad time = -1;
};

Reference search(const Polynomial& p, double end, int steps) {
  Reference found;
  Quad before = value_of(p, 0);
  if (before <= 0) return {false, 0};
  for (int i = 1; i <= steps; ++i) {
    const Quad t = Quad(end) * i / steps;
    const Quad value = value_of(p, t);
    if (value <= 0) {
      Quad low = Quad(end) * (i - 1) / steps;
      Quad high = t;
      for (int step = 0; step < 120; ++step) {
        const Quad middle = (low + high) / 2;
        (value_of(p, middle) > 0 ? low : high) = middle;
      }
      found.time = high;
      return found;
    }
    before = value;
  }
  return found;
}

TEST(EarliestDescent, IsExactForRandomQuartics) {
  Random random(2026);
  int found = 0;
  for (int i = 0; i < static_cast<int>(support::cases(3000)); ++i) {
    const auto degree = 3 + static_cast<std::size_t>(2 * random.uniform());
    std::vector<double> coefficients{random.uniform()};
    for (std::size_t k = 1; k <= degree; ++k) coefficients.push_back(random.normal());
    const Polynomial p = make(coefficients);
    const double wait = earliest_descent(p);
    const Reference reference = search(p, 4, 2000);
    if (!reference.is_clear) continue;
    if (reference.time < 0) {
      // A dip between two steps of the search may be found here only.
      if (wait < 4) {
        EXPECT_LT(abs(value_of(p, Quad(wait))), 1e-5) << i;
      }
      continue;
    }
    ++found;
    // The least double at which the polynomial is not positive.
    ASSERT_LE(value_of(p, Quad(wait)), 0) << i;
    ASSERT_GT(value_of(p, Quad(std::nextafter(wait, 0.0))), 0) << i;
    ASSERT_LE(Quad(wait), reference.time + Quad(wait) * std::numeric_limits<double>::epsilon()) << i;
  }
  EXPECT_GT(found, static_cast<int>(support::cases(1000)));
}

TEST(EarliestDescent, IsAccurateForParabolas) {
  Random random(7);
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < static_cast<int>(support::cases(100000)); ++i) {
    // From far above, from close by, and nearly grazing.
    const double scale = std::ldexp(random.uniform(), -static_cast<int>(40 * random.uniform()));
    const Polynomial p = make({scale * random.uniform(), random.normal(), random.normal()});
    const double wait = earliest_descent(p);
    if (!std::isfinite(wait) || wait == 0) continue;
    const Quad a = p.coefficients[2].high;
    const Quad b = p.coefficients[1].high;
    const Quad c = p.coefficients[0].high;
    const Quad root = sqrt(b * b - 4 * a * c);
    const Quad exact = b < 0 ? 2 * c / (root - b) : (-b - root) / (2 * a);
    ASSERT_LE(abs(Quad(wait) - exact), 4 * kUlp * exact) << i;
  }
}

using Wide = boost::multiprecision::cpp_bin_float_100;

TEST(Circular, IsExactInTheQuadrants) {
  EXPECT_EQ(circular(1, Time(0)).sine.high, 0);
  EXPECT_EQ(circular(1, Time(0)).cosine.high, 1);
  EXPECT_EQ(circular(1, Time(0.25)).sine.high, 1);
  EXPECT_EQ(circular(0.5, Time(1)).cosine.high, -1);
  EXPECT_EQ(circular(1, Time(1e15 + 0.75)).sine.high, -1);
  EXPECT_EQ(circular(1, Time(-0.25)).sine.high, -1);
}

TEST(Circular, IsDefinedForAnyNumberOfTurns) {
  for (const double frequency : {1e40, 1e200, 1e300}) {
    const Circular found = circular(frequency, Time(1e200));
    EXPECT_EQ(found.sine.high, 0) << frequency;
    EXPECT_EQ(found.cosine.high, 1) << frequency;
  }
}

TEST(Circular, AgreesWithAHundredDigits) {
  Random random(3);
  const Wide turn = 2 * boost::math::constants::pi<Wide>();
  for (int i = 0; i < 2000; ++i) {
    const double frequency = std::ldexp(1 + random.uniform(), static_cast<int>(20 * random.uniform()) - 10);
    const Time time = after(Time(std::ldexp(random.uniform(), static_cast<int>(40 * random.uniform()))),
                            1e-20 * random.uniform());
    Wide turns = Wide(frequency) * (Wide(time.high) + Wide(time.low));
    turns -= floor(turns);
    const Circular found = circular(frequency, time);
    const Wide sine = Wide(found.sine.high) + Wide(found.sine.low);
    const Wide cosine = Wide(found.cosine.high) + Wide(found.cosine.low);
    // The product of frequency and time is rounded to 2^-104.
    const double tolerance = std::ldexp(1 + frequency * time.high, -97);
    ASSERT_LT(abs(sine - sin(turn * turns)), tolerance) << i;
    ASSERT_LT(abs(cosine - cos(turn * turns)), tolerance) << i;
  }
}

constexpr double kSlope = 0.75;  // the wall has the direction (3, 4) / 5

Surface funnel() {
  return Surface(Cone({0, 0, 1}, kSlope), {});
}

TEST(Cone, IsAsFarAsItsWall) {
  EXPECT_DOUBLE_EQ(funnel().distance({0, 0, 5}, Time(0)), 3);
  EXPECT_NEAR(funnel().distance({3, 0, 4}, Time(0)), 0, 1e-15);
  EXPECT_DOUBLE_EQ(funnel().distance({6, 0, 4}, Time(0)), -2.4);
  const Vec3 direction = funnel().direction({1, 0, 5}, Time(0));
  EXPECT_NEAR(direction.x, 0.8, 1e-15);
  EXPECT_NEAR(direction.z, -0.6, 1e-15);
}

TEST(Cone, IsMetFromInside) {
  const Path across{{0, 0, 5}, {1, 0, 0}, Time(0)};
  // At the distance 3 - 0.8 x from the wall, less the radius.
  EXPECT_NEAR(funnel().contact_time({}, across, 1).value(), 2.5, 1e-15);
  const Path upwards{{1, 0, 5}, {0, 0, 1}, Time(0)};
  EXPECT_EQ(funnel().contact_time({}, upwards, 1), kNever);
}

// On the axis all directions are alike, and squares only touch.
TEST(Cone, HoldsASphereThatComesDownItsAxis) {
  const Path down{{0, 0, 5}, {0, 0, -1}, Time(0)};
  const double least_height = 1 / 0.6;
  EXPECT_NEAR(funnel().contact_time({}, down, 1).value(), 5 - least_height, 1e-14);
  World world(Box::walls({10, 10, 10}), {}, {Surface(Cone({0, 0, 1}, kSlope), {5, 5, 0})});
  world.add({.position = {5, 5, 5}, .velocity = {0, 0, -1}, .radius = 1});
  Simulation simulation(world);
  simulation.run_until(6);
  EXPECT_GT(simulation.velocity(0).z, 0);
}

// A sphere that fills the cone around the apex is on the axis but for rounding: yet its directions to the
// wall are perpendicular to it, and what it is told of an approach agrees with them.
TEST(Cone, HasDirectionsRightNextToItsAxis) {
  const double length_of_axis = std::sqrt(1 + 0.3 * 0.3);
  const Vec3 axis{1 / length_of_axis, 0.3 / length_of_axis, 0};
  const Vec3 across{-axis.y, axis.x, 0};
  const double secant = std::sqrt(1 + kSlope * kSlope);
  const Surface cone(Cone(axis, kSlope), {});
  const Surface tube(Cylinder(axis, 1), {});
  for (const double along : {1.0, 300.0, 2e6}) {
    const Vec3 on_axis = along * axis;
    for (int steps = -20; steps <= 20; ++steps) {
      const Vec3 position{on_axis.x, on_axis.y + steps * 0x1p-52 * along, 0};
      // The products are exact in long double.
      const long double aside =
          static_cast<long double>(position.y) * axis.x - static_cast<long double>(position.x) * axis.y;
      if (std::fabs(aside) < 1e-18 * along) continue;
      const double side = aside > 0 ? 1 : -1;
      const Vec3 expected = (1 / secant) * (side * across - kSlope * axis);
      EXPECT_NEAR(length(cone.direction(position, Time(0)) - expected), 0, 1e-9) << along << ", " << steps;
      EXPECT_NEAR(length(tube.direction(position, Time(0)) - side * across), 0, 1e-9);
      // Touching, and sliding along the wall a little outwards or inwards.
      const double radius = cone.distance(position, Time(0));
      for (const double speed : {1e-6, -1e-6}) {
        const Vec3 velocity = side * kSlope * across + axis + speed * expected;
        EXPECT_EQ(cone.is_approached(Motion(), {position, velocity, Time(0)}, radius), speed > 0);
      }
    }
  }
}

TEST(Cone, LeavesRoomBetweenTheFacesOfTheBox) {
  const World world(Box::walls({10, 10, 4}), {}, {Surface(Cone({0, 0, 1}, kSlope), {5, 5, -2})});
  const double frustum = std::numbers::pi / 3 * kSlope * kSlope * (6 * 6 * 6 - 2 * 2 * 2);
  EXPECT_DOUBLE_EQ(accessible_volume(world), frustum);
  const World wedge(Box::flat_walls(10, 4), {}, {Surface(Cone({0, -1, 0}, kSlope), {5, 4, 0})});
  EXPECT_DOUBLE_EQ(accessible_volume(wedge), kSlope * 16);
}

TEST(Cone, IsRefusedWhereItCannotBe) {
  EXPECT_THROW(Surface(Cone({0, 0, 1}, 0), {}), Error);
  EXPECT_THROW(Surface(Cone({0, 0, 2}, 1), {}), Error);
  EXPECT_THROW(World(Box::periodic({9, 9, 9}), {}, {funnel()}), Error);
  EXPECT_THROW(World(Box::flat_walls(9, 9), {}, {funnel()}), Error);
}

using Wide = boost::multiprecision::cpp_bin_float_100;

constexpr double kAmplitude = 0.1;
constexpr double kFrequency = 0.3;
constexpr double kRadius = 0.5;

Path straight_up(double height, double speed, const Time& start = Time(0)) {
  return {{0, 0, height}, {0, 0, speed}, start};
}

Time contact_of(const Path& path, double acceleration = 0, double amplitude = kAmplitude,
                double frequency = kFrequency) {
  const Surface floor(OscillatingPlane({0, 0, 1}, amplitude, frequency), {});
  return floor.contact_time(Motion({0, 0, acceleration}), path, kRadius);
}

// Between a sphere on a line and the floor.
Wide gap_at(const Path& path, const Time& moment) {
  const Wide now = Wide(moment.high) + Wide(moment.low);
  const Wide age = now - Wide(path.time.high) - Wide(path.time.low);
  Wide turns = Wide(kFrequency) * now;
  turns -= floor(turns);
  return Wide(path.position.z) + age * Wide(path.velocity.z) - Wide(kRadius) -
         Wide(kAmplitude) * sin(2 * boost::math::constants::pi<Wide>() * turns);
}

// However slowly a sphere comes, the floor meets it within the turn after it has come into its reach.
TEST(OscillatingPlane, IsMetByASphereThatComesAsSlowlyAsItLikes) {
  for (double speed = 1; speed > 1e-25; speed /= 7) {
    SCOPED_TRACE(speed);
    const Path path = straight_up(3, -speed, Time(0.7, 1e-17));
    const Time contact = contact_of(path);
    const double within_reach = 0.7 + (3 - kRadius - kAmplitude) / speed;
    EXPECT_GE(contact.high, within_reach * (1 - 1e-15));
    EXPECT_LE(contact.high, (within_reach + 1 / kFrequency) * (1 + 1e-15));
    const double fastest = 2 * 3.1416 * kAmplitude * kFrequency + speed;
    // One double counts up to 64 turns, two beyond, of which 2^-100 are what the frequency allows.
    const double resolution =
        1e-16 * std::min(contact.high, 100 / kFrequency) + std::ldexp(contact.high, -98) + 1e-16;
    EXPECT_LT(abs(gap_at(path, contact)), resolution * fastest);
    EXPECT_GE(gap_at(path, {contact.high, contact.low - 4 * resolution}), -1e-30);
  }
}

// Where not even the whole number of turns is known, the floor counts as at rest, and is met all the same.
TEST(OscillatingPlane, IsMetAfterMoreTurnsThanNumbersCount) {
  for (const double speed : {1e-30, 1e-40, 1e-60}) {
    const Time contact = contact_of(straight_up(3, -speed));
    EXPECT_GE(contact.high * speed, (3 - kRadius - kAmplitude) * (1 - 1e-15)) << speed;
    EXPECT_LE(contact.high * speed, (3 - kRadius + kAmplitude) * (1 + 1e-15)) << speed;
  }
  EXPECT_LT(contact_of(straight_up(3, -1, Time(1e40))).high, 1e41);
}

TEST(OscillatingPlane, IsNotMetBySpheresThatStayBeyondItsReach) {
  for (const double speed : {0.0, 1e-300, 1e-14, 1.0}) {
    EXPECT_EQ(contact_of(straight_up(3, speed)), kNever) << speed;
    EXPECT_EQ(contact_of(straight_up(kRadius + kAmplitude + 1e-9, speed)), kNever) << speed;
    // It stays where the crests of the floor touch it, to the last bit.
    EXPECT_EQ(contact_of(straight_up(0.625, speed), 0, 0.125), kNever) << speed;
  }
  // It falls toward the floor and turns back before, however far away.
  for (const double acceleration : {1e-3, 1e-14, 1e-28}) {
    const double speed = -std::sqrt(2 * acceleration * 2.39);
    EXPECT_EQ(contact_of(straight_up(3, speed), acceleration), kNever) << acceleration;
  }
}

TEST(OscillatingPlane, IsMetWithinATurnBySpheresWithinItsReach) {
  Random random(5);
  for (int i = 0; i < static_cast<int>(support::cases(1000)); ++i) {
    const double gap = kAmplitude * std::ldexp(1.0, -static_cast<int>(48 * random.uniform()));
    const double speed = std::ldexp(random.normal(), -20 - static_cast<int>(1000 * random.uniform()));
    // It rests just below the crests, or hardly moves.
    const Path path = straight_up(kRadius + kAmplitude - gap, std::fabs(speed) < gap / 100 ? speed : 0);
    const Time contact = contact_of(path);
    ASSERT_LE(contact.high, 1 / kFrequency) << i;
    ASSERT_LT(abs(gap_at(path, contact)), 1e-16) << i;
  }
}

// Falls so weak that they take millions of turns through the reach of the floor, and others that turn back
// just within it.
TEST(OscillatingPlane, IsMetBySpheresThatHardlyFall) {
  for (const double acceleration : {1e-3, 1e-9, 1e-15, 1e-21, 1e-27}) {
    EXPECT_LE(contact_of(straight_up(kRadius + 0.09, 0), -acceleration).high, 1 / kFrequency);
    const double until_reach = std::sqrt(2 * 2.4 / acceleration);
    const double contact = contact_of(straight_up(3, 0), -acceleration).high;
    EXPECT_GE(contact, until_reach * (1 - 1e-15)) << acceleration;
    EXPECT_LE(contact, (until_reach + 1 / kFrequency) * (1 + 1e-15)) << acceleration;
  }
  for (const double acceleration : {1e-9, 1e-15, 1e-21, 1e-27}) {
    const double turning_back = std::sqrt(2 * 2.45 / acceleration);
    const double contact = contact_of(straight_up(3, -acceleration * turning_back), acceleration).high;
    EXPECT_LT(contact, turning_back) << acceleration;
  }
}

// Gap, speed and acceleration vanish at once: the floor leaves the sphere as fast as it falls.
TEST(OscillatingPlane, LeavesASphereThatFallsWithItsCrest) {
  const double turning = 2 * 3.14159265358979323846 * 0.5;
  for (const double factor : {1 - 1e-9, 1.0, 1 + 1e-9}) {
    const double acceleration = -factor * 0.25 * turning * turning;
    const Path path = straight_up(kRadius + 0.25, 0, Time(0.5));  // the time of a crest
    const Time contact = contact_of(path, acceleration, 0.25, 0.5);
    EXPECT_LE(contact.high, 1.5) << factor;
    EXPECT_GE(contact.high, 0.5) << factor;
  }
}

}  // namespace
}  // namespace hardball::surfaces_test
