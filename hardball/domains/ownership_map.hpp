// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "hardball/domains/id_map.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// The neighbors of a domain among which something is true, a bit for each.
using NeighborSet = std::uint32_t;
inline constexpr std::size_t kMaxNeighbors = 31;

/// A bit for each slot: a million of them stay in a cache.
class SlotBits {
 public:
  bool operator[](Slot slot) const { return (words_[slot / kBits] >> (slot % kBits) & 1) != 0; }
  void set(Slot slot, bool value) {
    const std::uint64_t bit = std::uint64_t{1} << (slot % kBits);
    std::uint64_t& word = words_[slot / kBits];
    word = value ? word | bit : word & ~bit;
  }
  /// Makes room for this many bits, and perhaps more; new bits are not set.
  void grow_to(std::size_t slots) {
    if (words_.size() * kBits < slots) words_.resize((slots + kBits - 1) / kBits);
  }
  void reserve(std::size_t slots) { words_.reserve(slots / kBits + 1); }
  /// Calls visit(slot) for all bits that are set, and none is from then on. Cost: O(slots / 64), and the
  /// calls.
  template <class Visit>
  void take_all(Visit&& visit) {
    for (std::size_t k = 0; k < words_.size(); ++k) {
      for (std::uint64_t word = std::exchange(words_[k], 0); word != 0; word &= word - 1)
        visit(static_cast<Slot>(k * kBits + static_cast<std::size_t>(std::countr_zero(word))));
    }
  }
  std::size_t memory_bytes() const { return words_.capacity() * sizeof(std::uint64_t); }

 private:
  static constexpr std::size_t kBits = 64;
  std::vector<std::uint64_t> words_;
};

/// The role of each sphere that a domain holds: its own, or a ghost, which another domain owns.
class OwnershipMap {
 public:
  struct Ghost {
    SphereId sphere = 0;
    std::uint32_t owner = 0;  ///< The number of the neighbor.
    Slot slot = 0;            ///< Slot of the ghost.
  };

  bool is_own(Slot slot) const { return !is_shared(slot) || (roles_[slot] & kGhost) == 0; }
  /// The neighbors that hold an own sphere.
  NeighborSet holders(Slot slot) const { return is_shared(slot) ? roles_[slot] : 0; }
  void set_holders(Slot slot, NeighborSet holders) { set_role(slot, holders); }
  /// Whether a sphere concerns other domains, too.
  bool is_shared(Slot slot) const { return are_shared_[slot]; }
  /// Prefetches what a sphere is that concerns others. The slot need not be in use.
  void prefetch(Slot slot) const { hardball::prefetch(roles_.data() + slot); }
  /// The number of a ghost, which stays the same.
  std::uint32_t ghost_number(Slot slot) const { return roles_[slot] & ~kGhost; }
  /// The number of a ghost by the id of the sphere; IdMap::kNone if it is no ghost.
  std::uint32_t find_ghost(SphereId sphere) const { return numbers_.find(sphere); }
  void prefetch_ghost(std::uint32_t number) const { hardball::prefetch(&ghosts_[number]); }
  const Ghost& ghost(std::uint32_t number) const { return ghosts_[number]; }
  void set_owner(std::uint32_t number, std::uint32_t owner) { ghosts_[number].owner = owner; }
  std::size_t size() const { return roles_.size(); }
  std::size_t ghost_count() const { return numbers_.size(); }
  /// Ghosts have lower numbers.
  std::size_t ghost_numbers() const { return ghosts_.size(); }

  /// The state of a sphere has changed, or will.
  void note_change(Slot slot) { have_changed_.set(slot, true); }
  /// Calls visit(slot) for every own sphere of which a change was recorded since the last call.
  template <class Visit>
  void take_changes(Visit&& visit) {
    have_changed_.take_all([&](Slot slot) {
      if (slot < size() && is_own(slot)) visit(slot);
    });
  }

  /// Leaves room for this many and some more.
  void reserve(std::size_t count) {
    const std::size_t all = count + count / 16;
    roles_.reserve(all);
    are_shared_.reserve(all);
    have_changed_.reserve(all);
  }

  /// An own sphere is stored in slot size().
  void add_own(NeighborSet holders) {
    add_slot();
    set_role(static_cast<Slot>(size() - 1), holders);
  }
  /// A ghost is stored in slot size().
  void add_ghost(SphereId sphere, std::uint32_t owner) {
    add_slot();
    make_ghost(static_cast<Slot>(size() - 1), sphere, owner);
  }
  /// An own sphere is a ghost from now on.
  void make_ghost(Slot slot, SphereId sphere, std::uint32_t owner) {
    auto number = static_cast<std::uint32_t>(ghosts_.size());
    if (free_numbers_.empty()) {
      ghosts_.emplace_back();
    } else {
      number = free_numbers_.back();
      free_numbers_.pop_back();
    }
    ghosts_[number] = {sphere, owner, slot};
    numbers_.set(sphere, number);
    set_role(slot, number | kGhost);
  }
  /// A ghost is an own sphere from now on.
  void make_own(Slot slot, NeighborSet holders) {
    release(slot);
    set_role(slot, holders);
  }
  /// A sphere is gone; the one in the last slot takes its place.
  void erase(Slot slot) {
    if (!is_own(slot)) release(slot);
    const auto last = static_cast<Slot>(size() - 1);
    set_role(slot, roles_[last]);
    have_changed_.set(slot, have_changed_[last]);
    have_changed_.set(last, false);
    roles_.pop_back();
    if (slot < size() && !is_own(slot)) ghosts_[ghost_number(slot)].slot = slot;
  }

  std::size_t memory_bytes() const {
    return roles_.capacity() * sizeof(std::uint32_t) + are_shared_.memory_bytes() +
           have_changed_.memory_bytes() + ghosts_.capacity() * sizeof(Ghost) +
           free_numbers_.capacity() * sizeof(std::uint32_t) + numbers_.memory_bytes();
  }

 private:
  static constexpr std::uint32_t kGhost = 1U << kMaxNeighbors;

  void add_slot() {
    roles_.push_back(0);
    are_shared_.grow_to(size());
    have_changed_.grow_to(size());
  }
  void set_role(Slot slot, std::uint32_t role) {
    are_shared_.set(slot, role != 0);
    roles_[slot] = role;
  }

  void release(Slot slot) {
    HARDBALL_CHECK(!is_own(slot));
    numbers_.erase(ghosts_[ghost_number(slot)].sphere);
    free_numbers_.push_back(ghost_number(slot));
  }

  LargeVector<std::uint32_t> roles_;  // by slot: holders, or the number of the ghost with its mark
  SlotBits are_shared_;               // whether the role is not zero: most spheres concern no other domain
  SlotBits have_changed_;
  std::vector<Ghost> ghosts_;
  std::vector<std::uint32_t> free_numbers_;
  IdMap numbers_;
};

}  // namespace hardball
