// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/step_potential.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

StepPotential::StepPotential(const StepRules& rules) : rules_(rules) {
  const auto refuse = [](const std::string& what, const char* remedy) {
    throw Error(what, "potential", remedy);
  };
  if (rules.steps.empty()) refuse("a potential has no steps", "give at least one step, or no potential");
  if (rules.steps.size() > kMaxSteps) refuse("a potential has more than 255 steps", "give fewer steps");
  // Squares of distances must not overflow, nor two steps be one.
  constexpr double kLargestRatio = 1e6;
  constexpr double kLeastWidth = 1e-9;
  if (!(rules.core >= 0 && rules.core <= kLargestRatio))
    refuse("the core of a potential is at " + to_text(rules.core),
           "give zero, or a ratio of up to a million");
  double inner = rules.core;
  for (const Step& step : rules.steps) {
    if (!(step.ratio <= kLargestRatio))
      refuse("a step is at the ratio " + to_text(step.ratio), "give a ratio of up to a million");
    if (!(step.ratio > inner * (1 + kLeastWidth) && step.ratio > kLeastWidth)) {
      refuse("a step is at the ratio " + to_text(step.ratio) + ", and the one before, or the core, at " +
                 to_text(inner),
             "give ratios that increase from that of the core, by a billionth at least");
    }
    if (!(std::fabs(step.energy) <= 1e60))
      refuse("a step has the energy " + to_text(step.energy), "give a finite energy of at most 1e60");
    inner = step.ratio;
  }
}

StepPotential StepPotential::sensor() {
  return StepPotential({.steps = {{1, 0}}, .core = 0});
}

void StepTable::set(SpeciesId a, SpeciesId b, const StepPotential& potential) {
  if (potential.is_tether())
    throw Error("a tether is given for pairs of species", "potential", "tie spheres together by bonds");
  const std::size_t wanted = std::max(a, b) + std::size_t{1};
  if (wanted > species_) {
    std::vector<Number> wider(wanted * wanted, kNone);
    for (std::size_t i = 0; i < species_; ++i) {
      for (std::size_t k = 0; k < species_; ++k) wider[i * wanted + k] = of_pairs_[i * species_ + k];
    }
    of_pairs_ = std::move(wider);
    species_ = wanted;
  }
  const Number number = append(potential);
  of_pairs_[a * species_ + b] = of_pairs_[b * species_ + a] = number;
  note_range();
}

void StepTable::set_for_all(const StepPotential& potential) {
  if (potential.is_tether())
    throw Error("a tether is given for pairs of species", "potential", "tie spheres together by bonds");
  for_all_ = append(potential);
  note_range();
}

StepTable::Number StepTable::add_bond(const StepPotential& potential) {
  if (!potential.is_tether())
    throw Error("the potential of a bond is not a tether", "potential", "let it end in a tether");
  return append(potential);
}

StepTable::Number StepTable::append(const StepPotential& potential) {
  if (potentials_.size() >= kNone)
    throw Error("there are more than 65,535 potentials", "potential", "give the same ones to more pairs");
  potentials_.push_back(potential);
  return static_cast<Number>(potentials_.size() - 1);
}

void StepTable::note_range() {
  range_ = 1;
  const auto note = [this](Number number) {
    if (number != kNone) range_ = std::max(range_, potentials_[number].range());
  };
  for (const Number number : of_pairs_) note(number);
  note(for_all_);
}

bool StepTable::restored() {
  const auto is_number = [this](Number number) {
    return number == kNone || (number < potentials_.size() && !potentials_[number].is_tether());
  };
  const bool is_sound =
      potentials_.size() <= kNone && species_ <= std::numeric_limits<SpeciesId>::max() + std::size_t{1} &&
      of_pairs_.size() == species_ * species_ && is_number(for_all_) && ranges::all_of(of_pairs_, is_number);
  if (is_sound) note_range();
  return is_sound;
}

}  // namespace hardball
