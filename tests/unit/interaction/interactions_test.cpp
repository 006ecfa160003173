// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/response_table.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <string>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/interaction/step_potential.hpp"
#include "support/refusal.hpp"

namespace hardball::interactions_test {
namespace {

Bounce with(double restitution) {
  return Bounce({.restitution = ConstantRestitution{restitution}});
}

double restitution_of(const Rule& rule) {
  return std::get<ConstantRestitution>(std::get<Bounce>(rule).rules().restitution).value;
}

TEST(ResponseTable, HasOneRuleForEachPairAndWall) {
  ResponseTable table(with(0.5), with(0.25));
  table.set(3, 1, with(0.75));
  table.set_wall(1, with(0.125));
  EXPECT_EQ(restitution_of(table.rule(1, 3)), 0.75);
  EXPECT_EQ(restitution_of(table.rule(3, 1)), 0.75);
  // Rules stay when the table grows.
  table.set(7, 7, Merging());
  EXPECT_EQ(restitution_of(table.rule(3, 1)), 0.75);
  EXPECT_TRUE(std::holds_alternative<Merging>(table.rule(7, 7)));
  EXPECT_EQ(restitution_of(table.wall(1)), 0.125);
  for (const SpeciesId other : std::initializer_list<SpeciesId>{0, 2, 5, 255}) {
    EXPECT_EQ(restitution_of(table.rule(other, 7)), 0.5);
    EXPECT_EQ(restitution_of(table.rule(other, other)), 0.5);
    EXPECT_EQ(restitution_of(table.wall(other)), 0.25);
  }
  table.set(1, 3, with(0));
  EXPECT_EQ(restitution_of(table.rule(3, 1)), 0);
}

TEST(ResponseTable, KnowsWhetherSpheresMerge) {
  ResponseTable table;
  EXPECT_FALSE(table.has_merging());
  table.set(0, 1, Merging());
  EXPECT_TRUE(table.has_merging());
  EXPECT_TRUE(ResponseTable(Merging()).has_merging());
}

TEST(ResponseTable, RespondsByTheSpeciesOfTheContact) {
  ResponseTable table(with(1), with(0.5));
  table.set(1, 2, Merging());
  Contact contact;
  contact.separation = {1, 0, 0};
  contact.reach = 1;
  contact.first_radius = 0.5;
  contact.first_mass = contact.second_mass = 1;
  contact.before = contact.after = {{1, 0, 0}, {-1, 0, 0}};
  EXPECT_EQ(table(contact).velocities.first, (Vec3{-1, 0, 0}));
  contact.first_species = 2;
  contact.second_species = 1;
  EXPECT_TRUE(table(contact).merges);
  contact.kind = EventKind::wall;
  contact.wall_normal = {1, 0, 0};
  contact.before.second = {};
  EXPECT_FALSE(table(contact).merges);
  EXPECT_EQ(table(contact).velocities.first, (Vec3{-0.5, 0, 0}));
}

TEST(ResponseTable, LetsTheSamePassAsAnother) {
  ResponseTable before;
  before.set(0, 2, Passing());
  ResponseTable table{Merging()};
  table.pass_as_in(before);
  EXPECT_TRUE(table.pass(0, 2));
  EXPECT_TRUE(table.pass(2, 0));
  EXPECT_FALSE(table.pass(0, 0));
  EXPECT_FALSE(table.pass(2, 9));
  EXPECT_TRUE(std::holds_alternative<Merging>(table.rule(2, 9)));
  ResponseTable all{Passing()};
  EXPECT_THROW(all.pass_as_in(before), Error);
  ResponseTable others{Merging()};
  others.pass_as_in(all);
  EXPECT_TRUE(others.pass(7, 9)) << "species that no rule names";
}

TEST(ResponseTable, KnowsTheOneResponseOfAll) {
  const Bounce bounce(Restitution(0.5, 0.01));
  ResponseTable table(bounce, bounce);
  table.set(0, 1, Passing());
  EXPECT_EQ(table.one_for_all(), Restitution(0.5, 0.01));
  EXPECT_EQ(table.restitution(), 0.5);
  table.set_wall(1, Bounce(Restitution(0.5)));
  EXPECT_FALSE(table.one_for_all()) << "slow impacts at walls differ";
  EXPECT_FALSE(ResponseTable(Bounce({.tangential_restitution = 0})).one_for_all());
  EXPECT_FALSE(ResponseTable(Merging()).one_for_all());
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string problem_of(const StepRules& rules) {
  return support::problem_of([&] { static_cast<void>(StepPotential(rules)); });
}

TEST(StepPotential, HasLevelsFromTheOutsideIn) {
  const StepPotential potential({.steps = {{1.2, -3}, {1.5, -1}, {2, 0.5}}});
  EXPECT_EQ(potential.steps(), 3U);
  EXPECT_EQ(potential.range(), 2);
  EXPECT_EQ(potential.energy(0), 0);
  EXPECT_EQ(potential.energy(1), 0.5);
  EXPECT_EQ(potential.energy(2), -1);
  EXPECT_EQ(potential.energy(3), -3);
  EXPECT_EQ(potential.inner_ratio(0), 2);
  EXPECT_EQ(potential.inner_ratio(2), 1.2);
  EXPECT_EQ(potential.inner_ratio(3), 1) << "the core";
  EXPECT_EQ(potential.outer_ratio(1), 2);
  EXPECT_EQ(potential.outer_ratio(3), 1.2);
  EXPECT_TRUE(potential.is_innermost(3));
  EXPECT_EQ(potential.rise(0, false), 0.5);
  EXPECT_EQ(potential.rise(1, true), -0.5);
  EXPECT_EQ(potential.rise(2, false), -2);
  EXPECT_EQ(potential.rise(3, true), 2);
}

TEST(StepPotential, EndsAtATetherForEver) {
  const StepPotential tether({.steps = {{1.1, -1}, {1.3, 0}}, .core = 0.9, .is_tether = true});
  EXPECT_EQ(tether.rise(1, true), kInfinity);
  EXPECT_EQ(tether.rise(2, true), 1);
  EXPECT_EQ(tether.inner_ratio(2), 0.9);
}

TEST(StepPotential, RefusesWhatIsNone) {
  EXPECT_EQ(problem_of({}), "a potential has no steps");
  EXPECT_NE(problem_of({.steps = {{1.5, -1}, {1.2, -1}}}).find("the ratio 1.2"), std::string::npos);
  EXPECT_NE(problem_of({.steps = {{1.0, -1}}}).find("the ratio 1"), std::string::npos);
  EXPECT_NE(problem_of({.steps = {{0, -1}}, .core = 0}), "");
  EXPECT_NE(problem_of({.steps = {{1.5, kInfinity}}}).find("the energy inf"), std::string::npos);
  EXPECT_NE(problem_of({.steps = {{1.5, -1}}, .core = -1}).find("core"), std::string::npos);
  EXPECT_NE(problem_of({.steps = {{std::numeric_limits<double>::quiet_NaN(), -1}}}), "");
  StepRules many;
  for (int k = 0; k < 256; ++k) many.steps.push_back({1.1 + k, -1});
  EXPECT_NE(problem_of(many).find("255"), std::string::npos);
  many.steps.pop_back();
  EXPECT_EQ(problem_of(many), "");
}

TEST(StepTable, KnowsThePotentialOfEachPairOfSpecies) {
  StepTable table;
  EXPECT_TRUE(table.empty());
  EXPECT_EQ(table.of(0, 0), StepTable::kNone);
  EXPECT_EQ(table.range(), 1);
  table.set(2, 0, StepPotential({.steps = {{1.5, -1}}}));
  EXPECT_EQ(table.of(0, 2), 0);
  EXPECT_EQ(table.of(2, 0), 0);
  EXPECT_EQ(table.of(0, 0), StepTable::kNone);
  EXPECT_EQ(table.of(7, 7), StepTable::kNone);
  table.set_for_all(StepPotential({.steps = {{1.2, 2}}}));
  EXPECT_EQ(table.of(0, 0), 1);
  EXPECT_EQ(table.of(7, 200), 1);
  EXPECT_EQ(table.of(0, 2), 0);
  table.set(5, 5, StepPotential({.steps = {{1.9, -1}}}));
  EXPECT_EQ(table.of(0, 2), 0) << "what was set before stays";
  EXPECT_EQ(table.range(), 1.9);
  EXPECT_EQ(table.add_bond(StepPotential({.steps = {{3, 0}}, .is_tether = true})), 3);
  EXPECT_EQ(table.range(), 1.9) << "bonds are known without a range";
  EXPECT_THROW(table.add_bond(StepPotential({.steps = {{3, 0}}})), Error);
  EXPECT_THROW(table.set(0, 0, StepPotential({.steps = {{3, 0}}, .is_tether = true})), Error);
  EXPECT_THROW(table.set_for_all(StepPotential({.steps = {{3, 0}}, .is_tether = true})), Error);
}

TEST(StepTable, IsSaved) {
  StepTable table;
  table.set(1, 0, StepPotential({.steps = {{1.2, -2}, {1.5, -1}}, .core = 0.5}));
  table.set_for_all(StepPotential({.steps = {{1.2, 2}}}));
  StepTable loaded;
  restore(archived(table), "test", loaded);
  EXPECT_EQ(loaded.size(), 2U);
  EXPECT_EQ(loaded.range(), 1.5);
  EXPECT_EQ(loaded.of(0, 1), 0);
  EXPECT_EQ(loaded[0].rules().steps, table[0].rules().steps);
  EXPECT_EQ(loaded[0].rules().core, 0.5);
}

}  // namespace
}  // namespace hardball::interactions_test
