// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/extent_tree.hpp"
#include "hardball/geometry/growth.hpp"
#include "hardball/geometry/motion.hpp"
#include "hardball/interaction/interactions.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/box.hpp"
#include "hardball/world/features.hpp"

namespace hardball {

/// How much closer to a wall than its radius a center may lie through rounding alone, relative to the box.
inline constexpr double kWallTolerance = 1e-12;

/// What surrounds spheres and acts on them: the box, surfaces, gravity or growth, and what happens at
/// contacts. A world is a setting and the spheres in it.
class HARDBALL_EXPORT Setting {
 public:
  explicit Setting(const Box& box = Box::open());
  /// `gravity` is the acceleration of all spheres [L/T^2]; `surfaces` are numbered from kFaces on. Error:
  /// gravity is not finite or out of range; two features exclude each other; a surface that is not the same
  /// in every periodic image of the box, and is no obstacle; a plane that no sphere can reach, as faces of
  /// the box are in front of it; in two dimensions, gravity or a surface out of the plane.
  Setting(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces);

  const Box& box() const { return box_; }
  const Motion& motion() const { return motion_; }
  std::span<const Surface> surfaces() const { return surfaces_; }
  /// The surface of a wall event. Precondition: `number` is not that of a face of the box.
  const Surface& surface(std::uint32_t number) const { return surfaces_[number - kFaces]; }
  /// The obstacles at rest, by their numbers.
  const ExtentTree& obstacles() const { return obstacles_; }
  /// The numbers of the meshes.
  std::span<const std::uint32_t> meshes() const { return meshes_; }
  /// Whether there are solids, which are searched in trees and only some way ahead: obstacles at rest, and
  /// meshes.
  bool has_solids() const { return !obstacles_.is_empty() || !meshes_.empty(); }
  /// Whether all solids rest.
  bool do_solids_rest() const {
    return ranges::all_of(meshes_, [&](std::uint32_t mesh) { return surface(mesh).velocity() == Vec3{}; });
  }
  /// The numbers of all other surfaces.
  std::span<const std::uint32_t> other_surfaces() const { return other_surfaces_; }
  /// What happens when spheres touch each other or a wall; by default they are smooth and elastic.
  const Interactions& interactions() const { return interactions_; }
  /// What of the features of a world the setting has.
  Features features() const { return features_; }
  /// What it would have with other interactions. Cost: O(number of surfaces).
  Features features_with(const Interactions& interactions) const;
  /// Whether there are potentials of steps.
  bool has_steps() const { return features_.has(Feature::steps); }
  /// By how much bounding radii exceed base radii [1]: the largest scale of the present epoch of growth, or
  /// the range of the potentials of steps.
  double bounding_scale() const { return bounding_scale_; }

 protected:
  // Error, and nothing changes: they exclude each other, or another feature.
  void set_interactions(const Interactions& interactions);
  // Error: the epoch is impossible. Precondition: the features do not exclude growth.
  void set_growth(const Growth& growth);
  void end_growth();
  void set_surface(std::uint32_t number, const Surface& surface);
  std::size_t memory_bytes() const {
    return surfaces_.capacity() * sizeof(Surface) + other_surfaces_.capacity() * sizeof(std::uint32_t) +
           obstacles_.memory_bytes();
  }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.box_, self.motion_, self.surfaces_, self.interactions_);
  }
  bool restored();
  void derive();
  void divide_surfaces();

  Box box_;
  Motion motion_;
  std::vector<Surface> surfaces_;
  ExtentTree obstacles_;
  std::vector<std::uint32_t> meshes_;
  std::vector<std::uint32_t> other_surfaces_;
  Interactions interactions_;
  double bounding_scale_ = 1;
  Features features_;
};

/// Error, with `where` as its place: a vector in a box of two dimensions has a component along z; `what`
/// names it.
void refuse_out_of_plane(const Vec3& vector, const std::string& what, const std::string& where);

/// Error: an epoch of growth has a number that is not finite, an end before its begin, or a scale that is not
/// positive throughout.
void check_growth(const Growth& growth);

/// The radius of the largest sphere that fits into the box and into each surface that is closed around an
/// axis or a center [L]; infinite in open space.
HARDBALL_EXPORT double largest_fitting_radius(const Box& box, std::span<const Surface> surfaces);

}  // namespace hardball
