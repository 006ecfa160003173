// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/processors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>

#include "hardball/platform/processors.hpp"
#include "hardball/standard/number_text.hpp"

namespace hardball {
namespace {

// Of the container, or of the machine.
std::string quota() {
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  std::string text;
  std::getline(file, text);
  return text;
}

}  // namespace

// Numbers half of all processors apart often belong to one core: they fall to one thread.
std::vector<int> processors_of_thread(const std::vector<int>& available, std::size_t threads,
                                      std::size_t number) {
  std::vector<int> processors;
  for (std::size_t k = number; k < available.size(); k += threads) processors.push_back(available[k]);
  return processors;
}

std::size_t allowed_processors() {
  std::size_t all = platform::available_processors().size();
  if (all == 0) all = std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
  return processors_by_quota(quota(), all);
}

std::size_t free_processors() {
  const std::size_t all = allowed_processors();
  const std::size_t machine = std::max<std::size_t>(std::thread::hardware_concurrency(), all);
  const auto busy = static_cast<std::size_t>(std::lround(std::max(platform::load_average(), 0.0)));
  const std::size_t idle = machine - std::min(busy, machine - 1);
  return std::min(all, idle);
}

std::size_t processors_by_quota(std::string_view text, std::size_t processors) {
  std::uint64_t time = 0;
  std::uint64_t period = 0;
  const char* const end = text.data() + text.size();
  const auto [gap, problem] = from_chars(text.data(), end, time);
  if (problem != std::errc() || gap == end || *gap != ' ') return processors;
  if (from_chars(gap + 1, end, period).ec != std::errc() || period == 0) return processors;
  return std::clamp<std::size_t>(time / period, 1, processors);
}

}  // namespace hardball
