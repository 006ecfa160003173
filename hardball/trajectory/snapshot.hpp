// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The part of space that a snapshot shows.
struct SnapshotBox {
  Vec3 low;   ///< The corner with the least coordinates [L].
  Vec3 size;  ///< Edge lengths [L].
  std::array<bool, kAxes> is_periodic{};
  bool is_unbounded = false;  ///< Along some axis it only spans the spheres.
  bool is_flat = false;       ///< The box is a plane, and the spheres are discs.
  /// Whether the file says along which axes it is periodic.
  bool are_boundaries_known = true;
  /// By how much its upper end along y is displaced along x against the lower one, in a sheared box: at most
  /// half of the size along x. Centers lie in the tilted cell, whose middle is that of the box [L].
  double tilt = 0;

  /// The corner of the cell with the least coordinates along y and z [L].
  Vec3 corner() const { return {low.x - tilt / 2, low.y, low.z}; }

  friend bool operator==(const SnapshotBox&, const SnapshotBox&) = default;
};

/// A box in words: its edges, the axes along which it is periodic, its tilt.
HARDBALL_EXPORT std::string text_of(const SnapshotBox& box);

/// The spheres at one moment: what a frame of a trajectory holds, whatever its format.
struct HARDBALL_EXPORT Snapshot {
  std::vector<Sphere> spheres;     ///< By ascending id, if they have ids.
  std::vector<std::int64_t> ids;   ///< Ids of the spheres; none if the file has none.
  std::vector<Image> images;       ///< By how many boxes each was folded back; none if the file has none.
  std::vector<std::size_t> lines;  ///< Where each sphere is in a text file; none otherwise.
  std::vector<std::array<std::int64_t, 2>> bonds;  ///< The ids of pairs that are tied to each other.
  std::optional<double> time;                      ///< [T]
  std::optional<SnapshotBox> box;
  bool has_velocities = true;
  bool has_spins = false;

  std::int64_t id(std::size_t sphere) const {
    return ids.empty() ? static_cast<std::int64_t>(sphere) : ids[sphere];
  }
  /// The index of the sphere with this id. Error: no sphere has it. Cost: O(log n).
  std::size_t sphere_of(std::int64_t id) const;
  Image image(std::size_t sphere) const { return images.empty() ? Image{} : images[sphere]; }
  /// The place of a sphere in the file of this name, for messages.
  std::string location(const std::string& name, std::size_t sphere) const;
};

/// The spheres of a world at `moment`, centers folded into a periodic box. Along open axes the box spans the
/// spheres; in two dimensions it is as thick as they are. The world is not changed. Precondition: no contact
/// lies between the stored paths and `moment`. Cost: O(n).
HARDBALL_EXPORT Snapshot snapshot_of(const World& world, const Time& moment);

/// The snapshot's box or, if it has none, one without bounds that spans its spheres. Cost: O(n).
HARDBALL_EXPORT SnapshotBox box_of(const Snapshot& snapshot);

/// Sorts the spheres by id. Error, at its location in the file of this name: an id occurs twice.
HARDBALL_EXPORT void sort_by_id(Snapshot& snapshot, const std::string& name);

/// Folds centers into the box along the axes where it is periodic, and adds to the images by how many boxes.
/// Error, at its location in the file of this name: a center is more boxes away than an image can count.
HARDBALL_EXPORT void fold_into_box(Snapshot& snapshot, const std::string& name);

/// Error, with its location in the file of this name: a number is NaN or infinite, but for a mass; a radius
/// or mass is not positive; an edge of the box is negative, or zero where the box is periodic.
HARDBALL_EXPORT void check_numbers(const Snapshot& snapshot, const std::string& name);

}  // namespace hardball
