// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hardball/kernels/instruction_set.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The spheres that are inside of a step of a potential with one sphere, and the distances of their next
/// steps, as kernels read them: padded to a whole vector.
class StepCandidates {
 public:
  /// Those of the sphere in `slot`.
  void collect(const World& world, Slot slot) {
    const std::span<const PairLevel> pairs = world.pair_levels().of(slot);
    size_ = pairs.size();
    if (slots_.size() < size_ + kWidestVector) {
      slots_.resize(2 * size_ + kWidestVector);
      inner_.resize(slots_.size());
      outer_.resize(slots_.size());
    }
    const StepTable& steps = world.interactions().steps();
    const double radius = world.base_radius(slot);
    for (std::size_t i = 0; i < size_; ++i) {
      const PairLevel& pair = pairs[i];
      const StepPotential& potential = steps[pair.potential];
      const double radii = radius + world.base_radius(pair.partner);
      slots_[i] = pair.partner;
      inner_[i] = potential.inner_ratio(pair.level) * radii;
      outer_[i] = potential.outer_ratio(pair.level) * radii;
    }
    std::fill_n(slots_.begin() + static_cast<std::ptrdiff_t>(size_), kWidestVector, slot);
  }

  std::size_t size() const { return size_; }
  const Slot* slots() const { return slots_.data(); }
  const double* inner() const { return inner_.data(); }  ///< [L]
  const double* outer() const { return outer_.data(); }  ///< [L]

 private:
  std::size_t size_ = 0;
  std::vector<Slot> slots_;
  std::vector<double> inner_;
  std::vector<double> outer_;
};

}  // namespace hardball
