// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "apps/chart/chart.hpp"

namespace hardball::bench {
namespace {

using Quantity = std::function<double(const Row&)>;

// NaN becomes an empty field.
std::string field(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.6g}", value);
}

std::string comments(const std::vector<std::string>& header) {
  std::string text;
  for (const std::string& line : header) text += "# " + line + "\n";
  return text;
}

// The rows of a method, and of one step if it has steps.
std::vector<Row> rows_of(const std::vector<Row>& rows, std::string_view method, double step_radii = kNone) {
  std::vector<Row> chosen;
  for (const Row& row : rows) {
    if (row.method == method && (std::isnan(step_radii) || row.step_radii == step_radii))
      chosen.push_back(row);
  }
  return chosen;
}

chart::Series series_of(const std::vector<Row>& rows, const std::string& name, const Quantity& quantity) {
  chart::Series series{.name = name};
  for (const Row& row : rows) {
    series.x.push_back(static_cast<double>(row.spheres));
    series.y.push_back(quantity(row));
  }
  return series;
}

// A guide for the eye through the first point.
chart::Series proportional_to_n(const std::vector<Row>& rows) {
  chart::Series guide{.name = "proportional to n", .marks = false, .dashed = true};
  for (const Row& row : rows) {
    const double n = static_cast<double>(row.spheres);
    guide.x.push_back(n);
    guide.y.push_back(rows.front().seconds * n / static_cast<double>(rows.front().spheres));
  }
  return guide;
}

const chart::Axis kSpheresAxis{.label = "number of spheres n", .logarithmic = true};

chart::Chart time_chart(const Results& results) {
  const std::vector<Row>& rows = results.rows;
  const Quantity seconds = [](const Row& row) { return row.seconds; };
  const std::vector<Row> cells = rows_of(rows, "cells");
  chart::Chart chart{.title = "(a) Cost of a unit of simulated time",
                     .x = kSpheresAxis,
                     .y = {.label = "seconds per unit of time", .logarithmic = true}};
  chart.series = {series_of(cells, "Hardball, cells", seconds),
                  series_of(rows_of(rows, "paper"), "paper's algorithm", seconds),
                  series_of(rows_of(rows, "all_pairs"), "events, all pairs", seconds)};
  for (const std::size_t i : kStepsTaken) {
    chart.series.push_back(series_of(rows_of(rows, "time_stepped", kSteps[i].radii),
                                     fmt::format("steps of {} radius", kSteps[i].name), seconds));
  }
  chart.series.push_back(
      series_of(rows_of(results.rows_at_fixed_density, "cells"), "cells, fixed density", seconds));
  chart.series.push_back(proportional_to_n(rows_of(results.rows_at_fixed_density, "cells")));
  return chart;
}

chart::Chart event_cost_chart(const Results& results) {
  const Quantity microseconds = [](const Row& row) { return 1e6 * row.seconds_per_event(); };
  chart::Chart chart{.title = "(b) Cost of an event",
                     .x = kSpheresAxis,
                     .y = {.label = "microseconds per event", .logarithmic = true}};
  const std::vector<Row>& growing = results.rows_at_fixed_density;
  chart.series = {series_of(rows_of(results.rows, "cells"), "Hardball, fixed box", microseconds),
                  series_of(rows_of(results.rows, "paper"), "paper's algorithm, fixed box", microseconds),
                  series_of(rows_of(growing, "cells"), "Hardball, fixed density", microseconds),
                  series_of(rows_of(growing, "paper"), "paper's algorithm, fixed density", microseconds)};
  for (std::size_t i = 2; i < chart.series.size(); ++i) chart.series[i].dashed = true;
  return chart;
}

chart::Chart missed_chart(const std::vector<StepRow>& steps) {
  chart::Series measured{.name = "no check while they overlap", .line = false};
  chart::Series stepped{.name = "not resolved by time steps", .line = false};
  chart::Series theory{.name = "kinetic theory", .marks = false};
  for (const StepRow& row : steps) {
    for (chart::Series* series : {&measured, &stepped, &theory}) series->x.push_back(row.step.radii);
    measured.y.push_back(row.missed_share());
    const bool is_significant = row.unresolved_share() > 2 * row.unresolved_error();
    stepped.y.push_back(is_significant ? row.unresolved_share() : kNone);
    theory.y.push_back(row.expected_share);
  }
  return {.title = "(c) Collisions missed by time steps",
          .x = {.label = "step, in radii at mean speed", .logarithmic = true},
          .y = {.label = "share of collisions", .logarithmic = true},
          .series = {measured, stepped, theory}};
}

chart::Chart events_chart(const std::vector<Row>& rows) {
  const std::vector<Row> cells = rows_of(rows, "cells");
  return {.title = "(d) Events of the cell grid",
          .x = kSpheresAxis,
          .y = {.label = "events per unit of time", .logarithmic = true},
          .series = {series_of(cells, "collisions", [](const Row& row) { return row.collisions; }),
                     series_of(cells, "wall contacts", [](const Row& row) { return row.walls; }),
                     series_of(cells, "cells entered", [](const Row& row) { return row.enters; })}};
}

using Range = std::pair<std::size_t, std::size_t>;  // of numbers of spheres, both included

void add_fit(std::vector<Exponent>& exponents, const std::vector<Row>& rows, const Range& range, Exponent fit,
             const Quantity& value) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Row& row : rows) {
    if (row.spheres < range.first || row.spheres > range.second) continue;
    if (x.empty()) fit.from = row.spheres;
    fit.to = row.spheres;
    x.push_back(static_cast<double>(row.spheres));
    y.push_back(value(row));
  }
  if (x.size() < 2) return;
  fit.law = fit_power_law(x, y);
  exponents.push_back(std::move(fit));
}

