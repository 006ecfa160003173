// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/measurement_charts.hpp"

#include <algorithm>
#include <cmath>

#include "apps/report/number_text.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball::report {
namespace {

constexpr std::size_t kMaxMarks = 60;
constexpr std::size_t kLongestLabel = 38;  // with its unit; longer ones are not joined of names

std::string label_of(const std::string& name, const std::string& unit) {
  const std::string text = unit_text(unit);
  return text.empty() ? name : name + "  [" + text + "]";
}

std::size_t characters_of(const std::string& text) {
  return static_cast<std::size_t>(
      ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

// A chart under construction.
struct Group {
  const Column* argument;
  std::string unit;
  std::vector<const Column*> values;
  chart::Chart chart;
};

Group& group_of(std::vector<Group>& groups, const Column* argument, const std::string& unit) {
  for (Group& group : groups) {
    if (group.argument == argument && group.unit == unit) return group;
  }
  groups.push_back({argument, unit, {}, {}});
  return groups.back();
}

bool is_drawn(const chart::Chart& chart, double x, double y) {
  return std::isfinite(x) && std::isfinite(y) && (!chart.x.logarithmic || x > 0) &&
         (!chart.y.logarithmic || y > 0);
}

bool has_points(const chart::Chart& chart, const chart::Series& series) {
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (is_drawn(chart, series.x[i], series.y[i])) return true;
  }
  return false;
}

// What the curves of a chart are of, each name once.
std::string quantities_of(const std::vector<const Column*>& values, const SpeciesNames& species) {
  std::vector<std::string> names;
  for (const Column* value : values) {
    const std::string name = species.quantity(value->name);
    if (ranges::find(names, name) == names.end()) names.push_back(name);
  }
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

}  // namespace

std::vector<chart::Chart> charts_of(const Measurement& measurement, const SpeciesNames& species) {
  std::vector<Group> groups;
  const Column* argument = nullptr;
  Group* group = nullptr;    // that of the value column before
  std::size_t measured = 0;  // its series there
  for (const Column& column : measurement.columns) {
    switch (column.role) {
      case ColumnRole::argument:
        argument = &column;
        group = nullptr;
        break;
      case ColumnRole::value: {
        if (!argument) break;
        group = &group_of(groups, argument, column.unit);
        group->values.push_back(&column);
        const bool is_sparse = column.values.size() <= kMaxMarks;
        measured = group->chart.series.size();
        group->chart.series.push_back({.name = species.readable(column.name),
                                       .x = argument->values,
                                       .y = column.values,
                                       .line = !is_sparse,
                                       .marks = is_sparse,
                                       .error_band = !is_sparse});
        break;
      }
      case ColumnRole::error:
        if (group) group->chart.series[measured].y_error = column.values;
        break;
      case ColumnRole::theory:
        if (!group) break;
        group->chart.series.push_back({.name = species.readable(column.name),
                                       .x = argument->values,
                                       .y = column.values,
                                       .marks = false,
                                       .dashed = true,
                                       .reference = true});
        break;
    }
  }
  std::vector<chart::Chart> charts;
  for (Group& each : groups) {
    const std::string names = quantities_of(each.values, species);
    const bool is_only = groups.size() == 1;
    each.chart.title = is_only ? measurement.title : measurement.title + ": " + names;
    std::string label = label_of(names, each.unit);
    if (characters_of(label) > kLongestLabel) label = label_of(measurement.title, each.unit);
    each.chart.x = {.label = label_of(species.quantity(each.argument->name), each.argument->unit),
                    .logarithmic = measurement.is_logarithmic_in_argument};
    each.chart.y = {.label = label, .logarithmic = measurement.is_logarithmic_in_value};
    std::erase_if(each.chart.series,
                  [&](const chart::Series& series) { return !has_points(each.chart, series); });
    if (each.chart.series.empty()) continue;
    // Points without a theory are joined.
    const auto is_reference = [](const chart::Series& series) { return series.reference; };
    if (std::none_of(each.chart.series.begin(), each.chart.series.end(), is_reference)) {
      for (chart::Series& series : each.chart.series) series.line = true;
    }
    // A single curve needs no legend: the axis has its name.
    if (each.chart.series.size() == 1) each.chart.series.front().name.clear();
    charts.push_back(std::move(each.chart));
  }
  return charts;
}

}  // namespace hardball::report
