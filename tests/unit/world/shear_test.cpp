// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/sliding_images.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hardball/interaction/step_potential.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/queries/queries.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/static_hash_grid.hpp"
#include "hardball/world/world.hpp"
#include "support/refusal.hpp"

namespace hardball {
namespace {

using support::problem_of;

Box sheared_box() {
  Box box = Box::periodic({6, 5, 7});
  box.set_shear({.rate = 0.3, .offset = 1});
  return box;
}

TEST(SlidingImages, LoseNoDigitsHoweverFarTheySlide) {
  const SlidingImages images({.rate = 0.1}, 10, 10);
  const Time late(1e9, 1e-9);
  // In a billion units of time the image above slides by 1e8 boxes.
  EXPECT_EQ(images.shift(-100000000, 1, Time(1e9)), 0.1 * 10 * 1e9 - 1e9);
  EXPECT_NEAR(images.shift(-100000000, 1, late), 1e-9, 1e-24);
  EXPECT_NEAR(images.displacement_in_box(Time(1e9 + 2.5)), 2.5, 1e-15);
}

TEST(ShearedBox, TakesWholeBoxesOffTheOffset) {
  Box box = Box::periodic({6, 5, 7});
  const auto offset_of = [&](double offset) {
    box.set_shear({.rate = 0.3, .offset = offset});
    return box.shear().offset;
  };
  EXPECT_EQ(offset_of(5.5), 5.5);
  EXPECT_EQ(offset_of(-5.5), -5.5);
  EXPECT_EQ(offset_of(6), 0);
  EXPECT_EQ(offset_of(6e10 + 1.5), 1.5);
  EXPECT_EQ(offset_of(-6e10 - 1.5), -1.5);
  EXPECT_EQ(offset_of(1e60), std::fmod(1e60, 6));
  // Images in a file are counted by the very offset.
  box.set_recorded_shear({.rate = 0.3, .offset = 13});
  EXPECT_EQ(box.shear().offset, 13);
}

TEST(ShearedBox, FoldsWhatLeavesAbove) {
  const Box box = sheared_box();
  Vec3 position{3.5, 6, 2};
  Vec3 velocity{0.25, 1, 0};
  // At time 2 the image above is displaced by 1 + 0.3 * 5 * 2 = 4.
  EXPECT_EQ(box.fold(position, velocity, Time(2)), (Image{{-1, 1, 0}}));
  EXPECT_EQ(position, (Vec3{5.5, 1, 2}));
  EXPECT_EQ(velocity, (Vec3{-1.25, 1, 0}));
}

TEST(ShearedBox, FindsTheNearestImage) {
  const Box box = sheared_box();
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Time now(100 * random.uniform());
    const Vec3 apart{60 * random.uniform() - 30, 50 * random.uniform() - 25, 7 * random.uniform()};
    const Image image = box.nearest_image(apart, now);
    const Vec3 left = box.shift(image, now) - apart;
    EXPECT_LE(std::fabs(left.x), 3 + 1e-9);
    EXPECT_LE(std::fabs(left.y), 2.5 + 1e-9);
    EXPECT_LE(std::fabs(left.z), 3.5 + 1e-9);
  }
}

TEST(ShearedBox, NeedsPeriodsAlongXAndY) {
  Box walls({Boundary::periodic, Boundary::wall, Boundary::periodic}, {1, 1, 1});
  EXPECT_EQ(problem_of([&] { walls.set_shear({.rate = 1}); }),
            "the box is sheared, and not periodic along x and y");
  EXPECT_NO_THROW(walls.set_shear({}));
  Box box = Box::flat_periodic(1, 1);
  EXPECT_NE(problem_of([&] { box.set_shear({.rate = std::nan("")}); }), "");
  EXPECT_NE(problem_of([&] { box.set_shear({.rate = 1e-70}); }), "");
}

TEST(ShearedWorld, FollowsASphereAcrossTheFace) {
  World world(sheared_box());
  world.add({.position = {3, 4, 2}, .velocity = {0.25, 1, 0}, .radius = 0.5});
  const Vec3 peculiar = peculiar_velocity(world, 0, Time(0));
  Vec3 before = unwrapped_position(world, 0, Time(0));
  for (int k = 1; k <= 400; ++k) {
    const Time now(k / 20.0);
    const Vec3 position = world.position(0, now);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_GE(position[axis], -1e-12);
      ASSERT_LE(position[axis], world.box().size()[axis] + 1e-12);
    }
    // The peculiar velocity knows nothing of the image; what rises falls behind.
    ASSERT_NEAR(peculiar_velocity(world, 0, now).x, peculiar.x - 0.3 * now.value(), 1e-12);
    ASSERT_NEAR(world.velocity(0, now).x, peculiar_velocity(world, 0, now).x + flow_velocity(world, 0, now).x,
                1e-12);
    // Rewriting the path changes nothing, and never moves the unwrapped center.
    if (k % 7 == 0) world.rewrite_path(0, now, world.velocity(0, now));
    const Vec3 unwrapped = unwrapped_position(world, 0, now);
    ASSERT_NEAR(unwrapped.y - before.y, 0.05, 1e-12);
    ASSERT_LE(std::fabs(unwrapped.x - before.x), 0.5 + 1e-9);
    before = unwrapped;
  }
  EXPECT_GT(image_of(world, 0, Time(20))[1], 3);
}

