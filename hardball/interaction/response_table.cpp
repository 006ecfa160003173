// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/response_table.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// The rules that every table begins with.
constexpr std::uint32_t kCommon = 0;
constexpr std::uint32_t kCommonAtWalls = 1;

}  // namespace

ResponseTable::ResponseTable(const Rule& spheres, const Bounce& walls)
    : rules_{spheres, walls}, of_pairs_{kCommon}, of_walls_{kCommonAtWalls} {}

void ResponseTable::make_room(SpeciesId species) {
  if (species < species_) return;
  ResponseTable wider(*this);
  wider.species_ = species + std::size_t{1};
  const std::size_t rows = wider.species_ + 1;
  wider.of_pairs_.assign(rows * rows, kCommon);
  wider.of_walls_.assign(rows, kCommonAtWalls);
  for (std::size_t a = 0; a < species_; ++a) {
    wider.of_walls_[a] = of_walls_[a];
    for (std::size_t b = 0; b < species_; ++b) {
      wider.of_pairs_[a * rows + b] = of_pairs_[a * (species_ + 1) + b];
    }
  }
  *this = std::move(wider);
}

void ResponseTable::set(SpeciesId a, SpeciesId b, const Rule& rule) {
  make_room(std::max(a, b));
  of_pairs_[index(a, b)] = of_pairs_[index(b, a)] = static_cast<std::uint32_t>(rules_.size());
  rules_.push_back(rule);
}

void ResponseTable::set_wall(SpeciesId species, const Bounce& bounce) {
  make_room(species);
  of_walls_[row(species)] = static_cast<std::uint32_t>(rules_.size());
  rules_.emplace_back(bounce);
}

bool ResponseTable::has_merging() const {
  return ranges::any_of(rules_, [](const Rule& rule) { return std::holds_alternative<Merging>(rule); });
}

bool ResponseTable::is_rough() const {
  return ranges::any_of(rules_, [](const Rule& rule) {
    const auto* const bounce = std::get_if<Bounce>(&rule);
    return bounce && bounce->rules().tangential_restitution;
  });
}

std::optional<double> ResponseTable::restitution() const {
  const auto constant_of = [this](std::uint32_t index) -> std::optional<double> {
    const auto* const bounce = std::get_if<Bounce>(&rules_[index]);
    if (!bounce || bounce->rules().tangential_restitution) return {};
    const auto* const constant = std::get_if<ConstantRestitution>(&bounce->rules().restitution);
    return constant ? std::optional(constant->value) : std::nullopt;
  };
  std::optional<double> one;
  for (const std::uint32_t index : of_pairs_) {
    if (std::holds_alternative<Passing>(rules_[index])) continue;
    const std::optional<double> constant = constant_of(index);
    if (!constant || (one && constant != one)) return std::nullopt;
    one = constant;
  }
  return one;
}

bool ResponseTable::has_passing() const {
  return ranges::any_of(
      of_pairs_, [this](std::uint32_t index) { return std::holds_alternative<Passing>(rules_[index]); });
}

void ResponseTable::pass_as_in(const ResponseTable& other) {
  if (other.species_ > species_) make_room(static_cast<SpeciesId>(other.species_ - 1));
  for (std::size_t a = 0; a <= species_; ++a) {
    for (std::size_t b = 0; b <= species_; ++b) {
      const std::size_t row = std::min(a, other.species_);
      const std::size_t column = std::min(b, other.species_);
      const Rule& before = other.rules_[other.of_pairs_[row * (other.species_ + 1) + column]];
      std::uint32_t& own = of_pairs_[a * (species_ + 1) + b];
      const bool passed = std::holds_alternative<Passing>(before);
      if (std::holds_alternative<Passing>(rules_[own]) && !passed) {
        throw Error("spheres may pass through each other only if they do so from the start", "response table",
                    "set Passing before the simulation starts");
      }
      if (passed && !std::holds_alternative<Passing>(rules_[own])) {
        own = static_cast<std::uint32_t>(rules_.size());
        rules_.emplace_back(Passing());
      }
    }
  }
}

std::optional<Restitution> ResponseTable::one_for_all() const {
  const std::optional<Restitution> one = wall(0).restitution();
  const auto is_it = [&](std::uint32_t index) {
    const auto* const bounce = std::get_if<Bounce>(&rules_[index]);
    return bounce ? bounce->restitution() == one : std::holds_alternative<Passing>(rules_[index]);
  };
  const bool is_one = one && ranges::all_of(of_pairs_, is_it) && ranges::all_of(of_walls_, is_it);
  return is_one ? one : std::nullopt;
}

bool ResponseTable::decide(Contact& contact) const {
  if (!contact.is_collision()) return wall(contact.first_species).decide(contact);
  return std::visit([&](const auto& response) { return response.decide(contact); },
                    rule(contact.first_species, contact.second_species));
}

bool ResponseTable::restored() const {
  if (species_ > std::numeric_limits<SpeciesId>::max() + std::size_t{1}) return false;
  const std::size_t rows = species_ + 1;
  const auto is_rule = [this](std::uint32_t index) { return index < rules_.size(); };
  const auto is_bounce = [this](std::uint32_t index) {
    return index < rules_.size() && std::holds_alternative<Bounce>(rules_[index]);
  };
  return of_pairs_.size() == rows * rows && of_walls_.size() == rows && ranges::all_of(of_pairs_, is_rule) &&
         ranges::all_of(of_walls_, is_bounce);
}

}  // namespace hardball
