// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/layout.hpp"

#include <utility>

#include "hardball/domains/ownership_map.hpp"
#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr std::uint64_t kWindowsPerReview = 64;
// Of halos, in diameters.
constexpr double kDeepeningStep = 0.25;
constexpr double kDeepest = 4;

}  // namespace

void Layout::lay_out(const Box& box, const SystemSize& size, std::span<const Vec3> centers) {
  for (std::size_t each = division_.domains; each > 0; each /= 2) {
    if (take(division_, Partition::bisection(box, each * processes_, centers), size)) return;
  }
  throw Error("the system is too small to be divided among " + to_text(processes_) + " processes",
              "processes", "use fewer");
}

bool Layout::is_review_due(std::uint64_t windows) {
  if (windows < next_review_ || partition_.size() == 1) return false;
  next_review_ = windows + kWindowsPerReview;
  return true;
}

bool Layout::may_improve(const Load& load, std::uint64_t spheres) const {
  return may_deepen(load) || load.is_uneven(spheres);
}

bool Layout::improve(const Load& load, const Box& box, const SystemSize& size,
                     std::span<const Vec3> centers) {
  const Partition even =
      Partition::bisection(box, partition_.size(), centers_by_load(centers, partition_, load));
  if (may_deepen(load)) {
    Division deeper = division_;
    deeper.halo += kDeepeningStep;
    if (take(deeper, even, size)) return true;
  }
  return load.is_uneven(size.spheres) && take(division_, even, size);
}

bool Layout::may_deepen(const Load& load) const {
  return load.has_shallow_halos() && division_.halo + kDeepeningStep <= kDeepest;
}

bool Layout::take(const Division& division, Partition partition, const SystemSize& size) {
  const Halo halo = size.halo(division);
  if (partition.most_neighbors(halo.neighborhood()) > kMaxNeighbors) return false;
  division_ = division;
  windows_ = size.windows(division, partition.size());
  partition_ = std::move(partition);
  halo_ = halo;
  next_review_ = kWindowsPerReview;
  return true;
}

}  // namespace hardball
