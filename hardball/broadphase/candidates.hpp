// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/events/event.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// The spheres that one sphere may meet next, collected by a broad phase to be looked at all together.
///
/// Either each candidate comes with the periodic copy that is meant, or, where regions are small against the
/// box, the copy meant is the one that is nearest at the moment of asking: then a candidate is a slot alone.
/// Arrays end in room for a whole vector, filled with the sphere itself, which it never meets.
class Candidates {
 public:
  /// The widest vector that reads these arrays.
  static constexpr std::size_t kPadding = kWidestVector;

  /// `rounds` is how many calls of begin() there have been, so to speak: long runs come to the end of
  /// counting.
  explicit Candidates(std::uint32_t rounds = 0) : round_(rounds) {}

  /// Begins anew for the sphere in `slot`; `nearest` says whether copies are the nearest ones.
  void begin(Slot slot, bool nearest) {
    self_ = slot;
    nearest_ = nearest;
    size_ = 0;
    if (++round_ == 0) {
      // Counting begins again: no mark of the rounds before may be taken for one of those to come.
      std::fill(seen_.begin(), seen_.end(), 0);
      round_ = 1;
    }
    mark(slot);
  }

  Slot self() const { return self_; }
  /// Whether the copy of each candidate is the nearest one.
  bool are_nearest() const { return nearest_; }
  std::size_t size() const { return size_; }
  Slot slot(std::size_t i) const { return slots_[i]; }
  /// Precondition: not are_nearest().
  const Image& image(std::size_t i) const { return images_[i]; }

  const Slot* slots() const { return slots_.data(); }
  /// The displacements of the copies along an axis [L]. Precondition: not are_nearest().
  const double* shifts(std::size_t axis) const { return shifts_[axis].data(); }

  /// Adds a candidate whose copy is the nearest.
  void add(Slot other) {
    make_room(1);
    slots_[size_++] = other;
  }

  /// Adds the first `count` of a line of slots. Copies the line whole: its length is known, `count` is not.
  void add(const SlotLists::LineOfSlots& others, std::uint32_t count) {
    make_room(others.size());
    std::memcpy(slots_.data() + size_, others.data(), sizeof others);
    size_ += count;
  }

  /// Takes out candidates that have been added before, and the sphere itself. A few are left twice, which
  /// does no harm; none is lost. To be called once, when all have been added.
  void drop_repeated() {
    expect(size_);
    const std::size_t places = seen_.size() - 1;
    std::uint64_t* const seen = seen_.data();
    const std::uint64_t round = std::uint64_t{round_} << 32;
    Slot* const slots = slots_.data();
    Slot* end = slots;
    const auto look_at = [&](Slot other) {
      // Without a branch: whether a candidate is new cannot be foreseen.
      std::uint64_t& place = seen[other & places];
      *end = other;
      end += place != (round | other) ? 1 : 0;
      place = round | other;
    };
    // Two at a time: behind the last stands its repetition.
    const std::size_t size = size_;
    if (size == 0) return;
    slots[size] = slots[size - 1];
    for (std::size_t i = 0; i < size; i += 2) {
      look_at(slots[i]);
      look_at(slots[i + 1]);
    }
    size_ = static_cast<std::size_t>(end - slots);
  }

  /// Adds the copy `image` of a candidate.
  void add(Slot other, const Image& image, const Box& box) {
    make_room(1);
    if (images_.size() < slots_.size()) {
      images_.resize(slots_.size());
      for (auto& shifts : shifts_) shifts.resize(slots_.size());
    }
    const Vec3 shift = box.shift(image);
    for (std::size_t axis = 0; axis < kAxes; ++axis) shifts_[axis][size_] = shift[axis];
    images_[size_] = image;
    slots_[size_++] = other;
  }

  /// Makes room to tell apart so many. To be called before any but the sphere itself is marked.
  void expect(std::size_t count) {
    constexpr std::size_t kMost = std::size_t{1} << 16;
    if (2 * count <= seen_.size() || seen_.size() == kMost) return;
    seen_.resize(std::min(kMost, std::bit_ceil(4 * count)));
    mark(self_);
  }

  /// Whether `other` has not lately been marked since begin().
  bool is_new(Slot other) const { return seen_[other & (seen_.size() - 1)] != key(other); }
  void mark(Slot other) { seen_[other & (seen_.size() - 1)] = key(other); }

  /// Fills the room behind the last candidate. To be called before the arrays are read.
  void end() {
    for (std::size_t i = 0; i < kPadding; ++i) slots_[size_ + i] = self_;
  }

 private:
  std::uint64_t key(Slot other) const { return std::uint64_t{round_} << 32 | other; }

  void make_room(std::size_t count) {
    if (size_ + count <= room_) [[likely]]
      return;
    room_ = 2 * room_ + count;
    slots_.resize(room_ + kPadding);
  }

  Slot self_ = 0;
  bool nearest_ = true;
  std::size_t size_ = 0;
  std::uint32_t round_;
  std::size_t room_ = 56;  // for candidates; behind them is room for padding
  std::vector<Slot> slots_ = std::vector<Slot>(room_ + kPadding);
  std::vector<Image> images_;
  std::array<std::vector<double>, kAxes> shifts_;
  // A cache of the candidates marked, one place for each remainder, a power of two of them; the round tells
  // those of earlier calls.
  std::vector<std::uint64_t> seen_ = std::vector<std::uint64_t>(256);
};

}  // namespace hardball
