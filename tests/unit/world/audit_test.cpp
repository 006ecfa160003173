// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/audit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/errors/error.hpp"
#include "support/effort.hpp"
#include "support/random_world.hpp"
#include "support/refusal.hpp"

namespace hardball::audit_test {
namespace {

// The deepest overlap among all pairs and their adjacent images.
double deepest_overlap(const World& world, const Time& moment) {
  double deepest = 0;
  for (Slot a = 0; a < world.size(); ++a) {
    for (Slot b = a + 1; b < world.size(); ++b) {
      for (int i = 0; i < 27; ++i) {
        Vec3 apart = world.position(b, moment) - world.position(a, moment);
        const std::array<int, kAxes> boxes = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          if (world.box().is_periodic(axis)) apart[axis] += boxes[axis] * world.box().size()[axis];
        }
        deepest = std::max(deepest, 1 - length(apart) / (world.base_radius(a) + world.base_radius(b)));
      }
    }
  }
  return deepest;
}

double farthest_escape(const World& world, const Time& moment) {
  double farthest = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_wall(axis)) continue;
      const double x = world.position(slot, moment)[axis];
      const double radius = world.base_radius(slot);
      const double through = std::max(radius - x, x + radius - world.box().size()[axis]);
      farthest = std::max(farthest, through / (2 * radius));
    }
  }
  return farthest;
}

// Without collisions: the spheres fly through each other and through the walls.
TEST(Audit, FindsWhatACheckOfAllPairsFinds) {
  std::uint64_t overlapping = 0;
  for (std::uint64_t seed = 0; seed < support::cases(1000); ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    SCOPED_TRACE(made.name);
    EXPECT_LT(audit(made.world, Time(0)).max_overlap, 1e-12) << "worlds start sound";
    for (const double fraction : {0.0, 0.01, 0.1}) {
      const Time moment(fraction * made.until);
      const Audit found = audit(made.world, moment);
      // Positions of the same pair are subtracted the other way round, or folded differently.
      ASSERT_NEAR(found.max_overlap, deepest_overlap(made.world, moment), 1e-12);
      ASSERT_EQ(found.max_escape, farthest_escape(made.world, moment));
      ASSERT_EQ(found.not_finite, 0U);
      if (found.max_overlap > kOverlapTolerance) {
        ++overlapping;
        ASSERT_LT(found.overlap_first, found.overlap_second);
      }
      if (found.is_sound()) {
        ASSERT_NO_THROW(require_no_overlap(made.world, moment));
      } else {
        ASSERT_THROW(require_no_overlap(made.world, moment), Error);
      }
    }
  }
  EXPECT_GT(overlapping, support::cases(1000) / 2);
}

TEST(Audit, NamesTheWorstPairAndTheOneThatEscaped) {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {20, 20, 0}));
  world.add({{5, 0.5, 0}, {}, 1, 1});
  world.add({{5, 19, 0}, {}, 1, 1});  // overlaps sphere 0 through the edge by a quarter
  world.add({{15, 5, 0}, {}, 1, 1});
  world.add({{15, 5, 1.75}, {}, 1, 1});  // an eighth
  world.add({{18, 10, 0}, {1, 0, 0}, 1, 1});
  const Audit found = audit(world, Time(1.5));
  EXPECT_DOUBLE_EQ(found.max_overlap, 0.25);
  EXPECT_EQ(found.overlap_first, 0U);
  EXPECT_EQ(found.overlap_second, 1U);
  EXPECT_DOUBLE_EQ(found.max_escape, 0.25);
  EXPECT_EQ(found.escaped, 4U);
  EXPECT_FALSE(found.is_sound());
  EXPECT_TRUE(audit(World(), Time(0)).is_sound());
}

TEST(Audit, SeesOverlapsBetweenVeryUnequalSpheres) {
  World world;
  world.add({{0, 0, 0}, {}, 1e6, 1});
  world.add({{1e6 + 0.5, 0, 0}, {}, 1, 1});
  world.add({{0, -1e6 - 1e-6, 0}, {}, 1e-5, 1});
  const Audit found = audit(world, Time(0));
  EXPECT_NEAR(found.max_overlap, 0.5 / (1e6 + 1), 1e-15);
  EXPECT_EQ(found.overlap_second, 1U);
}

TEST(RequireRoom, ChecksAllOthersAndTheirImages) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 5, 5}, {1, 0, 0}, 1, 1});
  const auto is_room = [&world](const Vec3& place, double moment) {
    World with = world;
    with.add({place, {}, 1, 1}, Time(moment));
    const auto last = static_cast<Slot>(world.size());
    return support::refusal_of([&] { require_room(with, last, all_slots(with), Time(moment)); }).empty();
  };
  EXPECT_FALSE(is_room({9.5, 5, 5}, 0));
  EXPECT_TRUE(is_room({9, 5, 5}, 0)) << "touching";
  EXPECT_TRUE(is_room({9.5, 5, 5}, 1)) << "it has moved";
  EXPECT_FALSE(is_room({-28.5, 5, 35}, 0)) << "outside the box";
  world.add({{1, 7, 5}, {}, 1, 1});
  world.reorder(std::vector<Slot>{1, 0});
  World with = world;
  with.add({{1, 6, 5}, {}, 1, 1});
  const Error error = support::error_of([&] { require_room(with, 2, all_slots(with), Time(0)); });
  EXPECT_NE(std::string(error.what()).find("overlaps sphere 0 by"), std::string::npos) << error.what();
}

}  // namespace
}  // namespace hardball::audit_test
