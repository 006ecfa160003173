// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <thread>

#include "apps/viewer/client_limits.hpp"
#include "apps/viewer/page.hpp"
#include "apps/viewer/shared_recording.hpp"
#include "hardball/platform/sockets.hpp"

namespace httplib {
struct Request;
struct Response;
}  // namespace httplib

namespace hardball::viewer {

class Film;
class GuardedServer;

/// Serves a recording to browsers on this machine, from its own threads.
///
/// It listens at 127.0.0.1 alone and answers only requests that carry its token and its own name. It serves
/// the page and the recording, nothing else, and changes nothing but the film, if there is one.
/// docs/viewer.md describes the protocol.
class Server {
 public:
  /// Starts serving at `port`, or at any free one if it is zero, within these limits. `film` is to be made by
  /// the page, if it is not null. It, `recording` and what `page` refers to must outlive the server. Error:
  /// the port is taken.
  Server(const SharedRecording& recording, const Page& page, int port = 0, const ClientLimits& limits = {},
         Film* film = nullptr);
  /// Ends all connections.
  ~Server();
  Server(const Server&) = delete;

  int port() const { return port_; }
  const std::string& token() const { return token_; }
  /// The address to open in a browser; anyone who has it can view.
  std::string url() const;

 private:
  void set_rules();
  void add_page();
  void add_recording();
  void add_film();
  // If false, the response says why.
  bool is_allowed(const httplib::Request& request, httplib::Response& response) const;

  const SharedRecording* recording_;
  Film* film_;
  Page page_;
  std::string token_;
  std::string index_;
  std::unique_ptr<GuardedServer> server_;
  platform::Socket socket_ = 0;  // at which it listens
  int port_ = 0;
  std::thread thread_;
};

}  // namespace hardball::viewer
