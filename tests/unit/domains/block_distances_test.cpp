// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/block_distances.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "hardball/domains/partition.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::block_distances_test {
namespace {

TEST(BlockDistances, AreThoseOfEachBlock) {
  constexpr std::array kKinds{Boundary::periodic, Boundary::wall, Boundary::open};
  constexpr Vec3 kEdges{10, 7, 4};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto kind = [&] { return kKinds[static_cast<std::size_t>(3 * random.uniform())]; };
    const Box box({kind(), kind(), kind()}, kEdges);
    const auto point = [&](double margin) {
      Vec3 place;
      for (std::size_t axis = 0; axis < kAxes; ++axis)
        place[axis] = kEdges[axis] * (random.uniform() * (1 + 2 * margin) - margin);
      return place;
    };
    std::vector<Vec3> centers;
    for (int k = 0; k < 200; ++k) centers.push_back(point(0));
    const std::size_t count = 1 + seed % BlockDistances::kMaxBlocks;
    const Partition partition = Partition::bisection(box, count, centers);
    const BlockDistances all(partition.blocks());
    for (int k = 0; k < 20; ++k) {
      // Starts of legs may lie outside the box.
      const Vec3 place = point(0.5);
      BlockDistances::Distances distances;
      all.find(place, distances);
      for (std::size_t block = 0; block < count; ++block)
        ASSERT_EQ(distances[block], partition.blocks()[block].distance(place)) << block;
    }
  }
}

}  // namespace
}  // namespace hardball::block_distances_test
