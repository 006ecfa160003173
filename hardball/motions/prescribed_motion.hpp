// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/motions/keyframes.hpp"
#include "hardball/motions/oscillation.hpp"
#include "hardball/motions/rotation.hpp"

namespace hardball {

/// The kinds of motions that can be prescribed.
using MotionKind = std::variant<Rotation, Oscillation, Keyframes>;

/// A motion that is prescribed to kinematic spheres and to surfaces: a curve, and how far the chords that
/// follow it may lie from it.
///
/// Bodies move on chords between knots of the curve: on a straight path, or in free fall where there is
/// gravity. A curve with accelerations of at most a is followed within a tolerance e by chords of the
/// duration sqrt(8 e / a), under gravity g of sqrt(8 e / (a + g)).
class HARDBALL_EXPORT PrescribedMotion {
 public:
  /// `tolerance` [L]: the greatest distance of the chords from the curve; of keyframes, it matters only where
  /// there is gravity, and zero stands for none. Error: it is not positive.
  PrescribedMotion(MotionKind kind, double tolerance);

  /// A rotation about an axis through `point` [L] with this frequency [1/T]; see Rotation.
  static PrescribedMotion rotation(const Vec3& point, const Vec3& axis, double frequency, double tolerance) {
    return {Rotation(point, axis, frequency), tolerance};
  }
  /// An oscillation along `direction` with this amplitude [L] and frequency [1/T]; see Oscillation.
  static PrescribedMotion oscillation(const Vec3& direction, double amplitude, double frequency,
                                      double tolerance) {
    return {Oscillation(direction, amplitude, frequency), tolerance};
  }
  /// A timetable; see Keyframes.
  static PrescribedMotion keyframes(std::vector<Keyframe> rows, bool repeats = false, double tolerance = 0) {
    return {Keyframes(std::move(rows), repeats), tolerance};
  }
  /// The timetable of a curve, of which `position` returns the place [L] at a time since the motion began
  /// [T], up to `until` [T]. Its acceleration is at most `acceleration` [L/T^2]. Cost: a call for each knot.
  /// Error: a number is not positive; there would be more than 2^31 knots; as for Keyframes.
  static PrescribedMotion sampled(const std::function<Vec3(double)>& position, double until,
                                  double acceleration, double tolerance, bool repeats = false);

  const MotionKind& kind() const { return kind_; }
  /// The name of the kind in scenarios.
  std::string_view name() const;
  double tolerance() const { return tolerance_; }
  /// A vector with a component of zero along the axes of space along which bodies do not move.
  Vec3 span() const;
  /// The greatest acceleration of a body that begins at `from` [L/T^2]; zero on straight lines.
  double acceleration(const Vec3& from) const;
  /// How long chords may last at most where accelerations do not exceed this [T]; infinity if it is zero.
  double longest_chord(double acceleration) const;

 private:
  friend class Persistence;
  PrescribedMotion() : kind_(Keyframes(std::vector<Keyframe>(1))) {}
  static void persist(auto& archive, auto& self) { archive(self.kind_, self.tolerance_); }
  bool restored();

  MotionKind kind_;
  double tolerance_ = 0;
};

/// The knots of a motion: an unlimited sequence of times since it began, and where bodies are at each.
///
/// They are a function of the motion, of the gravity and of the greatest acceleration alone.
class HARDBALL_EXPORT Knots {
 public:
  /// A knot by its number: the `part`-th of those on a segment of a timetable; of other motions each segment
  /// is a chord.
  struct Number {
    std::uint64_t segment = 0;
    std::uint64_t part = 0;

    friend bool operator==(const Number&, const Number&) = default;
    static void persist(auto& archive, auto& self) { archive(self.segment, self.part); }
  };

  /// `acceleration` [L/T^2]: the greatest of any body, that of the curve and of gravity together. Error: the
  /// tolerance is so small that a turn has more than 2^40 chords; there is gravity, and a timetable has no
  /// tolerance.
  Knots(const PrescribedMotion& motion, double acceleration);

  /// The first knot at the begin of the motion.
  Number first(const PrescribedMotion& motion) const;
  /// The next knot. Precondition: there is one.
  Number after(const PrescribedMotion& motion, const Number& knot) const;
  /// Whether it is the last one: a body that stays at rest needs no others.
  bool is_last(const PrescribedMotion& motion, const Number& knot) const;
  /// The time of a knot since the motion began [T].
  double time(const PrescribedMotion& motion, const Number& knot) const;
  /// How far a body that began at `from` [L] has moved at a knot [L], whose time is `elapsed`.
  Vec3 displacement(const PrescribedMotion& motion, const Number& knot, const Vec3& from,
                    const Time& elapsed) const;

 private:
  // Of timetables: what lies between two rows.
  struct Segment {
    double begin = 0;         // [T]
    double length = 0;        // [T]; infinite for the rest after the last row
    std::uint64_t parts = 1;  // 0 for no end
    std::size_t from = 0;     // rows
    std::size_t to = 0;
  };
  Segment segment(const Keyframes& frames, std::uint64_t number) const;

  double chords_ = 0;   // in a unit of time, of motions that are no timetables
  double longest_ = 0;  // chord of a timetable [T]; infinity without gravity
};

}  // namespace hardball
