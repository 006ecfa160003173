// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The spheres that are inside of a step of a potential with one sphere, and the distances of their next
/// steps, as kernels read them: padded to a whole vector.
class StepCandidates {
 public:
  /// Collects the candidates of the sphere in `slot`, without distances.
  void collect(const World& world, Slot slot) {
    pairs_ = world.pair_levels().of(slot);
    if (slots_.size() < size() + kWidestVector) {
      const std::size_t room = 2 * size() + kWidestVector;
      slots_.resize(room);
      inner_.resize(room);
      outer_.resize(room);
      inner_for_bounds_.resize(room);
      outer_for_bounds_.resize(room);
    }
    for (std::size_t i = 0; i < size(); ++i) slots_[i] = pairs_[i].partner;
    std::fill_n(slots_.begin() + static_cast<std::ptrdiff_t>(size()), kWidestVector, slot);
    self_ = slot;
  }

  /// Finds the distances. Precondition: no level has changed since collect().
  void find_distances(const World& world) {
    for_each_pair(world, [this](std::size_t i, double inner, double outer) {
      inner_[i] = inner;
      outer_[i] = outer;
    });
  }

  /// Finds these distances for bounds: inwards rounded up, outwards rounded down.
  void find_distances_for_bounds(const World& world, const CompactPaths& copies) {
    constexpr double kRounding = 0x1p-22;
    const double up = (1 + kRounding) / copies.length_unit();
    const double down = (1 - kRounding) / copies.length_unit();
    for_each_pair(world, [&](std::size_t i, double inner, double outer) {
      inner_for_bounds_[i] = static_cast<float>(inner * up);
      outer_for_bounds_[i] = static_cast<float>(outer * down);
    });
  }

  Slot self() const { return self_; }
  std::size_t size() const { return pairs_.size(); }
  std::span<const PairLevel> pairs() const { return pairs_; }
  const Slot* slots() const { return slots_.data(); }
  const double* inner() const { return inner_.data(); }  ///< [L]
  const double* outer() const { return outer_.data(); }  ///< [L]
  const float* inner_for_bounds() const { return inner_for_bounds_.data(); }
  const float* outer_for_bounds() const { return outer_for_bounds_.data(); }

 private:
  template <class Visit>
  void for_each_pair(const World& world, Visit&& visit) const {
    const StepTable& steps = world.interactions().steps();
    const double radius = world.base_radius(self_);
    for (std::size_t i = 0; i < size(); ++i) {
      const PairLevel& pair = pairs_[i];
      const StepPotential& potential = steps[pair.potential];
      const double radii = radius + world.base_radius(pair.partner);
      visit(i, potential.inner_ratio(pair.level) * radii, potential.outer_ratio(pair.level) * radii);
    }
  }

  Slot self_ = 0;
  std::span<const PairLevel> pairs_;
  std::vector<Slot> slots_;
  std::vector<double> inner_, outer_;
  std::vector<float> inner_for_bounds_, outer_for_bounds_;  // in units of the compact paths
};

}  // namespace hardball
