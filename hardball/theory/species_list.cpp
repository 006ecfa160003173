// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/species_list.hpp"

#include <algorithm>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// What all spheres have; NaN if they differ, or there are none.
double common(const auto& of, std::size_t spheres) {
  for (Slot slot = 1; slot < spheres; ++slot) {
    if (of(slot) != of(0)) return kNoNumber;
  }
  return spheres > 0 ? of(0) : kNoNumber;
}

}  // namespace

SpeciesList::SpeciesList(const World& world) {
  world.for_each_by_id([&](Slot slot) {
    const double radius = world.base_radius(slot);
    const double mass = world.mass(slot);
    std::size_t kind = 0;
    const SpeciesId label = world.species(slot);
    const auto is_alike = [&](const Kind& known) {
      return known.radius == radius && known.mass == mass && known.label == label;
    };
    while (kind < kinds_.size() && !is_alike(kinds_[kind])) ++kind;
    if (kind > kMaxSpecies) return;
    if (kind == kinds_.size()) kinds_.push_back({radius, mass, label, 0});
    ++kinds_[kind].count;
    species_.resize(world.id(slot) + std::size_t{1});
    species_.back() = static_cast<std::uint8_t>(kind);
  });
  is_one_kind_ = kinds_.size() <= 1;
  if (kinds_.empty() || kinds_.size() > kMaxSpecies) {
    kinds_ = {{common([&](Slot slot) { return world.base_radius(slot); }, world.size()),
               common([&](Slot slot) { return world.mass(slot); }, world.size()), 0, world.size()}};
  }
  if (kinds_.size() == 1) species_ = {};
}

double SpeciesList::fraction(std::size_t species) const {
  std::size_t all = 0;
  for (const Kind& kind : kinds_) all += kind.count;
  return static_cast<double>(kinds_[species].count) / static_cast<double>(all);
}

std::string SpeciesList::suffix(std::size_t species) const {
  return size() > 1 ? "_" + to_text(species + 1) : "";
}

bool SpeciesList::restored() const {
  return kinds_.size() <= kMaxSpecies &&
         (kinds_.size() <= 1 ||
          ranges::all_of(species_, [this](std::size_t kind) { return kind < kinds_.size(); }));
}

bool SpeciesList::matches(const World& world) const {
  const bool is_any = world.size() > 0;
  return !kinds_.empty() &&
         (kinds_.size() == 1 || !is_any || species_.size() > world.id(world.slot_of_rank(world.size() - 1)));
}

}  // namespace hardball
