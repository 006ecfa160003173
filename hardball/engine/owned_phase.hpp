// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/memory/value_pointer.hpp"

namespace hardball {

/// The broad phase of a forecast, copied with it. What every event needs of it is found without a detour.
class OwnedPhase {
 public:
  explicit OwnedPhase(ValuePointer<BroadPhase> phase) : phase_(std::move(phase)) {}
  OwnedPhase(const OwnedPhase& other) : phase_(other.phase_) { find_lines(); }
  OwnedPhase(OwnedPhase&&) noexcept = default;
  OwnedPhase& operator=(OwnedPhase&&) noexcept = default;

  BroadPhase* operator->() { return &*phase_; }
  const BroadPhase* operator->() const { return &*phase_; }
  const BroadPhase& operator*() const { return *phase_; }

  SphereLine& line(Slot slot) { return lines_[slot]; }
  const SphereLine& line(Slot slot) const { return lines_[slot]; }
  /// To be called when lines may have moved: after `build` and `insert`.
  void find_lines() { lines_ = phase_->lines().data(); }

  /// Calls visit(phase), with neighbor lists as what they are: where they are used, events are so quick that
  /// virtual calls cost 2% of them, which inlined ones do not.
  template <class Visit>
  HARDBALL_ALWAYS_INLINE void visit(Visit&& visit) {
    if (phase_->kind() == PhaseKind::neighbors) return visit(static_cast<NeighborList&>(*phase_));
    visit(*phase_);
  }
  template <class Visit>
  HARDBALL_ALWAYS_INLINE void visit(Visit&& visit) const {
    if (phase_->kind() == PhaseKind::neighbors) return visit(static_cast<const NeighborList&>(*phase_));
    visit(*phase_);
  }

 private:
  ValuePointer<BroadPhase> phase_;
  SphereLine* lines_ = nullptr;
};

}  // namespace hardball
