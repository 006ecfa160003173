// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/result.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/measurement.hpp"

namespace hardball::result_test {
namespace {

struct Edge {
  static constexpr std::string_view kName = "edge";
  static constexpr Definition kDefinition{
      .title = "Edge", .formula = "$a$", .source = "Euclid", .source_of_discs = "Abbott"};

  bool has_settled = true;

  void add_results(const Scene& scene, Measurement& found) const {
    Transient{.end = {}, .is_over = has_settled, .reason = has_settled ? "" : "it grows"}.note_in(found);
    found.add("edge", "L", {scene.world().box().size().x, 0.5}, 3);
    found.add_argument("number", "1", {1});
    found.add("length", "L", std::vector<Estimate>{{2, 0.25}});
  }
};

TEST(ResultOf, HasTheDefinitionOfItsDimensions) {
  const World space(Box::periodic({2, 2, 2}));
  const Measurement found = result_of(Edge(), {space, Time(0)});
  EXPECT_EQ(found.name, "edge");
  EXPECT_EQ(found.title, "Edge");
  EXPECT_EQ(found.formula, "$a$");
  EXPECT_EQ(found.source, "Euclid");
  EXPECT_EQ(support::quantity(found, "edge").value, 2);
  const World plane(Box::flat_periodic(2, 2));
  EXPECT_EQ(result_of(Edge(), {plane, Time(0)}).formula, "$a$");
  EXPECT_EQ(result_of(Edge(), {plane, Time(0)}).source, "Abbott");
}

TEST(ResultOf, HasErrorsOnlyIfItHasSettled) {
  const World world(Box::periodic({2, 2, 2}));
  const Measurement settled = result_of(Edge(), {world, Time(0)});
  EXPECT_EQ(support::quantity(settled, "edge").error, 0.5);
  EXPECT_EQ(support::quantity(settled, "edge").reason, "");
  EXPECT_EQ(support::values(settled, "length_error").front(), 0.25);
  const Measurement growing = result_of(Edge{.has_settled = false}, {world, Time(0)});
  EXPECT_TRUE(std::isnan(support::quantity(growing, "edge").error));
  EXPECT_EQ(support::quantity(growing, "edge").reason, "it grows");
  EXPECT_EQ(support::quantity(growing, "edge").tolerance, kForComparison);
  EXPECT_TRUE(std::isnan(support::values(growing, "length_error").front()));
}

}  // namespace
}  // namespace hardball::result_test
