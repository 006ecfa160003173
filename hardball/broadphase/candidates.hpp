// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/events/event.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// The spheres that one sphere may meet next, collected by a broad phase so that contacts with all of them
/// are predicted together.
///
/// Either each candidate comes with its periodic image, or, where regions are small compared with the box,
/// the nearest image at the time of the query is meant: then a candidate is just a slot, may be repeated, and
/// may be the sphere itself, which it never meets. Arrays are padded to a whole vector with the sphere.
class Candidates {
 public:
  /// The widest vector that reads these arrays.
  static constexpr std::size_t kPadding = kWidestVector;

  /// `rounds` is the initial count of calls of start_round(), so that tests reach the overflow of the
  /// counter.
  explicit Candidates(std::uint32_t rounds = 0) : round_(rounds) {}

  /// Starts over for the sphere in `slot`; `nearest` says whether nearest images are meant.
  void begin(Slot slot, bool nearest) {
    self_ = slot;
    nearest_ = nearest;
    size_ = 0;
    listed_ = nullptr;
  }

  Slot self() const { return self_; }
  /// Whether the nearest image of each candidate is meant.
  bool uses_minimum_image() const { return nearest_; }
  std::size_t size() const { return size_; }
  Slot slot(std::size_t i) const { return slots()[i]; }
  /// Precondition: not uses_minimum_image().
  const Image& image(std::size_t i) const { return images_[i]; }

  const Slot* slots() const { return listed_ != nullptr ? listed_ : slots_.data(); }
  /// The displacements of the images along an axis [L]. Precondition: not uses_minimum_image().
  const double* shifts(std::size_t axis) const { return shifts_[axis].data(); }

  /// Makes the candidates those of a list elsewhere, whole vectors of slots, which must not change until
  /// begin().
  void refer_to(std::span<const Slot> listed) {
    listed_ = listed.data();
    size_ = listed.size();
  }

  /// Adds a candidate, meaning its nearest image.
  void add(Slot other) {
    make_room(1);
    slots_[size_++] = other;
  }

  /// Adds the first `count` slots of a cache line. Copies the whole line: its length is known at compile
  /// time, `count` is not.
  void add(const SlotLists::LineOfSlots& others, std::uint32_t count) {
    make_room(others.size());
    std::memcpy(slots_.data() + size_, others.data(), sizeof others);
    size_ += count;
  }

  /// Adds those of the first `count` slots of a cache line for which is_wanted(slot) holds. Branchless, as
  /// that is unpredictable.
  template <class Predicate>
  void add_if(const SlotLists::LineOfSlots& others, std::uint32_t count, Predicate&& is_wanted) {
    make_room(others.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      slots_[size_] = others[i];
      size_ += is_wanted(others[i]) ? 1U : 0U;
    }
  }

  /// Adds a candidate with its image.
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

  /// Removes all marks but that of the sphere itself, and makes room to mark `count` candidates.
  void start_round(std::size_t count) {
    constexpr std::size_t kMax = std::size_t{1} << 16;
    if (2 * count > seen_.size() && seen_.size() < kMax)
      seen_.resize(std::min(kMax, std::bit_ceil(4 * count)));
    if (++round_ == 0) {
      // The counter has wrapped around: old marks must not pass for new ones.
      std::fill(seen_.begin(), seen_.end(), 0);
      round_ = 1;
    }
    mark(self_);
  }

  /// Whether `other` is not marked since start_round(), or its mark has been overwritten.
  bool is_new(Slot other) const { return seen_[other & (seen_.size() - 1)] != key(other); }
  void mark(Slot other) { seen_[other & (seen_.size() - 1)] = key(other); }

  /// Removes the candidates i for which is_wanted(i) does not hold. Precondition: end() has been called.
  template <class Predicate>
  void keep_if(Predicate&& is_wanted) {
    std::size_t kept = 0;
    if (size_ > room_) {
      room_ = size_;
      slots_.resize(room_ + kPadding);
    }
    for (std::size_t i = 0; i < size_; ++i) {
      if (!is_wanted(i)) continue;
      slots_[kept] = slots()[i];
      if (!nearest_) {
        images_[kept] = images_[i];
        for (auto& shifts : shifts_) shifts[kept] = shifts[i];
      }
      ++kept;
    }
    listed_ = nullptr;
    size_ = kept;
    end();
  }

  /// Keeps only some of the candidates, which mean nearest images: keep(slots, count, kept) writes those
  /// wanted to `kept`, which may be `slots` and has room for a whole vector more, and returns their number.
  template <class Keep>
  void keep_slots(Keep&& keep) {
    if (size_ > room_) {
      room_ = size_;
      slots_.resize(room_ + kPadding);
    }
    size_ = keep(slots(), size_, slots_.data());
    listed_ = nullptr;
    end();
  }

  /// Fills the padding. Call before the arrays are read.
  void end() { std::fill_n(slots_.data() + size_, kPadding, self_); }

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
  std::size_t room_ = 56;         // for candidates, padding not counted
  const Slot* listed_ = nullptr;  // if the candidates are elsewhere
  std::vector<Slot> slots_ = std::vector<Slot>(room_ + kPadding);
  std::vector<Image> images_;
  std::array<std::vector<double>, kAxes> shifts_;
  // A direct-mapped cache of the candidates marked, its size a power of two; the round identifies outdated
  // marks.
  std::vector<std::uint64_t> seen_ = std::vector<std::uint64_t>(256);
};

}  // namespace hardball
