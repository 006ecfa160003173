// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/static_hash_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "hardball/numbers/random.hpp"

namespace hardball::static_hash_grid_test {
namespace {

// The indices of the spheres found, each with its image.
using Found = std::vector<std::tuple<std::uint32_t, long, long, long>>;

// So many cells are within reach that all spheres are visited instead.
TEST(StaticHashGrid, FindsSpheresOverManyEmptyCells) {
  constexpr std::uint32_t kSpheres = 10;
  constexpr double kSize = 10;
  constexpr double kRadius = 0.01;
  constexpr double kRange = 12;
  const Box box({Boundary::periodic, Boundary::open, Boundary::wall}, {kSize, kSize, kSize});
  Random random(52);
  std::vector<Vec3> centers;
  StaticHashGrid neighborhood(box, kSpheres, kRadius);
  for (std::uint32_t i = 0; i < kSpheres; ++i) {
    centers.push_back(kSize * Vec3{random.uniform(), random.uniform(), random.uniform()});
    neighborhood.insert(centers.back(), kRadius);
  }
  for (const Vec3& center : centers) {
    Found found;
    neighborhood.for_each_near(
        center, kRange, [&](std::uint32_t index, const Vec3& separation, double reach) {
          EXPECT_EQ(reach, kRange + kRadius);
          if (length(separation) > kRange) return;
          found.emplace_back(index, std::lround((separation - (centers[index] - center)).x / kSize), 0, 0);
        });
    Found expected;
    for (std::uint32_t i = 0; i < kSpheres; ++i) {
      for (long x = -2; x <= 2; ++x) {
        const Vec3 shift{kSize * static_cast<double>(x), 0, 0};
        if (length(centers[i] + shift - center) <= kRange) expected.emplace_back(i, x, 0, 0);
      }
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    EXPECT_GT(expected.size(), kSpheres);
  }
  EXPECT_THROW(neighborhood.for_each_near({}, 1e10, [](auto&&...) {}), BrokenInvariant);
}

// So few buckets that cells share them, and boxes so small that images share cells.
TEST(StaticHashGrid, FindsEveryTouchingImageOnceAndNoOther) {
  constexpr std::uint32_t kSpheres = 40;
  constexpr double kRadius = 0.5;
  for (const double size : {1.1, 2.3, 7.0, 40.0}) {
    for (const Boundary boundary : {Boundary::periodic, Boundary::open}) {
      const Box box({boundary, boundary, boundary}, {size, size, size});
      Random random(51);
      std::vector<Vec3> centers;
      StaticHashGrid neighborhood(box, kSpheres, kRadius);
      for (std::uint32_t i = 0; i < kSpheres; ++i) {
        centers.push_back(size * Vec3{random.uniform(), random.uniform(), random.uniform()});
        neighborhood.insert(centers.back(), kRadius);
      }
      std::size_t touching = 0;
      for (const Vec3& center : centers) {
        Found found;
        neighborhood.for_each_near(
            center, kRadius, [&](std::uint32_t index, const Vec3& separation, double reach) {
              EXPECT_EQ(reach, 2 * kRadius);
              if (length(separation) > reach) return;
              const Vec3 boxes = (1 / size) * (separation - (centers[index] - center));
              found.emplace_back(index, std::lround(boxes.x), std::lround(boxes.y), std::lround(boxes.z));
            });
        Found expected;
        const long farthest = boundary == Boundary::periodic ? 2 : 0;
        for (std::uint32_t i = 0; i < kSpheres; ++i) {
          for (long x = -farthest; x <= farthest; ++x) {
            for (long y = -farthest; y <= farthest; ++y) {
              for (long z = -farthest; z <= farthest; ++z) {
                const Vec3 shift =
                    size * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                if (length(centers[i] + shift - center) <= 2 * kRadius) expected.emplace_back(i, x, y, z);
              }
            }
          }
        }
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << "size " << size;
        touching += expected.size();
      }
      EXPECT_GE(touching, centers.size());
    }
  }
}

}  // namespace
}  // namespace hardball::static_hash_grid_test
