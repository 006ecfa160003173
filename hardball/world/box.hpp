// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>
#include <type_traits>

#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/sliding_images.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/surfaces/surface_material.hpp"

namespace hardball {

/// What lies at the two ends of the box along one axis.
enum class Boundary {
  wall,      ///< Hard faces at 0 and at the size.
  periodic,  ///< Spheres that leave at one end enter at the other.
  open,      ///< Space is unbounded.
  flat,      ///< The axis does not exist, and everything lies at 0: z in two dimensions.
};

template <>
inline constexpr std::array<std::string_view, 4> kNames<Boundary>{"wall", "periodic", "open", "flat"};

/// By the number of the face: what users call the faces of the box.
inline constexpr std::array<std::string_view, kFaces> kFaceNames{"x_min", "x_max", "y_min",
                                                                 "y_max", "z_min", "z_max"};

/// How a face of the box that is a wall reflects spheres; by default as the response says.
struct FaceProperties {
  SurfaceMaterial material = {};
  /// Along the face [L/T]; it matters if the face is thermal, or the spheres are rough.
  Vec3 velocity = {};

  friend bool operator==(const FaceProperties&, const FaceProperties&) = default;
  static void persist(auto& archive, auto& self) { archive(self.material, self.velocity); }
};

/// The space in which spheres move: along each axis from 0 to a size, or unbounded; or the plane z = 0, in
/// which they are discs. Source: docs/decisions/0015-discs-are-spheres-in-a-plane.md.
class HARDBALL_EXPORT Box {
 public:
  /// Open space.
  Box() : Box({Boundary::open, Boundary::open, Boundary::open}, {}) {}

  /// `size` [L] is ignored along open axes and flat ones. Error: a size that is not finite, positive and in
  /// the operating range (range.hpp); an axis other than z that is flat.
  Box(const std::array<Boundary, kAxes>& boundary, const Vec3& size);

  static Box walls(const Vec3& size) { return {{Boundary::wall, Boundary::wall, Boundary::wall}, size}; }
  static Box periodic(const Vec3& size) {
    return {{Boundary::periodic, Boundary::periodic, Boundary::periodic}, size};
  }
  static Box open() { return {}; }
  /// A box in two dimensions with walls, of width and height [L].
  static Box flat_walls(double x, double y) {
    return {{Boundary::wall, Boundary::wall, Boundary::flat}, {x, y, 0}};
  }
  static Box flat_periodic(double x, double y) {
    return {{Boundary::periodic, Boundary::periodic, Boundary::flat}, {x, y, 0}};
  }
  static Box flat_open() { return {{Boundary::open, Boundary::open, Boundary::flat}, {}}; }

  Boundary boundary(std::size_t axis) const { return boundary_[axis]; }
  bool is_wall(std::size_t axis) const { return boundary_[axis] == Boundary::wall; }
  bool is_periodic(std::size_t axis) const { return boundary_[axis] == Boundary::periodic; }
  bool is_open(std::size_t axis) const { return boundary_[axis] == Boundary::open; }
  /// Whether the box has two ends along an axis: walls, or those of a period.
  bool is_bounded(std::size_t axis) const { return is_wall(axis) || is_periodic(axis); }
  /// Whether all existing axes have this boundary.
  bool is_all(Boundary boundary) const {
    return boundary_[0] == boundary && boundary_[1] == boundary && (is_flat() || boundary_[2] == boundary);
  }
  bool is_any(Boundary boundary) const {
    return boundary_[0] == boundary || boundary_[1] == boundary || boundary_[2] == boundary;
  }

  /// Gives a face its own properties. Error, with its location: it is not a wall; a restitution or
  /// temperature that Surface would refuse; a velocity that is out of range, leads out of the face, or out of
  /// the plane in two dimensions.
  void set_face(Face face, const FaceProperties& properties);
  const FaceProperties& face(Face face) const { return faces_[face]; }
  /// Whether a face is a wall with properties of its own.
  bool has_own_properties(Face face) const { return !(faces_[face] == FaceProperties()); }
  /// Whether all faces that are walls reflect spheres as the response says.
  bool has_plain_faces() const;

  /// Lets the box be sheared. Whole boxes are taken off the offset, so that it is smaller than the width.
  /// Error: x or y is not periodic; a number that is not finite or out of range.
  void set_shear(const Shear& shear);
  /// Lets the box be sheared with the very offset by which the images in a file are counted. Error: as for
  /// set_shear.
  void set_recorded_shear(const Shear& shear);
  const Shear& shear() const { return images_.shear(); }
  /// Whether images above and below slide along x, or are displaced.
  bool is_sheared() const { return images_.are_present(); }
  /// How they do so.
  const SlidingImages& images() const { return images_; }
  /// The velocity along x of the flow at a height [L/T]: zero in the middle, and where there is no shear.
  double flow_speed(double y) const { return shear().rate * (y - size_.y / 2); }

  /// Whether this is a plane: everything has z = 0.
  bool is_flat() const { return boundary_[2] == Boundary::flat; }
  /// 3, or 2 if the box is flat: axes from this number on do not exist.
  std::size_t dimensions() const { return is_flat() ? 2 : 3; }

