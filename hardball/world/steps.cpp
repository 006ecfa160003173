// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Potentials of steps: the levels of pairs, their energy, and their events.
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/exit_time.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/static_hash_grid.hpp"
#include "hardball/world/world.hpp"

namespace hardball {
namespace {

// How far spheres that are tied may start beyond the end of their tether, or within their core, through
// rounding alone, relative to it [1].
constexpr double kBondTolerance = 1e-9;

std::string name_of(const World& world, Slot a, Slot b) {
  const auto [low, high] = std::minmax({world.id(a), world.id(b)});
  return "spheres " + to_text(low) + " and " + to_text(high);
}

// From one center to the nearest image of another.
State relative_state(const World& world, Slot a, Slot b, const Time& moment) {
  const Image image = nearest_image(world, a, b, moment);
  return relative_state_at(world.motion(), world.path(a), world.path(b), world.box().shift(image), moment);
}

// Of spheres at the distance of a step those that approach each other are inside.
bool is_inside(const State& relative, double reach) {
  const double excess = squared_excess(relative.position, reach);
  return excess < 0 || (excess == 0 && approach_to_106_bits(relative.position, relative.velocity) < 0);
}

StepPotential::Level level_at(const StepPotential& potential, const State& relative, double radii) {
  std::size_t level = 0;
  while (level < potential.steps() &&
         is_inside(relative, potential.rules().steps[potential.steps() - level - 1].ratio * radii)) {
    ++level;
  }
  return static_cast<StepPotential::Level>(level);
}

}  // namespace

double World::largest_bounding_radius() const {
  return radii_.largest() * bounding_scale_;
}

void World::note_reaches() {
  has_steps_ = !interactions_.steps().empty();
  bounding_scale_ = std::max(motion_.largest_scale(), interactions_.steps().range());
}

double World::core_ratio(Slot a, Slot b) const {
  if (pass(a, b)) return 0;
  if (!has_steps()) return 1;
  const PairLevel* const pair = levels_.find(a, b);
  const StepTable::Number number = pair ? pair->potential : potential_of(a, b);
  return number == StepTable::kNone ? 1 : interactions_.steps()[number].rules().core;
}

double World::step_energy(Slot slot) const {
  ExactSum energy;
  for (const PairLevel& pair : levels_.of(slot))
    energy += interactions_.steps()[pair.potential].energy(pair.level) / 2;
  return energy.value();
}

double World::step_energy() const {
  ExactSum energy;
  for (Slot slot = 0; slot < size(); ++slot) {
    for (const PairLevel& pair : levels_.of(slot))
      energy += interactions_.steps()[pair.potential].energy(pair.level) / 2;
  }
  return energy.value();
}

void World::add_bond(SphereId a, SphereId b, StepTable::Number potential) {
  const std::string where = "bond of spheres " + to_text(a) + " and " + to_text(b);
  if (a == b) throw Error("a sphere is tied to itself", where, "give two spheres");
  if (potential >= interactions_.steps().size() || !interactions_.steps()[potential].is_tether())
    throw Error("the potential is not a tether of the step table", where, "give a number of add_bond");
  const Slot first = slot_of(a);
  const Slot second = slot_of(b);
  if (is_kinematic(first) && is_kinematic(second))
    throw Error("both spheres are kinematic, of infinite mass", where, "give one a finite mass");
  if (levels_.find(first, second)) throw Error("they are tied already", where, "give each bond once");
  levels_.set(first, second, potential, 1);
}

std::vector<Bond> World::bonds() const {
  if (!interactions_.steps().has_bonds()) return {};
  std::vector<Bond> bonds;
  for (const auto& [slot, pair] : levels_.in_order()) {
    if (!interactions_.steps()[pair.potential].is_tether()) continue;
    const auto [low, high] = std::minmax({id(slot), id(pair.partner)});
    bonds.push_back({low, high, pair.potential});
  }
  std::ranges::sort(bonds);
  return bonds;
}

void World::assign_levels(const Time& moment) {
  if (!has_steps()) return;
  check_ranges();
  const std::vector<std::pair<Slot, PairLevel>> before = levels_.in_order();
  for (const auto& [slot, pair] : before) {
    if (interactions_.steps()[pair.potential].is_tether()) {
      assign_level(slot, pair.partner, moment);
    } else {
      levels_.set(slot, pair.partner, pair.potential, 0);
    }
  }
  StaticHashGrid near(box_, size(), largest_bounding_radius());
  for (Slot slot = 0; slot < size(); ++slot) {
    const Vec3 center = position(slot, moment);
    near.for_each_near(center, bounding_radius(slot),
                       [&](std::uint32_t other, const Vec3& separation, double reach) {
                         // With a margin for rounding.
                         if (dot(separation, separation) <= 1.001 * (reach * reach))
                           assign_level(slot, static_cast<Slot>(other), moment);
                       });
    near.insert(center, bounding_radius(slot));
  }
}

void World::assign_levels(Slot added, std::span<const Slot> others, const Time& moment) {
  if (!has_steps()) return;
  check_ranges();
  for (const Slot other : others) {
    if (other != added) assign_level(added, other, moment);
  }
}

void World::assign_level(Slot a, Slot b, const Time& moment) {
  const PairLevel* const pair = levels_.find(a, b);
  const StepTable::Number number = pair ? pair->potential : potential_of(a, b);
  if (number == StepTable::kNone) return;
  const StepPotential& potential = interactions_.steps()[number];
  const double radii = base_radius(a) + base_radius(b);
  const State relative = relative_state(*this, a, b, moment);
  StepPotential::Level level = level_at(potential, relative, radii);
  if (potential.is_tether()) {
    const double ratio = length(relative.position) / radii;
    const double core = potential.rules().core;
    if (ratio > potential.range() * (1 + kBondTolerance) || ratio < core * (1 - kBondTolerance)) {
      throw Error(name_of(*this, a, b) + " are tied, and " + to_text(ratio) +
                      " of the sum of their radii apart, where " + to_text(core) + " to " +
                      to_text(potential.range()) + " is allowed",
                  "start state", "place them within their bond");
    }
    level = std::max<StepPotential::Level>(level, 1);
  }
  if (level != (pair ? pair->level : 0)) set_level(a, b, number, level, moment);
}

void World::set_level(Slot a, Slot b, StepTable::Number potential, StepPotential::Level level,
                      const Time& moment) {
  if (has_journal_) {
    const PairLevel* const before = levels_.find(a, b);
    journal_.note_level(moment, a, before ? *before : PairLevel{b, potential, 0});
  }
  levels_.set(a, b, potential, level);
}

// What the potentials do not allow of the world.
void World::check_steps() const {
  if (!has_steps()) return;
  const auto refuse = [](const char* what, const char* remedy) {
    throw Error(std::string("there are potentials of steps, and ") + what, "potential", remedy);
  };
  if (!motion_.is_straight()) refuse("there is gravity", "remove one of them");
  if (motion_.has_growth()) refuse("spheres grow", "remove one of them");
  if (interactions_.table().has_merging()) refuse("some spheres merge", "let them bounce");
  if (!interactions_.has_passing()) return;
  const StepTable& steps = interactions_.steps();
  // Species beyond those that are named are alike.
  const std::size_t species = std::max(interactions_.table().species(), steps.species()) + 1;
  const std::size_t most = std::numeric_limits<SpeciesId>::max() + std::size_t{1};
  for (std::size_t a = 0; a < std::min(species, most); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const auto one = static_cast<SpeciesId>(a);
      const auto other = static_cast<SpeciesId>(b);
      if (interactions_.pass(one, other) && steps.of(one, other) != StepTable::kNone)
        refuse("spheres of the same species pass through each other", "give the potential a core of zero");
    }
  }
}

