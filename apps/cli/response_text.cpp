// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/response_text.hpp"

#include <fmt/format.h>

#include <variant>

namespace hardball::cli {
namespace {

std::string describe(const ConstantRestitution& law) {
  return law.value == 1 ? "elastic" : fmt::format("restitution {:.4g}", law.value);
}

std::string describe(const ViscoelasticRestitution& law) {
  return fmt::format("viscoelastic, restitution {:.4g} at the impact speed 1", law.at(1));
}

std::string describe(const TabulatedRestitution& law) {
  const auto& first = law.points().front();
  const auto& last = law.points().back();
  return fmt::format("restitution tabulated from {:.4g} at the impact speed {:.4g} to {:.4g} at {:.4g}",
                     first.value, first.speed, last.value, last.speed);
}

std::string describe(const BounceRules& rules) {
  std::string text =
      "bounce, " + std::visit([](const auto& law) { return describe(law); }, rules.restitution);
  if (rules.tangential_restitution) {
    text += fmt::format(", rough with tangential restitution {:.4g}", *rules.tangential_restitution);
  }
  if (rules.elastic_below > 0) text += fmt::format(", elastic below the speed {:.4g}", rules.elastic_below);
  if (rules.contact_duration > 0) {
    text += fmt::format(", elastic within {:.4g} after another contact", rules.contact_duration);
  }
  if (rules.settle_under > 0) text += ", elastic within a hundredth of sqrt(d / g) after another contact";
  return text;
}

std::string describe(const PairDescription& pair) {
  switch (pair.outcome) {
    case ContactOutcome::pass:
      return "pass through each other";
    case ContactOutcome::merge:
      return "merge";
    case ContactOutcome::bounce:
      break;
  }
  return describe(pair.bounce);
}

std::string describe(const StepRules& rules) {
  std::string text = rules.core == 0   ? "open core"
                     : rules.core == 1 ? ""
                                       : fmt::format("core at {:.4g}", rules.core);
  for (const Step& step : rules.steps) {
    if (!text.empty()) text += ", ";
    text += rules.is_tether && &step == &rules.steps.back()
                ? fmt::format("tether at {:.4g}", step.ratio)
                : fmt::format("energy {:.4g} within {:.4g}", step.energy, step.ratio);
  }
  return text;
}

}  // namespace

std::vector<ResponseText> response_texts(const Scenario& scenario) {
  const std::string bounce = describe(scenario.bounce);
  std::vector<ResponseText> texts{
      {"all contacts", scenario.merges ? "spheres merge; at walls they " + bounce : bounce}};
  for (const PairDescription& pair : scenario.pairs) {
    const std::string& first = scenario.species[pair.first].name;
    const std::string who =
        pair.second ? first + " and " + scenario.species[*pair.second].name : first + " at walls";
    texts.push_back({who, describe(pair)});
  }
  for (const PotentialDescription& potential : scenario.potentials) {
    const std::string who = potential.between ? scenario.species[potential.between->first].name + " and " +
                                                    scenario.species[potential.between->second].name
                                              : "all spheres";
    texts.push_back({"potential of " + who, describe(potential.rules)});
  }
  for (const BondsDescription& bonds : scenario.bonds) {
    const std::string who =
        bonds.file ? "bonds in " + bonds.file->filename().string()
                   : fmt::format("{} {}", bonds.pairs.size(), bonds.pairs.size() == 1 ? "bond" : "bonds");
    texts.push_back({who, describe(bonds.rules)});
  }
  return texts;
}

std::vector<std::size_t> species_counts(const Scenario& scenario, const World& world) {
  std::vector<std::size_t> counts(scenario.species.size());
  if (counts.empty()) return counts;
  for (Slot slot = 0; slot < world.size(); ++slot) ++counts[world.species(slot)];
  return counts;
}

std::string species_text(const Scenario& scenario, const std::vector<std::size_t>& counts) {
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", scenario.species[k].name, counts[k]);
  }
  return text;
}

}  // namespace hardball::cli
