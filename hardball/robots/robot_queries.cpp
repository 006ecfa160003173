// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/robot_queries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <tuple>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/geometry/safe_step.hpp"
#include "hardball/robots/kinematics.hpp"
#include "hardball/standard/share_work.hpp"

namespace hardball {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
// More than all rounding of sweeps.
constexpr double kRoundedUp = 1 + 0x1p-40;

// What a sphere of the robot may meet.
enum class Target : std::uint8_t { node, item, group, sphere };

struct Candidate {
  std::uint32_t sphere = 0;
  std::uint32_t other = 0;  // number of the node, item, group of pairs, or pair
  Target target = Target::node;
};

// A contact in the present piece.
struct Found {
  double time = kForever;  // since the piece began
  std::uint32_t sphere = 0;
  bool is_own = false;      // it is with a sphere of the robot
  std::uint32_t other = 0;  // obstacle or sphere
  double distance = 0;
  std::uint32_t item = 0;

  bool is_before(const Found& o) const {
    return std::tie(time, sphere, is_own, other) < std::tie(o.time, o.sphere, o.is_own, o.other);
  }
};

// Looks for contacts, or for the least distance, in one trajectory. A piece is halved again and again. Of the
// bodies that each sphere may meet in a window, those are dropped that are too far for it, as its motion in
// the middle and the bounds of its derivatives say. Boxes of the tree are opened once the way of the sphere
// in the window is shorter than they are. Where that is shorter than the sphere, steps from below look for a
// contact.
class TrajectorySearch {
 public:
  TrajectorySearch(const Robot& robot, const JointTrajectory& trajectory, const Obstacles& obstacles)
      : robot_(robot),
        trajectory_(trajectory),
        obstacles_(obstacles),
        kinematics_(robot, trajectory),
        states_(robot.sphere_count() + robot.bodies().size()),
        left_(kMostHalvings + 1) {
    list_candidates();
  }

  std::optional<RobotContact> first_contact(double clearance) {
    clearance_ = clearance;
    most_halvings_ = kMostHalvings;
    for (std::size_t piece = 0; piece < trajectory_.piece_count(); ++piece) {
      search_piece(piece);
      if (best_.time < kForever) return described();
    }
    return std::nullopt;
  }

  std::optional<RobotContact> least_clearance(double tolerance) {
    seeks_least_ = true;
    tolerance_ = tolerance;
    best_.distance = kForever;
    // First coarsely: what is found makes the second search short.
    constexpr std::size_t kFewHalvings = 3;
    std::size_t best_piece = 0;
    for (const std::size_t halvings : {kFewHalvings, kMostHalvings}) {
      most_halvings_ = halvings;
      for (std::size_t piece = 0; piece < trajectory_.piece_count(); ++piece) {
        const double before = best_.distance;
        search_piece(piece);
        if (best_.distance < before) best_piece = piece;
      }
    }
    if (best_.distance == kForever) return std::nullopt;
    enter_piece(best_piece);
    return described();
  }

 private:
  static constexpr std::size_t kMostHalvings = 48;

  // A sphere in the present window.
  struct SphereState {
    Vec3 position;
    Vec3 velocity;
    MotionBounds bounds;
    double sweep = 0;  // how far it moves from its place in the middle
    bool is_ready = false;
    std::size_t window = 0;
  };

  void list_candidates() {
    const std::vector<std::uint32_t> roots = obstacles_.roots();
    const auto count = static_cast<std::uint32_t>(robot_.sphere_count());
    for (std::uint32_t sphere = 0; sphere < count; ++sphere) {
      for (const std::uint32_t root : roots) all_.push_back({sphere, root, Target::node});
      if (robot_.spheres()[sphere].body == 0) continue;
      for (const std::uint32_t item : obstacles_.unbounded()) all_.push_back({sphere, item, Target::item});
    }
    const auto groups = static_cast<std::uint32_t>(robot_.pair_groups().size());
    for (std::uint32_t group = 0; group < groups; ++group)
      all_.push_back({robot_.pair_groups()[group].sphere, group, Target::group});
  }

  void enter_piece(std::size_t piece) {
    piece_ = piece;
    kinematics_.enter_piece(piece);
    piece_begin_ = trajectory_.times()[piece];
    piece_length_ = trajectory_.times()[piece + 1] - piece_begin_;
  }