  /// Edge lengths [L]; infinite along open axes, zero along flat ones.
  const Vec3& size() const { return size_; }
  /// The least of the edge lengths along periodic axes [L]; infinite if there are none.
  double shortest_period() const {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (is_periodic(axis)) shortest = std::min(shortest, size_[axis]);
    }
    return shortest;
  }
  /// [L^3], in two dimensions the area [L^2]; infinite if an axis is open.
  double volume() const { return volume_of(size_); }
  /// The volume of a part of the box with these edge lengths [L^3], in two dimensions the area [L^2].
  double volume_of(const Vec3& size) const { return is_flat() ? size.x * size.y : size.x * size.y * size.z; }
  /// The area of a face across an axis [L^2], in two dimensions the length of an edge [L].
  double face_area(std::size_t axis) const {
    if (is_flat()) return size_[1 - axis];
    return size_[(axis + 1) % kAxes] * size_[(axis + 2) % kAxes];
  }
  /// The volume of a sphere of this radius [L], in two dimensions the area of a disc [L^2].
  double sphere_volume(double radius) const {
    return is_flat() ? std::numbers::pi * radius * radius
                     : 4 * std::numbers::pi / 3 * radius * radius * radius;
  }
  /// The surface of a sphere of this radius [L^2], in two dimensions the circumference of a disc [L].
  double sphere_surface(double radius) const {
    return is_flat() ? 2 * std::numbers::pi * radius : 4 * std::numbers::pi * radius * radius;
  }

  friend bool operator==(const Box&, const Box&) = default;

  /// The displacement [L] of `image`. Precondition: the box is not sheared.
  Vec3 shift(const Image& image) const {
    return {image[0] * period_.x, image[1] * period_.y, image[2] * period_.z};
  }
  /// The displacement [L] of `image` at `moment`, also in a sheared box.
  Vec3 shift(const Image& image, const Time& moment) const {
    Vec3 shift = this->shift(image);
    if (is_sheared() && image[1] != 0) shift.x = images_.shift(image[0], image[1], moment);
    return shift;
  }
  /// How much faster `image` moves than the body [L/T].
  Vec3 image_velocity(const Image& image) const { return {image[1] * images_.speed(), 0, 0}; }

  /// Edge lengths along periodic axes, zero along the others [L].
  const Vec3& period() const { return period_; }

  /// The reciprocals of the periods, zero along axes that are not periodic [1/L].
  const Vec3& inverse_period() const { return inverse_period_; }

  /// The largest number of boxes by which a position may lie outside along a periodic axis [1].
  static constexpr double kMaxBoxesBeyond = 1 << 30;

  /// By how many boxes `position` lies outside this one; zero along axes that are not periodic.
  /// Error (RunFailure): more than 2^30 boxes away.
  Image boxes_beyond(const Vec3& position) const {
    return needs_no_folding(position) ? Image{} : count_boxes_beyond(position);
  }

  /// Moves `position` [L] into the box, back by boxes_beyond(position), which it returns.
  Image fold(Vec3& position) const {
    if (needs_no_folding(position)) return {};
    const Image beyond = count_boxes_beyond(position);
    position -= shift(beyond);
    return beyond;
  }

  /// By how many boxes `position` lies outside this one at `moment`, also in a sheared box. Error
  /// (RunFailure): more than 2^30 boxes away.
  Image boxes_beyond(const Vec3& position, const Time& moment) const {
    if (needs_no_folding(position)) return {};
    return is_sheared() ? count_sheared_boxes_beyond(position, moment) : count_boxes_beyond(position);
  }

  /// Moves a body at `position` [L] into the box and gives it the `velocity` [L/T] of its image there, also
  /// in a sheared box; returns boxes_beyond(position, moment).
  Image fold(Vec3& position, Vec3& velocity, const Time& moment) const {
    if (needs_no_folding(position)) return {};
    const Image beyond = boxes_beyond(position, moment);
    position -= shift(beyond, moment);
    if (is_sheared()) velocity -= image_velocity(beyond);
    return beyond;
  }

  /// The image of a body that is nearest to another at `moment`, also in a sheared box.
  Image nearest_image(const Vec3& apart, const Time& moment) const {
    const Image nearest = nearest_image(apart);
    return is_sheared() && nearest[1] != 0 ? nearest_sliding_image(apart, nearest, moment) : nearest;
  }

  /// The image of a body that is nearest to another, `apart` [L] being the vector from the body to the other;
  /// zero along axes that are not periodic. Precondition: they are fewer than 2^31 boxes apart; the box is
  /// not sheared.
  Image nearest_image(const Vec3& apart) const {
    const Vec3 boxes = nearest_boxes(apart, inverse_period_);
    return {{static_cast<std::int32_t>(boxes.x), static_cast<std::int32_t>(boxes.y),
             static_cast<std::int32_t>(boxes.z)}};
  }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.boundary_, self.size_, self.faces_);
    Shear shear = self.shear();
    archive(shear);
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) self.images_ = {shear, 0, 0};
  }
  bool restored();

  // Most centers lie in the box, which takes no division to find out.
  bool needs_no_folding(const Vec3& position) const {
    return position.x >= lower_end_.x && position.x < upper_end_.x && position.y >= lower_end_.y &&
           position.y < upper_end_.y && position.z >= lower_end_.z && position.z < upper_end_.z;
  }

  void check_shear(const Shear& shear) const;
  void slide_images(const Shear& shear);
  // By value: passed by reference, a position would be kept in memory even where this is not called.
  Image count_boxes_beyond(Vec3 position) const;
  Image count_sheared_boxes_beyond(Vec3 position, const Time& moment) const;
  Image nearest_sliding_image(const Vec3& apart, Image nearest, const Time& moment) const;
  template <class Round>
  std::int32_t boxes_along(double distance, std::int32_t above, const Time& moment, Round&& round) const;

  std::array<Boundary, kAxes> boundary_;
  Vec3 size_;
  Vec3 period_;  // the size along periodic axes, zero along the others
  Vec3 inverse_period_;
  // Positions between these need no folding; infinite along axes that are not periodic.
  Vec3 lower_end_;
  Vec3 upper_end_;
  std::array<FaceProperties, kFaces> faces_{};
  SlidingImages images_;
};

}  // namespace hardball
