// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/connection_threads.hpp"

#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace hardball::viewer {

void ConnectionThreads::enqueue(std::function<void()> serve) {
  const auto task = std::make_shared<const std::function<void()>>(std::move(serve));
  std::unique_lock lock(mutex_);
  for (std::size_t fewer = most_;;) {
    ended_.wait(lock, [&] { return running_ < fewer; });
    try {
      std::thread([this, task] {
        (*task)();
        const std::lock_guard ending(mutex_);
        --running_;
        ended_.notify_all();
      }).detach();
      ++running_;
      return;
    } catch (const std::system_error&) {
      // The system has no more threads.
      if (running_ == 0) break;
      fewer = running_;
    }
  }
  lock.unlock();
  (*task)();
}

void ConnectionThreads::shutdown() {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [&] { return running_ == 0; });
}

}  // namespace hardball::viewer
