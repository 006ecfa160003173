// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/response_table.hpp"
#include "hardball/errors/error.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace hardball::response_table_test {
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

}  // namespace
}  // namespace hardball::response_table_test
