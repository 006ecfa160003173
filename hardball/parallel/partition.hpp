// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/geometry/vec3.hpp"
#include "hardball/parallel/block.hpp"
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
  /// So many blocks that hold about equally many of these centers [L]. They are cut in two again and again,
  /// across the longest edge of what the centers take up. Precondition: `count` is not zero. Cost:
  /// O(n log(count)).
  static Partition bisection(const Box& box, std::size_t count, std::span<const Vec3> centers);

  std::size_t size() const { return blocks_.size(); }
  const Block& block(DomainNumber domain) const { return blocks_[domain]; }
  /// The domain in whose block a point lies. Cost: O(size()).
  DomainNumber domain_at(const Vec3& point) const;
  /// The domains whose blocks come as near as `distance` [L] to that of one, in the order of numbers.
  std::vector<DomainNumber> neighbors(DomainNumber domain, double distance) const;

 private:
  std::vector<Block> blocks_;
};

}  // namespace hardball
