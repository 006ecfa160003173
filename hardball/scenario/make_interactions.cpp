// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_interactions.hpp"

#include <fstream>
#include <memory>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/sphere_id.hpp"
#include "hardball/trajectory/text_lines.hpp"
#include "hardball/world/step_levels.hpp"

namespace hardball {
namespace {

ResponseTable make_responses(const Scenario& scenario) {
  const Bounce common(scenario.bounce);
  ResponseTable table(scenario.merges ? Rule(Merging()) : Rule(common), common);
  for (const PairDescription& pair : scenario.pairs) {
    if (!pair.second) {
      table.set_wall(pair.first, Bounce(pair.bounce));
    } else if (pair.outcome == ContactOutcome::merge) {
      table.set(pair.first, *pair.second, Merging());
    } else if (pair.outcome == ContactOutcome::pass) {
      table.set(pair.first, *pair.second, Passing());
    } else {
      table.set(pair.first, *pair.second, Bounce(pair.bounce));
    }
  }
  return table;
}

StepTable make_steps(const Scenario& scenario) {
  StepTable table;
  for (const PotentialDescription& each : scenario.potentials) {
    if (each.between) {
      table.set(each.between->first, each.between->second, StepPotential(each.rules));
    } else {
      table.set_for_all(StepPotential(each.rules));
    }
  }
  for (const BondsDescription& bonds : scenario.bonds)
    static_cast<void>(table.add_bond(StepPotential(bonds.rules)));
  return table;
}

std::vector<std::pair<SphereId, SphereId>> pairs_in(const std::filesystem::path& file,
                                                    const std::string& where) {
  auto in = std::make_unique<std::ifstream>(file);
  if (!*in || !std::filesystem::is_regular_file(file))
    throw Error("the file " + file.string() + " cannot be read", where, "name a text file of bonds");
  Lines lines(std::move(in), file.string());
  std::vector<std::pair<SphereId, SphereId>> pairs;
  while (lines.next_text()) {
    const std::vector<Token> tokens = tokens_of(lines.line());
    const std::string place = file.string() + ":" + to_text(lines.number());
    if (tokens.size() != 2) throw Error("there are not two ids on the line", place, "give two whole numbers");
    const auto id = [&](const Token& token) {
      return sphere_id(static_cast<double>(parse_integer(token, "an id", lines.location())), place);
    };
    pairs.emplace_back(id(tokens[0]), id(tokens[1]));
  }
  if (pairs.empty()) throw Error("the file has no bonds", file.string(), "give two ids on each line");
  return pairs;
}

}  // namespace

Interactions make_interactions(const Scenario& scenario) {
  Interactions interactions(make_responses(scenario));
  interactions.set_steps(make_steps(scenario));
  return interactions;
}

void add_bonds(const Scenario& scenario, World& world) {
  auto number = static_cast<StepTable::Number>(scenario.potentials.size());
  for (const BondsDescription& bonds : scenario.bonds) {
    const std::vector<std::pair<SphereId, SphereId>> pairs =
        bonds.file ? pairs_in(*bonds.file, bonds.where) : bonds.pairs;
    for (const auto& [first, second] : pairs) {
      try {
        add_bond(world, first, second, number);
      } catch (const Error& error) {
        throw Error(error.problem(), bonds.where + ": " + error.where(), error.remedy());
      }
    }
    ++number;
  }
}

}  // namespace hardball
