// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/robot.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
namespace {

// Where the frame of a link lies in that of its body.
struct Pose {
  std::size_t body = 0;
  Vec3 origin;
  RotationMatrix rotation;
};

std::string quoted(const std::string& name) {
  return "'" + shortened(name) + "'";
}

void check_vector(const Vec3& vector, const char* name, const std::string& where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(vector[axis], name, where);
}

// The numbers of the links by their names, and after them those of links that only joints name. Error: two
// have one name; a sphere is none.
std::map<std::string, std::size_t> numbers_of(const std::vector<Link>& links,
                                              const std::vector<Joint>& joints) {
  std::map<std::string, std::size_t> numbers;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const std::string where = "link " + quoted(links[k].name);
    if (!numbers.emplace(links[k].name, k).second)
      throw Error("there are two links of one name", where, "give each link a name of its own");
    for (const LinkSphere& sphere : links[k].spheres) {
      check_vector(sphere.center, "a center", where);
      check_positive(sphere.radius, "a radius", where);
    }
  }
  for (const Joint& joint : joints) {
    for (const std::string& end : {joint.parent, joint.child}) numbers.emplace(end, numbers.size());
  }
  if (numbers.empty()) throw Error("there are no links", "links", "give at least one");
  return numbers;
}

void check(const Joint& joint, const std::string& where) {
  check_vector(joint.origin, "the origin", where);
  check_vector(joint.axis, "the axis", where);
  if (joint.kind != JointKind::fixed && !(length(joint.axis) > 0))
    throw Error("the axis is a vector of length zero", where, "give a direction, such as (0, 0, 1)");
  if (joint.locked) check_finite(*joint.locked, "the coordinate", where);
  if (!joint.rotation.is_sound())
    throw Error("the rotation is none", where, "give three unit vectors at right angles, right-handed");
}

// The joint that carries each link; none carries the root.
std::vector<const Joint*> carriers_of(const std::vector<Joint>& joints,
                                      const std::map<std::string, std::size_t>& numbers) {
  std::vector<const Joint*> carriers(numbers.size());
  std::set<std::string> names;
  for (const Joint& joint : joints) {
    const std::string where = "joint " + quoted(joint.name);
    if (!names.insert(joint.name).second)
      throw Error("there are two joints of one name", where, "give each joint a name of its own");
    check(joint, where);
    const Joint*& carrier = carriers[numbers.at(joint.child)];
    if (carrier != nullptr) {
      throw Error(
          "it carries the link " + quoted(joint.child) + ", as the joint " + quoted(carrier->name) + " does",
          where, "let one joint carry each link");
    }
    carrier = &joint;
  }
  return carriers;
}

Pose placed(const Pose& frame, const Vec3& origin, const RotationMatrix& rotation) {
  return {frame.body, frame.origin + frame.rotation.turned(origin), frame.rotation * rotation};
}

// The frame of a child whose joint keeps its coordinate.
Pose locked(const Pose& at_zero, const Joint& joint) {
  const Vec3 direction = (1 / length(joint.axis)) * joint.axis;
  if (joint.kind == JointKind::prismatic) return placed(at_zero, *joint.locked * direction, {});
  const auto [sine, cosine] = sine_cosine(*joint.locked);
  const RotationMatrix axis = RotationMatrix::of_z_into(direction);
  const RotationMatrix about_z{{cosine, sine, 0}, {-sine, cosine, 0}, {0, 0, 1}};
  return placed(at_zero, {}, axis * (about_z * axis.inverse()));
}

}  // namespace

