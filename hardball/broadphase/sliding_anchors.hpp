// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/broadphase/anchor.hpp"
#include "hardball/broadphase/sliding_rows.hpp"
#include "hardball/geometry/inlining.hpp"

namespace hardball {

/// How the anchors of neighbor lists move in a sheared box: each with the row of cells in which it was made.
///
/// Anchors in one row keep their distances. Those in adjacent rows slide past each other, so lists are made
/// for the middle of a certain time, and expire after it.
class SlidingAnchors {
 public:
  SlidingAnchors() = default;
  /// Anchors in `rows` rows from `now` on; lists expire when adjacent ones have slid past each other by
  /// `slide` [L].
  SlidingAnchors(const Box& box, std::int32_t rows, double slide, const Time& now)
      : rows_(box, rows, now), start_(now) {
    const double speed = rows_.speed_of_step();
    if (speed > 0) duration_ = slide / speed;
    time_of_tick_ = kCutShort * duration_ / (kTicksOfList + 1);
    ticks_per_time_ = 1 / time_of_tick_;
  }

  bool are_present() const { return rows_.are_present(); }
  /// Makes what follows cheap at moments near this one.
  void keep_near(const Time& now) { rows_.keep_near_and_small(now); }

  /// Whether lists expire.
  bool expire() const { return duration_ < kNever.high; }
  /// The expiry of a list made at `now`, as an Anchor has it.
  std::uint32_t expiry_of_new(const Time& now) const { return expire() ? ticks_at(now) + kTicksOfList : 0; }
  /// When the list of an anchor expires.
  double expiry(const Anchor& anchor, const Time& now) const {
    return expire() ? rounded_down(now) + std::max(ticks_left(anchor, now), 0) * time_of_tick_ : kNever.high;
  }
  bool is_expired(const Anchor& anchor, const Time& now) const {
    return expire() && ticks_left(anchor, now) < 0;
  }

  /// The coordinate along x of a point of a box in the row of an anchor [L].
  double in_row(const Anchor& anchor, double x, const Time& now) const {
    return x - rows_.displacement(anchor.cell[1], now);
  }

  /// The row with which an anchor moves, relative to a compact copy, which is of the image in the box.
  struct Row {
    std::int32_t displacement;  ///< Along x, on the grid of CompactPaths.
    double speed;               ///< [L/T]
  };
  HARDBALL_ALWAYS_INLINE Row row_of(const Anchor& anchor, const CompactPath& copy, const Time& now,
                                    const CompactPaths& copies) const {
    Row row{copies.steps_along_x(rows_.displacement(anchor.cell[1], now)), rows_.speed(anchor.cell[1])};
    // The anchor may be that of an image above or below.
    const std::int64_t above = std::int64_t{static_cast<std::uint32_t>(copy.position[1])} -
                               static_cast<std::uint32_t>(anchor.position[1]);
    const auto layer = static_cast<std::int32_t>((above + (std::int64_t{1} << 31)) >> 32);
    if (layer == 0) [[likely]]
      return row;
    const std::int32_t slide = copies.slide_at(now);
    row.displacement = sum_on_grid(row.displacement, layer > 0 ? slide : difference_on_grid(0, slide));
    row.speed += layer * copies.slide_speed();
    return row;
  }

  /// By how much a row is displaced along x against the one below when a list that is made now is half as old
  /// as it will get, but for whole boxes [L].
  double step_of_list(const Time& now) const {
    return rows_.step(expire() ? after(now, duration_ / 2) : now);
  }
  /// Prepares for lists of which only the present counts.
  void look_at_the_present() { duration_ = 0; }

 private:
  // The duration of a list in ticks, the last of which may be cut short.
  static constexpr std::uint32_t kTicksOfList = 1U << 20;
  static constexpr double kCutShort = 1 - 1e-6;

  std::uint32_t ticks_at(const Time& moment) const {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(duration(start_, moment) * ticks_per_time_));
  }
  std::int32_t ticks_left(const Anchor& anchor, const Time& now) const {
    return static_cast<std::int32_t>(anchor.expiry - ticks_at(now));
  }

  SlidingRows rows_;
  Time start_;
  double duration_ = kNever.high;  // of lists [T]
  double ticks_per_time_ = 0;
  double time_of_tick_ = 0;
};

}  // namespace hardball
