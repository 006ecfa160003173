// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/row_surplus.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/numbers/random.hpp"

namespace hardball::row_surplus_test {
namespace {

CellAxes undisturbed(const Vec3& edges) {
  CellAxes axes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes[axis].edge = edges[axis];
  return axes;
}

// Reference: a sphere that moves through cells, and the rows that it holds.
class Flyer {
 public:
  Flyer(const Vec3& edges, double diameter, double free_path)
      : edges_(edges), diameter_(diameter), free_path_(free_path) {
    turn();
  }

  // Means at evenly spaced path lengths.
  RowSurplus mean(int samples) {
    RowSurplus sum;
    const double spacing = 0.37 * edges_.x;
    double flown = 0;
    for (int k = 0; k < samples; ++k) {
      while (flown < spacing) flown += advance(spacing - flown);
      flown = 0;
      std::array<double, kAxes> surplus{};
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        surplus[axis] = front_[axis] - back_[axis] - diameter_ / edges_[axis];
      }
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        sum.along[axis] += surplus[axis] / samples;
        sum.across[axis] += surplus[(axis + 1) % kAxes] * surplus[(axis + 2) % kAxes] / samples;
      }
      sum.all += surplus[0] * surplus[1] * surplus[2] / samples;
    }
    return sum;
  }

 private:
  // Moves to the next crossing or collision, at most by `most`; returns the distance.
  double advance(double most) {
    double way = std::min(most, until_collision_);
    std::size_t crossed = kAxes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double to_row =
          ((front_[axis] + 1) * edges_[axis] - (center_[axis] + diameter_ / 2)) / direction_[axis];
      if (to_row >= way) continue;
      way = std::max(0.0, to_row);
      crossed = axis;
    }
    center_ += way * direction_;
    until_collision_ -= way;
    if (crossed < kAxes) {
      ++front_[crossed];
      give_up_rows();
    } else if (until_collision_ <= 0) {
      turn();
    }
    return way;
  }

  // By symmetry all directions may be taken to point upwards, if the position in the cells is drawn again.
  void turn() {
    until_collision_ = -free_path_ * std::log(1 - random_.uniform());
    direction_ = {std::fabs(random_.normal()), std::fabs(random_.normal()), std::fabs(random_.normal())};
    direction_ = (1 / length(direction_)) * direction_;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      center_[axis] = edges_[axis] * random_.uniform();
      front_[axis] = std::floor((center_[axis] + diameter_ / 2) / edges_[axis]);
    }
    give_up_rows();
  }

  void give_up_rows() {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      back_[axis] = std::floor((center_[axis] - diameter_ / 2) / edges_[axis]);
    }
  }

  Vec3 edges_;
  double diameter_;
  double free_path_;
  Random random_{1};
  Vec3 center_;
  Vec3 direction_;
  double until_collision_ = 0;
  std::array<double, kAxes> front_{};
  std::array<double, kAxes> back_{};
};

TEST(RowSurplus, IsThatOfASphereMovingThroughCells) {
  for (const Vec3& edges : {Vec3{1, 1, 1}, Vec3{1, 1.6, 2.5}}) {
    for (const double diameter : {0.01, 0.4, 1.7}) {
      for (const double free_path : {0.3, 2.0, 40.0}) {
        const RowSurplus expected = Flyer(edges, diameter, free_path).mean(200000);
        const RowSurplus surplus = mean_row_surplus(undisturbed(edges), diameter, free_path, 3);
        // Standard errors of the samples, which are correlated over a few edges, and of 512 points: below
        // 0.01.
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          EXPECT_NEAR(surplus.along[axis], expected.along[axis], 0.03);
          EXPECT_NEAR(surplus.across[axis], expected.across[axis], 0.03);
        }
        EXPECT_NEAR(surplus.all, expected.all, 0.03);
      }
    }
  }
}

TEST(RowSurplus, VanishesWithManyCollisionsAndWithOneCell) {
  const RowSurplus crowded = mean_row_surplus(undisturbed({1, 1, 1}), 0.4, 1e-4, 3);
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_NEAR(crowded.along[axis], 0, 0.01);
  CellAxes whole = undisturbed({1, 1, 1});
  for (CellAxis& axis : whole) axis.is_divided = false;
  const RowSurplus none = mean_row_surplus(whole, 0.4, std::numeric_limits<double>::infinity(), 3);
  EXPECT_EQ(none.along, (std::array<double, kAxes>{}));
  EXPECT_EQ(none.all, 0);
}

}  // namespace
}  // namespace hardball::row_surplus_test
