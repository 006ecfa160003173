// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/run/division_watch.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace hardball::division_watch_test {
namespace {

constexpr double kSlice = 0.01;  // s

// A run of so many seconds, with these rates of contacts in threads and in one; the part of the time that was
// divided.
class WatchedRun {
 public:
  WatchedRun(double divided_rate, double single_rate, bool are_hindered)
      : divided_rate_(divided_rate), single_rate_(single_rate), are_hindered_(are_hindered) {
    watch_.begin(0, 0);
  }

  double divided_part(double duration) {
    const int slices = static_cast<int>(duration / kSlice);
    int divided = 0;
    for (int i = 0; i < slices; ++i) {
      const bool divides = watch_.divides();
      now_ += kSlice;
      contacts_ += kSlice * (divides ? divided_rate_ : single_rate_);
      divided += divides ? 1 : 0;
      watch_.note(now_, static_cast<std::uint64_t>(contacts_), divides && are_hindered_);
    }
    return static_cast<double>(divided) / slices;
  }

  void set(double divided_rate, bool are_hindered) {
    divided_rate_ = divided_rate;
    are_hindered_ = are_hindered;
  }
  void pause(double duration) {
    now_ += duration;
    watch_.begin(now_, static_cast<std::uint64_t>(contacts_));
  }

 private:
  DivisionWatch watch_;
  double divided_rate_;
  double single_rate_;
  bool are_hindered_;
  double now_ = 0;
  double contacts_ = 0;
};

TEST(DivisionWatch, LetsThreadsShareTheWorkThatAreNotHindered) {
  EXPECT_EQ(WatchedRun(2e6, 1e6, false).divided_part(100), 1);
  EXPECT_EQ(WatchedRun(0.5e6, 1e6, false).divided_part(100), 1)
      << "others may be slow for reasons of their own";
}

TEST(DivisionWatch, PrefersOneThreadWhileOthersTakeAProcessor) {
  WatchedRun run(0.4e6, 1e6, true);
  EXPECT_EQ(run.divided_part(0.9), 1) << "at first, whatever happens";
  EXPECT_LT(run.divided_part(10), 0.2);
  const double tried = run.divided_part(100);
  EXPECT_LT(tried, 0.05);
  EXPECT_GT(tried, 0) << "it tries now and then";
  run.set(2e6, false);
  run.divided_part(10);
  EXPECT_EQ(run.divided_part(100), 1) << "the others have gone";
  run.set(0.4e6, true);
  EXPECT_GT(run.divided_part(3), 0.06) << "they are back, and it tries as often as at first";
}

TEST(DivisionWatch, KeepsThreadsThatWaitButAreFaster) {
  WatchedRun run(1.5e6, 1e6, true);
  EXPECT_GT(run.divided_part(10), 0.9);
  EXPECT_GT(run.divided_part(100), 0.97);
}

TEST(DivisionWatch, DoesNotCountTheTimeBetweenRuns) {
  WatchedRun run(1.5e6, 1e6, true);
  for (int i = 0; i < 100; ++i) {
    run.divided_part(0.15);
    run.pause(10);
  }
  EXPECT_GT(run.divided_part(10), 0.9);
}

}  // namespace
}  // namespace hardball::division_watch_test
