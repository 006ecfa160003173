// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "hardball/interaction/response_table.hpp"
#include "hardball/interaction/restitution.hpp"
#include "hardball/interaction/step_potential.hpp"
#include "hardball/memory/function.hpp"

namespace hardball {

/// A custom response; none if empty.
using CustomResponse = Function<Outcome(const Contact&)>;

/// What happens when bodies touch: a table of the pairs of species, and a custom response that is called
/// instead of it wherever spheres do not pass through each other; and the potentials of steps that act before
/// they touch. Walls have their own materials: see SurfaceMaterial.
class Interactions {
 public:
  Interactions() : Interactions(Restitution()) {}
  /// One coefficient of restitution for all spheres and walls.
  Interactions(const Restitution& restitution)  // NOLINT(google-explicit-constructor)
      : Interactions(ResponseTable(Bounce(restitution), Bounce(restitution))) {}
  Interactions(const ResponseTable& table)  // NOLINT(google-explicit-constructor)
      : table_(table) {
    choose();
  }

  const ResponseTable& table() const { return table_; }
  const StepTable& steps() const { return steps_; }
  void set_steps(const StepTable& steps) { steps_ = steps; }
  const CustomResponse& function() const { return function_; }
  /// Replaces the function; an empty one leaves it to the table.
  void set_function(CustomResponse function) {
    function_ = std::move(function);
    choose();
  }

  /// Whether spheres of these species pass through each other.
  bool pass(SpeciesId a, SpeciesId b) const { return has_passing_ && table_.pass(a, b); }
  bool has_passing() const { return has_passing_; }
  /// Whether spheres may merge: by the table, or if the function says so.
  bool may_merge() const { return function_ || has_merging_; }
  /// Whether all contacts are known to be elastic and smooth, and to keep the kinetic energy.
  bool are_elastic() const { return one_for_all_ && one_for_all_->coefficient() == 1 && steps_.empty(); }

  /// See Response. Precondition: the bodies do not pass through each other.
  bool decide(Contact& contact) const {
    if (one_for_all_) [[likely]]
      return hardball::decide(*one_for_all_, contact);
    return function_ ? hardball::decide(function_, contact) : table_.decide(contact);
  }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) {
      ResponseTable table;
      archive(table);
      self = Interactions(table);
    } else {
      archive(self.table_);
    }
    archive(self.steps_);
  }

  void choose() {
    has_passing_ = table_.has_passing();
    has_merging_ = table_.has_merging();
    one_for_all_ = function_ ? std::nullopt : table_.one_for_all();
  }

  ResponseTable table_;
  StepTable steps_;
  CustomResponse function_;
  std::optional<Restitution> one_for_all_;  // the fastest, if it is that
  bool has_passing_ = false;
  bool has_merging_ = false;
};

static_assert(Response<Interactions>);

}  // namespace hardball
