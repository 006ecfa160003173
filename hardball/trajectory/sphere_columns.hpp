// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_lines.hpp"

namespace hardball {

/// The quantities of a sphere, by the names of columns that CSV files, LAMMPS dumps and NumPy arrays share.
enum class SphereColumn {
  x,
  y,
  z,
  vx,
  vy,
  vz,
  radius,
  diameter,
  mass,
  id,
  type,
  ix,
  iy,
  iz,
  omegax,
  omegay,
  omegaz,
  moment,
  species_id
};
inline constexpr std::size_t kSphereColumns = 19;

/// The names of the columns, in the order of SphereColumn.
inline constexpr std::array<std::string_view, kSphereColumns> kSphereColumnNames{
    "x",    "y",  "z",  "vx", "vy",     "vz",     "radius", "diameter", "mass",      "id",
    "type", "ix", "iy", "iz", "omegax", "omegay", "omegaz", "moment",   "species_id"};

/// The places of the columns of a table; others are ignored.
///
/// Required are `x y z` and either `radius` or `diameter`. `vx vy vz` is the velocity; `mass` is 1 if not
/// given; `omegax omegay omegaz` is the angular velocity; `type` counts from one, and is the species
/// unless there is `species_id`, which counts from one, too.
class SphereColumns {
 public:
  /// `where`: the place of the names. Error: a column is missing, or occurs twice.
  SphereColumns(std::span<const Token> names, const TextLocation& where);

  /// Appends the sphere of a line. Error, with its location: there are not as many values as columns, or one
  /// is not what it should be.
  void add(std::span<const Token> values, const TextLocation& location, Snapshot& snapshot) const;

  /// Appends a sphere from real(column) and integer(column), the values of a column as such. Error, at
  /// `place`: an image out of range.
  template <class Real, class Integer>
  void add(Snapshot& snapshot, const std::string& location, const Real& real, const Integer& integer) const {
    using enum SphereColumn;
    const auto vector = [&](SphereColumn first) {
      Vec3 parts;
      for (std::size_t axis = 0; axis < kAxes; ++axis) parts[axis] = real(at(first, axis));
      return parts;
    };
    Sphere& sphere = snapshot.spheres.emplace_back();
    sphere.position = vector(x);
    if (has(vx)) sphere.velocity = vector(vx);
    sphere.radius = has(radius) ? real(at(radius)) : real(at(diameter)) / 2;
    if (has(mass)) sphere.mass = real(at(mass));
    if (has(type) && !has(species_id)) sphere.species = species_of_type(integer(at(type)));
    if (has(species_id)) sphere.species = species_of_type(integer(at(species_id)));
    if (has(omegax)) sphere.spin = vector(omegax);
    if (has(moment)) sphere.inertia_factor = real(at(moment));
    if (has(id)) snapshot.ids.push_back(integer(at(id)));
    if (has(ix)) {
      Image& image = snapshot.images.emplace_back();
      for (std::size_t axis = 0; axis < kAxes; ++axis)
        image[axis] = box_count(integer(at(ix, axis)), location);
    }
  }

  /// Says which quantities the spheres of the snapshot have.
  void describe(Snapshot& snapshot) const {
    snapshot.has_velocities = has(SphereColumn::vx);
    snapshot.has_spins = has(SphereColumn::omegax);
  }

  /// The number of columns, known or not.
  std::size_t size() const { return count_; }
  bool has(SphereColumn column) const { return index_[static_cast<std::size_t>(column)].has_value(); }

 private:
  // The index of a column, or of one that follows it in SphereColumn.
  std::size_t at(SphereColumn column, std::size_t further = 0) const {
    return *index_[static_cast<std::size_t>(column) + further];
  }
  static std::int32_t box_count(std::int64_t number, const std::string& location);

  std::array<std::optional<std::size_t>, kSphereColumns> index_;
  std::size_t count_;
  std::vector<std::string> names_;
};

}  // namespace hardball
