// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/distributed/blocks_in_first.hpp"

#include <cstring>
#include <string>

namespace hardball {

std::optional<std::vector<Traveler>> BlocksInFirst::next() {
  if (taken_ == blocks_) return std::nullopt;
  const std::size_t block = taken_++;
  const std::size_t holder = block % processes_.size();
  if (holder == processes_.rank()) return own_[block / processes_.size()];
  const std::string nothing;
  const std::string bytes = processes_.exchange({&holder, 1}, {&nothing, 1}).front();
  std::vector<Traveler> spheres(bytes.size() / sizeof(Traveler));
  if (!bytes.empty()) std::memcpy(spheres.data(), bytes.data(), bytes.size());
  return spheres;
}

void BlocksInFirst::complete() {
  if (processes_.is_first()) {
    while (next()) continue;
    return;
  }
  const std::size_t first = 0;
  for (const std::vector<Traveler>& block : own_) {
    const std::string bytes(reinterpret_cast<const char*>(block.data()), block.size() * sizeof(Traveler));
    processes_.exchange({&first, 1}, {&bytes, 1});
  }
}

}  // namespace hardball
