// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/surfaces/passage.hpp"

namespace hardball {

/// A shape that a program defines for itself. Positions are relative to the surface's point. All answers must
/// be functions of the arguments alone, or runs do not repeat.
class ShapeInterface {
 public:
  virtual ~ShapeInterface() = default;

  /// The name of the shape, for messages.
  virtual std::string_view name() const = 0;
  /// When a sphere first touches the surface while they approach, at the start of a passage or later; kNever
  /// if it never does. A polynomial gap helps, see Plane and `earliest_descent`.
  virtual Time contact_time(const Passage& passage) const = 0;
  /// How fast the gap opens at the start of a passage that begins with a contact; negative if it closes. Only
  /// the sign matters.
  virtual DoubleDouble<> opening_speed(const Passage& passage) const = 0;
  /// A distance from a point to the surface [L], no larger than the true one; negative beyond it.
  virtual double distance(const Vec3& position) const = 0;
  /// A vector of any length from a point toward the surface.
  virtual Vec3 towards(const Vec3& position) const = 0;
  /// Where spheres may be along the axes of a box [L].
  virtual Extent room() const { return {}; }
  /// What would make it the same in all images of a box that is periodic along an axis; null if it is.
  virtual const char* remedy_for_period(std::size_t /*axis*/) const {
    return "make the axis a wall, or open";
  }
  /// The radius of the largest sphere within [L]; infinite if there is none.
  virtual double largest_sphere() const { return std::numeric_limits<double>::infinity(); }
};

/// A shape of a program's own among those of the library. Copies share it. It cannot be saved.
class OwnShape {
 public:
  static constexpr std::string_view kName = "shape of the program's own";
  static constexpr auto fields() { return std::tuple<>(); }

  explicit OwnShape(std::shared_ptr<const ShapeInterface> shape) : shape_(std::move(shape)) {}

  std::string_view name() const { return shape_->name(); }
  Time contact_time(const Passage& passage) const { return shape_->contact_time(passage); }
  DoubleDouble<> opening_speed(const Passage& passage) const { return shape_->opening_speed(passage); }
  double distance(const Vec3& position) const { return shape_->distance(position); }
  Vec3 towards(const Vec3& position) const { return shape_->towards(position); }
  Extent room() const { return shape_->room(); }
  const char* remedy_for_period(std::size_t axis) const { return shape_->remedy_for_period(axis); }
  double largest_sphere() const { return shape_->largest_sphere(); }

 private:
  friend class Persistence;
  OwnShape() = default;
  static void persist(auto&, auto&) {
    throw Error("a surface has a shape of the program's own", "surface",
                "save and share simulations without it");
  }

  std::shared_ptr<const ShapeInterface> shape_;
};

}  // namespace hardball
