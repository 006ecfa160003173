// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/errors/export.hpp"
#include "hardball/surfaces/passage.hpp"
#include "hardball/surfaces/plane.hpp"

namespace hardball {

/// A plane that oscillates along its normal about the origin: at time t it is amplitude * sin(2 pi frequency
/// t) away.
class HARDBALL_EXPORT OscillatingPlane {
 public:
  static constexpr std::string_view kName = "oscillating plane";
  static constexpr auto fields() {
    return std::tuple{
        normal_field(&OscillatingPlane::normal),
        Field{"amplitude", &OscillatingPlane::amplitude, NumberRange::positive, "L",
              "together with `frequency`, instead of `velocity`: at time t the plane is displaced along its "
              "normal by amplitude · sin(2π · frequency · t)",
              "0.1"},
        Field{"frequency", &OscillatingPlane::frequency, NumberRange::positive, "1/T",
              "the frequency of this oscillation", "2.0"}};
  }

  /// `normal` is a unit vector, toward the spheres; amplitude [L], frequency [1/T].
  OscillatingPlane(const Vec3& normal, double amplitude, double frequency)
      : rest_(normal), amplitude_(amplitude), frequency_(frequency) {}

  /// The plane at rest, in the middle.
  const Plane& rest() const { return rest_; }
  const Vec3& normal() const { return rest_.normal(); }
  double amplitude() const { return amplitude_; }
  double frequency() const { return frequency_; }

  /// When a sphere first touches the plane while they approach, at the start of a passage or
  /// later; kNever if it never does. The gap, a parabola less a sine, is evaluated in twice the precision,
  /// and advanced by steps in which a bound of its curvature excludes a contact, to the last bit. Cost: that
  /// of a few turns, however long the passage.
  Time contact_time(const Passage& passage) const;
  /// How fast the gap opens at the start of a passage [L/T]; negative if it closes.
  DoubleDouble<> opening_speed(const Passage& passage) const;

  double distance(const Vec3& position) const { return rest_.distance(position); }
  Vec3 towards(const Vec3& position) const { return rest_.towards(position); }
  /// Where spheres may be along the axes of a box at all times [L].
  Extent room() const {
    Extent room = rest_.room();
    const Vec3 all{amplitude_, amplitude_, amplitude_};
    room.low -= all;
    room.high += all;
    return room;
  }
  /// See Plane.
  const char* remedy_for_period(std::size_t axis) const { return rest_.remedy_for_period(axis); }
  /// See Plane.
  double area(const auto& box) const { return rest_.area(box); }
  /// By how much the plane is displaced at `moment` [L], and how fast it moves [L/T].
  Vec3 displacement_at(const Time& moment) const;
  Vec3 velocity_at(const Time& moment) const;

 private:
  friend class Persistence;
  OscillatingPlane() : OscillatingPlane({}, 0, 0) {}
  static void persist(auto& archive, auto& self) { archive(self.rest_, self.amplitude_, self.frequency_); }

  // The gap of a sphere to the plane at rest, as a function of the time after the start.
  struct Flight {
    Polynomial rest;
    Time start;
  };
  // The gap to the plane, and its derivatives.
  struct Gap {
    double width;
    double opening_speed;
    double curvature;
  };
  Gap gap_at(const Flight& flight, double t) const;
  // A time in which a gap does not close.
  double safe_step(const Flight& flight, const Gap& gap) const;
  // Whether the sphere is met within the next turn, or before there is `room` between it and the plane's
  // reach; moves `t` to the time when it is, or to the end of what was searched.
  bool is_met(const Flight& flight, const Polynomial& room, double& t) const;

  Plane rest_;
  double amplitude_;
  double frequency_;
};

}  // namespace hardball
