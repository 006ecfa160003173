// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/thread_team.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hardball/domains/processors.hpp"

#if defined(__linux__)
#include <sched.h>
#endif

namespace hardball::thread_team_test {
namespace {

#if defined(__linux__)
// The calling thread is not the one that has made the team, or may run elsewhere by then.
TEST(ThreadTeam, LetsItsCallerRunWhereItCouldBefore) {
  const std::vector<int> all = available_processors();
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
    EXPECT_EQ(available_processors(), processors_of_thread(all, 2, 0));
  }
  EXPECT_EQ(available_processors(), std::vector<int>{all.back()});
  EXPECT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}
#endif

}  // namespace
}  // namespace hardball::thread_team_test
