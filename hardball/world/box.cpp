// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/box.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/number.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

Box::Box(const std::array<Boundary, kAxes>& boundary, const Vec3& size) : boundary_(boundary), size_(size) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    lower_end_[axis] = is_periodic(axis) ? 0 : -kInfinity;
    upper_end_[axis] = is_periodic(axis) ? size[axis] : kInfinity;
    if (is_open(axis)) {
      size_[axis] = kInfinity;
      continue;
    }
    if (boundary[axis] == Boundary::flat) {
      if (axis != 2) throw Error("an axis other than z is flat", "boundary", "make z flat instead");
      size_[axis] = 0;
      continue;
    }
    check_positive(size[axis], "box size", axis == 0 ? "size.x" : axis == 1 ? "size.y" : "size.z");
    if (!is_periodic(axis)) continue;
    period_[axis] = size[axis];
    inverse_period_[axis] = 1 / size[axis];
  }
}

void Box::set_face(Face face, const FaceProperties& properties) {
  if (face >= kFaces) throw Error("there is no face " + to_text(face), "face", "give one that face_of names");
  const std::string where = "face " + std::string(kFaceNames[face]);
  const std::size_t across = axis_of(face);
  if (!is_wall(across)) {
    throw Error("the box has no wall there", where,
                std::string("make the boundary along ") + kAxisNames[across] + " a wall");
  }
  check_material(properties.material, where);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double velocity = properties.velocity[axis];
    check_finite(velocity, "velocity", where);
    if (velocity == 0) continue;
    if (axis == across) {
      throw Error("the velocity along " + std::string(kAxisNames[axis]) + " is " + to_text(velocity) +
                      ", and a face of the box moves only along itself",
                  where,
                  "make it zero; for such a wall, open the axis and use a plane, in scenarios [[walls]]");
    }
    if (axis >= dimensions()) {
      throw Error("the velocity along z is " + to_text(velocity) + " in a box of two dimensions", where,
                  "make it zero, or give the box three dimensions");
    }
    if (std::fabs(velocity) < kSmallestMagnitude) {
      throw Error("the velocity is " + to_text(velocity), where,
                  "give zero, or a magnitude of at least 1e-60");
    }
  }
  faces_[face] = properties;
}

void Box::set_shear(const Shear& shear) {
  check_shear(shear);
  // Whole boxes change nothing, and would count toward those by which images may slide.
  slide_images(
      {shear.rate, std::fabs(shear.offset) < size_.x ? shear.offset : std::fmod(shear.offset, size_.x)});
}

void Box::check_shear(const Shear& shear) const {
  check_finite(shear.rate, "the shear rate", "shear");
  check_finite(shear.offset, "the offset", "shear");
  if (shear.rate != 0 && std::fabs(shear.rate) < kSmallestMagnitude) {
    throw Error("the shear rate is " + to_text(shear.rate), "shear",
                "give zero, or a magnitude of at least 1e-60");
  }
  if (shear.is_present() && !(is_periodic(0) && is_periodic(1))) {
    throw Error("the box is sheared, and not periodic along x and y", "shear",
                "make both periodic, or let walls move along themselves");
  }
}

void Box::slide_images(const Shear& shear) {
  images_ = shear.is_present() ? SlidingImages(shear, size_.x, size_.y) : SlidingImages();
}

void Box::set_recorded_shear(const Shear& shear) {
  check_shear(shear);
  slide_images(shear);
}

bool Box::has_plain_faces() const {
  return ranges::all_of(faces_, [](const FaceProperties& face) { return face == FaceProperties(); });
}

Image Box::count_boxes_beyond(Vec3 position) const {
  Image beyond;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!is_periodic(axis)) continue;
    const double boxes = std::floor(position[axis] / size_[axis]);
    if (!(std::fabs(boxes) <= kMaxBoxesBeyond)) {
      throw RunFailure(
          "a sphere has crossed the periodic box 2^30 times without a collision; use a larger box");
    }
    beyond[axis] = static_cast<std::int32_t>(boxes);
  }
  return beyond;
}

Image Box::count_sheared_boxes_beyond(Vec3 position, const Time& moment) const {
  const Vec3 above{size_.x / 2, position.y, position.z};
  Image beyond = count_boxes_beyond(above);
  if (beyond[1] == 0) return count_boxes_beyond(position);
  beyond[0] = boxes_along(position.x, beyond[1], moment, [](double boxes) { return std::floor(boxes); });
  return beyond;
}

Image Box::nearest_sliding_image(const Vec3& apart, Image nearest, const Time& moment) const {
  nearest[0] = boxes_along(apart.x, nearest[1], moment, round_to_integer<double>);
  return nearest;
}

// By how many boxes `distance` [L] along x exceeds the displacement of the image `above`, rounded.
template <class Round>
std::int32_t Box::boxes_along(double distance, std::int32_t above, const Time& moment, Round&& round) const {
  const double boxes = round(images_.beyond(distance, above, moment) * inverse_period_.x);
  if (!(std::fabs(boxes) <= kMaxBoxesBeyond)) {
    throw RunFailure(
        "the images of the sheared box have slid by 2^30 boxes; begin a new run where this ends");
  }
  return static_cast<std::int32_t>(boxes);
}

bool Box::restored() {
  const auto is_known = [](Boundary boundary) {
    return boundary >= Boundary::wall && boundary <= Boundary::flat;
  };
  if (!ranges::all_of(boundary_, is_known)) return false;
  const std::array<FaceProperties, kFaces> faces = faces_;
  const Shear shear = this->shear();
  *this = Box(boundary_, size_);
  set_recorded_shear(shear);
  for (Face face = 0; face < kFaces; ++face) {
    if (!(faces[face] == FaceProperties())) set_face(face, faces[face]);
  }
  return true;
}

}  // namespace hardball