  void search_piece(std::size_t piece) {
    enter_piece(piece);
    search(0, piece_length_, 0, all_);
  }

  void search(double begin, double end, std::size_t halvings, const std::vector<Candidate>& candidates) {
    if (!seeks_least_ && begin > best_.time) return;
    const double middle = begin + 0.5 * (end - begin);
    if (halvings > most_halvings_ || (halvings > 0 && !(middle > begin && middle < end))) return;
    begin_ = begin;
    end_ = end;
    middle_ = middle;
    half_ = kRoundedUp * 0.5 * (end - begin);
    halvings_ = halvings;
    ++window_;
    kinematics_.enter_window(begin, end);
    std::vector<Candidate>& left = left_[halvings];
    left.clear();
    for (const Candidate& candidate : candidates) {
      switch (candidate.target) {
        case Target::node:
          pass_node(candidate, left);
          break;
        case Target::item:
          pass_item(candidate, left);
          break;
        case Target::group:
          pass_group(candidate, left);
          break;
        case Target::sphere:
          pass_pair(candidate, left);
          break;
      }
    }
    if (left.empty()) return;
    search(begin, middle, halvings + 1, left);
    search(middle, end, halvings + 1, left);
  }

  // Of a sphere, or after all spheres of the hull of a body.
  const SphereState& state_of(std::uint32_t number) {
    SphereState& state = states_[number];
    if (state.window == window_) return state;
    const std::size_t spheres = robot_.sphere_count();
    const Robot::BodySphere& body_sphere =
        number < spheres ? robot_.spheres()[number] : robot_.hulls()[number - spheres];
    kinematics_.state_of(body_sphere, state.position, state.velocity);
    state.bounds = kinematics_.bounds_of(body_sphere, 0);
    state.sweep = sweep(state.bounds, length(state.velocity));
    state.is_ready = is_ready(state.bounds, body_sphere.radius);
    state.window = window_;
    return state;
  }

  // How far something moves from the middle of the window to its ends, if that is its speed in the middle.
  double sweep(const MotionBounds& bounds, double speed) const {
    const double straight = speed * half_;
    return kRoundedUp * std::min(bounds.speed * half_, straight + 0.5 * bounds.acceleration * half_ * half_);
  }
  // Whether steps from below pay, a function of the motion of one center alone.
  bool is_ready(const MotionBounds& bounds, double radius) const {
    return bounds.speed * half_ <= kReadySweep * (radius + clearance_) || halvings_ >= kMostHalvingsToReady;
  }
  // Up to this distance a contact in the window is of interest.
  double reach() const { return seeks_least_ ? best_.distance - tolerance_ : 0; }

  void pass_node(const Candidate& candidate, std::vector<Candidate>& left) {
    const SphereState& state = state_of(candidate.sphere);
    const Obstacles::Node& node = obstacles_.node(candidate.other);
    const bool is_at_rest = robot_.spheres()[candidate.sphere].body == 0;
    if (is_at_rest && node.speed == 0) return;
    const double age = std::fabs(piece_begin_ - obstacles_.reference_time() + middle_) + half_;
    const double margin = robot_.radius(candidate.sphere) + clearance_ + state.sweep +
                          (node.speed > 0 ? kRoundedUp * node.speed * age : 0) + reach();
    double square = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double apart = std::max(
          {node.extent.low[axis] - state.position[axis], state.position[axis] - node.extent.high[axis], 0.0});
      square += apart * apart;
    }
    if (square > margin * std::fabs(margin) || margin < 0) return;
    if (node.is_leaf) {
      pass_item({candidate.sphere, node.right_or_item, Target::item}, left);
    } else if (state.is_ready || node.size > state.sweep) {
      pass_node({candidate.sphere, candidate.other + 1, Target::node}, left);
      pass_node({candidate.sphere, node.right_or_item, Target::node}, left);
    } else {
      left.push_back(candidate);
    }
  }

