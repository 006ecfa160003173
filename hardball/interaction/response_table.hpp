// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/interaction/bounce.hpp"
#include "hardball/interaction/merging.hpp"
#include "hardball/interaction/passing.hpp"

namespace hardball {

/// The built-in responses.
using Rule = std::variant<Bounce, Merging, Passing>;

/// A response for each pair of species, and for each species at walls.
class HARDBALL_EXPORT ResponseTable {
 public:
  /// One rule for all spheres, and one for all spheres at walls.
  explicit ResponseTable(const Rule& spheres = Bounce(), const Bounce& walls = Bounce());

  /// Sets the response of two species. Cost: O(number of species squared).
  void set(SpeciesId a, SpeciesId b, const Rule& rule);
  /// Sets how a species bounces off walls.
  void set_wall(SpeciesId species, const Bounce& bounce);

  const Rule& rule(SpeciesId a, SpeciesId b) const { return rules_[of_pairs_[index(a, b)]]; }
  const Bounce& wall(SpeciesId species) const { return std::get<Bounce>(rules_[of_walls_[row(species)]]); }
  /// Species from this number on are alike: no rule names them.
  std::size_t species() const { return species_; }
  /// Whether any spheres merge.
  bool has_merging() const;
  /// Whether any contacts change spins.
  bool is_rough() const;
  /// The coefficient of restitution of all spheres that meet and do not pass [1]; none if it is not one
  /// number.
  std::optional<double> restitution() const;
  /// Whether spheres of these species pass through each other.
  bool pass(SpeciesId a, SpeciesId b) const { return std::holds_alternative<Passing>(rule(a, b)); }
  /// Whether any do.
  bool has_passing() const;
  /// Lets the same pass through each other as in another table. Error: others do in this one.
  void pass_as_in(const ResponseTable& other);
  /// The one response of all spheres that do not pass through each other, and of all at walls, if it is that.
  std::optional<Restitution> one_for_all() const;
  /// See Response.
  bool decide(Contact& contact) const;
  Outcome operator()(const Contact& contact) const { return outcome_of(*this, contact); }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.rules_, self.of_pairs_, self.of_walls_);
  }
  bool restored() const;

  // Species that no rule names are alike: the last row is theirs.
  std::size_t row(SpeciesId species) const { return species < species_ ? species : species_; }
  std::size_t index(SpeciesId a, SpeciesId b) const { return row(a) * (species_ + 1) + row(b); }
  void make_room(SpeciesId species);

  std::size_t species_ = 0;  // numbers below this have a row of their own
  std::vector<Rule> rules_;
  std::vector<std::uint32_t> of_pairs_;  // indices into rules_
  std::vector<std::uint32_t> of_walls_;
};

static_assert(Response<ResponseTable>);

}  // namespace hardball
