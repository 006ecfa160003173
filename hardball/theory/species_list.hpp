// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The spheres of a world by kind: those of equal radius, mass and SpeciesId are one species. Species are
/// numbered from zero in the order of their lowest ids, which is that of the groups of a scenario.
///
/// If there are more than eight kinds, as with radii from a distribution, all spheres are one species.
class HARDBALL_EXPORT SpeciesList {
 public:
  static constexpr std::size_t kMaxSpecies = 8;

  /// The species of no spheres.
  SpeciesList() = default;

  /// Cost: O(n).
  explicit SpeciesList(const World& world);

  std::size_t size() const { return kinds_.size(); }
  /// The species of a sphere. Precondition: the sphere was there at the start.
  std::size_t of(SphereId id) const { return kinds_.size() == 1 ? 0 : species_[id]; }
  SpeciesId label(std::size_t species) const { return kinds_[species].label; }
  std::size_t count(std::size_t species) const { return kinds_[species].count; }
  /// The fraction of the spheres that belong to it [1].
  double fraction(std::size_t species) const;
  double radius(std::size_t species) const { return kinds_[species].radius; }  ///< [L]; NaN if they differ.
  double mass(std::size_t species) const { return kinds_[species].mass; }      ///< [M]; NaN if they differ.
  /// Whether all spheres are of one kind.
  bool is_one_kind() const { return is_one_kind_; }
  /// The suffix of names of quantities: empty if there is one species, otherwise "_1" for the first and so
  /// on.
  std::string suffix(std::size_t species) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.kinds_, self.species_, self.is_one_kind_); }
  bool restored() const;

  struct Kind {
    double radius;
    double mass;
    SpeciesId label;
    std::size_t count;
    static void persist(auto& archive, auto& self) {
      archive(self.radius, self.mass, self.label, self.count);
    }
  };

  std::vector<Kind> kinds_;
  std::vector<std::uint8_t> species_;  // by id
  bool is_one_kind_ = true;
};

}  // namespace hardball