  void pass_item(const Candidate& candidate, std::vector<Candidate>& left) {
    const SphereState& state = state_of(candidate.sphere);
    const Obstacles::Item& item = obstacles_.item(candidate.other);
    Vec3 velocity = state.velocity;
    MotionBounds bounds = state.bounds;
    if (const auto* const ball = std::get_if<Obstacles::Ball>(&item.shape)) {
      if (robot_.spheres()[candidate.sphere].body == 0 && ball->velocity == Vec3{}) return;
      velocity -= ball->velocity;
      bounds.speed += length(ball->velocity);
    } else if (robot_.spheres()[candidate.sphere].body == 0) {
      return;
    }
    const NearestOfShape nearest = nearest_of(item.shape, state.position, piece_begin_ + middle_);
    const double gap = nearest.distance - (robot_.radius(candidate.sphere) + clearance_);
    const bool is_within = nearest.normal == Vec3{};
    const double rate = is_within ? bounds.speed : std::fabs(dot(nearest.normal, velocity));
    if (seeks_least_) note_least({middle_, candidate.sphere, false, item.obstacle, gap, candidate.other});
    // Within a shape that has no depth the distance is the least already.
    if (seeks_least_ && is_within) return;
    if (gap - sweep(bounds, rate) > reach()) return;
    if (!seeks_least_ && state.is_ready) {
      step_to_item(candidate.sphere, item, candidate.other, bounds);
    } else {
      left.push_back(candidate);
    }
  }

  // How two spheres of the robot lie and move to each other in the window.
  struct OwnPair {
    double gap = 0;
    MotionBounds bounds;
    double sweep = 0;
  };
  OwnPair own_pair(const Robot::BodySphere& first, const SphereState& a, const Robot::BodySphere& second,
                   const SphereState& b, std::size_t ancestor) {
    const MotionBounds of_first = kinematics_.bounds_of(first, ancestor);
    const MotionBounds of_second = kinematics_.bounds_of(second, ancestor);
    OwnPair pair;
    pair.bounds = {of_first.speed + of_second.speed, of_first.acceleration + of_second.acceleration,
                   of_first.jerk + of_second.jerk};
    const Vec3 apart = a.position - b.position;
    const double distance = length(apart);
    pair.gap = distance - (first.radius + second.radius + clearance_);
    const double rate =
        distance > 0 ? std::fabs(dot(apart, a.velocity - b.velocity)) / distance : pair.bounds.speed;
    pair.sweep = sweep(pair.bounds, rate);
    return pair;
  }

  void pass_group(const Candidate& candidate, std::vector<Candidate>& left) {
    const Robot::PairGroup& group = robot_.pair_groups()[candidate.other];
    const Robot::BodySphere& first = robot_.spheres()[group.sphere];
    const Robot::BodySphere& hull = robot_.hulls()[group.body];
    const auto hull_number = static_cast<std::uint32_t>(robot_.sphere_count()) + group.body;
    const OwnPair pair = own_pair(first, state_of(group.sphere), hull, state_of(hull_number), group.ancestor);
    if (pair.gap - pair.sweep > reach()) return;
    if (hull.radius > pair.bounds.speed * half_ || is_ready(pair.bounds, first.radius)) {
      for (std::uint32_t number = group.begin; number < group.end; ++number)
        pass_pair({group.sphere, number, Target::sphere}, left);
    } else {
      left.push_back(candidate);
    }
  }

  void pass_pair(const Candidate& candidate, std::vector<Candidate>& left) {
    const Robot::SpherePair& numbers = robot_.pairs()[candidate.other];
    const Robot::BodySphere& first = robot_.spheres()[numbers.first];
    const Robot::BodySphere& second = robot_.spheres()[numbers.second];
    const OwnPair pair =
        own_pair(first, state_of(numbers.first), second, state_of(numbers.second), numbers.ancestor);
    if (seeks_least_) note_least({middle_, numbers.first, true, numbers.second, pair.gap, 0});
    if (pair.gap - pair.sweep > reach()) return;
    if (!seeks_least_ && is_ready(pair.bounds, std::min(first.radius, second.radius))) {
      step_to_sphere(numbers, pair.bounds);
    } else {
      left.push_back(candidate);
    }
  }

  void note_least(const Found& found) {
    if (found.distance < best_.distance) best_ = found;
  }

  // The first time in the window, and not after the best, at which the gap is not positive; gap_at(time,
  // rest) gives the gap, and how long a step is safe, given the rest of the window.
  template <class StepAt>
  void step(Found found, StepAt&& step_at) {
    constexpr double kShortened = 1 - 1e-12;
    // Shorter steps do not change the time of the trajectory.
    const double shortest = 0x1p-54 * piece_length_;
    double time = begin_;
    const double end = std::min(end_, best_.time);
    while (time <= end) {
      double safe = 0;
      if (step_at(time, end - time, safe)) {
        found.time = time;
        if (found.is_before(best_)) best_ = found;
        return;
      }
      HARDBALL_CHECK(safe >= 0);
      const double next = time + std::max(shortest, kShortened * safe);
      time = next > time ? next : std::nextafter(time, kForever);
    }
  }

