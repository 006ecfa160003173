// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/restitution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::restitution_test {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Contact random_collision(Random& random) {
  Contact contact;
  contact.reach = 0.5 + random.uniform();
  contact.separation = contact.reach * random.direction();
  contact.first_mass = std::ldexp(1 + random.uniform(), static_cast<int>(random.bits() % 10));
  contact.second_mass = std::ldexp(1 + random.uniform(), static_cast<int>(random.bits() % 10));
  contact.before = {{random.normal(), random.normal(), random.normal()},
                    {random.normal(), random.normal(), random.normal()}};
  if (dot(contact.separation, contact.before.second - contact.before.first) > 0) {
    std::swap(contact.before.first, contact.before.second);
  }
  contact.after = contact.before;
  return contact;
}

double kinetic_energy(const Contact& contact, const Velocities& v) {
  return (contact.first_mass * dot(v.first, v.first) + contact.second_mass * dot(v.second, v.second)) / 2;
}

TEST(Restitution, ConservesMomentumAndSeparatesAtTheFractionOfTheApproach) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const Contact contact = random_collision(random);
    const double coefficient = i % 2 == 0 ? 1 : random.uniform();
    const Velocities after = Restitution(coefficient)(contact);
    const Vec3 gained = contact.first_mass * (after.first - contact.before.first);
    const Vec3 lost = contact.second_mass * (contact.before.second - after.second);
    // Each velocity is rounded a few times.
    const double momenta = contact.first_mass * (length(contact.before.first) + length(after.first)) +
                           contact.second_mass * (length(contact.before.second) + length(after.second));
    ASSERT_LT(length(gained - lost), 8 * kEpsilon * momenta);
    const double speeds = length(contact.before.first) + length(contact.before.second) + length(after.first) +
                          length(after.second);
    const double approach = dot(contact.normal(), contact.before.first - contact.before.second);
    const double separation = dot(contact.normal(), after.second - after.first);
    ASSERT_NEAR(separation, coefficient * approach, 8 * kEpsilon * speeds);
    // Nothing changes perpendicular to the normal.
    ASSERT_LT(length(cross(gained, contact.normal())), 8 * kEpsilon * momenta);
    // The energy lost is that of the relative motion along the normal.
    const double reduced =
        contact.first_mass * contact.second_mass / (contact.first_mass + contact.second_mass);
    const double loss = (1 - coefficient * coefficient) * reduced * approach * approach / 2;
    const double before = kinetic_energy(contact, contact.before);
    ASSERT_NEAR(kinetic_energy(contact, after), before - loss, 32 * kEpsilon * before);
  }
}

TEST(Restitution, SwapsVelocitiesOfEqualSpheresHeadOnWithoutRounding) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    Contact contact;
    const double a = std::floor(1000 * random.uniform()) / 64;
    const double b = a + std::floor(1 + 1000 * random.uniform()) / 64;
    contact.separation = {1, 0, 0};
    contact.reach = 1;
    contact.first_mass = contact.second_mass = 3;
    contact.before = {{b, 0.1, 0.3}, {a, 0.7, -0.2}};
    const Velocities after = Restitution(1)(contact);
    ASSERT_EQ(after, (Velocities{{a, 0.1, 0.3}, {b, 0.7, -0.2}}));
  }
}

TEST(Restitution, ReflectsAtWallsAndChangesNoOtherComponent) {
  for (Face face = 0; face < 6; ++face) {
    Contact contact;
    contact.kind = EventKind::wall;
    contact.second = face;
    contact.wall_normal[axis_of(face)] = is_upper(face) ? 1 : -1;
    contact.before.first = {0.1, 0.2, 0.3};
    contact.before.first[axis_of(face)] *= is_upper(face) ? 1 : -1;
    Vec3 expected = contact.before.first;
    expected[axis_of(face)] *= -0.5;
    EXPECT_EQ(Restitution(0.5)(contact).first, expected);
  }
}

TEST(Restitution, DoesNotChangeSpheresThatDoNotApproach) {
  Contact contact;
  contact.separation = {1, 0, 0};
  contact.first_mass = contact.second_mass = 1;
  contact.before = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(Restitution(1)(contact), contact.before);
}

TEST(Restitution, RefusesCoefficientsOutsideZeroToOne) {
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Restitution{bad}, Error);
  }
  EXPECT_EQ(Restitution(0).coefficient(), 0);
  EXPECT_EQ(Restitution().coefficient(), 1);
}

}  // namespace
}  // namespace hardball::restitution_test
