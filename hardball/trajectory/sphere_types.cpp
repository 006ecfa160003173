// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/sphere_types.hpp"

#include <algorithm>

#include "hardball/standard/ranges.hpp"

namespace hardball {

SphereTypes::SphereTypes(std::span<const Sphere> spheres) {
  for (const Sphere& sphere : spheres) add(sphere.species, sphere.radius, sphere.mass);
}

void SphereTypes::add(SpeciesId species, double radius, double mass) {
  largest_species_ = std::max(largest_species_, species);
  if (has_more_kinds_) return;
  const Kind kind{species, radius, mass};
  const auto place = ranges::lower_bound(kinds_, kind);
  if (place != kinds_.end() && *place == kind) return;
  has_more_kinds_ = kinds_.size() == kMostKinds;
  if (has_more_kinds_) {
    kinds_.clear();
  } else {
    kinds_.insert(place, kind);
  }
}

void SphereTypes::add(const SphereTypes& others) {
  for (const Kind& kind : others.kinds_) add(kind.species, kind.radius, kind.mass);
  largest_species_ = std::max(largest_species_, others.largest_species_);
  if (!others.has_more_kinds_) return;
  has_more_kinds_ = true;
  kinds_.clear();
}

bool SphereTypes::are_finer_than_species() const {
  return ranges::adjacent_find(kinds_, {}, &Kind::species) != kinds_.end();
}

std::size_t SphereTypes::count() const {
  return are_finer_than_species() ? kinds_.size() : std::size_t{largest_species_} + 1;
}

std::size_t SphereTypes::type_of(const Sphere& sphere) const {
  if (!are_finer_than_species()) return sphere.species;
  const Kind kind{sphere.species, sphere.radius, sphere.mass};
  return static_cast<std::size_t>(ranges::lower_bound(kinds_, kind) - kinds_.begin());
}

SpeciesId SphereTypes::species_of(std::size_t type) const {
  return are_finer_than_species() ? kinds_[type].species : static_cast<SpeciesId>(type);
}

}  // namespace hardball
