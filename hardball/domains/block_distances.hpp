// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "hardball/geometry/vec3.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/block.hpp"

namespace hardball {

/// How far a point is outside each of some blocks, found for several at once; see Block::distance.
class BlockDistances {
 public:
  static constexpr std::size_t kMaxBlocks = 32;
  /// By block [L]; those beyond the last block have no meaning.
  using Distances = std::array<double, kMaxBlocks>;

  BlockDistances() = default;
  /// Precondition: there are no more than kMaxBlocks.
  explicit BlockDistances(std::span<const Block> blocks) {
    // Whole vectors are worked on.
    constexpr std::size_t kStep = 4;
    count_ = (blocks.size() + kStep - 1) / kStep * kStep;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (ranges::none_of(blocks, [axis](const Block& block) { return block.is_divided(axis); })) continue;
      Interval& interval = intervals_.emplace_back();
      interval.axis = axis;
      interval.low.assign(count_, -kInfinity);
      interval.high.assign(count_, kInfinity);
      for (std::size_t k = 0; k < blocks.size(); ++k) {
        interval.period = blocks[k].period(axis);
        if (!blocks[k].is_divided(axis)) continue;
        interval.low[k] = blocks[k].low(axis);
        interval.high[k] = blocks[k].high(axis);
      }
    }
  }

  /// Precondition: as of Block::distance. Cost: O(blocks).
  void find(const Vec3& point, Distances& distances) const {
    std::fill_n(distances.begin(), count_, -kInfinity);
    for (const Interval& interval : intervals_) {
      const double* const low = interval.low.data();
      const double* const high = interval.high.data();
      const double x = point[interval.axis];
      const double period = interval.period;
      for (std::size_t k = 0; k < count_; ++k) {
        double outside = std::max(low[k] - x, x - high[k]);
        // An image may be nearer.
        outside = std::min(outside, std::max(low[k] - (x - period), (x - period) - high[k]));
        outside = std::min(outside, std::max(low[k] - (x + period), (x + period) - high[k]));
        distances[k] = std::max(distances[k], outside);
      }
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  // Of all blocks along an axis that some divide; along others it is infinite.
  struct Interval {
    std::size_t axis = 0;
    double period = 0;
    std::vector<double> low;
    std::vector<double> high;
  };

  std::size_t count_ = 0;
  std::vector<Interval> intervals_;
};

}  // namespace hardball
