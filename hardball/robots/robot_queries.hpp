// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/robots/joint_trajectory.hpp"
#include "hardball/robots/obstacles.hpp"
#include "hardball/robots/robot.hpp"

namespace hardball {

/// Where a robot touches an obstacle, or itself, or is nearest to one.
struct RobotContact {
  double time = 0;                          ///< [T]
  std::size_t sphere = 0;                   ///< The sphere of the robot.
  std::optional<std::size_t> obstacle;      ///< The obstacle; none if the robot meets itself.
  std::optional<std::size_t> other_sphere;  ///< The other sphere of the robot, if it meets itself.
  double distance = 0;                      ///< Between both surfaces; negative where they overlap [L].
  Vec3 point;                               ///< The point of the other surface that is nearest [L].
  Vec3 normal;  ///< The unit vector from there to the sphere [1]; zero if its center is within the other.

  friend bool operator==(const RobotContact&, const RobotContact&) = default;
};

/// The first time at which a robot on a trajectory comes as near to an obstacle, or to itself, as `clearance`
/// [L]; nothing if it never does. By default, the first contact. Of simultaneous contacts, that of the lowest
/// sphere comes first, then obstacles by their numbers, then other spheres.
///
/// It goes along the trajectory in steps that cannot pass a contact, so none is missed that is deeper than
/// some 1e-15 of the coordinates; what is shallower is decided by rounding, on every machine in the same way.
/// The time is exact to a few units in the last place, where the contact is not a graze.
///
/// Error: the trajectory has not the joints of the robot; a clearance that is not finite, or not greater than
/// minus the least radius. Cost: some ms for 200 spheres, 40 obstacles and seven seconds.
HARDBALL_EXPORT std::optional<RobotContact> first_contact(const Robot& robot,
                                                          const JointTrajectory& trajectory,
                                                          const Obstacles& obstacles, double clearance = 0);

/// first_contact of each of many trajectories. As many threads as given share them, or with zero as many as
/// there are processors; results do not depend on their number.
HARDBALL_EXPORT std::vector<std::optional<RobotContact>> first_contacts(
    const Robot& robot, std::span<const JointTrajectory> trajectories, const Obstacles& obstacles,
    double clearance = 0, std::size_t threads = 0);

/// The least distance of a robot on a trajectory from an obstacle, or from itself, and where it is found;
/// nothing if there is neither. The true least distance is less by at most `tolerance` [L]. Where the center
/// of a sphere is within a box or another obstacle that is not a sphere or a half-space, the distance is
/// minus the radius.
///
/// Error: the trajectory has not the joints of the robot; a tolerance that is not positive. Cost: a few times
/// that of first_contact; where the least distance hardly changes, more, as the inverse square root of the
/// tolerance.
HARDBALL_EXPORT std::optional<RobotContact> least_clearance(const Robot& robot,
                                                            const JointTrajectory& trajectory,
                                                            const Obstacles& obstacles,
                                                            double tolerance = 1e-9);

/// least_clearance of each of many trajectories, shared by threads as first_contacts shares them.
HARDBALL_EXPORT std::vector<std::optional<RobotContact>> least_clearances(
    const Robot& robot, std::span<const JointTrajectory> trajectories, const Obstacles& obstacles,
    double tolerance = 1e-9, std::size_t threads = 0);

}  // namespace hardball
