// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/oscillating_plane.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "hardball/numbers/random.hpp"
#include "hardball/surfaces/surface.hpp"
#include "support/effort.hpp"

namespace hardball::oscillating_plane_test {
namespace {

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
}  // namespace hardball::oscillating_plane_test
