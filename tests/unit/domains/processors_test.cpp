// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/processors.hpp"

#include <gtest/gtest.h>

#include <sched.h>
#include <set>
#include <vector>

#include "hardball/domains/system_size.hpp"
#include "hardball/domains/thread_team.hpp"
#include "hardball/platform/processors.hpp"

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
  const std::vector<int> available = platform::available_processors();
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

#if defined(__linux__)
// The calling thread is not the one that has made the team, or may run elsewhere by then.
TEST(ThreadTeam, LetsItsCallerRunWhereItCouldBefore) {
  const std::vector<int> all = platform::available_processors();
  if (all.size() < 2) GTEST_SKIP() << "needs two processors";
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  ThreadTeam team(2);
  cpu_set_t last;
  CPU_ZERO(&last);
  CPU_SET(static_cast<unsigned>(all.back()), &last);
  ASSERT_EQ(sched_setaffinity(0, sizeof last, &last), 0);
  {
    const ThreadTeam::Pinned pinned(team);
    EXPECT_EQ(platform::available_processors(), processors_of_thread(all, 2, 0));
  }
  EXPECT_EQ(platform::available_processors(), std::vector<int>{all.back()});
  EXPECT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}
#endif

// 256 contacts of the domain itself, but at most twice as many as there would be otherwise.
TEST(SystemSize, GivesSmallDomainsLongerWindows) {
  const auto contacts_in = [](std::uint64_t spheres, std::size_t domains) {
    const SystemSize size{.spheres = spheres, .speeds = 1.5 * static_cast<double>(spheres), .contact = 1};
    return size.windows({.window = 0.02}, domains);
  };
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 8).contacts, 10000);
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 8).more_contacts, 10000);
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 64).contacts, 10000);
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 64).more_contacts, 256 * 64);
  EXPECT_DOUBLE_EQ(contacts_in(10000, 2).more_contacts, 200);
  // Never less than one.
  EXPECT_DOUBLE_EQ(contacts_in(10, 2).contacts, 1);
  EXPECT_DOUBLE_EQ(contacts_in(10, 2).more_contacts, 1);
}

TEST(SystemSize, KnowsHowLongSpheresFlyByADiameter) {
  const SystemSize size{.spheres = 100, .speeds = 400, .contact = 2};
  EXPECT_DOUBLE_EQ(size.windows({}, 2).flight, 0.5);
}

}  // namespace
}  // namespace hardball::processors_test
