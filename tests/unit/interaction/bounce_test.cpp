// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/bounce.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/interaction/restitution.hpp"
#include "hardball/interaction/restitution_law.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::bounce_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A collision of two spheres that differ in everything and spin.
Contact any_collision(Random& random) {
  Contact contact;
  contact.first_radius = 0.5 + random.uniform();
  contact.second_radius = 0.5 + random.uniform();
  contact.reach = contact.first_radius + contact.second_radius;
  contact.separation = contact.reach * random.direction();
  contact.first_mass = 0.5 + random.uniform();
  contact.second_mass = 0.5 + random.uniform();
  contact.first_inertia_factor = 0.1 + 0.5 * random.uniform();
  contact.second_inertia_factor = 0.1 + 0.5 * random.uniform();
  contact.time = Time(1);
  contact.before = {3 * random.uniform() * random.direction(), 3 * random.uniform() * random.direction()};
  if (approach(contact.separation, contact.before) > 0) {
    std::swap(contact.before.first, contact.before.second);
  }
  contact.spins_before = {random.direction(), 2 * random.uniform() * random.direction()};
  contact.after = contact.before;
  contact.spins_after = contact.spins_before;
  return contact;
}

double inertia_of_first(const Contact& contact) {
  return contact.first_inertia_factor * contact.first_mass * contact.first_radius * contact.first_radius;
}

double inertia_of_second(const Contact& contact) {
  return contact.second_inertia_factor * contact.second_mass * contact.second_radius * contact.second_radius;
}

double energy(const Contact& contact, const Velocities& velocities, const Spins& spins) {
  return (contact.first_mass * dot(velocities.first, velocities.first) +
          contact.second_mass * dot(velocities.second, velocities.second) +
          inertia_of_first(contact) * dot(spins.first, spins.first) +
          inertia_of_second(contact) * dot(spins.second, spins.second)) /
         2;
}

Vec3 momentum(const Contact& contact, const Velocities& velocities) {
  return contact.first_mass * velocities.first + contact.second_mass * velocities.second;
}

// About the center of the first sphere.
Vec3 angular_momentum(const Contact& contact, const Velocities& velocities, const Spins& spins) {
  return contact.second_mass * cross(contact.separation, velocities.second) +
         inertia_of_first(contact) * spins.first + inertia_of_second(contact) * spins.second;
}

// How fast the surface of the first moves along that of the second, where they touch.
Vec3 slip(const Contact& contact, const Velocities& velocities, const Spins& spins) {
  const Vec3 normal = contact.normal();
  const Vec3 of_first = velocities.first + cross(spins.first, contact.first_radius * normal);
  const Vec3 of_second = velocities.second + cross(spins.second, -contact.second_radius * normal);
  const Vec3 relative = of_first - of_second;
  return relative - dot(relative, normal) * normal;
}

double normal_speed(const Contact& contact, const Velocities& velocities) {
  return dot(velocities.first - velocities.second, contact.normal());
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE(length(a - b), tolerance);
}

TEST(Bounce, OfRoughSpheresKeepsMomentaAndReversesTheSlip) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Contact contact = any_collision(random);
    const double restitution = random.uniform();
    const double tangential = 2 * random.uniform() - 1;
    const Bounce bounce(
        {.restitution = ConstantRestitution{restitution}, .tangential_restitution = tangential});
    const Outcome outcome = bounce(contact);
    constexpr double kRounding = 1e-14;
    const double scale = 30;
    expect_near(momentum(contact, outcome.velocities), momentum(contact, contact.before), kRounding * scale);
    expect_near(angular_momentum(contact, outcome.velocities, outcome.spins),
                angular_momentum(contact, contact.before, contact.spins_before), kRounding * scale);
    EXPECT_NEAR(normal_speed(contact, outcome.velocities),
                -restitution * normal_speed(contact, contact.before), kRounding * scale);
    expect_near(slip(contact, outcome.velocities, outcome.spins),
                -tangential * slip(contact, contact.before, contact.spins_before), kRounding * scale);
    // Spheres do not turn about the line through their centers.
    EXPECT_NEAR(dot(outcome.spins.first - contact.spins_before.first, contact.normal()), 0,
                kRounding * scale);
    EXPECT_FALSE(outcome.merges);
  }
}

TEST(Bounce, KeepsEnergyIfPerfectlyRoughOrSmoothAndElastic) {
  Random random(2);
  for (const double tangential : {1.0, -1.0}) {
    const Bounce bounce({.tangential_restitution = tangential});
    for (int i = 0; i < 200; ++i) {
      const Contact contact = any_collision(random);
      const Outcome outcome = bounce(contact);
      const double before = energy(contact, contact.before, contact.spins_before);
      EXPECT_NEAR(energy(contact, outcome.velocities, outcome.spins), before, 1e-14 * before);
      if (tangential == -1) {
        EXPECT_EQ(outcome.spins, contact.spins_before);
      }
    }
  }
}

