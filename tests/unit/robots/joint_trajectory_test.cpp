// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/joint_trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal.hpp"

namespace hardball::joint_trajectory_test {
namespace {

using Row = JointTrajectory::Row;

const std::vector<double> kTimes{0.5, 1, 3, 3.5, 5};
const std::vector<Row> kRows{{0, 1}, {1, -1}, {0.5, 2}, {2, 0}, {-1, 0.5}};

// A derivative of the polynomial of a joint in a piece, at the time since the piece began.
double derivative(const JointTrajectory& trajectory, std::size_t piece, std::size_t joint, int order,
                  double t) {
  const JointTrajectory::Cubic& c = trajectory.piece(piece)[joint];
  if (order == 0) return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  if (order == 1) return c[1] + t * (2 * c[2] + 3 * t * c[3]);
  return 2 * c[2] + 6 * t * c[3];
}

TEST(JointTrajectory, SplinesAreSmoothAndMeetTheirKnots) {
  for (const SplineEnds ends : {SplineEnds::natural, SplineEnds::clamped}) {
    const JointTrajectory trajectory = JointTrajectory::cubic(kTimes, kRows, ends);
    const std::size_t last = trajectory.piece_count() - 1;
    const int of_end = ends == SplineEnds::natural ? 2 : 1;
    for (std::size_t joint = 0; joint < 2; ++joint) {
      for (std::size_t k = 0; k <= last; ++k) {
        const double step = kTimes[k + 1] - kTimes[k];
        EXPECT_EQ(derivative(trajectory, k, joint, 0, 0), kRows[k][joint]);
        EXPECT_NEAR(derivative(trajectory, k, joint, 0, step), kRows[k + 1][joint], 1e-14);
        for (int order = 1; k < last && order <= 2; ++order) {
          EXPECT_NEAR(derivative(trajectory, k, joint, order, step),
                      derivative(trajectory, k + 1, joint, order, 0), 1e-13);
        }
      }
      EXPECT_NEAR(derivative(trajectory, 0, joint, of_end, 0), 0, 1e-13);
      EXPECT_NEAR(derivative(trajectory, last, joint, of_end, kTimes[last + 1] - kTimes[last]), 0, 1e-13);
    }
  }
}

TEST(JointTrajectory, KnowsItsCoordinates) {
  const JointTrajectory trajectory = JointTrajectory::linear(kTimes, kRows);
  EXPECT_EQ(trajectory.begin(), 0.5);
  EXPECT_EQ(trajectory.end(), 5);
  EXPECT_EQ(trajectory.coordinates_at(0.75), (Row{0.5, 0}));
  EXPECT_EQ(trajectory.coordinates_at(1), (Row{1, -1}));
  EXPECT_EQ(trajectory.coordinates_at(2), (Row{0.75, 0.5}));
  EXPECT_EQ(trajectory.coordinates_at(5), (Row{-1, 0.5}));
  EXPECT_EQ(support::problem_of([&] { trajectory.coordinates_at(5.5); }), "the time is 5.5");
}

TEST(JointTrajectory, TakesRatesAndPolynomials) {
  // t^3 from 0 to 2.
  const JointTrajectory whole = JointTrajectory::from_pieces({0, 2}, {{{0, 0, 0, 1}}});
  const JointTrajectory by_rates = JointTrajectory::from_rates({0, 2}, {{0}, {8}}, {{0}, {12}});
  EXPECT_EQ(whole.piece(0)[0], by_rates.piece(0)[0]);
  EXPECT_EQ(whole.coordinates_at(1.5), (Row{3.375}));
}

TEST(JointTrajectory, RefusesWhatIsNoFunctionOfTime) {
  const auto problem = [](const std::vector<double>& times, const std::vector<Row>& rows) {
    return support::problem_of([&] { JointTrajectory::cubic(times, rows); });
  };
  EXPECT_EQ(problem({}, {}), "there are fewer than two times");
  EXPECT_EQ(problem({1}, {{0}}), "there are fewer than two times");
  EXPECT_EQ(problem({1, 1}, {{0}, {0}}), "the time 1 follows 1");
  EXPECT_EQ(problem({0, 1}, {{0}}), "there are 2 times and 1 rows of coordinates");
  EXPECT_EQ(problem({0, 1}, {{0}, {0, 1}}), "the rows of coordinates differ in length");
  EXPECT_EQ(problem({0, 1}, {{0}, {std::nan("")}}), "one of the coordinates is nan");
  EXPECT_EQ(support::problem_of([] {
              JointTrajectory::from_rates({0, 1}, {{0}, {1}}, {{0, 1}, {1, 2}});
            }),
            "coordinates and rates are of different lengths");
  EXPECT_EQ(support::problem_of([] {
              JointTrajectory::from_pieces({0, 1, 2}, {{{0, 1, 0, 0}}, {{1.5, 0, 0, 0}}});
            }),
            "joint 0 jumps by 0.5 at the time 1");
  EXPECT_EQ(support::problem_of([] {
              JointTrajectory::from_pieces({0, 1, 2}, {{{0, 1, 0, 0}}});
            }),
            "there are 3 times and 1 pieces");
}

}  // namespace
}  // namespace hardball::joint_trajectory_test
