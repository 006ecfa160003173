// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/sliding_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hardball {
namespace {

constexpr double kWidth = 12;
constexpr std::int32_t kRows = 5;

Box sheared_box(double rate) {
  Box box = Box::periodic({kWidth, 10, 8});
  box.set_shear({.rate = rate, .offset = 3});
  return box;
}

// How far a distance is from a whole number of boxes.
double off_whole_boxes(double distance) {
  return std::fabs(std::remainder(distance, kWidth));
}

TEST(SlidingRows, SlideWithTheFlowAtTheirMiddles) {
  const Box box = sheared_box(0.5);
  const SlidingRows rows(box, kRows, Time(0));
  for (std::int32_t row = -kRows; row < 2 * kRows; ++row) {
    EXPECT_NEAR(rows.speed(row), box.flow_speed(2.0 * row + 1), 1e-15);
    const double moved = rows.displacement(row, Time(2)) - rows.displacement(row, Time(1));
    EXPECT_NEAR(moved, rows.speed(row), 1e-14);
  }
  EXPECT_NEAR(rows.speed_of_step(), 1, 1e-15);
}

TEST(SlidingRows, AreThoseOfTheImageAboveDisplacedAsItIs) {
  for (const double rate : {0.5, -3.0, 0.0}) {
    const Box box = sheared_box(rate);
    SlidingRows rows(box, kRows, Time(10));
    // Near the time of construction, far from it, and after that has been noted.
    for (const double moment : {10.0, 10.7, 1e6, 1e6 + 0.5}) {
      if (moment > 1e6) rows.keep_near(Time(moment));
      const double slid = box.images().displacement_in_box(Time(moment));
      for (std::int32_t row = 0; row < kRows; ++row) {
        const double own = rows.displacement(row, Time(moment));
        EXPECT_LT(off_whole_boxes(rows.displacement(row + kRows, Time(moment)) - own - slid), 1e-8);
        EXPECT_LT(off_whole_boxes(rows.displacement(row - kRows, Time(moment)) - own + slid), 1e-8);
        const double step = rows.displacement(row + 1, Time(moment)) - own;
        EXPECT_LT(off_whole_boxes(step - rows.step(Time(moment))), 1e-8);
      }
    }
  }
}

TEST(SlidingRows, AreCountedOnUnlessTheyMayJumpByBoxes) {
  const Box box = sheared_box(2);
  SlidingRows counted(box, kRows, Time(0));
  SlidingRows small(box, kRows, Time(0));
  for (const double moment : {1.0, 7.0, 400.0}) {
    counted.keep_near(Time(moment));
    small.keep_near_and_small(Time(moment));
    for (std::int32_t row = 0; row < kRows; ++row) {
      const double expected = counted.displacement(row, Time(0)) + counted.speed(row) * moment;
      EXPECT_NEAR(counted.displacement(row, Time(moment)), expected, 1e-11);
      EXPECT_LE(std::fabs(small.displacement(row, Time(moment))), 2 * kWidth);
      EXPECT_LT(off_whole_boxes(small.displacement(row, Time(moment)) - expected), 1e-11);
    }
  }
}

}  // namespace
}  // namespace hardball
