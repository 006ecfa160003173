// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/rotation_matrix.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A sphere that is fixed in a link of a robot.
struct LinkSphere {
  Vec3 center;        ///< In the frame of the link [L].
  double radius = 0;  ///< [L]
};

/// A link of a robot: a rigid body, whose surface is that of spheres.
struct Link {
  std::string name;
  std::vector<LinkSphere> spheres = {};
};

/// How a joint lets its child move.
enum class JointKind : std::uint8_t {
  fixed,      ///< The child does not move.
  revolute,   ///< The child turns about the axis, by an angle in radians.
  prismatic,  ///< The child slides along the axis, by a length [L].
};

/// A joint between two links of a robot.
struct Joint {
  std::string name;
  JointKind kind = JointKind::revolute;
  std::string parent;            ///< The name of the link that carries the joint.
  std::string child;             ///< The name of the link that the joint moves.
  Vec3 origin = {};              ///< Where the child's frame has its origin, in the parent's frame [L].
  RotationMatrix rotation = {};  ///< Turns the child's frame in the parent's, where the joint is at zero.
  Vec3 axis{0, 0, 1};            ///< In the child's frame; a vector of any length but zero.
  /// The coordinate that the joint keeps, an angle or a length [L]; without one it moves.
  std::optional<double> locked = std::nullopt;

  /// Whether the trajectory says where it is.
  bool moves() const { return kind != JointKind::fixed && !locked; }
};

/// A robot: links that joints make a tree, and whose surfaces are spheres.
///
/// Spheres are numbered through all links, in their order. The joints that move have coordinates, an angle or
/// a length for each, in the order of the joints. The first link of the tree is at rest, and its frame is
/// that of the world.
///
/// Two links meet if at least two joints that move lie between them, and their pair is not ignored. Links
/// that no joint moves do not meet what is at rest.
class HARDBALL_EXPORT Robot {
 public:
  /// A robot from its links and joints; links that only joints name have no spheres. `ignored` are pairs of
  /// names of links that do not meet each other. Error: two links or joints of one name; links that are not
  /// one tree; a radius that is not positive; a number that is not finite; an axis of length zero; a rotation
  /// that is none; an ignored link that does not exist. Cost: O(spheres^2).
  static Robot from_spheres(const std::vector<Link>& links, const std::vector<Joint>& joints,
                            const std::vector<std::pair<std::string, std::string>>& ignored = {});

  /// The number of spheres.
  std::size_t sphere_count() const { return spheres_.size(); }
  /// The number of joints that move.
  std::size_t joint_count() const { return joint_names_.size(); }
  /// The names of the joints that move, in the order of their coordinates.
  std::span<const std::string> joint_names() const { return joint_names_; }
  /// The names of all links, in their order, and then of those that only joints name.
  std::span<const std::string> link_names() const { return link_names_; }
  /// The number of the link that has a sphere. Precondition: there is such a sphere.
  std::size_t link_of(std::size_t sphere) const { return link_of_[sphere]; }
  /// The radius of a sphere [L]. Precondition: there is such a sphere.
  double radius(std::size_t sphere) const { return spheres_[sphere].radius; }
  /// The centers of all spheres where the joints have these coordinates [L]. Error: there are more or fewer
  /// than joints that move; one is not finite.
  std::vector<Vec3> centers(std::span<const double> coordinates) const;

  /// What moves as one: the world, which is the first, or a joint that moves and all links that it carries.
  /// Its frame has the axis of the joint as z.
  struct Body {
    std::size_t parent = 0;   ///< Comes before its children; the world is its own.
    std::size_t joint = 0;    ///< Number of the coordinate.
    bool turns = false;       ///< Whether it turns; otherwise it slides.
    Vec3 origin;              ///< In the parent's frame, where the joint is at zero [L].
    RotationMatrix rotation;  ///< Into the parent's frame, where the joint is at zero.
    double distance = 0;      ///< From the origin of the parent [L].
  };
  /// A sphere of a body.
  struct BodySphere {
    std::size_t body = 0;
    Vec3 center;          ///< In the body's frame [L].
    double distance = 0;  ///< From the origin to the center [L].
    double radius = 0;    ///< [L]
  };
  /// Two spheres that may meet.
  struct SpherePair {
    std::uint32_t first = 0;  ///< Lower than `second`.
    std::uint32_t second = 0;
    std::uint32_t ancestor = 0;  ///< The last body that carries both.
  };
  /// The pairs of one sphere with those of a body, which follow each other.
  struct PairGroup {
    std::uint32_t sphere = 0;
    std::uint32_t body = 0;
    std::uint32_t ancestor = 0;
    std::uint32_t begin = 0;  ///< The first pair.
    std::uint32_t end = 0;    ///< After the last.
  };
  /// The bodies, parents first.
  std::span<const Body> bodies() const { return bodies_; }
  /// The spheres, by their numbers.
  std::span<const BodySphere> spheres() const { return spheres_; }
  /// The pairs of spheres that may meet, in the order of their numbers.
  std::span<const SpherePair> pairs() const { return pairs_; }
  /// The groups of all pairs.
  std::span<const PairGroup> pair_groups() const { return pair_groups_; }
  /// A sphere of each body that holds all others.
  std::span<const BodySphere> hulls() const { return hulls_; }

 private:
  Robot() = default;
  void find_hulls();
  void list_pairs(const std::set<std::pair<std::size_t, std::size_t>>& ignored);

  std::vector<std::string> link_names_;
  std::vector<std::string> joint_names_;
  std::vector<std::size_t> link_of_;
  std::vector<Body> bodies_;
  std::vector<BodySphere> spheres_;
  std::vector<SpherePair> pairs_;
  std::vector<PairGroup> pair_groups_;
  std::vector<BodySphere> hulls_;
};

}  // namespace hardball
