// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The spheres of a world at one moment, sorted by speed and by cells, in single precision: which of them a
/// body may touch on its way is decided several at a time, without computing contact times.
///
/// Spheres of about one speed make a layer with cells of its own, so that slow spheres are looked for close
/// by, and only fast ones far away. Few are much larger than most, and make a layer, too. Where cells lie
/// depends on where the spheres are, and not on the engine.
class HARDBALL_EXPORT MovingSpheres {
 public:
  /// Sorts the spheres as they are at `now`, which do not grow, in a box that is not sheared. Cost: O(n).
  void sort(const World& world, const Time& now);

  /// No sphere is faster [L/T].
  double fastest() const { return fastest_; }
  /// Few spheres are faster [L/T].
  double usual_speed() const { return usual_speed_; }
  /// The edge of a cube that has a few spheres [L].
  double cell_edge() const { return cell_edge_; }
  /// No sphere is farther from another along an axis [L].
  double extent() const { return 2 * length_unit_; }

  /// Calls visit(slot) for the spheres of which an image may touch a body between `begin` and `end` after the
  /// moment [T], and for some others, perhaps more than once. The body begins at `from`, in the box, and
  /// moves as spheres do; its radius is `radius` [L].
  void for_each_near(const State& from, double radius, double begin, double end,
                     const Function<void(Slot)>& visit) const;

 private:
  // The top speeds of layers, over the root mean square of all speeds: about a fifth of the spheres of a gas
  // in each of the first four. Faster ones are in a layer behind, and large spheres in the last.
  static constexpr std::array kTopSpeeds{0.58, 0.78, 0.97, 1.22, 1.6, 2.5};
  static constexpr std::size_t kLayers = kTopSpeeds.size() + 2;
  // The radius of large spheres, over the root mean square of all.
  static constexpr double kLarge = 2.5;

  struct Axis {
    double low = 0;     // of the first cell [L]
    double edge = 0;    // of a cell [L]; zero if all spheres are at `low`
    double period = 0;  // [L]; zero if the axis is not periodic
    std::int32_t count = 1;
  };
  struct Layer {
    double speed = 0;   // no sphere is faster [L/T]
    double radius = 0;  // nor larger [L]
    std::array<Axis, kAxes> axes;
    std::uint32_t first_cell = 0;
    std::uint32_t size = 0;
  };
  // Cells along an axis, the last one included, counted on through images.
  struct Span {
    std::int32_t first;
    std::int32_t last;
  };
  // A body relative to which spheres of a layer are looked at, in units of the layer.
  struct Body {
    std::array<float, kAxes> position;
    std::array<float, kAxes> velocity;
    float end;
    float reach;  // of its surface, with what rounding may amount to
  };
  // Where the center of a body is during an interval.
  struct Sweep {
    Vec3 low;
    Vec3 high;
  };

  void assign_layers(const World& world);
  void choose_cells(const Box& box);
  void sort_by_cells();
  void copy_sorted(const World& world);
  static std::uint32_t cell_of(const Layer& layer, const Vec3& center);
  static Span span_within(const Axis& axis, double low, double high);
  void look_in(const Layer& layer, const State& from, const Sweep& sweep, double radius, double end,
               const Function<void(Slot)>& visit) const;
  void look_at(const Body& body, std::size_t begin, std::size_t end, const Function<void(Slot)>& visit) const;

  double fastest_ = 0;
  double usual_speed_ = 0;
  double cell_edge_ = 0;
  double length_unit_ = 1;  // [L]; that of speeds is the top speed of a layer
  std::array<Layer, kLayers> layers_;
  Vec3 low_;  // of all centers [L]
  Vec3 high_;
  std::array<Axis, kAxes> extent_;     // of all centers, as one cell
  std::vector<std::uint32_t> begins_;  // by cell: the first of its spheres; after the last cell, their number
  // By cell, in units:
  std::array<std::vector<float>, kAxes> positions_;
  std::array<std::vector<float>, kAxes> velocities_;
  std::vector<float> radii_;
  std::vector<Slot> slots_;
  // By slot, while they are sorted:
  std::vector<State> states_;
  std::vector<std::uint8_t> layer_numbers_;
  std::vector<std::uint32_t> cells_;
};

/// MovingSpheres that are sorted when a moment is asked about again, or at once where that was so before.
/// Copies sort their own. Const members may be called by several threads at once.
class HARDBALL_EXPORT LazyMovingSpheres {
 public:
  LazyMovingSpheres() = default;
  LazyMovingSpheres(const LazyMovingSpheres&) noexcept {}
  LazyMovingSpheres& operator=(const LazyMovingSpheres&) noexcept {
    reset();
    return *this;
  }

  /// The spheres of the world, which has not changed since `reset`, at this moment; null when it is likely to
  /// be asked about once, which a search of all spheres answers sooner.
  const MovingSpheres* at(const World& world, const Time& now) const;
  /// To be called when the world has changed.
  void reset() { asked_ = 0; }

 private:
  mutable std::mutex mutex_;
  mutable MovingSpheres spheres_;
  mutable Time moment_;
  mutable std::uint64_t asked_ = 0;       // about the moment, since the world has changed
  mutable bool is_sorted_ = false;        // for it
  mutable bool was_asked_again_ = false;  // about the last moment that was asked about
};

}  // namespace hardball
