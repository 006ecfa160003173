// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The spheres of a world at one moment, sorted by cells, in single precision: which of them a body may touch
/// on its way is decided several at a time, without computing contact times.
///
/// Few spheres are much faster or larger than most. Those are kept apart, so that the others are far from
/// what they will not touch soon. Where cells lie depends on where the spheres are, and not on the engine.
class HARDBALL_EXPORT MovingSpheres {
 public:
  /// Speeds and radii of most spheres, over the root mean square of all.
  static constexpr double kUsual = 2.5;

  /// The spheres at `now`, which do not grow, in a box that is not sheared. Cost: O(n).
  MovingSpheres(const World& world, const Time& now);

  /// No sphere is faster [L/T].
  double fastest() const { return fastest_; }
  /// Slots of the spheres that are faster or larger than most.
  std::span<const Slot> unusual() const { return unusual_; }
  /// How far the others move at most in a time [L/T].
  double usual_speed() const { return usual_speed_; }
  /// The edge of a cell [L].
  double cell_edge() const { return cell_edge_; }
  /// No sphere is farther from another along an axis [L].
  double extent() const { return 2 * length_unit_; }

  /// Calls visit(slot) for the usual spheres of which an image may touch a body between `begin` and `end`
  /// after the moment [T], and for some others, perhaps more than once. The body begins at `from`, in the
  /// box, and moves as spheres do; its radius is `radius` [L].
  void for_each_near(const State& from, double radius, double begin, double end,
                     const Function<void(Slot)>& visit) const;

 private:
  struct Axis {
    double low = 0;     // of the first cell [L]
    double edge = 0;    // [L]; zero if all spheres are at `low`
    double period = 0;  // [L]; zero if the axis is not periodic
    std::int32_t count = 1;
  };
  // Cells along an axis, the last one included, counted on through images.
  struct Span {
    std::int32_t first;
    std::int32_t last;
  };
  // A body relative to which spheres are looked at, in units.
  struct Body {
    std::array<float, kAxes> position;
    std::array<float, kAxes> velocity;
    float end;
    float reach;  // of its surface, with what rounding may amount to
  };

  void choose_cells(std::span<const Vec3> centers, const Box& box);
  std::uint32_t cell_of(const Vec3& center) const;
  Span span_within(std::size_t axis, double low, double high) const;
  void look_at(const Body& body, std::size_t begin, std::size_t end, const Function<void(Slot)>& visit) const;

  double fastest_ = 0;
  double usual_speed_ = 0;
  double largest_usual_radius_ = 0;
  double cell_edge_ = 0;
  double length_unit_ = 1;  // [L]; that of speeds is the usual one
  std::array<Axis, kAxes> axes_;
  std::vector<std::uint32_t> begins_;  // by cell: the first of its spheres; after the last cell, their number
  // Of the usual spheres, by cell, in units:
  std::array<std::vector<float>, kAxes> positions_;
  std::array<std::vector<float>, kAxes> velocities_;
  std::vector<float> radii_;
  std::vector<Slot> slots_;
  std::vector<Slot> unusual_;
};

/// MovingSpheres that are made when a moment is asked about again. Copies make their own. Const members may
/// be called by several threads at once.
class HARDBALL_EXPORT LazyMovingSpheres {
 public:
  LazyMovingSpheres() = default;
  LazyMovingSpheres(const LazyMovingSpheres&) noexcept {}
  LazyMovingSpheres& operator=(const LazyMovingSpheres&) noexcept {
    reset();
    return *this;
  }

  /// The spheres of the world, which has not changed since `reset`, at this moment; null when it is asked
  /// about for the first time, which a search of all spheres answers sooner.
  const MovingSpheres* at(const World& world, const Time& now) const;
  /// To be called when the world has changed.
  void reset() {
    spheres_.reset();
    is_asked_ = false;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::optional<MovingSpheres> spheres_;
  mutable Time moment_;
  mutable bool is_asked_ = false;  // about the moment
};

}  // namespace hardball