TEST(ShearedWorld, RefusesWhatDoesNotGoTogether) {
  const std::string sheared = "the box is sheared, and ";
  EXPECT_EQ(problem_of([] { World(sheared_box(), {0, 0, -1}); }), sheared + "there is gravity");
  const Surface tube(Cylinder({1, 0, 0}, 1), {0, 2.5, 3});
  EXPECT_EQ(problem_of([&] { World(sheared_box(), {}, {tube}); }), sheared + "a surface is not a plane");
  World world(sheared_box());
  world.add({.position = {3, 4, 2}, .radius = 0.5});
  EXPECT_NE(
      problem_of([&] { world.set_growth({.begin = Time(0), .end = Time(1), .scale = 1, .rate = 0.1}); }), "");
  StepTable steps;
  steps.set_for_all(StepPotential({.steps = {{1.5, -1.0}}}));
  Interactions interactions;
  interactions.set_steps(steps);
  EXPECT_EQ(problem_of([&] { world.set_interactions(interactions); }),
            sheared + "there are potentials of steps");
  EXPECT_FALSE(world.has_steps()) << "what is refused is not kept";
  EXPECT_NE(problem_of([&] { static_cast<void>(ray(world, Time(0), {1, 1, 1}, {1, 0, 0}, 1)); }), "");
  EXPECT_NE(problem_of([&] { Simulation(world, {.engine = EngineKind::paper}); }), "");
  EXPECT_EQ(problem_of([&] { Simulation(world, {.threads = 2}); }), "threads cannot share a sheared box");
}

TEST(StaticHashGrid, FindsNeighborsAcrossSlidingFaces) {
  const Box box = sheared_box();
  Random random(3);
  for (const double moment : {0.0, 1.3, 100.0}) {
    StaticHashGrid grid(box, 200, 0.2, Time(moment));
    std::vector<Vec3> centers;
    for (int i = 0; i < 200; ++i) {
      centers.push_back({6 * random.uniform(), 5 * random.uniform(), 7 * random.uniform()});
      grid.insert(centers.back(), 0.2);
    }
    std::size_t found = 0;
    grid.for_each_near(centers[0], 1, [&](std::uint32_t, const Vec3& separation, double) {
      found += length(separation) <= 1.2 ? 1U : 0U;
    });
    for (const Vec3& center : centers) {
      grid.for_each_near(center, 1, [&](std::uint32_t index, const Vec3& separation, double) {
        const Vec3 apart = centers[index] - center;
        const Vec3 nearest = apart + box.shift(box.nearest_image(-apart, Time(moment)), Time(moment));
        if (length(separation) <= 1.2) {
          EXPECT_NEAR(length(nearest), length(separation), 1e-9);
        }
      });
    }
    std::size_t expected = 0;
    for (const Vec3& center : centers) {
      const Vec3 apart = center - centers[0];
      const Vec3 nearest = apart + box.shift(box.nearest_image(-apart, Time(moment)), Time(moment));
      expected += length(nearest) <= 1.2 ? 1U : 0U;
    }
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace hardball
