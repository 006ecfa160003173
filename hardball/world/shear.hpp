// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/time.hpp"

namespace hardball {

/// A steady shear of a periodic box: the fluid flows along x, faster the higher it is along y, so the image
/// of the box above slides along x over it.
/// Source: Lees and Edwards, J. Phys. C 5 (1972) 1921.
struct Shear {
  double rate = 0;    ///< By how much the flow along x grows along y [1/T].
  double offset = 0;  ///< By how much the image above is displaced along x at time zero [L].

  bool is_present() const { return rate != 0 || offset != 0; }

  friend bool operator==(const Shear&, const Shear&) = default;
  static void persist(auto& archive, auto& self) { archive(self.rate, self.offset); }
};

/// How the images of a sheared box move, those above along y.
class SlidingImages {
 public:
  SlidingImages() = default;
  /// Of a box of this width along x and height along y [L].
  SlidingImages(const Shear& shear, double width, double height)
      : shear_(shear), width_(width), speed_(shear.rate * height) {}

  bool are_present() const { return shear_.is_present(); }
  const Shear& shear() const { return shear_; }
  /// The velocity along x of the image above [L/T].
  double speed() const { return speed_; }
  /// By how much the image above is displaced along x at `moment` [L], to twice the precision: so no digits
  /// are lost, however many boxes that are.
  DoubleDouble<double> displacement(const Time& moment) const {
    const DoubleDouble<double> slid = product(speed_, moment.high);
    return normalized(slid.high, slid.low + speed_ * moment.low) + DoubleDouble<double>{shear_.offset, 0};
  }
  /// The same up to whole boxes, between zero and the width [L].
  double displacement_in_box(const Time& moment) const {
    const DoubleDouble<double> whole = displacement(moment);
    const DoubleDouble<double> boxes = product(std::floor(whole.high / width_), width_);
    return (whole - boxes).high;
  }
  /// By how much the image `along` boxes ahead along x and `above` boxes up is displaced along x at `moment`
  /// [L].
  double shift(std::int32_t along, std::int32_t above, const Time& moment) const {
    const DoubleDouble<double> ahead = product(static_cast<double>(along), width_);
    return (ahead + DoubleDouble<double>{static_cast<double>(above), 0} * displacement(moment)).high;
  }

  friend bool operator==(const SlidingImages&, const SlidingImages&) = default;

 private:
  Shear shear_;
  double width_ = 0;
  double speed_ = 0;
};

}  // namespace hardball
