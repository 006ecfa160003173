// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/measurement_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace hardball::measurement_json_test {
namespace {

using nlohmann::json;

TEST(MeasurementsJson, IsReadByAParser) {
  const double third = 1.0 / 3;
  Measurement found{
      .name = "things", .title = "\"Things\"\n\x1f", .formula = "$\\frac{1}{3}$", .source = "here"};
  found.quantities = {{"size", "L", third, 0.5, std::nan(""), kForComparison, "why"}};
  found.columns = {{"radius", "L", ColumnRole::argument, {1, 2}},
                   {"count", "1", ColumnRole::value, {third, -std::nan("")}},
                   {"count_theory", "1", ColumnRole::theory, {}}};
  found.is_transient_over = false;
  const json read = json::parse(measurements_json(std::vector{found, found}));
  ASSERT_EQ(read.size(), 2U);
  const json& one = read[1];
  EXPECT_EQ(one["name"], "things");
  EXPECT_EQ(one["title"], found.title);
  EXPECT_EQ(one["formula"], found.formula);
  EXPECT_EQ(one["source"], "here");
  EXPECT_EQ(one["duration"], nullptr);
  EXPECT_EQ(one["transient"], 0);
  EXPECT_EQ(one["transient_over"], false);
  EXPECT_EQ(one["unsettled"], "");
  EXPECT_EQ(one["logarithmic_in_argument"], false);
  EXPECT_EQ(one["quantities"], json::parse(R"([{"name": "size", "unit": "L", "value": 0.3333333333333333,
      "error": 0.5, "theory": null, "tolerance": null, "reason": "why"}])"));
  EXPECT_EQ(one["columns"][1], json::parse(R"({"name": "count", "unit": "1", "role": "value",
      "values": [0.3333333333333333, null]})"));
  EXPECT_EQ(one["columns"][0]["role"], "argument");
  EXPECT_EQ(one["columns"][2]["values"], json::array());
}

TEST(MeasurementsJson, IsAnEmptyListWithoutMeasurements) {
  EXPECT_EQ(measurements_json({}), "[]");
}

}  // namespace
}  // namespace hardball::measurement_json_test
