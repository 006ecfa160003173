// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/world/sphere.hpp"

namespace hardball {

/// The types of spheres in files for programs that know the size and the mass of a sphere by its type.
///
/// A type is a species, unless spheres of one species have several radii or masses. Then each kind of sphere,
/// its species, radius and mass, is a type, in the order of these, if there are no more than kMostKinds
/// kinds: radii from a continuous distribution are no types.
class HARDBALL_EXPORT SphereTypes {
 public:
  /// The largest number of kinds that are types.
  static constexpr std::size_t kMostKinds = 32;

  SphereTypes() = default;
  explicit SphereTypes(std::span<const Sphere> spheres);

  /// Accounts for a sphere of this species, radius [L] and mass [M]. Cost: O(log kMostKinds).
  void add(SpeciesId species, double radius, double mass);
  /// Accounts for the spheres that other types account for.
  void add(const SphereTypes& others);

  /// Whether several types are of one species.
  bool are_finer_than_species() const;
  /// The number of types, at least one.
  std::size_t count() const;
  /// The type of a sphere, from 0 on. Precondition: it is accounted for.
  std::size_t type_of(const Sphere& sphere) const;
  /// The species of a type. Precondition: there is such a type.
  SpeciesId species_of(std::size_t type) const;

  static void persist(auto& archive, auto& self) {
    archive(self.kinds_, self.has_more_kinds_, self.largest_species_);
  }

 private:
  struct Kind {
    SpeciesId species = 0;
    double radius = 0;
    double mass = 0;

    friend auto operator<=>(const Kind&, const Kind&) = default;
    static void persist(auto& archive, auto& self) { archive(self.species, self.radius, self.mass); }
  };

  std::vector<Kind> kinds_;  // ascending
  bool has_more_kinds_ = false;
  SpeciesId largest_species_ = 0;
};

}  // namespace hardball
