// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/measure_unit_costs.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "hardball/tuning/cell_edge.hpp"
#include "unit/theory/some_gas.hpp"

namespace hardball::measure_unit_costs_test {
namespace {

TEST(MeasureUnitCosts, FindsCostsFromWhichCellsCanBeChosen) {
  const auto clock = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  const UnitCosts costs = measure_unit_costs(clock);
  EXPECT_GT(costs.prediction, 0);
  EXPECT_GE(costs.contact, 0);
  EXPECT_GE(costs.enter, 0);
  EXPECT_GE(costs.cell, 0);
  EXPECT_GT(costs.enter + costs.cell, 0);
  // On any machine, however busy: the optimum is flat and tolerates large errors in the costs.
  const GasStatistics statistics = support::some_gas(20000, 0.05, 0.5);
  const double edge = optimal_cell_edge(statistics, costs);
  EXPECT_GT(edge, optimal_cell_edge(statistics) / 10);
  EXPECT_LT(edge, optimal_cell_edge(statistics) * 10);
}

TEST(MeasureUnitCosts, EndsEvenIfTheClockStandsStill) {
  EXPECT_EQ(measure_unit_costs([] { return 0.0; }), UnitCosts{});
}

}  // namespace
}  // namespace hardball::measure_unit_costs_test