TEST(Bounce, WithoutRoughnessIsThatOfRestitution) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Contact contact = any_collision(random);
    const Outcome outcome = Bounce({.restitution = ConstantRestitution{0.7}})(contact);
    EXPECT_EQ(outcome.velocities, Restitution(0.7)(contact));
    EXPECT_EQ(outcome.spins, contact.spins_before);
  }
}

Contact sphere_on_a_floor() {
  Contact contact;
  contact.kind = EventKind::wall;
  contact.first_radius = contact.reach = 0.5;
  contact.first_mass = 2;
  contact.second_mass = kInfinity;
  contact.time = Time(1);
  contact.second_since = Time(-kInfinity);
  contact.wall_normal = {0, 0, -1};
  contact.before = contact.after = {{3, 0, -1}, {1, 0, 0}};
  return contact;
}

// A sphere that rolls onto a floor: what it loses in translation it gains in rotation.
TEST(Bounce, OffARoughWallTurnsASphere) {
  const Contact contact = sphere_on_a_floor();
  const Bounce sticking({.restitution = ConstantRestitution{0.5}, .tangential_restitution = 0});
  const Outcome outcome = sticking(contact);
  // It rolls without slipping on the wall, which moves with velocity 1.
  EXPECT_NEAR(outcome.velocities.first.z, 0.5, 1e-15);
  const double angular = outcome.spins.first.y;
  EXPECT_NEAR(outcome.velocities.first.x - angular * 0.5, 1, 1e-14);
  // 2/7 of the slip goes.
  EXPECT_NEAR(outcome.velocities.first.x, 3 - 2 * 2.0 / 7, 1e-14);
}

// Whatever the response says of spheres.
TEST(Bounce, OffAWallOfItsOwnRoughnessIsThatOfARoughResponse) {
  Contact contact = sphere_on_a_floor();
  const BounceRules smooth{.restitution = ConstantRestitution{0.5}};
  BounceRules rough = smooth;
  rough.tangential_restitution = 0.25;
  BounceRules rougher = smooth;
  rougher.tangential_restitution = 0.75;
  const Outcome expected = Bounce(rough)(contact);
  ASSERT_NE(expected.spins, contact.spins_before);
  contact.wall_material.tangential_restitution = 0.25;
  for (const Outcome& outcome :
       {Bounce(smooth)(contact), Bounce(rougher)(contact), outcome_of(Restitution(0.5), contact)}) {
    EXPECT_EQ(outcome.velocities, expected.velocities);
    EXPECT_EQ(outcome.spins, expected.spins);
  }
  contact.wall_material.tangential_restitution = -1;
  EXPECT_EQ(Bounce(rough)(contact).spins, contact.spins_before);
  EXPECT_EQ(Bounce(rough)(contact).velocities, Bounce(smooth)(contact).velocities);
}

TEST(Bounce, OfAKinematicSphereIsThatOffAWall) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Contact contact = any_collision(random);
    contact.first_mass = kInfinity;
    const double tangential = 2 * random.uniform() - 1;
    const Outcome outcome =
        Bounce({.restitution = ConstantRestitution{0.6}, .tangential_restitution = tangential})(contact);
    EXPECT_EQ(outcome.velocities.first, contact.before.first);
    EXPECT_EQ(outcome.spins.first, contact.spins_before.first);
    EXPECT_NEAR(normal_speed(contact, outcome.velocities), -0.6 * normal_speed(contact, contact.before),
                1e-13);
    expect_near(slip(contact, outcome.velocities, outcome.spins),
                -tangential * slip(contact, contact.before, contact.spins_before), 1e-13);
  }
}

TEST(Bounce, IsElasticSoonAfterAnotherContact) {
  Random random(5);
  Contact contact = any_collision(random);
  const Bounce bounce({.restitution = ConstantRestitution{0.5}, .contact_duration = 0.01});
  const double before = normal_speed(contact, contact.before);
  const auto ratio = [&] { return -normal_speed(contact, bounce(contact).velocities) / before; };
  EXPECT_NEAR(ratio(), 0.5, 1e-14);
  contact.first_since = Time(1 - 0.011);
  EXPECT_NEAR(ratio(), 0.5, 1e-14);
  contact.first_since = Time(1 - 0.009);
  EXPECT_NEAR(ratio(), 1, 1e-14);
  contact.first_since = Time(0);
  contact.second_since = Time(1);
  EXPECT_NEAR(ratio(), 1, 1e-14);
}

