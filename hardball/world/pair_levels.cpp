// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/pair_levels.hpp"

#include <algorithm>
#include <utility>

#include "hardball/standard/ranges.hpp"

namespace hardball {

const PairLevel* PairLevels::find(Slot a, Slot b) const {
  for (const PairLevel& pair : of(a)) {
    if (pair.partner == b) return &pair;
  }
  return nullptr;
}

void PairLevels::set(Slot a, Slot b, StepTable::Number potential, StepPotential::Level level) {
  set_one(a, {b, potential, level});
  set_one(b, {a, potential, level});
}

void PairLevels::set_one(Slot slot, const PairLevel& pair) {
  if (slot >= pairs_.size()) {
    if (pair.level == 0) return;
    pairs_.resize(slot + std::size_t{1});
  }
  std::vector<PairLevel>& pairs = pairs_[slot];
  const auto found = ranges::find(pairs, pair.partner, &PairLevel::partner);
  if (pair.level > 0) {
    if (found == pairs.end()) {
      pairs.push_back(pair);
    } else {
      *found = pair;
    }
  } else if (found != pairs.end()) {
    *found = pairs.back();
    pairs.pop_back();
  }
}

std::size_t PairLevels::size() const {
  std::size_t ends = 0;
  for (const auto& pairs : pairs_) ends += pairs.size();
  return ends / 2;
}

std::vector<std::pair<Slot, PairLevel>> PairLevels::in_order() const {
  std::vector<std::pair<Slot, PairLevel>> all;
  for (std::size_t slot = 0; slot < pairs_.size(); ++slot) {
    const auto begin = static_cast<std::ptrdiff_t>(all.size());
    for (const PairLevel& pair : pairs_[slot]) {
      if (slot < pair.partner) all.emplace_back(static_cast<Slot>(slot), pair);
    }
    std::sort(all.begin() + begin, all.end(),
              [](const auto& a, const auto& b) { return a.second.partner < b.second.partner; });
  }
  return all;
}

void PairLevels::rename(Slot from, Slot to) {
  for (const PairLevel& pair : of(from)) {
    const auto found = ranges::find(pairs_[pair.partner], from, &PairLevel::partner);
    found->partner = to;
  }
}

void PairLevels::take_place(Slot slot, Slot last) {
  if (slot == last || last >= pairs_.size()) return;
  rename(last, slot);
  std::swap(pairs_[slot], pairs_[last]);
}

void PairLevels::give_back(Slot slot, Slot last) {
  if (slot == last || slot >= pairs_.size()) return;
  if (last >= pairs_.size()) pairs_.resize(last + std::size_t{1});
  rename(slot, last);
  std::swap(pairs_[slot], pairs_[last]);
}

void PairLevels::reorder(std::span<const Slot> order) {
  if (pairs_.empty()) return;
  pairs_.resize(order.size());
  std::vector<Slot> now_in(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) now_in[order[k]] = static_cast<Slot>(k);
  std::vector<std::vector<PairLevel>> moved(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    moved[k] = std::move(pairs_[order[k]]);
    for (PairLevel& pair : moved[k]) pair.partner = now_in[pair.partner];
  }
  pairs_ = std::move(moved);
}

std::size_t PairLevels::memory_bytes() const {
  std::size_t bytes = pairs_.capacity() * sizeof(pairs_[0]);
  for (const auto& pairs : pairs_) bytes += pairs.capacity() * sizeof(PairLevel);
  return bytes;
}

}  // namespace hardball
