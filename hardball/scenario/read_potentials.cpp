// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/read_tables.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/sphere_id.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

using IdPair = std::pair<SphereId, SphereId>;

void read_steps(const Section& section, StepRules& rules) {
  if (const auto core = section.find("core")) rules.core = core->number();
  for (const Section& step : section.sections("steps")) step.read_fields(rules.steps.emplace_back());
}

// Error, with the place of the table: what StepPotential refuses.
void check(const StepRules& rules, const Section& section) {
  made_at(section.location(), [&] { return StepPotential(rules); });
}

PotentialDescription read_potential(const Section& section, const Scenario& scenario) {
  PotentialDescription potential;
  if (const auto between = section.find("between")) {
    const std::vector<Value> names = between->texts();
    if (names.size() != 2) between->wrong_length(names.size(), "give two species, alike or not");
    potential.between = {species_named(names[0], scenario.species),
                         species_named(names[1], scenario.species)};
  }
  const auto is_same = [&potential](const PotentialDescription& known) {
    if (!known.between || !potential.between) return known.between == potential.between;
    return std::minmax(known.between->first, known.between->second) ==
           std::minmax(potential.between->first, potential.between->second);
  };
  if (ranges::any_of(scenario.potentials, is_same))
    throw Error("there are two potentials for the same species", section.location(), "remove one of the two");
  read_steps(section, potential.rules);
  check(potential.rules, section);
  return potential;
}

IdPair two_ids(const Value& value) {
  const std::vector<double> ids = value.numbers();
  if (ids.size() != 2) value.wrong_length(ids.size(), "give two ids in brackets");
  return {sphere_id(ids[0], value.location()), sphere_id(ids[1], value.location())};
}

std::vector<IdPair> chain_of(const Section& section) {
  const Value chain = section.need("chain");
  const auto [first, last] = two_ids(chain);
  if (!(first < last)) throw Error("the last id is not after the first", chain.location(), "exchange them");
  const auto beads = section.find("beads");
  const std::uint64_t spheres = std::uint64_t{last} - first + 1;
  const std::uint64_t length = beads ? beads->integer() : spheres;
  if (spheres % length != 0) {
    throw Error(to_text(spheres) + " spheres cannot be cut into chains of " + to_text(length),
                beads->location(), "give a divisor");
  }
  // More would be refused as there are no such spheres, but after their memory has been taken.
  constexpr std::uint64_t kMost = 100'000'000;
  if (spheres > kMost)
    throw Error("a chain has " + to_text(spheres) + " spheres", chain.location(), "give at most 1e8");
  std::vector<IdPair> pairs;
  for (std::uint64_t bead = 1; bead < spheres; ++bead) {
    if (bead % length != 0)
      pairs.emplace_back(static_cast<SphereId>(first + bead - 1), static_cast<SphereId>(first + bead));
  }
  return pairs;
}

BondsDescription read_bonds(const Section& section, const std::filesystem::path& folder) {
  BondsDescription bonds;
  bonds.where = section.location();
  if (const auto between = section.find("between")) {
    bonds.pairs = {two_ids(*between)};
  } else if (section.find("chain")) {
    bonds.pairs = chain_of(section);
  } else {
    bonds.file = folder / section.need("file").text();
  }
  if (const auto beads = section.find("beads"); beads && !section.find("chain"))
    throw Error("beads is given without chain", beads->location(), "add chain, or remove it");
  read_steps(section, bonds.rules);
  const Value longest = section.need("longest");
  bonds.rules.steps.push_back({longest.number(), 0});
  bonds.rules.is_tether = true;
  check(bonds.rules, section);
  return bonds;
}

}  // namespace

void read_potentials(const Section& root, Scenario& scenario) {
  for (const Section& section : root.sections("potentials")) {
    scenario.potentials.push_back(read_potential(section, scenario));
    check_exclusions(Feature::steps, scenario.features(), section.location());
  }
  const std::filesystem::path folder = std::filesystem::path(scenario.name).parent_path();
  for (const Section& section : root.sections("bonds")) {
    scenario.bonds.push_back(read_bonds(section, folder));
    check_exclusions(Feature::steps, scenario.features(), section.location());
  }
}

}  // namespace hardball
