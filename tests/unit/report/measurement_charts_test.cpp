// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/measurement_charts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace hardball::report::measurement_charts_test {
namespace {

Column column(const std::string& name, const std::string& unit, ColumnRole role, std::vector<double> values) {
  return {name, unit, role, std::move(values)};
}

TEST(MeasurementCharts, DrawValuesWithErrorsAgainstTheArgument) {
  Measurement measurement;
  measurement.title = "Mean square displacement";
  measurement.columns = {column("time", "T", ColumnRole::argument, {1, 2}),
                         column("mean_square", "L^2", ColumnRole::value, {3, 4}),
                         column("error", "L^2", ColumnRole::error, {0.3, 0.4}),
                         column("Enskog", "L^2", ColumnRole::theory, {5, 6})};
  measurement.is_logarithmic_in_value = true;
  const std::vector<chart::Chart> charts = charts_of(measurement);
  ASSERT_EQ(charts.size(), 1U);
  const chart::Chart& chart = charts[0];
  EXPECT_EQ(chart.title, "Mean square displacement");
  EXPECT_EQ(chart.x.label, "time  [T]");
  EXPECT_EQ(chart.y.label, "mean square  [L²]");
  EXPECT_FALSE(chart.x.logarithmic);
  EXPECT_TRUE(chart.y.logarithmic);
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_EQ(chart.series[0].name, "mean square");
  EXPECT_EQ(chart.series[0].x, (std::vector<double>{1, 2}));
  EXPECT_EQ(chart.series[0].y, (std::vector<double>{3, 4}));
  EXPECT_EQ(chart.series[0].y_error, (std::vector<double>{0.3, 0.4}));
  EXPECT_TRUE(chart.series[0].marks);
  EXPECT_FALSE(chart.series[0].line) << "the theory goes through the points";
  EXPECT_FALSE(chart.series[0].reference);
  EXPECT_EQ(chart.series[1].name, "Enskog");
  EXPECT_EQ(chart.series[1].y, (std::vector<double>{5, 6}));
  EXPECT_TRUE(chart.series[1].reference);
  EXPECT_FALSE(chart.series[1].marks);
}

TEST(MeasurementCharts, GiveEachUnitAndArgumentAChart) {
  Measurement measurement;
  measurement.title = "Profiles";
  measurement.columns = {column("z", "L", ColumnRole::argument, {1, 2}),
                         column("density", "L^-3", ColumnRole::value, {1, 2}),
                         column("temperature", "M L^2 T^-2", ColumnRole::value, {1, 2}),
                         column("bulk_density", "L^-3", ColumnRole::value, {3, 4}),
                         column("error", "L^-3", ColumnRole::error, {0.3, 0.4}),
                         column("speed", "L T^-1", ColumnRole::argument, {5, 6}),
                         column("density", "L^-3", ColumnRole::value, {7, 8})};
  const std::vector<chart::Chart> charts = charts_of(measurement);
  ASSERT_EQ(charts.size(), 3U);
  EXPECT_EQ(charts[0].title, "Profiles: density, bulk density");
  ASSERT_EQ(charts[0].series.size(), 2U);
  EXPECT_TRUE(charts[0].series[0].y_error.empty()) << "errors are those of the value before them";
  EXPECT_EQ(charts[0].series[1].y_error, (std::vector<double>{0.3, 0.4}));
  EXPECT_EQ(charts[1].y.label, "temperature  [M L² T⁻²]");
  EXPECT_TRUE(charts[1].series[0].name.empty()) << "a single curve needs no legend";
  EXPECT_TRUE(charts[1].series[0].line) << "points without a theory are joined";
  EXPECT_EQ(charts[2].series[0].x, (std::vector<double>{5, 6}));
  EXPECT_EQ(charts[2].series[0].y, (std::vector<double>{7, 8}));
}

TEST(MeasurementCharts, NameTheQuantityAtTheAxisAndTheSpeciesInTheLegend) {
  Measurement measurement;
  measurement.title = "Velocity autocorrelation";
  measurement.columns = {column("lag", "T", ColumnRole::argument, {1, 2}),
                         column("diffusion_integral_1", "L^2 T^-1", ColumnRole::value, {1, 2}),
                         column("diffusion_integral_2", "L^2 T^-1", ColumnRole::value, {3, 4})};
  const chart::Chart chart = charts_of(measurement, SpeciesNames({"helium", "krypton"})).at(0);
  EXPECT_EQ(chart.y.label, "diffusion integral  [L² T⁻¹]");
  EXPECT_EQ(chart.series[0].name, "diffusion integral, helium");
  EXPECT_EQ(chart.series[1].name, "diffusion integral, krypton");
}

TEST(MeasurementCharts, HaveLabelsThatFitWithTheirUnits) {
  Measurement measurement;
  measurement.title = "Profiles";
  measurement.columns = {column("z", "L", ColumnRole::argument, {1, 2}),
                         column("pressure_along_walls", "M L^-1 T^-2", ColumnRole::value, {1, 2}),
                         column("across_walls", "M L^-1 T^-2", ColumnRole::value, {3, 4})};
  EXPECT_EQ(charts_of(measurement).at(0).y.label, "Profiles  [M L⁻¹ T⁻²]");
}

TEST(MeasurementCharts, ManyPointsAreALineInABand) {
  Measurement measurement;
  const std::vector<double> many(200, 1.0);
  measurement.columns = {column("r", "L", ColumnRole::argument, many),
                         column("g", "1", ColumnRole::value, many),
                         column("error", "1", ColumnRole::error, many)};
  const std::vector<chart::Chart> charts = charts_of(measurement);
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_TRUE(charts[0].series[0].line);
  EXPECT_FALSE(charts[0].series[0].marks);
  EXPECT_TRUE(charts[0].series[0].error_band);
}

TEST(MeasurementCharts, LeaveOutWhatHasNoPoint) {
  EXPECT_TRUE(charts_of({}).empty());
  Measurement measurement;
  measurement.columns = {column("r", "L", ColumnRole::argument, {0, 1}),
                         column("g", "1", ColumnRole::value, {1, std::nan("")})};
  measurement.columns.push_back(column("g_theory", "1", ColumnRole::theory, {std::nan(""), std::nan("")}));
  ASSERT_EQ(charts_of(measurement).size(), 1U);
  EXPECT_EQ(charts_of(measurement)[0].series.size(), 1U) << "no legend entry for an absent curve";
  measurement.is_logarithmic_in_argument = true;
  EXPECT_TRUE(charts_of(measurement).empty()) << "the only point has no logarithm";
}

}  // namespace
}  // namespace hardball::report::measurement_charts_test
