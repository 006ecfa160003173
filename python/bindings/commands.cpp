// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/interruption.hpp"
#include "apps/cli/results.hpp"
#include "apps/report/measurement_charts.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/statistics/measurement.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/charts.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

using cli::ScenarioChoice;
using Text = std::optional<std::string>;

// `text`: the scenario, of which `path` is then the name.
ScenarioChoice choice_of(const std::string& path, const Text& text, const std::vector<std::string>& overrides,
                         const Text& until, const Text& seed) {
  return {.path = path, .overrides = overrides, .until = until, .seed = seed, .text = text};
}

std::vector<std::pair<std::string, std::string>> check(const ScenarioChoice& scenario,
                                                       const std::string& engine) {
  std::vector<std::pair<std::string, std::string>> rows;
  const py::gil_scoped_release release;
  for (const cli::TableRow& row :
       cli::check_rows({.scenario = scenario, .engine = {.engine = engine}, .output = {.quiet = true}}))
    rows.emplace_back(row.name, row.text);
  return rows;
}

py::list verify(const ScenarioChoice& scenario) {
  std::vector<cli::VerifiedWay> ways;
  {
    const py::gil_scoped_release release;
    cli::verify_ways({.scenario = scenario, .quiet = true},
                     [&](const cli::VerifiedWay& way) { ways.push_back(way); });
  }
  py::list all;
  for (const cli::VerifiedWay& way : ways) {
    py::dict row;
    row["name"] = way.name;
    row["skipped"] = way.skipped;
    row["event_log_hash"] = way.skipped.empty() ? hash_text(way.hash) : "";
    row["collisions"] = way.collisions;
    row["max_overlap"] = way.max_overlap;
    row["is_same"] = way.is_same;
    row["is_sound"] = way.is_sound;
    row["seconds"] = way.seconds;
    all.append(row);
  }
  return all;
}

py::dict tune(const ScenarioChoice& scenario, const std::string& unit_costs, const Text& budget,
              const Text& out) {
  const cli::Tuning tuning = [&] {
    const py::gil_scoped_release release;
    return cli::tune_cells(
        {.scenario = scenario, .unit_costs = unit_costs, .budget = budget, .out = out, .quiet = true});
  }();
  py::dict all;
  const auto column = [&](const char* name, const auto& get) {
    std::vector<double> values;
    for (const cli::EdgePoint& point : tuning.sweep.points) values.push_back(get(point));
    all[name] = read_only(array_around(std::move(values)));
  };
  column("cell_edge", [](const cli::EdgePoint& point) { return point.edge; });
  column("predicted", [](const cli::EdgePoint& point) { return point.predicted_seconds; });
  column("measured", [](const cli::EdgePoint& point) { return point.median_seconds(); });
  column("least", [](const cli::EdgePoint& point) { return point.seconds.front(); });
  column("most", [](const cli::EdgePoint& point) { return point.seconds.back(); });
  all["chosen"] = tuning.sweep.chosen().edge;
  all["paper"] = tuning.sweep.paper().edge;
  all["best"] = tuning.sweep.best().edge;
  all["text"] = tuning.text;
  return all;
}

}  // namespace

py::list list_of(const std::vector<chart::Chart>& charts) {
  py::list all;
  for (const chart::Chart& chart : charts) {
    py::list series;
    for (const chart::Series& each : chart.series) {
      py::dict one;
      one["name"] = each.name;
      one["x"] = array_around(each.x);
      one["y"] = array_around(each.y);
      one["y_error"] = array_around(each.y_error);
      one["line"] = each.line;
      one["marks"] = each.marks;
      one["dashed"] = each.dashed;
      one["error_band"] = each.error_band;
      one["like_previous"] = each.like_previous;
      series.append(one);
    }
    py::dict one;
    one["title"] = chart.title;
    one["x_label"] = chart.x.label;
    one["y_label"] = chart.y.label;
    one["x_logarithmic"] = chart.x.logarithmic;
    one["y_logarithmic"] = chart.y.logarithmic;
    one["series"] = series;
    all.append(one);
  }
  return all;
}

void bind_commands(py::module_& module) {
  // Ctrl-C ends what takes long.
  cli::ask_for_interruption([] {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return false;
  });
  py::class_<ScenarioChoice>(module, "_ScenarioChoice")
      .def(py::init(&choice_of), py::arg("path"), py::arg("text"), py::arg("overrides"), py::arg("until"),
           py::arg("seed"));
  module.def("_check", &check, py::arg("scenario"), py::arg("engine"));
  module.def(
      "_verify",
      [](const ScenarioChoice& scenario) -> Typed<"list[dict[str, Any]]"> { return verify(scenario); },
      py::arg("scenario"));
  module.def("_tune", &tune, py::arg("scenario"), py::arg("unit_costs"), py::arg("budget"), py::arg("out"));
  module.def(
      "_convert",
      [](const std::string& in, const std::string& out, const Text& frame, bool overwrite) {
        const py::gil_scoped_release release;
        return cli::convert_frames(
            {.in = in, .out = out, .frame = frame, .quiet = true, .overwrite = overwrite});
      },
      py::arg("source"), py::arg("target"), py::arg("frame"), py::arg("overwrite"));
  module.def(
      "_describe_file", [](const std::filesystem::path& path) { return cli::describe_file(path); },
      py::arg("path"));
  module.def(
      "_charts", [](const Measurement& measurement) -> Typed<"list[dict[str, Any]]"> {
        return list_of(report::charts_of(measurement));
      },
      py::arg("measurement"));
}

}  // namespace hardball::python
