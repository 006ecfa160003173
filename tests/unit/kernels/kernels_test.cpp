// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/kernels/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/world/random.hpp"
#include "support/effort.hpp"
#include "support/instruction_sets.hpp"

namespace hardball {
namespace {

using support::available_instruction_sets;

TEST(InstructionSet, PortableIsAlwaysAvailableAndTheWidestIsToo) {
  EXPECT_TRUE(is_available(InstructionSet::portable));
  EXPECT_TRUE(is_available(widest_instruction_set()));
  EXPECT_EQ(widest_instruction_set(), available_instruction_sets().back());
}

TEST(InstructionSet, IsRefusedWhereItIsNotAvailable) {
  for (const InstructionSet set : {InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512}) {
    if (is_available(set)) {
      EXPECT_NO_THROW(kernels_of(set));
    } else {
      EXPECT_THROW(kernels_of(set), Error);
    }
  }
}

// Points in a box that is periodic along the axes with a period, and a query for some of them.
struct Points {
  std::vector<Vec3> places;
  std::vector<double> radii;
  std::vector<std::uint32_t> asked;
  Vec3 period;
};

Points random_points(Random& random) {
  constexpr double kSize = 8;
  Points points;
  for (std::size_t axis = 0; axis < kAxes; ++axis) points.period[axis] = random.uniform() < 0.5 ? kSize : 0;
  for (std::uint32_t slot = 0; slot < 60; ++slot) {
    points.places.push_back(kSize * Vec3{random.uniform(), random.uniform(), random.uniform()});
    points.radii.push_back(0.1 + random.uniform());
    if (random.uniform() < 0.7) points.asked.push_back(slot);
  }
  return points;
}

// The distance of the nearest image from `place`.
double distance(const Points& points, std::uint32_t slot, const Vec3& place) {
  Vec3 apart = points.places[slot] - place;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double period = points.period[axis];
    if (period > 0) apart[axis] = std::remainder(apart[axis], period);
  }
  return length(apart);
}

TEST(NearKernel, PicksThePointsWithinReachWithAllInstructionSets) {
  std::size_t picked = 0;
  for (std::uint64_t seed = 0; seed < support::cases(2000); ++seed) {
    Random random(seed);
    Points points = random_points(random);
    const auto count = static_cast<std::size_t>(random.bits() % (points.asked.size() + 1));
    const Vec3 place = 8 * Vec3{random.uniform(), random.uniform(), random.uniform()};
    const double reach = 3 * random.uniform();
    const bool has_radii = seed % 2 == 0;
    std::vector<std::uint32_t> expected;
    bool is_close = false;  // to the reach, where rounding decides
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t slot = points.asked[i];
      const double beyond = distance(points, slot, place) - reach - (has_radii ? points.radii[slot] : 0);
      if (beyond < 0) expected.push_back(slot);
      is_close |= std::fabs(beyond) < 1e-12;
    }
    if (is_close) continue;
    // The padding contains near points, too.
    const auto nearest =
        static_cast<std::uint32_t>(std::min_element(points.places.begin(), points.places.end(),
                                                    [&](const Vec3& a, const Vec3& b) {
                                                      return length(a - place) < length(b - place);
                                                    }) -
                                   points.places.begin());
    points.asked.resize(count);
    points.asked.resize(count + kWidestVector, nearest);
    const auto inverse = [](double period) { return period > 0 ? 1 / period : 0; };
    const NearQuery query{
        .points = points.places.data(),
        .slots = points.asked.data(),
        .count = count,
        .place = place,
        .period = points.period,
        .inverse_period = {inverse(points.period.x), inverse(points.period.y), inverse(points.period.z)},
        .reach = reach,
        .radii = has_radii ? points.radii.data() : nullptr,
    };
    for (const InstructionSet set : available_instruction_sets()) {
      std::vector<std::uint32_t> near(count + kWidestVector);
      near.resize(kernels_of(set).pick_near(query, near.data()));
      ASSERT_EQ(near, expected) << "seed " << seed;
    }
    picked += expected.size();
  }
  EXPECT_GT(picked, support::cases(2000));
}

}  // namespace
}  // namespace hardball
