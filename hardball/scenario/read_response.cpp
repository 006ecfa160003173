// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/read_tables.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/nearest_name.hpp"
#include "hardball/scenario/settling_heap.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr std::string_view kWall = "wall";

RestitutionLaw read_law(const Section& section) {
  constexpr std::size_t kViscoelastic = 0;
  if (section.need("law").choice() == kViscoelastic) {
    const double value = section.need("value").number();
    const double speed = section.need("speed").number();
    return made_at(section.location(), [&] { return RestitutionLaw(ViscoelasticRestitution(value, speed)); });
  }
  const std::vector<double> speeds = section.need("speeds").numbers();
  const std::vector<double> values = section.need("values").numbers();
  if (speeds.size() != values.size()) {
    section.need("values").wrong_length(values.size(), "give one for each of the speeds");
  }
  std::vector<TabulatedRestitution::Point> points;
  for (std::size_t i = 0; i < speeds.size(); ++i) points.push_back({speeds[i], values[i]});
  return made_at(section.location(), [&] { return RestitutionLaw(TabulatedRestitution(points)); });
}

// Reads the section; what it leaves open does not change.
void read_bounce(const Section& section, BounceRules& bounce) {
  if (const auto restitution = section.find("restitution")) {
    if (const auto law = restitution->section()) {
      bounce.restitution = read_law(*law);
    } else {
      bounce.restitution = ConstantRestitution{restitution->number()};
    }
  }
  section.read_fields(bounce);
}

PairDescription read_pair(const Section& section, const Scenario& scenario) {
  PairDescription pair;
  const Value kind = section.need("kind");
  static_cast<void>(kind.choice());
  pair.outcome = *find_named<ContactOutcome>(kind.text());
  const Value between = section.need("between");
  const std::vector<Value> names = between.texts();
  if (names.size() != 2) between.wrong_length(names.size(), "give two species, or a species and \"wall\"");
  const bool is_wall_first = names[0].text() == kWall;
  const Value& species = names[is_wall_first ? 1 : 0];
  const Value& other = names[is_wall_first ? 0 : 1];
  pair.first = species_named(species, scenario.species);
  if (other.text() != kWall) pair.second = species_named(other, scenario.species);
  if (!pair.second && pair.outcome != ContactOutcome::bounce) {
    throw Error("spheres can only bounce off walls", between.location(), "make the kind \"bounce\"");
  }
  const auto is_same = [&pair](const PairDescription& known) {
    return (known.first == pair.first && known.second == pair.second) ||
           (known.second == pair.first && pair.second == known.first);
  };
  if (ranges::any_of(scenario.pairs, is_same)) {
    throw Error("there are two rules for the same species", between.location(), "remove one of the two");
  }
  pair.bounce = scenario.bounce;
  if (pair.outcome == ContactOutcome::bounce) read_bounce(section, pair.bounce);
  return pair;
}

}  // namespace

std::vector<SpeciesDescription> read_species(const Section& root) {
  std::vector<SpeciesDescription> all;
  for (const Section& section : root.sections("species")) {
    SpeciesDescription species;
    section.read_fields(species);
    const Value name = section.need("name");
    if (species.name == kWall) {
      throw Error("a species is named \"wall\"", name.location(),
                  "choose another name: that one means walls");
    }
    if (ranges::find(all, species.name, &SpeciesDescription::name) != all.end()) {
      throw Error("there are two species \"" + shortened(species.name) + "\"", name.location(),
                  "choose another name");
    }
    if (all.size() > std::numeric_limits<SpeciesId>::max()) {
      throw Error("there are more than 256 species", name.location(), "describe fewer");
    }
    all.push_back(species);
  }
  return all;
}

SpeciesId species_named(const Value& name, std::span<const SpeciesDescription> species) {
  const std::string wanted = name.text();
  const auto found = ranges::find(species, wanted, &SpeciesDescription::name);
  if (found != species.end()) return static_cast<SpeciesId>(found - species.begin());
  std::vector<std::string_view> names;
  for (const SpeciesDescription& each : species) names.push_back(each.name);
  throw Error("there is no species \"" + shortened(wanted) + "\"", name.location(),
              names.empty() ? "add [[species]] with this name" : suggestion(wanted, names, '"'));
}

void read_settling(const Section& root, Scenario& scenario) {
  const std::optional<Section> response = root.section("response");
  const std::optional<Value> settle = response ? response->find("settle") : std::nullopt;
  scenario.settles = settle ? settle->truth() : comes_to_rest(scenario);
  if (!scenario.settles) return;
  if (scenario.gravity == Vec3{}) {
    throw Error("nothing settles without gravity", settle->location(), "give gravity in [box]");
  }
  const auto settle_by_default = [&](BounceRules& rules) {
    if (rules.contact_duration == 0) rules.settle_under = length(scenario.gravity);
  };
  settle_by_default(scenario.bounce);
  for (PairDescription& pair : scenario.pairs) {
    if (pair.outcome == ContactOutcome::bounce) settle_by_default(pair.bounce);
  }
}

void read_response(const Section& root, Scenario& scenario) {
  const std::optional<Section> response = root.section("response");
  if (!response) return;
  read_bounce(*response, scenario.bounce);
  if (const auto kind = response->find("kind")) scenario.merges = kind->choice() == 1;
  for (const Section& section : response->sections("pairs")) {
    scenario.pairs.push_back(read_pair(section, scenario));
  }
}

}  // namespace hardball
