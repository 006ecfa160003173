// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/distributed/blocks_in_first.hpp"

#include <string>

#include "hardball/processes/bytes.hpp"

namespace hardball {

std::optional<std::vector<Traveler>> BlocksInFirst::next() {
  if (taken_ == blocks_) return std::nullopt;
  const std::size_t block = taken_++;
  const std::size_t holder = block % processes_.size();
  if (holder == processes_.rank()) return own_[block / processes_.size()];
  const std::string nothing;
  const std::string bytes = processes_.exchange({&holder, 1}, {&nothing, 1}).front();
  std::vector<Traveler> spheres;
  append_bytes(bytes, spheres);
  return spheres;
}

void BlocksInFirst::complete() {
  if (processes_.is_first()) {
    while (next()) continue;
    return;
  }
  const std::size_t first = 0;
  for (const std::vector<Traveler>& block : own_) {
    const std::string bytes = bytes_of(block);
    processes_.exchange({&first, 1}, {&bytes, 1});
  }
}

}  // namespace hardball
