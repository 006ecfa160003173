// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace hardball {

/// Calls work(k) for each k below `count`, in up to so many threads, of which the caller's is one. Error: the
/// first that is thrown; then some are not called.
template <class Work>
void share_work(std::size_t count, std::size_t threads, Work&& work) {
  std::vector<std::exception_ptr> failures(
      std::clamp<std::size_t>(threads, 1, std::max<std::size_t>(1, count)));
  std::atomic<std::size_t> next{0};
  const auto take = [&](std::size_t thread) {
    try {
      for (std::size_t k = next++; k < count; k = next++) work(k);
    } catch (...) {
      failures[thread] = std::current_exception();
      next = count;
    }
  };
  // Joins all, even where one cannot be started.
  struct Others {
    std::vector<std::thread> threads;
    ~Others() {
      for (std::thread& thread : threads) thread.join();
    }
  };
  {
    Others others;
    for (std::size_t thread = 1; thread < failures.size(); ++thread)
      others.threads.emplace_back(take, thread);
    take(0);
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace hardball
