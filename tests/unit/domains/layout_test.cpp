// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/layout.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hardball/domains/residents.hpp"
#include "hardball/errors/error.hpp"
#include "support/random_centers.hpp"

namespace hardball::layout_test {
namespace {

constexpr Vec3 kSize{20, 10, 10};
const Box kBox = Box::periodic(kSize);

SystemSize size_of(const std::vector<Vec3>& centers, double diameter) {
  return {.spheres = centers.size(), .speeds = static_cast<double>(centers.size()), .contact = diameter};
}

// A tenth of all windows has failed.
constexpr WindowCounters kOftenFailed{.windows = 100, .failed = 10};

TEST(Layout, HasSoManyDomainsThatNoneHasTooManyNeighbors) {
  const std::vector<Vec3> centers = support::random_centers(1000, kSize);
  Layout layout({.domains = 64, .halo = 1.5});
  layout.lay_out(kBox, size_of(centers, 0.5), centers);
  EXPECT_EQ(layout.partition().size(), 64U);
  EXPECT_DOUBLE_EQ(layout.halo().depth, 0.75);
  layout.lay_out(kBox, size_of(centers, 2), centers);
  EXPECT_EQ(layout.partition().size(), 32U);
  EXPECT_LE(layout.partition().most_neighbors(layout.halo().neighborhood()), kMaxNeighbors);
}

TEST(Layout, RefusesMoreProcessesThanCanBeNeighbors) {
  const std::vector<Vec3> centers = support::random_centers(1000, kSize);
  Layout layout({.domains = 4, .halo = 1.5}, 64);
  layout.lay_out(kBox, size_of(centers, 0.5), centers);
  EXPECT_EQ(layout.partition().size() % 64, 0U);
  EXPECT_THROW(layout.lay_out(kBox, size_of(centers, 4), centers), Error);
}

TEST(Layout, DeepensHalosByStepsWhileWindowsFail) {
  const std::vector<Vec3> centers = support::random_centers(1000, kSize);
  const SystemSize size = size_of(centers, 1);
  Layout layout({.domains = 4, .halo = 3.7});
  layout.lay_out(kBox, size, centers);
  const Load load{{10, 10, 10, 10}, kOftenFailed};
  ASSERT_TRUE(layout.may_improve(load, size.spheres));
  EXPECT_TRUE(layout.improve(load, kBox, size, centers));
  EXPECT_DOUBLE_EQ(layout.halo().depth, 3.95);
  EXPECT_FALSE(layout.may_improve(load, size.spheres));
}

// Blocks crowd where the contacts are: then halos cannot be as deep, or blocks have to stay where they are.
TEST(Layout, NeverGetsTooManyNeighborsByLoad) {
  constexpr std::size_t kDomains = 40;
  const std::vector<Vec3> centers = support::random_centers(4000, kSize);
  Load load{std::vector<std::uint64_t>(kDomains, 0), kOftenFailed};
  for (std::size_t k = 0; k < 4; ++k) load.contacts[k] = 1'000'000;
  std::size_t deeper = 0;
  std::size_t only_moved = 0;
  std::size_t unchanged = 0;
  for (double diameter = 0.2; diameter < 2; diameter *= 1.01) {
    const SystemSize size = size_of(centers, diameter);
    Layout layout({.domains = kDomains, .halo = 1.5});
    layout.lay_out(kBox, size, centers);
    if (layout.partition().size() < kDomains) break;
    ASSERT_TRUE(load.is_uneven(size.spheres));
    const double before = layout.partition().block(0).high(0);
    const bool has_improved = layout.improve(load, kBox, size, centers);
    EXPECT_EQ(layout.partition().size(), kDomains);
    EXPECT_LE(layout.partition().most_neighbors(layout.halo().neighborhood()), kMaxNeighbors);
    const bool is_deeper = layout.halo().depth > 1.6 * diameter;
    const bool has_moved = layout.partition().block(0).high(0) != before;
    EXPECT_EQ(has_improved, has_moved);
    ++(is_deeper ? deeper : has_moved ? only_moved : unchanged);
  }
  EXPECT_GT(deeper, 0U);
  EXPECT_GT(only_moved, 0U);
  EXPECT_GT(unchanged, 0U);
}

TEST(Layout, IsReviewedEverySoManyWindows) {
  const std::vector<Vec3> centers = support::random_centers(100, kSize);
  Layout layout({.domains = 2});
  layout.lay_out(kBox, size_of(centers, 1), centers);
  EXPECT_FALSE(layout.is_review_due(63));
  EXPECT_TRUE(layout.is_review_due(64));
  EXPECT_FALSE(layout.is_review_due(127));
  EXPECT_TRUE(layout.is_review_due(128));
  Layout alone({.domains = 1});
  alone.lay_out(kBox, size_of(centers, 1), centers);
  EXPECT_FALSE(alone.is_review_due(1000));
}

}  // namespace
}  // namespace hardball::layout_test
