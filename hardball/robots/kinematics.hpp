// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "hardball/robots/joint_trajectory.hpp"
#include "hardball/robots/robot.hpp"

namespace hardball {

/// How a center moves at one time.
struct CenterMotion {
  Vec3 position;      ///< [L]
  Vec3 velocity;      ///< [L/T]
  Vec3 acceleration;  ///< [L/T^2]
};

/// What the derivatives of a center's position do not exceed in a time.
struct MotionBounds {
  double speed = 0;         ///< [L/T]
  double acceleration = 0;  ///< [L/T^2]
  double jerk = 0;          ///< [L/T^3]
};

/// The motion of a robot in one piece of a trajectory, as a function of the time since the piece began.
///
/// Of a time, it knows the frames of all bodies in its middle, and bounds of all derivatives.
class Kinematics {
 public:
  /// Both outlive it.
  Kinematics(const Robot& robot, const JointTrajectory& trajectory);

  /// Turns to another piece.
  void enter_piece(std::size_t piece) { cubics_ = trajectory_.piece(piece); }

  /// How the center of a sphere moves, seen from the frame of a body that carries its own. Cost: O(joints).
  CenterMotion motion_of(const Robot::BodySphere& sphere, std::size_t ancestor, double time) const;

  /// Turns to the time from `begin` to `end`. Cost: O(joints).
  void enter_window(double begin, double end);
  /// Where the center of a sphere is in the middle of the window, and its velocity.
  void state_of(const Robot::BodySphere& sphere, Vec3& position, Vec3& velocity) const {
    const Frame& frame = frames_[sphere.body];
    const Vec3 arm = frame.axes.turned(sphere.center);
    position = frame.origin + arm;
    velocity = frame.velocity + cross(frame.spin, arm);
  }
  /// Bounds of the motion of a center within the window, seen from the frame of a body that carries its own.
  MotionBounds bounds_of(const Robot::BodySphere& sphere, std::size_t ancestor) {
    const BodyBounds& bounds = bounds_of_body(sphere.body, ancestor);
    constexpr double kRoundedUp = 1 + 0x1p-40;
    return {kRoundedUp * (bounds.origin.speed + sphere.distance * bounds.first),
            kRoundedUp * (bounds.origin.acceleration + sphere.distance * bounds.second),
            kRoundedUp * (bounds.origin.jerk + sphere.distance * bounds.third)};
  }

 private:
  struct Frame {
    Vec3 origin;
    RotationMatrix axes;
    Vec3 velocity;
    Vec3 spin;
  };
  // The greatest magnitudes of a coordinate and its derivatives in the window.
  struct Extremes {
    double value = 0;
    double first = 0;
    double second = 0;
    double third = 0;
  };
  // Bounds of the motion of a body's origin, and of the derivatives of its rotation: those of the exponential
  // of the sum of all angles on the way, as products of rotations have no greater ones.
  struct BodyBounds {
    MotionBounds origin;
    double first = 0;
    double second = 0;
    double third = 0;
    // Sums over the angles on the way.
    double rate = 0;
    double rate_of_rate = 0;
    double third_of_angle = 0;
    std::size_t window = 0;
  };

  const BodyBounds& bounds_of_body(std::size_t body, std::size_t ancestor);

  const Robot& robot_;
  const JointTrajectory& trajectory_;
  std::span<const JointTrajectory::Cubic> cubics_;
  std::vector<Frame> frames_;
  std::vector<Extremes> extremes_;
  std::vector<BodyBounds> bounds_;  // of each body, seen from each
  std::size_t window_ = 0;
};

}  // namespace hardball
