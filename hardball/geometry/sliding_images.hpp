// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/inlining.hpp"
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

/// How the images of a sheared box move, those above along y. Formulas are templates on the number
/// (number.hpp).
class SlidingImages {
 public:
  SlidingImages() = default;
  /// The images of a box of this width along x and height along y [L].
  SlidingImages(const Shear& shear, double width, double height)
      : are_present_(shear.is_present()), shear_(shear), width_(width), speed_(shear.rate * height) {}

  bool are_present() const { return are_present_; }
  const Shear& shear() const { return shear_; }
  /// The velocity along x of the image above [L/T].
  double speed() const { return speed_; }
  /// By how much the image above is displaced along x at `moment` [L], to twice the precision: so no digits
  /// are lost, however many boxes that are.
  template <class Number>
  HARDBALL_ALWAYS_INLINE DoubleDouble<Number> displacement(const TimeOf<Number>& moment) const {
    const Number speed(speed_);
    const DoubleDouble<Number> slid = product(speed, moment.high);
    return normalized<Number>(slid.high, slid.low + speed * moment.low) +
           DoubleDouble<Number>{Number(shear_.offset), Number(0.0)};
  }
  /// The displacement without whole boxes, between zero and the width [L].
  double displacement_in_box(const Time& moment) const {
    const DoubleDouble<double> whole = displacement(moment);
    const DoubleDouble<double> boxes = product(std::floor(whole.high / width_), width_);
    return (whole - boxes).high;
  }
  /// By how much the image `along` boxes ahead along x and `above` boxes up is displaced along x at `moment`
  /// [L]; both are integers.
  template <class Number>
  HARDBALL_ALWAYS_INLINE Number shift(const std::type_identity_t<Number>& along,
                                      const std::type_identity_t<Number>& above,
                                      const TimeOf<Number>& moment) const {
    const DoubleDouble<Number> ahead = product(along, Number(width_));
    return (ahead + DoubleDouble<Number>{above, Number(0.0)} * displacement(moment)).high;
  }
  /// By how much `distance` along x exceeds the displacement of the image `above` at `moment` [L].
  template <class Number>
  HARDBALL_ALWAYS_INLINE Number beyond(const std::type_identity_t<Number>& distance,
                                       const std::type_identity_t<Number>& above,
                                       const TimeOf<Number>& moment) const {
    const DoubleDouble<Number> slid = DoubleDouble<Number>{above, Number(0.0)} * displacement(moment);
    return (DoubleDouble<Number>{distance, Number(0.0)} - slid).high;
  }

  friend bool operator==(const SlidingImages&, const SlidingImages&) = default;

 private:
  bool are_present_ = false;
  Shear shear_;
  double width_ = 0;
  double speed_ = 0;
};

}  // namespace hardball
