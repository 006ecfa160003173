// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/per_sphere.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::per_sphere_test {
namespace {

TEST(PerSphere, NeedsNoMemoryWhileAllNumbersAreEqual) {
  PerSphere values;
  EXPECT_TRUE(values.is_common());
  EXPECT_EQ(values.common(), 0);
  EXPECT_EQ(values.largest(), 0);
  for (int i = 0; i < 1000; ++i) values.push_back(1.5);
  EXPECT_TRUE(values.is_common());
  EXPECT_EQ(values.common(), 1.5);
  EXPECT_EQ(values.largest(), 1.5);
  EXPECT_EQ(values[999], 1.5);
  EXPECT_TRUE(values.each().empty());
  EXPECT_EQ(values.memory_bytes(), 0U);
  values.push_back(0.5);
  EXPECT_FALSE(values.is_common());
  ASSERT_EQ(values.each().size(), 1001U);
  EXPECT_EQ(values[999], 1.5);
  EXPECT_EQ(values[1000], 0.5);
  EXPECT_EQ(values.largest(), 1.5);
  EXPECT_GE(values.memory_bytes(), 1001 * sizeof(double));
}

TEST(PerSphere, ForgetsTheNumberWhenAllSpheresAreGone) {
  for (const double second : {2.0, 3.0}) {
    PerSphere values;
    values.push_back(2);
    values.push_back(second);
    values.erase(0);
    values.erase(0);
    EXPECT_TRUE(values.is_common());
    EXPECT_EQ(values.common(), 0);
    EXPECT_EQ(values.largest(), 0);
    values.push_back(5);
    EXPECT_TRUE(values.is_common());
    EXPECT_EQ(values.common(), 5);
    EXPECT_EQ(values[0], 5);
  }
}

TEST(PerSphere, AgreesWithAVector) {
  Random random(1);
  for (const std::uint64_t different : {1U, 2U, 5U}) {
    PerSphere values;
    std::vector<double> vector;
    for (std::uint64_t step = 0; step < support::cases(3000); ++step) {
      const double what = random.uniform();
      const bool filling = step / 50 % 2 == 0;
      if (vector.empty() || what < (filling ? 0.7 : 0.2)) {
        const double value = 1 + static_cast<double>(random.bits() % different);
        values.push_back(value);
        vector.push_back(value);
      } else if (what < 0.9) {
        const auto slot = static_cast<Slot>(random.bits() % vector.size());
        values.erase(slot);
        vector[slot] = vector.back();
        vector.pop_back();
      } else {
        std::vector<Slot> order(vector.size());
        for (Slot k = 0; k < order.size(); ++k) order[k] = k;
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.bits() % i]);
        std::vector<double> moved;
        for (const Slot slot : order) moved.push_back(vector[slot]);
        values.reorder(order);
        vector = moved;
      }
      double largest = 0;
      for (Slot slot = 0; slot < vector.size(); ++slot) {
        ASSERT_EQ(values[slot], vector[slot]) << "step " << step;
        largest = std::max(largest, vector[slot]);
      }
      ASSERT_EQ(values.largest(), largest);
      if (values.is_common()) {
        ASSERT_EQ(values.common(), largest);
      } else {
        ASSERT_EQ(values.each().size(), vector.size());
      }
      ASSERT_TRUE(values.is_common() || different > 1);
    }
  }
}

}  // namespace
}  // namespace hardball::per_sphere_test
