// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What a step does to velocities.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hardball/execution/execute.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::execution_steps_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// At the step along x, moving with this relative velocity.
Contact at_step(const Vec3& relative, bool is_outward, double rise, double first_mass = 1,
                double second_mass = 1) {
  Contact contact;
  contact.separation = {1.5, 0, 0};
  contact.reach = 1.5;
  contact.first_mass = first_mass;
  contact.second_mass = second_mass;
  contact.before = {{0.25, 0.5, 0}, Vec3{0.25, 0.5, 0} + relative};
  contact.after = contact.before;
  contact.step = {.potential = 0, .step = 0, .is_outward = is_outward, .passes = false, .rise = rise};
  return contact;
}

double kinetic(const Contact& contact, const Velocities& velocities) {
  const auto of = [](double mass, const Vec3& v) { return std::isinf(mass) ? 0 : mass * dot(v, v) / 2; };
  return of(contact.first_mass, velocities.first) + of(contact.second_mass, velocities.second);
}

double normal_speed(const Velocities& velocities) {
  return velocities.second.x - velocities.first.x;
}

TEST(Step, IsPassedByWhatHasTheEnergy) {
  Contact contact = at_step({2, 1, 0}, true, 0.5);
  decide_at_step(contact);
  EXPECT_TRUE(contact.step.passes);
  // mu u^2 / 2 with mu = 1/2: 1 before, and half of that after.
  EXPECT_DOUBLE_EQ(normal_speed(contact.after), std::sqrt(2.0));
  EXPECT_EQ((contact.after.second - contact.after.first).y, 1) << "along the step nothing changes";
  EXPECT_DOUBLE_EQ(kinetic(contact, contact.after), kinetic(contact, contact.before) - 0.5);
}

TEST(Step, ReflectsWhatHasNot) {
  Contact contact = at_step({2, 1, 0}, true, 1.5);
  decide_at_step(contact);
  EXPECT_FALSE(contact.step.passes);
  EXPECT_DOUBLE_EQ(normal_speed(contact.after), -2);
  Contact shoulder = at_step({-2, 1, 0}, false, 1.5);
  decide_at_step(shoulder);
  EXPECT_FALSE(shoulder.step.passes);
  EXPECT_DOUBLE_EQ(normal_speed(shoulder.after), 2);
}

TEST(Step, DownwardsIsPassedFaster) {
  Contact contact = at_step({-2, 0, 0}, false, -3);
  decide_at_step(contact);
  EXPECT_TRUE(contact.step.passes);
  EXPECT_DOUBLE_EQ(normal_speed(contact.after), -4);
}

TEST(Step, OfATetherIsNeverPassed) {
  Contact contact = at_step({1e9, 0, 0}, true, kInfinity);
  decide_at_step(contact);
  EXPECT_FALSE(contact.step.passes);
  EXPECT_DOUBLE_EQ(normal_speed(contact.after), -1e9);
}

TEST(Step, WithoutHeightChangesNothing) {
  Contact contact = at_step({2, 1, 0.5}, true, 0);
  decide_at_step(contact);
  EXPECT_TRUE(contact.step.passes);
  EXPECT_EQ(contact.after, contact.before);
}

TEST(Step, LeavesKinematicSpheresAsTheyAre) {
  Contact contact = at_step({2, 0, 0}, true, 1, kInfinity, 1);
  decide_at_step(contact);
  EXPECT_EQ(contact.after.first, contact.before.first);
  EXPECT_DOUBLE_EQ(normal_speed(contact.after), std::sqrt(2.0));
}

// What hardly moves, by rounding even away from the step, is on the right side afterwards.
TEST(Step, IsLeftInTheRightDirectionWhateverTheRounding) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 direction = random.direction();
    const double normal =
        random.uniform() < 0.2 ? -1e-16 * random.uniform() : std::pow(10, -20 * random.uniform());
    Vec3 along = random.direction();
    along = along - dot(along, direction) * direction;
    const bool is_outward = random.uniform() < 0.5;
    const double rise = random.uniform() < 0.2 ? kInfinity
                        : random.uniform() < 0.2
                            ? 0
                            : (random.uniform() - 0.5) * std::pow(10, -18 * random.uniform());
    Contact contact = at_step({}, is_outward, is_outward ? rise : std::min(rise, 1e9), 0.5 + random.uniform(),
                              0.5 + random.uniform());
    contact.separation = (1.5 * (1 + 1e-16 * (random.uniform() - 0.5))) * direction;
    contact.before.second = contact.before.first + along + (is_outward ? normal : -normal) * direction;
    contact.after = contact.before;
    decide_at_step(contact);
    const double closing = approach(contact.separation, contact.after);
    if (is_outward == contact.step.passes) {
      ASSERT_GE(closing, 0);
    } else {
      ASSERT_LT(closing, 0);
    }
    const double gained = kinetic(contact, contact.after) - kinetic(contact, contact.before);
    ASSERT_NEAR(gained, -contact.step.gain(), is_outward && !contact.step.passes ? 0x1p-40 : 1e-15);
  }
}

}  // namespace
}  // namespace hardball::execution_steps_test
