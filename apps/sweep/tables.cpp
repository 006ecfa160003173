// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/sweep/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "apps/cli/run_files.hpp"
#include "apps/cli/version.hpp"
#include "apps/report/number_text.hpp"
#include "apps/report/page.hpp"
#include "hardball/error.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/io/xml_text.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/scenario/nearest_name.hpp"

namespace hardball::sweep {
namespace {

using Json = nlohmann::ordered_json;

double number_or_none(const std::string& text) {
  return text.empty() ? kNoNumber : std::strtod(text.c_str(), nullptr);
}

// The value of a number in a summary, such as energy.final; NaN if it has none.
double summary_number(const Json& summary, const std::string& name) {
  const Json* at = &summary;
  std::istringstream parts(name);
  for (std::string part; std::getline(parts, part, '.');) {
    if (!at->is_object() || !at->contains(part)) return kNoNumber;
    at = &(*at)[part];
  }
  return at->is_number() ? at->get<double>() : kNoNumber;
}

// Adds the quantities of a run, from its table of measures; `names` in the order in which they come up.
void read_measures(const std::filesystem::path& directory, Row& row, std::vector<std::string>& names) {
  const std::filesystem::path path = directory / "measures" / "quantities.csv";
  if (!std::filesystem::exists(path)) return;
  std::istringstream lines(read_file(path));
  std::string line;
  std::getline(lines, line);  // the heads
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string measure;
    std::string name;
    std::string value;
    std::string error;
    std::getline(cells, measure, ',');
    std::getline(cells, name, ',');
    std::getline(cells, value, ',');
    std::getline(cells, error, ',');
    if (value.empty()) continue;
    names.push_back(measure + "." + name);
    row.quantities[names.back()] = {number_or_none(value), number_or_none(error)};
  }
}

// Adds the results of a function: numbers, or pairs of a number and its error.
void read_function_results(const Json& results, Row& row, std::vector<std::string>& names) {
  for (const auto& [name, result] : results.items()) {
    const bool has_error = result.is_array() && result.size() == 2;
    const Json& value = has_error ? result[0] : result;
    if (!value.is_number()) continue;
    const bool is_error_known = has_error && result[1].is_number();
    row.quantities[name] = {value.get<double>(), is_error_known ? result[1].get<double>() : kNoNumber};
    names.push_back(name);
  }
}

Row read_row(const Study& study, const Member& member, std::vector<std::string>& names) {
  Row row{.member = &member, .state = state_of(member), .setup_seconds = kNoNumber, .run_seconds = kNoNumber};
  if (row.state != State::finished) return row;
  const std::filesystem::path results = member.directory / kResults;
  const std::filesystem::path summary = member.directory / cli::kSummary;
  const bool is_of_function = std::filesystem::exists(results);
  try {
    if (is_of_function) {
      read_function_results(Json::parse(read_file(results)), row, names);
      return row;
    }
    const Json json = Json::parse(read_file(summary));
    row.hash = json.at("event_log_hash").get<std::string>();
    row.collisions = json.at("events").at("collision").get<std::uint64_t>();
    row.setup_seconds = json.at("seconds").at("setup").get<double>();
    row.run_seconds = json.at("seconds").at("run").get<double>();
    read_measures(member.directory, row, names);
    for (const std::string& name : study.quantities) {
      const double number = summary_number(json, name);
      if (!row.quantities.contains(name) && std::isfinite(number)) row.quantities[name] = {number, kNoNumber};
    }
  } catch (const Json::exception&) {
    throw Error("is damaged", (is_of_function ? results : summary).string(), "remove it, and sweep again");
  }
  return row;
}

// Error: a quantity of the study is none of those found.
void check_quantities(const Study& study, const std::vector<Row>& rows,
                      const std::vector<std::string>& names) {
  if (names.empty()) return;
  for (const std::string& name : study.quantities) {
    if (std::ranges::any_of(rows, [&](const Row& row) { return row.quantities.contains(name); })) continue;
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw Error("no run has the quantity '" + shortened(name) + "'", study.name, suggestion(name, known));
  }
}

std::string cell(double number) {
  return std::isfinite(number) ? to_text(number) : "";
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

// A value in a table: strings without the quotes of JSON.
std::string text_of(const Setting& setting) {
  const Json json = Json::parse(setting.value);
  return json.is_string() ? json.get<std::string>() : setting.value;
}

void append_line(std::string& text, const std::vector<std::string>& cells) {
  text += fmt::format("{}\n", fmt::join(cells, ","));
}

std::string runs_csv(const Study& study, const Results& results) {
  std::vector<std::string> heads{"member"};
  for (const std::string& key : study.keys) heads.push_back(cell(key));
  for (const char* head : {"replica", "seed", "status", "event_log_hash", "collisions"})
    heads.emplace_back(head);
  for (const std::string& name : results.quantities) {
    heads.push_back(cell(name));
    heads.push_back(cell(name + "_error"));
  }
  std::string text;
  append_line(text, heads);
  for (const Row& row : results.rows) {
    std::vector<std::string> cells{row.member->name()};
    for (const Setting& each : row.member->values) cells.push_back(cell(text_of(each)));
    cells.push_back(to_text(row.member->replica));
    cells.push_back(to_text(row.member->seed));
    cells.emplace_back(name_of(row.state));
    cells.push_back(row.hash);
    cells.push_back(row.collisions ? to_text(*row.collisions) : "");
    for (const std::string& name : results.quantities) {
      const auto found = row.quantities.find(name);
      const bool is_known = found != row.quantities.end();
      cells.push_back(is_known ? cell(found->second.value) : "");
      cells.push_back(is_known ? cell(found->second.error) : "");
    }
    append_line(text, cells);
  }
  return text;
}

std::string points_csv(const Study& study, const Results& results) {
  std::vector<std::string> heads;
  for (const std::string& key : study.keys) heads.push_back(cell(key));
  heads.emplace_back("runs");
  for (const std::string& name : results.quantities) {
    for (const char* end : {"", "_error_between", "_error_within", "_error_ratio"})
      heads.push_back(cell(name + end));
  }
  std::string text;
  append_line(text, heads);
  for (const Point& point : results.points) {
    std::vector<std::string> cells;
    for (const Setting& each : point.values) cells.push_back(cell(text_of(each)));
    cells.push_back(to_text(point.runs));
    for (const PointEstimate& each : point.quantities) {
      for (const double number : {each.mean, each.between, each.within, each.ratio()})
        cells.push_back(cell(number));
    }
    append_line(text, cells);
  }
  return text;
}

std::string timing_csv(const Results& results) {
  std::string text = "member,setup_seconds,run_seconds\n";
  for (const Row& row : results.rows)
    append_line(text, {row.member->name(), cell(row.setup_seconds), cell(row.run_seconds)});
  return text;
}

std::string points_table(const Study& study, const Results& results) {
  using report::typeset;
  std::vector<std::string> heads = study.keys;
  heads.emplace_back("runs");
  for (const std::string& name : results.quantities) {
    heads.push_back(name);
    heads.emplace_back("between");
    heads.emplace_back("within");
    heads.emplace_back("ratio");
  }
  report::Table table("numbers", "", heads);
  const auto shown = [](double number, int digits) {
    return std::isfinite(number) ? typeset(report::number_text(number, digits)) : std::string();
  };
  for (const Point& point : results.points) {
    std::vector<std::string> cells;
    for (const Setting& each : point.values) cells.push_back(xml_escaped(text_of(each)));
    cells.push_back(to_text(point.runs));
    for (const PointEstimate& each : point.quantities) {
      cells.push_back(shown(each.mean, 6));
      cells.push_back(shown(each.between, 2));
      cells.push_back(shown(each.within, 2));
      cells.push_back(shown(each.ratio(), 2));
    }
    const std::string name = cells.front();
    cells.erase(cells.begin());
    table.add_row(name, cells);
  }
  return table.html();
}

std::string report_html(const Study& study, const Results& results) {
  report::Table facts("facts", "");
  const auto count = [&](State state) {
    return static_cast<std::size_t>(std::ranges::count(results.rows, state, &Row::state));
  };
  facts.add_row("members", {to_text(study.members.size())});
  facts.add_row("points", {to_text(results.points.size())});
  for (const State state : {State::finished, State::failed, State::interrupted, State::fresh})
    facts.add_row(name_of(state), {to_text(count(state))});
  std::string figures;
  for (const chart::Chart& chart : charts_of(study, results))
    figures += report::figure(chart::to_inline_svg(chart, fmt::format("plot-{}-", figures.size())));
  std::string sections;
  if (!figures.empty()) {
    sections += report::section("plots", "Quantities",
                                report::paragraph("",
                                                  "Bars are standard errors by the scatter of the runs of a "
                                                  "point or, of single runs, by the run itself.") +
                                    "<div class=\"pair\">\n" + figures + "</div>\n");
  }
  sections += report::section(
      "points", "Points",
      report::paragraph("",
                        "Means over the runs of a point, with the standard error by their scatter (between), "
                        "that by their own errors (within), and the ratio of the two.") +
          points_table(study, results));
  report::Table failures("facts", "");
  for (const Row& row : results.rows) {
    if (row.state != State::failed) continue;
    const std::string message = read_file(row.member->directory / kFailed);
    failures.add_row(row.member->name(), {xml_escaped(message)});
  }
  if (!failures.is_empty()) sections += report::section("failures", "Failures", failures.html());
  const std::string its_facts = facts.html();
  const std::string its_name = std::filesystem::path(study.name).stem().string();
  const std::string program = "hardball " + cli::version();
  return report::Page{.kind = "sweep",
                      .name = its_name,
                      .program = program,
                      .summary_html = its_facts,
                      .sections_html = sections,
                      .units_html = "Numbers are in the units of the scenario."}
      .html();
}

// Whether a key has several values, all of them numbers.
bool is_axis(const Study& study, std::size_t key) {
  std::set<std::string> values;
  for (const Member& member : study.members) {
    if (!Json::parse(member.values[key].value).is_number()) return false;
    values.insert(member.values[key].value);
  }
  return values.size() > 1;
}

}  // namespace

PointEstimate combined(const std::vector<Estimate>& replicas) {
  const auto count = static_cast<double>(replicas.size());
  if (replicas.empty()) return {0, kNoNumber, kNoNumber, kNoNumber};
  double sum = 0;
  double squared_errors = 0;
  for (const Estimate& each : replicas) {
    sum += each.value;
    squared_errors += each.error * each.error;
  }
  const double mean = sum / count;
  double squares = 0;
  for (const Estimate& each : replicas) squares += (each.value - mean) * (each.value - mean);
  const double between = replicas.size() > 1 ? std::sqrt(squares / (count - 1) / count) : kNoNumber;
  return {replicas.size(), mean, between, std::sqrt(squared_errors) / count};
}

Results read_results(const Study& study) {
  Results results;
  std::vector<std::string> names;  // in the order of the first run that has them
  for (const Member& member : study.members) {
    std::vector<std::string> of_run;
    results.rows.push_back(read_row(study, member, of_run));
    for (std::string& name : of_run) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
  }
  check_quantities(study, results.rows, names);
  results.quantities = study.quantities.empty() ? names : study.quantities;
  for (std::size_t first = 0; first < results.rows.size(); first += study.replicas) {
    Point point{.values = results.rows[first].member->values, .quantities = {}};
    const auto replica = [&](std::size_t k) -> const Row& { return results.rows[first + k]; };
    for (std::size_t k = 0; k < study.replicas; ++k)
      point.runs += replica(k).state == State::finished ? 1U : 0U;
    for (const std::string& name : results.quantities) {
      std::vector<Estimate> estimates;
      for (std::size_t k = 0; k < study.replicas; ++k) {
        const auto found = replica(k).quantities.find(name);
        if (found != replica(k).quantities.end()) estimates.push_back(found->second);
      }
      point.quantities.push_back(combined(estimates));
    }
    results.points.push_back(std::move(point));
  }
  return results;
}

std::vector<chart::Chart> charts_of(const Study& study, const Results& results) {
  std::size_t axis = 0;
  while (axis < study.keys.size() && !is_axis(study, axis)) ++axis;
  std::vector<chart::Chart> charts;
  if (axis == study.keys.size()) return charts;
  const std::string& key = study.keys[axis];
  for (std::size_t q = 0; q < results.quantities.size(); ++q) {
    chart::Chart chart{.title = results.quantities[q],
                       .x = {.label = key, .logarithmic = study.logarithmic.contains(key)},
                       .y = {.label = results.quantities[q]}};
    for (const Point& point : results.points) {
      const PointEstimate& estimate = point.quantities[q];
      if (!std::isfinite(estimate.mean)) continue;
      std::string name;
      for (std::size_t k = 0; k < study.keys.size(); ++k) {
        if (k != axis) name += (name.empty() ? "" : ", ") + study.keys[k] + " = " + text_of(point.values[k]);
      }
      auto series = std::ranges::find(chart.series, name, &chart::Series::name);
      if (series == chart.series.end())
        series = chart.series.insert(chart.series.end(), chart::Series{.name = name});
      series->x.push_back(std::stod(point.values[axis].value));
      series->y.push_back(estimate.mean);
      series->y_error.push_back(std::isfinite(estimate.between) ? estimate.between : estimate.within);
    }
    if (!chart.series.empty()) charts.push_back(std::move(chart));
  }
  return charts;
}

void write_tables(const Study& study, const Results& results) {
  const cli::DirectoryLock lock = lock_of(study);
  const auto write = [&](const char* name, const std::string& text) {
    replace_file(study.directory / name, text);
  };
  write(kRuns, runs_csv(study, results));
  write(kPoints, points_csv(study, results));
  write(kTiming, timing_csv(results));
  write(kStudyReport, report_html(study, results));
}

}  // namespace hardball::sweep
