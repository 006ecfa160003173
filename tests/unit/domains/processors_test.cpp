// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/processors.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace hardball::processors_test {
namespace {

TEST(Processors, OfThreadsAreNotShared) {
  const std::vector<int> available{0, 1, 2, 3, 8, 9, 10};
  for (std::size_t threads = 1; threads <= available.size(); ++threads) {
    std::set<int> used;
    for (std::size_t number = 0; number < threads; ++number) {
      const std::vector<int> processors = processors_of_thread(available, threads, number);
      EXPECT_FALSE(processors.empty());
      for (const int processor : processors) EXPECT_TRUE(used.insert(processor).second);
    }
    EXPECT_EQ(used, std::set<int>(available.begin(), available.end()));
  }
  EXPECT_EQ(processors_of_thread({0, 1, 2, 3, 4, 5, 6, 7}, 4, 1), (std::vector<int>{1, 5}));
}

TEST(Processors, ThatAreFreeAreSome) {
  EXPECT_GE(free_processors(), 1U);
  const std::vector<int> available = available_processors();
  if (!available.empty()) {
    EXPECT_LE(free_processors(), available.size());
  }
}

TEST(Processors, AreLimitedByQuotas) {
  EXPECT_EQ(processors_by_quota("200000 100000", 8), 2U);
  EXPECT_EQ(processors_by_quota("250000 100000", 8), 2U);
  EXPECT_EQ(processors_by_quota("50000 100000", 8), 1U);
  EXPECT_EQ(processors_by_quota("2000000 100000", 8), 8U);
  for (const char* none : {"max 100000", "max", "", "200000", "200000 ", "200000 0", "200000 x", "-1 100000"})
    EXPECT_EQ(processors_by_quota(none, 8), 8U) << none;
}

}  // namespace
}  // namespace hardball::processors_test
