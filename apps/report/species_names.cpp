// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/species_names.hpp"

#include <algorithm>
#include <charconv>

#include "hardball/standard/ranges.hpp"

namespace hardball::report {
namespace {

constexpr std::string_view kOfSpecies = " of species";

}  // namespace

SpeciesNames::Parts SpeciesNames::parts_of(std::string_view name) const {
  Parts parts;
  while (names_.size() > 1) {
    const std::size_t seam = name.rfind('_');
    if (seam == std::string_view::npos) break;
    std::size_t number = 0;
    const char* const end = name.data() + name.size();
    const auto [last, error] = std::from_chars(name.data() + seam + 1, end, number);
    if (error != std::errc() || last != end || number < 1 || number > names_.size()) break;
    parts.species.insert(parts.species.begin(), number - 1);
    name.remove_suffix(name.size() - seam);
  }
  parts.quantity = name;
  std::replace(parts.quantity.begin(), parts.quantity.end(), '_', ' ');
  return parts;
}

std::string SpeciesNames::quantity(std::string_view name) const {
  return parts_of(name).quantity;
}

std::string SpeciesNames::readable(std::string_view name) const {
  Parts parts = parts_of(name);
  if (parts.species.empty()) return parts.quantity;
  std::string species;
  for (const std::size_t k : parts.species) {
    if (!species.empty()) species += "–";
    species += names_[k].empty() ? std::to_string(k + 1) : names_[k];
  }
  if (ranges::any_of(parts.species, [this](std::size_t k) { return names_[k].empty(); })) {
    species = "species " + species;
  }
  if (!parts.quantity.ends_with(kOfSpecies)) return parts.quantity + ", " + species;
  parts.quantity.resize(parts.quantity.size() - kOfSpecies.size());
  return parts.quantity + " of " + species;
}

}  // namespace hardball::report
