// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>

#include "apps/viewer/http.hpp"

namespace hardball::viewer {

/// A thread for each connection of a server, for as long as the connection lasts: so a connection that sends
/// nothing delays no other.
class ConnectionThreads final : public httplib::TaskQueue {
 public:
  /// More than `most` connections wait until others end.
  explicit ConnectionThreads(std::size_t most) : most_(most) {}

  void enqueue(std::function<void()> serve) override;
  /// Waits until all connections have ended.
  void shutdown() override;

 private:
  std::size_t most_;
  std::size_t running_ = 0;
  std::mutex mutex_;
  std::condition_variable ended_;
};

}  // namespace hardball::viewer