  // A step of the squared distance of two centers, less that at which they touch.
  static bool step_of_squares(const CenterMotion& apart, double radii, const MotionBounds& bounds,
                              double rest, double& safe) {
    const auto& [d, v, a] = apart;
    const double square = dot(d, d);
    const double width = square - radii * radii;
    if (width <= 0) return true;
    const double farthest = kRoundedUp * (std::sqrt(square) + bounds.speed * rest);
    const double most = 2 * bounds.acceleration * farthest;
    const double third = 2 * (3 * bounds.speed * bounds.acceleration + farthest * bounds.jerk);
    safe = safe_step_of_smooth_gap(width, 2 * dot(d, v), 2 * (dot(v, v) + dot(d, a)), kRoundedUp * most,
                                   kRoundedUp * third, rest);
    return false;
  }

  void step_to_item(std::uint32_t sphere, const Obstacles::Item& item, std::uint32_t number,
                    const MotionBounds& bounds) {
    const Robot::BodySphere& center = robot_.spheres()[sphere];
    const double radius = center.radius + clearance_;
    const Found found{kForever, sphere, false, item.obstacle, 0, number};
    if (const auto* const ball = std::get_if<Obstacles::Ball>(&item.shape)) {
      step(found, [&](double time, double rest, double& safe) {
        CenterMotion motion = kinematics_.motion_of(center, 0, time);
        const double age = (piece_begin_ - ball->time) + time;
        motion.position -= ball->center + age * ball->velocity;
        motion.velocity -= ball->velocity;
        return step_of_squares(motion, radius + ball->radius, bounds, rest, safe);
      });
      return;
    }
    // The plane across the normal at the nearest point parts the center from all of a convex shape.
    step(found, [&](double time, double rest, double& safe) {
      const CenterMotion motion = kinematics_.motion_of(center, 0, time);
      const NearestOfShape nearest = nearest_of(item.shape, motion.position, piece_begin_ + time);
      const double width = nearest.distance - radius;
      if (width <= 0) return true;
      safe = safe_step_of_smooth_gap(width, dot(nearest.normal, motion.velocity),
                                     dot(nearest.normal, motion.acceleration), bounds.acceleration,
                                     bounds.jerk, rest);
      return false;
    });
  }

  void step_to_sphere(const Robot::SpherePair& pair, const MotionBounds& bounds) {
    const Robot::BodySphere& first = robot_.spheres()[pair.first];
    const Robot::BodySphere& second = robot_.spheres()[pair.second];
    const double radii = first.radius + second.radius + clearance_;
    const Found found{kForever, pair.first, true, pair.second, 0, 0};
    step(found, [&](double time, double rest, double& safe) {
      CenterMotion motion = kinematics_.motion_of(first, pair.ancestor, time);
      const CenterMotion other = kinematics_.motion_of(second, pair.ancestor, time);
      motion.position -= other.position;
      motion.velocity -= other.velocity;
      motion.acceleration -= other.acceleration;
      return step_of_squares(motion, radii, bounds, rest, safe);
    });
  }

  // The best contact of the present piece, for users.
  RobotContact described() const {
    RobotContact contact;
    contact.time = std::min(piece_begin_ + best_.time, trajectory_.times()[piece_ + 1]);
    contact.sphere = best_.sphere;
    const Robot::BodySphere& sphere = robot_.spheres()[best_.sphere];
    const Vec3 center = kinematics_.motion_of(sphere, 0, best_.time).position;
    if (best_.is_own) {
      contact.other_sphere = best_.other;
      const Robot::BodySphere& other = robot_.spheres()[best_.other];
      const Vec3 place = kinematics_.motion_of(other, 0, best_.time).position;
      const Vec3 apart = center - place;
      const double distance = length(apart);
      if (distance > 0) contact.normal = (1 / distance) * apart;
      contact.distance = distance - sphere.radius - other.radius;
      contact.point = place + other.radius * contact.normal;
    } else {
      contact.obstacle = best_.other;
      const NearestOfShape nearest =
          nearest_of(obstacles_.item(best_.item).shape, center, piece_begin_ + best_.time);
      contact.normal = nearest.normal;
      contact.distance = nearest.distance - sphere.radius;
      contact.point = center - nearest.distance * nearest.normal;
    }
    return contact;
  }

