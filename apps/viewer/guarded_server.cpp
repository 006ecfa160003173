// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/guarded_server.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "hardball/platform/sockets.hpp"

namespace hardball::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view kEndOfHead = "\r\n\r\n";
constexpr int kMostRequests = 1000;  // of one connection
constexpr std::chrono::seconds kIdle{1};

std::chrono::milliseconds until(Clock::time_point deadline) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
}

enum class Received { bytes, end, nothing };

// Appends what the client has sent before the deadline.
Received receive(socket_t socket, std::string& text, Clock::time_point deadline) {
  std::array<char, 4096> part{};
  if (!platform::can_read(socket, until(deadline))) return Received::nothing;
  const std::ptrdiff_t count = platform::receive(socket, part.data(), part.size());
  if (count <= 0) return count == 0 ? Received::end : Received::nothing;
  text.append(part.data(), static_cast<std::size_t>(count));
  return Received::bytes;
}

// A connection of which the beginning has been read.
class Connection final : public httplib::Stream {
 public:
  Connection(socket_t socket, std::string& read, std::chrono::milliseconds patience)
      : socket_(socket), read_(read), patience_(patience) {}

  bool is_readable() const override { return !read_.empty() || platform::can_read(socket_, patience_); }
  bool is_writable() const override { return platform::can_write(socket_, patience_); }
  ssize_t read(char* bytes, std::size_t most) override {
    if (read_.empty() && receive(socket_, read_, deadline()) != Received::bytes) return -1;
    const std::size_t count = std::min(most, read_.size());
    std::memcpy(bytes, read_.data(), count);
    read_.erase(0, count);
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* bytes, std::size_t count) override {
    return is_writable() ? platform::send(socket_, {bytes, count}) : -1;
  }
  void get_remote_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  void get_local_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  socket_t socket() const override { return socket_; }

 private:
  Clock::time_point deadline() const { return Clock::now() + patience_; }

  socket_t socket_;
  std::string& read_;
  std::chrono::milliseconds patience_;
};

}  // namespace

void GuardedServer::end_connections() {
  const std::lock_guard lock(mutex_);
  is_ending_ = true;
  for (const auto* sockets : {&strangers_, &trusted_}) {
    for (const socket_t socket : *sockets) platform::end_connection(socket);
  }
}

bool GuardedServer::process_and_close_socket(socket_t socket) {
  begin(socket);
  serve(socket);
  end(socket);
  return true;
}

void GuardedServer::serve(socket_t socket) {
  std::string text;
  for (int request = 1; request <= kMostRequests; ++request) {
    if (request > 1 && text.empty() && receive(socket, text, Clock::now() + kIdle) != Received::bytes) {
      return;
    }
    const Clock::time_point deadline = Clock::now() + limits_.patience;
    while (text.find(kEndOfHead) == std::string::npos) {
      if (text.size() > limits_.head_bytes) {
        return platform::send_at_once(
            socket, "HTTP/1.1 431 Request Header Fields Too Large\r\nConnection: close\r\n\r\n");
      }
      // Without an end the head is not valid, which the library says.
      const Received received = receive(socket, text, deadline);
      if (received == Received::nothing || (received == Received::end && text.empty())) return;
      if (received == Received::end) break;
    }
    if (may_view_(std::string_view(text).substr(0, text.find('\n')))) trust(socket);
    Connection connection(socket, text, limits_.patience);
    bool is_closed = false;
    if (!process_request(connection, request == kMostRequests, is_closed, nullptr) || is_closed) return;
  }
}

void GuardedServer::begin(socket_t socket) {
  const std::lock_guard lock(mutex_);
  if (is_ending_) platform::end_connection(socket);
  strangers_.push_back(socket);
  // Its thread closes the socket, and takes it out.
  if (strangers_.size() > limits_.strangers)
    platform::end_connection(strangers_[strangers_.size() - limits_.strangers - 1]);
}

void GuardedServer::trust(socket_t socket) {
  const std::lock_guard lock(mutex_);
  if (std::erase(strangers_, socket) > 0) trusted_.push_back(socket);
}

void GuardedServer::end(socket_t socket) {
  const std::lock_guard lock(mutex_);
  std::erase(strangers_, socket);
  std::erase(trusted_, socket);
  platform::end_connection(socket);
  platform::close_socket(socket);
}

}  // namespace hardball::viewer
