// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hardball/domains/division.hpp"
#include "hardball/domains/halo.hpp"
#include "hardball/domains/load.hpp"
#include "hardball/domains/partition.hpp"
#include "hardball/domains/system_size.hpp"
#include "hardball/domains/window_settings.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// Where the domains of a system are, what they hold around their blocks, and how long windows are; and when
/// another layout would pay. All decisions follow from counts and positions, so that all processes that share
/// a system decide alike.
class Layout {
 public:
  /// A layout of the domains of a division in each of `processes` processes. Precondition: neither number is
  /// zero.
  explicit Layout(const Division& division, std::size_t processes = 1)
      : division_(division), processes_(processes) {}

  const Partition& partition() const { return partition_; }
  const Halo& halo() const { return halo_; }
  const WindowSettings& windows() const { return windows_; }

  /// Lays a system out, whose spheres have these centers or a fair sample of them [L]: in half as many
  /// domains, again and again, as long as one would have more neighbors than kMaxNeighbors. Error: even one
  /// domain in each process would be too many. Cost: O(n log(domains)).
  void lay_out(const Box& box, const SystemSize& size, std::span<const Vec3> centers);

  /// Whether it is time to review the load, this many windows after the last layout.
  bool is_review_due(std::uint64_t windows);
  /// Whether another layout would pay, with this load and this number of spheres.
  bool may_improve(const Load& load, std::uint64_t spheres) const;
  /// Lays the system out by load: blocks with as many contacts each, and deeper halos if many windows fail.
  /// Returns false, and changes nothing, if a domain would have more neighbors than kMaxNeighbors.
  /// Precondition: as for lay_out; may_improve(). Cost: the same.
  bool improve(const Load& load, const Box& box, const SystemSize& size, std::span<const Vec3> centers);

 private:
  bool may_deepen(const Load& load) const;
  // Takes it if no domain has too many neighbors.
  bool take(const Division& division, Partition partition, const SystemSize& size);

  Division division_;
  std::size_t processes_;
  Partition partition_;
  Halo halo_;
  WindowSettings windows_;
  std::uint64_t next_review_ = 0;  // in windows since the last layout
};

}  // namespace hardball
