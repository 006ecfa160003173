// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "hardball/describe/field.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/interaction/species.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

/// A step of a potential: the energy of two spheres inside of it, down to the next step or the core.
struct Step {
  double ratio = 1;   ///< The distance of the centers where the step is, over the sum of the radii [1].
  double energy = 0;  ///< [M L^2 T^-2]

  static constexpr auto fields() {
    return std::tuple{
        Field{"ratio", &Step::ratio, NumberRange::positive, "",
              "the distance of the centers at which the step is, over the sum of the radii", "1.5"},
        Field{"energy", &Step::energy, NumberRange::finite, "M L²/T²",
              "the energy of two spheres between this step and the next one inward, or the core", "-1.0"}};
  }
  friend bool operator==(const Step&, const Step&) = default;
  static void persist(auto& archive, auto& self) { archive(self.ratio, self.energy); }
};

/// What a potential is made of.
struct StepRules {
  /// From the inside to the outside; beyond the last the energy is zero.
  std::vector<Step> steps = {};
  /// The distance at which spheres bounce off each other, over the sum of the radii [1]; zero if they do not,
  /// and may take the same place.
  double core = 1;
  /// Whether the spheres never part beyond the last step.
  bool is_tether = false;

  static void persist(auto& archive, auto& self) { archive(self.steps, self.core, self.is_tether); }
};

/// A potential of steps between two spheres: wells, shoulders, tethers.
///
/// The level of a pair is the number of steps that it is inside of: zero beyond the last step, where the
/// energy is zero. It is a state of the pair, and changes only where the pair passes a step, because at a
/// step its distance does not say on which side it is. Source: Alder and Wainwright, J. Chem. Phys. 31 (1959)
/// 459.
class HARDBALL_EXPORT StepPotential {
 public:
  using Level = std::uint8_t;
  static constexpr std::size_t kMaxSteps = std::numeric_limits<Level>::max();

  /// Error: there are no steps, or more than 255; their ratios do not increase, or begin at or below the
  /// core; a number is not finite; the core is negative; the tethered spheres have no room.
  explicit StepPotential(const StepRules& rules);
  /// The potential of a sensor and what it senses: the spheres do not act on each other, and the beginning
  /// and the end of their overlap are contacts at the one step, which both pass.
  static StepPotential sensor();

  const StepRules& rules() const { return rules_; }
  std::size_t steps() const { return rules_.steps.size(); }
  bool is_tether() const { return rules_.is_tether; }
  /// The ratio of the farthest step [1].
  double range() const { return rules_.steps.back().ratio; }
  /// The number of the step that a pair passes from a level outwards, counted from the inside. Precondition:
  /// the level is not zero.
  std::size_t step_outside(Level level) const { return steps() - level; }
  /// The ratio at which a pair leaves a level outwards [1]. Precondition: the level is not zero.
  double outer_ratio(Level level) const { return rules_.steps[step_outside(level)].ratio; }
  /// The ratio at which a pair leaves a level inwards: that of the next step, or of the core [1].
  double inner_ratio(Level level) const {
    return is_innermost(level) ? rules_.core : rules_.steps[steps() - level - 1].ratio;
  }
  bool is_innermost(Level level) const { return level == steps(); }
  /// The energy at a level [M L^2 T^-2].
  double energy(Level level) const { return level == 0 ? 0 : rules_.steps[step_outside(level)].energy; }
  /// The energy that a pair must spend to leave a level outwards, or inwards [M L^2 T^-2]; infinite at the
  /// end of a tether. Precondition: there is a step.
  double rise(Level level, bool is_outward) const {
    if (is_outward && level == 1 && is_tether()) return std::numeric_limits<double>::infinity();
    const int next = is_outward ? level - 1 : level + 1;
    return energy(static_cast<Level>(next)) - energy(level);
  }

 private:
  friend class Persistence;
  StepPotential() = default;
  static void persist(auto& archive, auto& self) { archive(self.rules_); }
  bool restored() {
    *this = StepPotential(rules_);
    return true;
  }

  StepRules rules_;
};

/// The potentials of steps of a world: for pairs of species, and for bonds between certain spheres.
class HARDBALL_EXPORT StepTable {
 public:
  /// The number of a potential in this table; kNone if there are no steps.
  using Number = std::uint16_t;
  static constexpr Number kNone = std::numeric_limits<Number>::max();

  /// Sets the potential of two species. Error: it is a tether, which only bonds have; there are more than
  /// 65,535 potentials. Cost: O(number of species squared).
  void set(SpeciesId a, SpeciesId b, const StepPotential& potential);
  /// Sets the potential of all pairs of species that have none of their own.
  void set_for_all(const StepPotential& potential);
  /// Adds a potential of bonds, and returns its number. Error: it is not a tether.
  Number add_bond(const StepPotential& potential);

  bool empty() const { return potentials_.empty(); }
  /// Whether some potential is one of bonds. Cost: O(size).
  bool has_bonds() const {
    return ranges::any_of(potentials_, [](const StepPotential& each) { return each.is_tether(); });
  }
  std::size_t size() const { return potentials_.size(); }
  const StepPotential& operator[](Number number) const { return potentials_[number]; }
  /// The potential of two spheres of these species that have no bond.
  Number of(SpeciesId a, SpeciesId b) const {
    if (a >= species_ || b >= species_) return for_all_;
    const Number number = of_pairs_[a * species_ + b];
    return number == kNone ? for_all_ : number;
  }
  /// Species from this number on are alike: no potential names them.
  std::size_t species() const { return species_; }
  /// The greatest ratio at which spheres without a bond have steps [1]; one if there are none.
  double range() const { return range_; }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.potentials_, self.species_, self.of_pairs_, self.for_all_);
  }
  bool restored();

  Number append(const StepPotential& potential);
  void note_range();

  std::vector<StepPotential> potentials_;
  std::size_t species_ = 0;       // numbers below this have a row
  std::vector<Number> of_pairs_;  // kNone where nothing has been set
  Number for_all_ = kNone;
  double range_ = 1;
};

/// A step that the two spheres of a contact have come to.
struct StepAttempt {
  StepTable::Number potential = StepTable::kNone;  ///< Number of the potential in the step table.
  std::uint8_t step = 0;                           ///< Number of the step, counted from the inside.
  bool is_outward = false;                         ///< Whether the spheres came from inside.
  bool passes = false;  ///< Whether they pass the step; if not, they bounce off it.
  /// The potential energy beyond the step less that before it [M L^2 T^-2]; infinite at the end of a tether.
  double rise = 0;

  friend bool operator==(const StepAttempt&, const StepAttempt&) = default;
  /// Whether there is a step; if not, it is a contact of the cores.
  bool happens() const { return potential != StepTable::kNone; }
  /// The potential energy gained [M L^2 T^-2].
  double gain() const { return passes ? rise : 0; }
};

}  // namespace hardball
