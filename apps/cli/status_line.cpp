// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/status_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "hardball/platform/program.hpp"

namespace hardball::cli {

StatusLine::StatusLine(bool wanted) : is_visible_(wanted && platform::shows_messages()) {}

StatusLine::~StatusLine() {
  if (width_ == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(width_), "");
  std::fflush(stderr);
}

void StatusLine::show(double done, const std::string& text) {
  constexpr int kBarWidth = 24;
  next_ = Clock::now() + std::chrono::milliseconds(100);
  const std::string bar(static_cast<std::size_t>(done * kBarWidth), '#');
  const std::string line = fmt::format("[{:<{}}] {:3.0f}%  {}", bar, kBarWidth, 100 * done, text);
  fmt::print(stderr, "\r{:<{}}", line, width_);
  std::fflush(stderr);
  width_ = std::max(width_, line.size());
}

}  // namespace hardball::cli