TEST(Bounce, LetsHeapsSettle) {
  Random random(5);
  Contact contact = any_collision(random);
  contact.first_radius = 0.5;
  contact.second_radius = 2;
  const double gravity = 4;
  const double duration = 0.01 * std::sqrt(1 / gravity);
  const Bounce bounce({.restitution = ConstantRestitution{0.5}, .settle_under = gravity});
  const double before = normal_speed(contact, contact.before);
  const auto ratio = [&] { return -normal_speed(contact, bounce(contact).velocities) / before; };
  contact.first_since = Time(1 - 1.1 * duration);
  EXPECT_NEAR(ratio(), 0.5, 1e-14);
  contact.first_since = Time(1 - 0.9 * duration);
  EXPECT_NEAR(ratio(), 1, 1e-14);
  // A sphere that lies on a wall leaves it for that long.
  contact.kind = EventKind::wall;
  contact.second_since = Time(-kInfinity);
  contact.wall_normal = {0, 0, -1};
  contact.before = {{1, 0, 0}, {}};
  for (const double pressing : {gravity, -gravity}) {
    contact.pressing = pressing;
    EXPECT_DOUBLE_EQ(bounce(contact).velocities.first.z, pressing > 0 ? gravity * duration / 2 : 0);
  }
}

TEST(Bounce, IsElasticIfSlow) {
  Random random(6);
  const Contact contact = any_collision(random);
  const double speed = contact.impact_speed();
  for (const double factor : {0.99, 1.01}) {
    const Bounce bounce({.restitution = ConstantRestitution{0.5}, .elastic_below = factor * speed});
    const double ratio = -normal_speed(contact, bounce(contact).velocities) / speed;
    EXPECT_NEAR(ratio, factor > 1 ? 1 : 0.5, 1e-14);
  }
}

TEST(Bounce, RefusesRulesOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-0.1, 1.1, nan}) {
    EXPECT_THROW(Bounce({.restitution = ConstantRestitution{bad}}), Error);
  }
  for (const double bad : {-1.0, kInfinity, nan}) {
    EXPECT_THROW(Bounce({.elastic_below = bad}), Error);
    EXPECT_THROW(Bounce({.contact_duration = bad}), Error);
    EXPECT_THROW(Bounce({.settle_under = bad}), Error);
  }
  for (const double bad : {-1.1, 1.1, nan}) EXPECT_THROW(Bounce({.tangential_restitution = bad}), Error);
}

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

TEST(ViscoelasticRestitution, HasTheGivenValueAtTheGivenSpeed) {
  for (const double value : {0.01, 0.3, 0.8, 0.999, 1.0}) {
    for (const double speed : {1e-20, 0.1, 1.0, 1e30}) {
      EXPECT_NEAR(ViscoelasticRestitution(value, speed).at(speed), value, 1e-14);
    }
  }
}

TEST(ViscoelasticRestitution, DecreasesFromOneWithTheFifthRootOfTheSpeed) {
  const ViscoelasticRestitution law(0.8, 1);
  EXPECT_EQ(law.at(0), 1);
  double last = 1;
  for (double speed = 1e-30; speed < 1e6; speed *= 3) {
    const double value = law.at(speed);
    EXPECT_LT(value, last);
    last = value;
  }
  // Of slow impacts the loss is proportional to u^(1/5).
  EXPECT_NEAR((1 - law.at(1e-35)) / (1 - law.at(1e-40)), 10, 1e-3);
}

// The first terms of the exact series, 1 - 1.15344 x^2 + 0.79826 x^4, with x^2 = b u^(1/5).
// Source: Schwager and Poeschel, Phys. Rev. E 57 (1998) 650.
TEST(ViscoelasticRestitution, AgreesWithTheSeriesOfSlowImpacts) {
  const double square = 0.01;
  const double series = 1 - 1.15344 * square + 0.79826 * square * square;
  const ViscoelasticRestitution law(series, 1);
  const double smaller = square / 10;
  EXPECT_NEAR(law.at(1e-5), 1 - 1.15344 * smaller + 0.79826 * smaller * smaller, 3e-5);
}

TEST(TabulatedRestitution, IsLinearBetweenPointsAndConstantBeyond) {
  const TabulatedRestitution law({{1, 0.75}, {3, 0.25}, {5, 0.5}});
  EXPECT_EQ(law.at(0), 0.75);
  EXPECT_EQ(law.at(1), 0.75);
  EXPECT_EQ(law.at(2), 0.5);
  EXPECT_EQ(law.at(3), 0.25);
  EXPECT_EQ(law.at(4), 0.375);
  EXPECT_EQ(law.at(5), 0.5);
  EXPECT_EQ(law.at(100), 0.5);
}

TEST(RestitutionLaws, RefuseWhatIsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ViscoelasticRestitution(1.1, 1), Error);
  EXPECT_THROW(ViscoelasticRestitution(0, 1), Error);
  EXPECT_THROW(ViscoelasticRestitution(0.5, 0), Error);
  EXPECT_THROW(ViscoelasticRestitution(nan, 1), Error);
  EXPECT_THROW(TabulatedRestitution(std::vector<TabulatedRestitution::Point>()), Error);
  EXPECT_THROW(TabulatedRestitution({{0, 1.5}}), Error);
  EXPECT_THROW(TabulatedRestitution({{-1, 0.5}}), Error);
  EXPECT_THROW(TabulatedRestitution({{1, 0.5}, {1, 0.6}}), Error);
  EXPECT_THROW(TabulatedRestitution({{nan, 0.5}}), Error);
}

}  // namespace
}  // namespace hardball::bounce_test
