// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/measurement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hardball::measurement_test {
namespace {

// As columns_csv() and quantities_csv() have it.
TEST(Measurement, AddsNumbersAndColumnsWithErrorsAndTheory) {
  Measurement found{.name = "things", .title = "", .formula = "", .source = ""};
  found.add("size", "L", {2, 0.5}, 3, 0.25).reason = "why";
  found.add("count", "1", Estimate{7});
  found.add_argument("radius", "L", bin_middles(1, 0.5, 2));
  found.add("all", "1", std::vector<double>{5, 6});
  found.add("part", "1", std::vector<Estimate>{{0.5, 0.125}, {}}, std::vector<double>{0.75, 1});
  EXPECT_EQ(columns_csv(found),
            "radius [L],all [1],part [1],part_error [1],part_theory [1]\n"
            "1.25,5,0.5,0.125,0.75\n1.75,6,nan,nan,1\n");
  EXPECT_EQ(quantities_csv(std::vector{found}),
            "measure,name,value,error,theory,unit,transient [T],tolerance,reason\n"
            "things,size,2,0.5,3,L,0,0.25,why\nthings,count,7,nan,nan,1,0,0,\n");
  EXPECT_EQ(found.columns.back().role, ColumnRole::theory);
}

TEST(Csv, NamesColumnsWithTheirUnitsAndRoundTrips) {
  const double third = 1.0 / 3;
  const Measurement measurement{
      .name = "things",
      .title = "Things",
      .formula = "",
      .source = "",
      .quantities = {{"size", "L", third, 0.5, std::nan("")}},
      .columns = {{"radius", "L", ColumnRole::argument, {1, 2}},
                  {"count", "1", ColumnRole::value, {third, -std::nan("")}}},
  };
  EXPECT_EQ(columns_csv(measurement), "radius [L],count [1]\n1,0.3333333333333333\n2,nan\n");
  EXPECT_EQ(quantities_csv(std::vector{measurement}),
            "measure,name,value,error,theory,unit,transient [T],tolerance,reason\n"
            "things,size,0.3333333333333333,0.5,nan,L,0,0,\n");
  Measurement changing = measurement;
  changing.duration = 8;
  changing.transient = 1.5;
  EXPECT_NE(quantities_csv(std::vector{changing}).find(",L,1.5,0,\n"), std::string::npos);
  changing.is_transient_over = false;
  EXPECT_NE(quantities_csv(std::vector{changing}).find(",L,8,0,\n"), std::string::npos);
  Measurement without = measurement;
  without.quantities = {{.name = "size", .unit = "L", .tolerance = 0.25, .reason = "the run is too short"}};
  EXPECT_NE(quantities_csv(std::vector{without}).find("size,nan,nan,nan,L,0,0.25,the run is too short\n"),
            std::string::npos);
  EXPECT_EQ(columns_csv({.name = "none", .title = "", .formula = "", .source = ""}), "");
}

}  // namespace
}  // namespace hardball::measurement_test
