// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/interaction/step_potential.hpp"

namespace hardball {

/// A partner of a sphere that is inside of a step of their potential.
struct PairLevel {
  Slot partner = 0;
  StepTable::Number potential = StepTable::kNone;
  StepPotential::Level level = 0;  ///< How many steps the pair is inside of.

  friend bool operator==(const PairLevel&, const PairLevel&) = default;
  static void persist(auto& archive, auto& self) { archive(self.partner, self.potential, self.level); }
};

/// The levels of the pairs of spheres that are inside of a step of their potential, each kept with both
/// spheres. Bonds are pairs that never leave their potential.
///
/// Cost of looking up a pair: O(pairs of a sphere), which are few; their order says nothing.
class PairLevels {
 public:
  /// The pairs of a sphere.
  std::span<const PairLevel> of(Slot slot) const {
    if (slot >= pairs_.size()) return {};
    return pairs_[slot];
  }
  /// The pair of two spheres; nullptr if it is inside of no step.
  const PairLevel* find(Slot a, Slot b) const;
  /// Sets the level of a pair; at level zero it is forgotten.
  void set(Slot a, Slot b, StepTable::Number potential, StepPotential::Level level);

  /// How many pairs there are. Cost: O(n).
  std::size_t size() const;
  /// All pairs, each once, with the lower slot, in the order of slots. Cost: O(pairs log pairs).
  std::vector<std::pair<Slot, PairLevel>> in_order() const;

  /// A sphere without pairs is no more, and the one in the `last` slot takes its place.
  void take_place(Slot slot, Slot last);
  /// Undoes take_place.
  void give_back(Slot slot, Slot last);
  /// Moves the sphere of slot order[k] to slot k.
  void reorder(std::span<const Slot> order);

  std::size_t memory_bytes() const;

 private:
  void set_one(Slot slot, const PairLevel& pair);
  void rename(Slot from, Slot to);

  std::vector<std::vector<PairLevel>> pairs_;  // by slot; as many as have been needed
};

}  // namespace hardball