// Of each pair only one image may be inside of a step.
void World::check_ranges() const {
  const double shortest = box_.shortest_period();
  const auto check = [&](double reach) {
    constexpr double kRoom = 1 - 1e-9;
    if (reach < shortest / 2 * kRoom) return;
    throw Error("a step of a potential is at the distance " + to_text(reach) +
                    ", and half of the periodic box is " + to_text(shortest / 2),
                "potential", "enlarge the box, or give steps at smaller ratios");
  };
  if (!(shortest < std::numeric_limits<double>::infinity())) return;
  constexpr std::size_t kSpecies = std::numeric_limits<SpeciesId>::max() + std::size_t{1};
  std::array<double, kSpecies> largest{};
  for (Slot slot = 0; slot < size(); ++slot)
    largest[species(slot)] = std::max(largest[species(slot)], base_radius(slot));
  const StepTable& steps = interactions_.steps();
  for (std::size_t a = 0; a < kSpecies; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      if (!(largest[a] > 0 && largest[b] > 0)) continue;
      const StepTable::Number number = steps.of(static_cast<SpeciesId>(a), static_cast<SpeciesId>(b));
      if (number != StepTable::kNone) check(steps[number].range() * (largest[a] + largest[b]));
    }
  }
  for (const auto& [slot, pair] : levels_.in_order())
    check(steps[pair.potential].range() * (base_radius(slot) + base_radius(pair.partner)));
}

PairEvent next_pair_event(const World& world, Slot a, Slot b, const Image& image) {
  if (const PairLevel* const pair = world.pair_levels().find(a, b))
    return next_pair_event(world, a, *pair, image);
  const StepTable::Number number = world.potential_of(a, b);
  const double radii = world.base_radius(a) + world.base_radius(b);
  const double reach =
      number == StepTable::kNone ? radii : world.interactions().steps()[number].inner_ratio(0) * radii;
  return {contact_time(world.motion(), world.path(a), world.path(b), world.box().shift(image), reach), false};
}

PairEvent next_pair_event(const World& world, Slot slot, const PairLevel& pair, const Image& image) {
  const StepPotential& potential = world.interactions().steps()[pair.potential];
  const double radii = world.base_radius(slot) + world.base_radius(pair.partner);
  const Path& a = world.path(slot);
  const Path& b = world.path(pair.partner);
  const Time start = later(a.time, b.time);
  const State relative = relative_state_at(StraightMotion(), a, b, world.box().shift(image), start);
  const WaitBetween<double> wait =
      wait_between<double>(relative.position, relative.velocity, potential.inner_ratio(pair.level) * radii,
                           potential.outer_ratio(pair.level) * radii);
  const bool is_outward = !(wait.inward < kNever.high);
  return {after(start, is_outward ? wait.outward : wait.inward), is_outward};
}

}  // namespace hardball
