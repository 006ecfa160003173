// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/gsd_type_names.hpp"

#include <cstddef>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/text_lines.hpp"

namespace hardball::gsd {
namespace {

constexpr std::size_t kLetters = 26;

std::string species_name(std::size_t species) {
  return species < kLetters ? std::string(1, static_cast<char>('A' + species)) : to_text(species);
}

std::optional<SpeciesId> species_of_name(std::string_view name) {
  if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z') return static_cast<SpeciesId>(name[0] - 'A');
  SpeciesId species = 0;
  if (!parse(name, species) || species < kLetters) return std::nullopt;
  return species;
}

}  // namespace

std::vector<std::string> type_names(const SphereTypes& types) {
  const bool are_finer = types.are_finer_than_species();
  std::vector<std::string> names;
  std::size_t of_its_species = 0;
  for (std::size_t type = 0; type < types.count(); ++type) {
    const bool is_first = type == 0 || types.species_of(type) != types.species_of(type - 1);
    of_its_species = is_first ? 1 : of_its_species + 1;
    names.push_back(species_name(types.species_of(type)) + (are_finer ? "." + to_text(of_its_species) : ""));
  }
  return names;
}

std::optional<std::vector<SpeciesId>> species_of_type_names(const std::vector<std::string>& names) {
  std::vector<SpeciesId> all;
  for (const std::string_view name : names) {
    const std::size_t point = name.find('.');
    std::size_t number = 0;
    if (point == std::string_view::npos || !parse(name.substr(point + 1), number)) return std::nullopt;
    const std::optional<SpeciesId> species = species_of_name(name.substr(0, point));
    if (!species) return std::nullopt;
    all.push_back(*species);
  }
  return all;
}

}  // namespace hardball::gsd