  // Halvings that leave a way shorter than this, in radii, are enough.
  static constexpr double kReadySweep = 0.5;
  static constexpr std::size_t kMostHalvingsToReady = 16;

  const Robot& robot_;
  const JointTrajectory& trajectory_;
  const Obstacles& obstacles_;
  Kinematics kinematics_;
  double clearance_ = 0;
  bool seeks_least_ = false;
  double tolerance_ = 0;
  std::size_t most_halvings_ = 0;
  std::vector<Candidate> all_;
  std::vector<SphereState> states_;
  std::vector<std::vector<Candidate>> left_;  // by the number of halvings
  Found best_;
  // The present piece and window.
  std::size_t piece_ = 0;
  double piece_begin_ = 0;
  double piece_length_ = 0;
  double begin_ = 0;
  double end_ = 0;
  double middle_ = 0;
  double half_ = 0;
  std::size_t halvings_ = 0;
  std::size_t window_ = 0;
};

void check(const Robot& robot, const JointTrajectory& trajectory, const char* where) {
  if (trajectory.joint_count() == robot.joint_count()) return;
  throw Error("the trajectory is of " + to_text(trajectory.joint_count()) + " joints", where,
              "give one of the robot, of which " + to_text(robot.joint_count()) + " move");
}

void check_clearance(const Robot& robot, double clearance, const char* where) {
  check_finite(clearance, "the clearance", where);
  for (std::size_t sphere = 0; sphere < robot.sphere_count(); ++sphere) {
    if (robot.radius(sphere) + clearance > 0) continue;
    throw Error("the clearance is " + to_text(clearance), where,
                "give more than minus the least radius, " + to_text(robot.radius(sphere)));
  }
}

void check_tolerance(double tolerance, const char* where) {
  check_positive(tolerance, "the tolerance", where);
}

// As many as there are processors, if zero.
std::size_t threads_of(std::size_t threads) {
  return threads > 0 ? threads : std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

}  // namespace

std::optional<RobotContact> first_contact(const Robot& robot, const JointTrajectory& trajectory,
                                          const Obstacles& obstacles, double clearance) {
  check(robot, trajectory, "first_contact");
  check_clearance(robot, clearance, "first_contact");
  return TrajectorySearch(robot, trajectory, obstacles).first_contact(clearance);
}

std::vector<std::optional<RobotContact>> first_contacts(const Robot& robot,
                                                        std::span<const JointTrajectory> trajectories,
                                                        const Obstacles& obstacles, double clearance,
                                                        std::size_t threads) {
  for (const JointTrajectory& trajectory : trajectories) check(robot, trajectory, "first_contacts");
  check_clearance(robot, clearance, "first_contacts");
  std::vector<std::optional<RobotContact>> contacts(trajectories.size());
  share_work(trajectories.size(), threads_of(threads), [&](std::size_t k) {
    contacts[k] = TrajectorySearch(robot, trajectories[k], obstacles).first_contact(clearance);
  });
  return contacts;
}

std::optional<RobotContact> least_clearance(const Robot& robot, const JointTrajectory& trajectory,
                                            const Obstacles& obstacles, double tolerance) {
  check(robot, trajectory, "least_clearance");
  check_tolerance(tolerance, "least_clearance");
  return TrajectorySearch(robot, trajectory, obstacles).least_clearance(tolerance);
}

std::vector<std::optional<RobotContact>> least_clearances(const Robot& robot,
                                                          std::span<const JointTrajectory> trajectories,
                                                          const Obstacles& obstacles, double tolerance,
                                                          std::size_t threads) {
  for (const JointTrajectory& trajectory : trajectories) check(robot, trajectory, "least_clearances");
  check_tolerance(tolerance, "least_clearances");
  std::vector<std::optional<RobotContact>> nearest(trajectories.size());
  share_work(trajectories.size(), threads_of(threads), [&](std::size_t k) {
    nearest[k] = TrajectorySearch(robot, trajectories[k], obstacles).least_clearance(tolerance);
  });
  return nearest;
}

}  // namespace hardball
