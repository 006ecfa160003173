// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <string_view>
#include <utility>

#include "apps/viewer/client_limits.hpp"
#include "apps/viewer/http.hpp"

namespace hardball::viewer {

/// An HTTP server that no client can hold up: it reads the head of a request before it hands it on.
///
/// A head that takes too long, or is too long, ends its connection. Of the clients that have not shown that
/// they may view, the one that came first gives way to the next.
class GuardedServer final : public httplib::Server {
 public:
  /// `may_view` decides from the first line of a request whether its client may view.
  GuardedServer(const ClientLimits& limits, std::function<bool(std::string_view line)> may_view)
      : limits_(limits), may_view_(std::move(may_view)) {}

  /// Ends all connections, and those to come.
  void end_connections();

 private:
  bool process_and_close_socket(socket_t socket) override;
  void serve(socket_t socket);
  void begin(socket_t socket);
  void trust(socket_t socket);
  void end(socket_t socket);

  ClientLimits limits_;
  std::function<bool(std::string_view line)> may_view_;
  std::mutex mutex_;
  std::deque<socket_t> strangers_;  // in the order in which they came
  std::deque<socket_t> trusted_;
  bool is_ending_ = false;
};

}  // namespace hardball::viewer
