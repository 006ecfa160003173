// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/step_potential.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"

namespace hardball::step_potential_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string problem_of(const StepRules& rules) {
  try {
    static_cast<void>(StepPotential(rules));
  } catch (const Error& error) {
    return error.problem();
  }
  return "";
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
}  // namespace hardball::step_potential_test