Robot Robot::from_spheres(const std::vector<Link>& links, const std::vector<Joint>& joints,
                          const std::vector<std::pair<std::string, std::string>>& ignored) {
  const std::map<std::string, std::size_t> numbers = numbers_of(links, joints);
  const std::vector<const Joint*> carriers = carriers_of(joints, numbers);
  Robot robot;
  robot.link_names_.resize(numbers.size());
  for (const auto& [name, number] : numbers) robot.link_names_[number] = name;
  std::map<std::string, std::size_t> coordinates;
  for (const Joint& joint : joints) {
    if (!joint.moves()) continue;
    coordinates.emplace(joint.name, robot.joint_names_.size());
    robot.joint_names_.push_back(joint.name);
  }

  // From the root on, a joint is passed as soon as its parent has a place.
  std::vector<std::optional<Pose>> poses(numbers.size());
  const std::size_t root =
      static_cast<std::size_t>(std::find(carriers.begin(), carriers.end(), nullptr) - carriers.begin());
  if (root == numbers.size())
    throw Error("the links form a circle", "joints", "let one link be carried by none");
  poses[root] = Pose{};
  robot.bodies_.push_back({});
  bool is_growing = true;
  while (is_growing) {
    is_growing = false;
    for (const Joint& joint : joints) {
      const std::optional<Pose>& parent = poses[numbers.at(joint.parent)];
      std::optional<Pose>& child = poses[numbers.at(joint.child)];
      if (!parent || child) continue;
      is_growing = true;
      const Pose at_zero = placed(*parent, joint.origin, joint.rotation);
      if (!joint.moves()) {
        child = joint.kind == JointKind::fixed ? at_zero : locked(at_zero, joint);
        continue;
      }
      const RotationMatrix axis = RotationMatrix::of_z_into((1 / length(joint.axis)) * joint.axis);
      child = Pose{robot.bodies_.size(), {}, axis.inverse()};
      robot.bodies_.push_back({.parent = at_zero.body,
                               .joint = coordinates.at(joint.name),
                               .turns = joint.kind == JointKind::revolute,
                               .origin = at_zero.origin,
                               .rotation = at_zero.rotation * axis,
                               .distance = length(at_zero.origin)});
    }
  }
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (poses[k]) continue;
    throw Error("it is not connected with the link " + quoted(robot.link_names_[root]),
                "link " + quoted(robot.link_names_[k]), "join all links to one tree");
  }

  for (std::size_t k = 0; k < links.size(); ++k) {
    for (const LinkSphere& sphere : links[k].spheres) {
      const Vec3 center = poses[k]->origin + poses[k]->rotation.turned(sphere.center);
      robot.spheres_.push_back({poses[k]->body, center, length(center), sphere.radius});
      robot.link_of_.push_back(k);
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> apart;
  for (const auto& [first, second] : ignored) {
    for (const std::string& name : {first, second}) {
      if (!numbers.contains(name))
        throw Error("there is no link " + quoted(name), "ignored", "name one of the links");
    }
    apart.emplace(numbers.at(first), numbers.at(second));
    apart.emplace(numbers.at(second), numbers.at(first));
  }
  robot.find_hulls();
  robot.list_pairs(apart);
  return robot;
}

// Around the middle of the centers' extent.
void Robot::find_hulls() {
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Vec3 low{kFar, kFar, kFar};
    Vec3 high{-kFar, -kFar, -kFar};
    for (const BodySphere& sphere : spheres_) {
      if (sphere.body != body) continue;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        low[axis] = std::min(low[axis], sphere.center[axis]);
        high[axis] = std::max(high[axis], sphere.center[axis]);
      }
    }
    BodySphere hull{body, {}, 0, 0};
    if (low.x <= high.x) hull.center = low + 0.5 * (high - low);
    hull.distance = length(hull.center);
    constexpr double kRoundedUp = 1 + 0x1p-40;
    for (const BodySphere& sphere : spheres_) {
      if (sphere.body != body) continue;
      hull.radius = std::max(hull.radius, kRoundedUp * (length(sphere.center - hull.center) + sphere.radius));
    }
    hulls_.push_back(hull);
  }
}

void Robot::list_pairs(const std::set<std::pair<std::size_t, std::size_t>>& ignored) {
  // The last body that carries two, if at least two joints lie between them.
  const auto ancestor_of = [&](std::size_t a, std::size_t b) -> std::optional<std::size_t> {
    std::size_t joints = 0;
    while (a != b) {
      std::size_t& later = a > b ? a : b;
      later = bodies_[later].parent;
      ++joints;
    }
    return joints < 2 ? std::nullopt : std::optional(a);
  };
  const std::size_t count = bodies_.size();
  std::vector<std::optional<std::size_t>> ancestors(count * count);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) ancestors[a * count + b] = ancestor_of(a, b);
  }
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    for (std::size_t j = i + 1; j < spheres_.size(); ++j) {
      const auto ancestor = ancestors[spheres_[i].body * count + spheres_[j].body];
      if (!ancestor || ignored.contains({link_of_[i], link_of_[j]})) continue;
      const auto number = static_cast<std::uint32_t>(pairs_.size());
      const auto sphere = static_cast<std::uint32_t>(i);
      const auto body = static_cast<std::uint32_t>(spheres_[j].body);
      const auto carrier = static_cast<std::uint32_t>(*ancestor);
      if (pair_groups_.empty() || pair_groups_.back().sphere != sphere || pair_groups_.back().body != body)
        pair_groups_.push_back({sphere, body, carrier, number, number});
      pairs_.push_back({sphere, static_cast<std::uint32_t>(j), carrier});
      pair_groups_.back().end = number + 1;
    }
  }
}

std::vector<Vec3> Robot::centers(std::span<const double> coordinates) const {
  if (coordinates.size() != joint_count()) {
    throw Error("there are " + to_text(coordinates.size()) + " coordinates", "centers",
                "give " + to_text(joint_count()) + ", one for each joint that moves");
  }
  for (const double coordinate : coordinates) check_finite(coordinate, "a coordinate", "centers");
  std::vector<Vec3> places;
  places.reserve(spheres_.size());
  for (const BodySphere& sphere : spheres_) {
    Vec3 place = sphere.center;
    for (std::size_t body = sphere.body; body != 0; body = bodies_[body].parent) {
      const Body& its = bodies_[body];
      const double coordinate = coordinates[its.joint];
      if (its.turns) {
        const auto [sine, cosine] = sine_cosine(coordinate);
        place = {cosine * place.x - sine * place.y, sine * place.x + cosine * place.y, place.z};
      } else {
        place.z += coordinate;
      }
      place = its.origin + its.rotation.turned(place);
    }
    places.push_back(place);
  }
  return places;
}

}  // namespace hardball
