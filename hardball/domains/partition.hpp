// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/geometry/vec3.hpp"
#include "hardball/world/block.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// The number of a domain, from zero on.
using DomainNumber = std::uint32_t;

/// How the box is divided among domains: blocks that cover it and do not overlap.
class Partition {
 public:
  /// Equal parts along each axis, of the box, or along axes without ends of what the centers [L] take up.
  static Partition grid(const Box& box, const std::array<std::size_t, kAxes>& parts,
                        std::span<const Vec3> centers);
  /// Cuts the box into `count` blocks that hold about equally many of these centers [L]. Blocks are halved
  /// again and again, across the longest edge of what the centers take up. Precondition: `count` is not zero.
  /// Cost: O(n log(count)).
  static Partition bisection(const Box& box, std::size_t count, std::span<const Vec3> centers);

  std::size_t size() const { return blocks_.size(); }
  std::span<const Block> blocks() const { return blocks_; }
  const Block& block(DomainNumber domain) const { return blocks_[domain]; }
  /// The domain in whose block a point inside the box lies. Cost: O(log(size())).
  DomainNumber domain_at(const Vec3& point) const;
  /// The domains whose blocks come as near as `distance` [L] to that of one, in the order of numbers.
  /// Cost: O(size()).
  std::vector<DomainNumber> neighbors(DomainNumber domain, double distance) const;
  /// How many these are of the domain that has most. Cost: O(size()^2).
  std::size_t most_neighbors(double distance) const;

 private:
  // A cut across an axis, with what lies below it and from it on: another cut, or if negative the block
  // -1 - number.
  struct Cut {
    std::size_t axis = 0;
    double place = 0;  // [L]
    std::int32_t below = 0;
    std::int32_t above = 0;
  };

  static constexpr std::int32_t leaf(std::size_t block) { return -1 - static_cast<std::int32_t>(block); }

  template <class Part>
  std::int32_t divide(Block block, Part part);

  std::vector<Block> blocks_;
  std::vector<Cut> cuts_;  // the first divides the whole
};

}  // namespace hardball
