// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/geometry/sine_cosine.hpp"

namespace hardball {
namespace {

using Cubic = JointTrajectory::Cubic;

double rate_at(const Cubic& c, double t) {
  return c[1] + t * (2 * c[2] + t * (3 * c[3]));
}

double second_at(const Cubic& c, double t) {
  return 2 * c[2] + t * (6 * c[3]);
}

}  // namespace

Kinematics::Kinematics(const Robot& robot, const JointTrajectory& trajectory)
    : robot_(robot),
      trajectory_(trajectory),
      frames_(robot.bodies().size()),
      extremes_(robot.joint_count()),
      bounds_(robot.bodies().size() * robot.bodies().size()) {}

CenterMotion Kinematics::motion_of(const Robot::BodySphere& sphere, std::size_t ancestor, double time) const {
  CenterMotion motion{sphere.center, {}, {}};
  auto& [position, velocity, acceleration] = motion;
  for (std::size_t k = sphere.body; k != ancestor;) {
    const Robot::Body& body = robot_.bodies()[k];
    const Cubic& cubic = cubics_[body.joint];
    const double value = coordinate_at(cubic, time);
    const double rate = rate_at(cubic, time);
    const double second = second_at(cubic, time);
    if (body.turns) {
      const SineCosine phase = sine_cosine(value);
      const auto turned = [&](const Vec3& v) {
        return Vec3{phase.cosine * v.x - phase.sine * v.y, phase.sine * v.x + phase.cosine * v.y, v.z};
      };
      position = turned(position);
      velocity = turned(velocity);
      acceleration = turned(acceleration);
      const double square = rate * rate;
      acceleration.x += -second * position.y - square * position.x - 2 * rate * velocity.y;
      acceleration.y += second * position.x - square * position.y + 2 * rate * velocity.x;
      velocity.x -= rate * position.y;
      velocity.y += rate * position.x;
    } else {
      position.z += value;
      velocity.z += rate;
      acceleration.z += second;
    }
    position = body.origin + body.rotation.turned(position);
    velocity = body.rotation.turned(velocity);
    acceleration = body.rotation.turned(acceleration);
    k = body.parent;
  }
  return motion;
}

void Kinematics::enter_window(double begin, double end) {
  ++window_;
  const double middle = begin + 0.5 * (end - begin);
  for (std::size_t joint = 0; joint < extremes_.size(); ++joint) {
    const Cubic& cubic = cubics_[joint];
    Extremes& its = extremes_[joint];
    its.third = std::fabs(6 * cubic[3]);
    its.second = std::max(std::fabs(second_at(cubic, begin)), std::fabs(second_at(cubic, end)));
    its.first = std::max(std::fabs(rate_at(cubic, begin)), std::fabs(rate_at(cubic, end)));
    // Between the ends it is greatest where the second derivative is zero.
    const double turn = -cubic[2] / (3 * cubic[3]);
    if (turn > begin && turn < end) its.first = std::max(its.first, std::fabs(rate_at(cubic, turn)));
    its.value = std::fabs(coordinate_at(cubic, middle)) + 0.5 * (end - begin) * its.first;
  }
  for (std::size_t k = 1; k < frames_.size(); ++k) {
    const Robot::Body& body = robot_.bodies()[k];
    const Frame& parent = frames_[body.parent];
    Frame& frame = frames_[k];
    const Cubic& cubic = cubics_[body.joint];
    const double value = coordinate_at(cubic, middle);
    const double rate = rate_at(cubic, middle);
    const Vec3 arm = parent.axes.turned(body.origin);
    frame.axes = parent.axes * body.rotation;
    frame.origin = parent.origin + arm;
    frame.velocity = parent.velocity + cross(parent.spin, arm);
    frame.spin = parent.spin;
    if (body.turns) {
      const auto [sine, cosine] = sine_cosine(value);
      const Vec3 x = frame.axes.x;
      frame.axes.x = cosine * x + sine * frame.axes.y;
      frame.axes.y = cosine * frame.axes.y - sine * x;
      frame.spin += rate * frame.axes.z;
    } else {
      const Vec3 slide = value * frame.axes.z;
      frame.origin += slide;
      frame.velocity += cross(parent.spin, slide) + rate * frame.axes.z;
    }
  }
}

const Kinematics::BodyBounds& Kinematics::bounds_of_body(std::size_t body, std::size_t ancestor) {
  BodyBounds& bounds = bounds_[ancestor * frames_.size() + body];
  if (bounds.window == window_) return bounds;
  bounds = {};
  bounds.window = window_;
  if (body == ancestor) return bounds;
  const Robot::Body& its = robot_.bodies()[body];
  bounds = bounds_of_body(its.parent, ancestor);
  const Extremes& extremes = extremes_[its.joint];
  // The origin lies at this distance in the parent's frame.
  const double distance = its.distance + (its.turns ? 0 : extremes.value);
  MotionBounds& origin = bounds.origin;
  origin.speed += distance * bounds.first;
  origin.acceleration += distance * bounds.second;
  origin.jerk += distance * bounds.third;
  if (its.turns) {
    bounds.rate += extremes.first;
    bounds.rate_of_rate += extremes.second;
    bounds.third_of_angle += extremes.third;
    bounds.first = bounds.rate;
    bounds.second = bounds.rate * bounds.rate + bounds.rate_of_rate;
    bounds.third = bounds.rate * bounds.rate * bounds.rate + 3 * bounds.rate * bounds.rate_of_rate +
                   bounds.third_of_angle;
  } else {
    origin.speed += extremes.first;
    origin.acceleration += 2 * bounds.first * extremes.first + extremes.second;
    origin.jerk += 3 * bounds.second * extremes.first + 3 * bounds.first * extremes.second + extremes.third;
  }
  return bounds;
}

}  // namespace hardball