// All fits of one method.
void add_fits(std::vector<Exponent>& exponents, const std::vector<Row>& rows, const std::string& box,
              const std::vector<Range>& ranges) {
  if (rows.empty()) return;
  const std::string& method = rows.front().method;
  const auto add = [&](const std::string& quantity, const Quantity& value) {
    for (const Range& range : ranges)
      add_fit(exponents, rows, range, {.method = method, .quantity = quantity, .box = box}, value);
  };
  add("seconds_per_unit_time", [](const Row& row) { return row.seconds; });
  if (std::isnan(rows.front().collisions)) return;
  add("events_per_unit_time", [](const Row& row) { return row.events(); });
  add("seconds_per_event", [](const Row& row) { return row.seconds_per_event(); });
}

}  // namespace

std::vector<Exponent> fit_exponents(const Results& results) {
  std::vector<Exponent> exponents;
  const std::vector<Range> regimes = {{0, 10'000}, {20'000, 200'000}};
  const std::vector<Range> all = {{0, std::numeric_limits<std::size_t>::max()}};
  for (const std::string_view method : {"cells", "paper", "all_pairs"}) {
    add_fits(exponents, rows_of(results.rows, method), "fixed", regimes);
    add_fits(exponents, rows_of(results.rows_at_fixed_density, method), "growing", all);
  }
  // One step stands for all: the others differ by a factor.
  const double step = kSteps[kStepsTaken.front()].radii;
  add_fits(exponents, rows_of(results.rows, "time_stepped", step), "fixed", regimes);
  return exponents;
}

std::string figure_csv(const Results& results, const std::vector<std::string>& header) {
  std::string text = comments(header);
  text +=
      "method,spheres,box_edge,packing_fraction,step_radii,step,seconds_per_unit_time,minimum,maximum,"
      "repetitions,"
      "span,"
      "collisions_per_unit_time,walls_per_unit_time,enters_per_unit_time,leaves_per_unit_time,"
      "events_per_unit_time,seconds_per_event,seconds_per_collision,missed_share,note\n";
  std::vector<Row> rows = results.rows;
  rows.insert(rows.end(), results.rows_at_fixed_density.begin(), results.rows_at_fixed_density.end());
  for (const Row& row : rows) {
    text +=
        fmt::format("{},{},{:.6g},{:.4f},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.method,
                    row.spheres, row.box_edge, row.packing_fraction(), field(row.step_radii), field(row.step),
                    field(row.seconds), field(row.seconds_minimum), field(row.seconds_maximum),
                    row.repetitions, field(row.span), field(row.collisions), field(row.walls),
                    field(row.enters), field(row.leaves), field(row.events()), field(row.seconds_per_event()),
                    field(row.seconds_per_collision()), field(row.missed_share), row.note);
  }
  return text;
}

std::string steps_csv(const Results& results, const std::vector<std::string>& header) {
  std::string text = comments(header);
  text +=
      "step_radii,step,collisions,missed,missed_share,expected_share,spheres,span,exact_collisions,"
      "resolved_collisions,unresolved_share,unresolved_error\n";
  for (const StepRow& row : results.steps) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{}\n", field(row.step.radii), field(row.step.duration()),
        row.contacts, row.missed, field(row.missed_share()), field(row.expected_share),
        std::isnan(row.exact) ? "" : fmt::format("{}", row.spheres), field(row.span), field(row.exact),
        field(row.resolved), field(row.unresolved_share()), field(row.unresolved_error()));
  }
  return text;
}

std::string exponents_csv(const std::vector<Exponent>& exponents, const std::vector<std::string>& header) {
  std::string text = comments(header) + "method,quantity,box,from,to,points,exponent,standard_error\n";
  for (const Exponent& fit : exponents) {
    text += fmt::format("{},{},{},{},{},{},{},{}\n", fit.method, fit.quantity, fit.box, fit.from, fit.to,
                        fit.law.points, field(fit.law.exponent), field(fit.law.standard_error));
  }
  return text;
}

std::string exponents_table(const std::vector<Exponent>& exponents) {
  std::string text = fmt::format("{:<14}{:<24}{:<9}{:>8}{:>9}{:>8}{:>10}{:>10}\n", "method", "quantity",
                                 "box", "from", "to", "points", "exponent", "error");
  for (const Exponent& fit : exponents) {
    text +=
        fmt::format("{:<14}{:<24}{:<9}{:>8}{:>9}{:>8}{:>10.3f}{:>10}\n", fit.method, fit.quantity, fit.box,
                    fit.from, fit.to, fit.law.points, fit.law.exponent,
                    std::isnan(fit.law.standard_error) ? "-" : fmt::format("{:.3f}", fit.law.standard_error));
  }
  return text;
}

std::string figure_svg(const Results& results) {
  return chart::to_svg({time_chart(results), event_cost_chart(results), missed_chart(results.steps),
                        events_chart(results.rows)});
}

}  // namespace hardball::bench
