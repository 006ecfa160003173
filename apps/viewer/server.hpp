// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "apps/viewer/page.hpp"
#include "apps/viewer/shared_recording.hpp"

namespace httplib {
class Server;
struct Request;
struct Response;
}  // namespace httplib

namespace hardball::viewer {

/// Shows a recording to browsers on this machine, from threads of its own.
///
/// It listens at 127.0.0.1 alone and answers only those who know its token and call it by its own name. It
/// gives the page and the recording, nothing else, and changes nothing. docs/viewer.md says what is served.
class Server {
 public:
  /// Begins to serve at `port`, or at any that is free if it is zero. A client that reads nothing for longer
  /// than `patience` is given up. `recording` and what `page` refers to must outlive the server. Error: the
  /// port is taken.
  Server(const SharedRecording& recording, const Page& page, int port = 0,
         std::chrono::seconds patience = std::chrono::seconds(5));
  /// Ends every answer that is on its way, which takes no longer than `patience`.
  ~Server();
  Server(const Server&) = delete;

  int port() const { return port_; }
  const std::string& token() const { return token_; }
  /// The address to open in a browser; whoever has it may look.
  std::string url() const;

 private:
  void set_rules(std::chrono::seconds patience);
  void add_page();
  void add_recording();
  // Otherwise the response says why not.
  bool is_allowed(const httplib::Request& request, httplib::Response& response) const;

  const SharedRecording* recording_;
  Page page_;
  std::string token_;
  std::string index_;
  std::unique_ptr<httplib::Server> server_;
  int port_ = 0;
  std::thread thread_;
};

}  // namespace hardball::viewer
