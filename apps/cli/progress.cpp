// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace hardball::cli {
namespace {

constexpr int kBarWidth = 24;

std::string readable_duration(double seconds) {
  if (!(seconds < 360000)) return "long";
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(bool wanted, double until)
    : visible_(wanted && isatty(STDERR_FILENO) == 1), until_(until) {}

Progress::~Progress() {
  if (width_ > 0) std::fprintf(stderr, "\r%*s\r", static_cast<int>(width_), "");
}

void Progress::show(const Simulation& simulation) {
  if (!visible_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  const double done = until_ > 0 ? std::clamp(simulation.time() / until_, 0.0, 1.0) : 1;
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double rate = static_cast<double>(simulation.counters().collision) / std::max(elapsed, 1e-9);
  const std::string bar(static_cast<std::size_t>(done * kBarWidth), '#');
  const std::string line =
      fmt::format("[{:<{}}] {:3.0f}%  t = {:.6g}  {:.3g} collisions/s  {} left", bar, kBarWidth, 100 * done,
                  simulation.time(), rate, readable_duration(elapsed * (1 - done) / done));
  fmt::print(stderr, "\r{:<{}}", line, width_);
  std::fflush(stderr);
  width_ = std::max(width_, line.size());
}

}  // namespace hardball::cli
