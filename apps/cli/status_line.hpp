// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace hardball::cli {

/// A line on the terminal that is rewritten in place.
class StatusLine {
 public:
  /// Shows nothing unless `wanted` and the standard error is a terminal.
  explicit StatusLine(bool wanted);
  /// Removes the line.
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;

  /// Whether the line should be brought up to date: ten times a second at most.
  bool is_due() const { return is_visible_ && Clock::now() >= next_; }
  /// Shows a bar for the share that is done, from 0 to 1, and a text behind it.
  void show(double done, const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  bool is_visible_;
  Clock::time_point next_ = Clock::now();
  std::size_t width_ = 0;  // of the line shown
};

}  // namespace hardball::cli
