// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/execution/collapse_guard.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hardball/errors/error.hpp"

namespace hardball::collapse_guard_test {
namespace {

constexpr double kRestitution = 0.5;

// A sphere hits a floor at this speed, `flight` after its last contact there.
Contact bounce(double speed, double flight, double restitution = kRestitution) {
  Contact contact;
  contact.kind = EventKind::wall;
  contact.time = Time(10, flight);
  contact.first_since = Time(10);
  contact.second_since = Time(-std::numeric_limits<double>::infinity());
  contact.position = {3, 5, 1};
  contact.first_radius = contact.reach = 1;
  contact.wall_normal = {0, 0, -1};
  contact.separation = {0, 0, -1};
  contact.before.first = {0, 0, -speed};
  contact.after.first = {0, 0, restitution * speed};
  return contact;
}

Contact collision(double speed, double flight, double restitution = kRestitution) {
  Contact contact = bounce(speed, flight, restitution);
  contact.kind = EventKind::collision;
  contact.second = 1;
  contact.second_since = Time(9);
  contact.second_position = {3, 5, 0.5};
  contact.second_radius = 0.5;
  contact.reach = 1.5;
  contact.separation = {0, 0, -1.5};
  contact.wall_normal = {};
  return contact;
}

// Places near 5 are rounded to 2^-51.
TEST(HaveNotParted, ComparesWhatOpenedWithWhatPlacesResolve) {
  for (const auto& make : {bounce, collision}) {
    EXPECT_TRUE(have_not_parted(make(1e-8, 1e-8, kRestitution)));
    EXPECT_TRUE(have_not_parted(make(1, 1e-16, kRestitution)));
    EXPECT_FALSE(have_not_parted(make(1e-6, 1e-6, kRestitution))) << "a gap of 1e-12 is seen";
    EXPECT_FALSE(have_not_parted(make(1e-4, 1e-8, kRestitution)));
    EXPECT_FALSE(have_not_parted(make(1, 1, kRestitution)));
  }
  Contact near_origin = bounce(1e-7, 1e-6);
  EXPECT_FALSE(have_not_parted(near_origin));
  near_origin.position = {1000, 0, 0};
  EXPECT_TRUE(have_not_parted(near_origin)) << "places are known less well there";
}

TEST(HaveNotParted, LooksAcrossTheContactOnly) {
  Contact sliding = bounce(1e-8, 1e-8);
  sliding.before.first.x = sliding.after.first.x = 1;
  EXPECT_TRUE(have_not_parted(sliding)) << "along the floor it hardly moves";
  sliding.before.first.x = sliding.after.first.x = 1e5;
  EXPECT_FALSE(have_not_parted(sliding)) << "it makes good progress";
}

TEST(HaveNotParted, ExceptsImpactsThatKeepTheirSpeed) {
  EXPECT_FALSE(have_not_parted(bounce(1e-8, 1e-8, 1)));
  EXPECT_FALSE(have_not_parted(bounce(1e-8, 1e-8, 10))) << "it parts with a least speed";
  EXPECT_TRUE(have_not_parted(bounce(0, 0, 1))) << "it rests";
  Contact sliding = bounce(1e-17, 1e-12, 1);
  sliding.before.first.x = sliding.after.first.x = 1;
  EXPECT_TRUE(have_not_parted(sliding)) << "its approach is a rounding error";
}

TEST(HaveNotParted, ComparesTheTwoSpheresOfACollision) {
  // A gas hits a sphere of great mass, which stays where it is.
  Contact heavy = collision(0, 1e-2);
  heavy.before.second = {0, 0, 1};
  heavy.after.second = {0, 0, -kRestitution};
  EXPECT_FALSE(have_not_parted(heavy));
  // Two that stick together, and travel.
  Contact traveling = collision(0, 1e3);
  traveling.before = traveling.after = {{0, 0, 1}, {0, 0, 1}};
  EXPECT_FALSE(have_not_parted(traveling));
}

TEST(CollapseGuard, CountsContactsOfSpheresThatDoNotPart) {
  const Contact idle = bounce(1e-8, 1e-8);
  CollapseGuard guard;
  for (int i = 0; i < 9999; ++i) ASSERT_NO_THROW(guard.note_contact(idle));
  try {
    guard.note_contact(idle);
    FAIL();
  } catch (const RunFailure& failure) {
    EXPECT_EQ(std::string(failure.what()).find("inelastic collapse: sphere 0 was hit 10000 times"), 0U);
  }
}

TEST(CollapseGuard, ForgivesAHundredContactsForOneThatCounts) {
  CollapseGuard guard;
  // As of a sphere that comes to rest a thousand times.
  for (int round = 0; round < 1000; ++round) {
    for (int i = 0; i < 100; ++i) ASSERT_NO_THROW(guard.note_contact(bounce(1e-8, 1e-8)));
    guard.note_contact(bounce(1, 1));
  }
  // As of one that creeps along a wall, and is hit by others.
  const auto creep = [&guard] {
    for (int i = 0; i < 50'000; ++i) guard.note_contact(i % 1000 == 0 ? bounce(1, 1) : bounce(1e-8, 1e-8));
  };
  EXPECT_THROW(creep(), RunFailure);
}

TEST(CollapseGuard, CountsEachSphere) {
  CollapseGuard guard;
  Contact other = bounce(1e-8, 1e-8);
  other.first = 7;
  for (int i = 0; i < 9999; ++i) guard.note_contact(bounce(1e-8, 1e-8));
  EXPECT_NO_THROW(guard.note_contact(other));
  EXPECT_THROW(guard.note_contact(collision(1e-8, 1e-8)), RunFailure);
}

TEST(CollapseGuard, NeedsMemoryOnlyForSpheresThatDoNotPart) {
  CollapseGuard guard;
  const std::size_t empty = guard.memory_bytes();
  const auto hit = [&guard](double speed) {
    for (SphereId id = 0; id < 1000; ++id) {
      Contact contact = bounce(speed, 1e-8);
      contact.first = id;
      guard.note_contact(contact);
    }
  };
  hit(1);
  EXPECT_EQ(guard.memory_bytes(), empty);
  hit(1e-8);
  EXPECT_GT(guard.memory_bytes(), empty);
}

}  // namespace
}  // namespace hardball::collapse_guard_test
