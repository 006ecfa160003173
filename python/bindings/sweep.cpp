// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/sweep/workers.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/interruption.hpp"
#include "apps/sweep/tables.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/charts.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

using sweep::Member;
using sweep::Results;
using sweep::Study;
using Text = std::optional<std::string>;

Study study_of(const std::string& path, const Text& text, const Text& scenario, const Text& directory) {
  return sweep::read_study({.path = path, .text = text, .scenario = scenario, .directory = directory});
}

// The texts of values by their keys, in JSON.
py::dict dict_of(const std::vector<sweep::Setting>& values) {
  py::dict dict;
  for (const sweep::Setting& each : values) dict[each.key.c_str()] = each.value;
  return dict;
}

// The indices of the members to be run, in their order, and how many threads should run them.
std::pair<std::vector<std::size_t>, std::size_t> check(const Study& study) {
  const py::gil_scoped_release release;
  std::vector<std::size_t> indices;
  const std::vector<sweep::Task> tasks = sweep::check(study, sweep::unfinished(part_of(study, 1, 1)));
  for (const sweep::Task& task : tasks)
    indices.push_back(static_cast<std::size_t>(task.member - study.members.data()));
  return {std::move(indices), sweep::usual_workers(tasks)};
}

// The members with their states, values and quantities.
py::list rows_of(const Results& results) {
  py::list rows;
  for (const sweep::Row& row : results.rows) {
    py::dict quantities;
    for (const auto& [name, estimate] : row.quantities)
      quantities[name.c_str()] = py::make_tuple(estimate.value, estimate.error);
    py::dict one;
    one["member"] = row.member->name();
    one["values"] = dict_of(row.member->values);
    one["replica"] = row.member->replica;
    one["seed"] = row.member->seed;
    one["status"] = name_of(row.state);
    one["quantities"] = quantities;
    rows.append(one);
  }
  return rows;
}

py::list points_of(const Results& results) {
  py::list points;
  for (const sweep::Point& point : results.points) {
    py::list quantities;
    for (const sweep::PointEstimate& each : point.quantities)
      quantities.append(py::make_tuple(each.mean, each.between, each.within, each.ratio()));
    py::dict one;
    one["values"] = dict_of(point.values);
    one["runs"] = point.runs;
    one["quantities"] = quantities;
    points.append(one);
  }
  return points;
}

py::dict write_tables(const Study& study) {
  const Results results = [&] {
    const py::gil_scoped_release release;
    Results found = read_results(study);
    sweep::write_tables(study, found);
    return found;
  }();
  py::dict all;
  all["quantities"] = results.quantities;
  all["rows"] = rows_of(results);
  all["points"] = points_of(results);
  all["charts"] = list_of(charts_of(study, results));
  return all;
}

}  // namespace

void bind_sweep(py::module_& module) {
  py::class_<cli::DirectoryLock>(module, "_DirectoryLock");
  py::class_<Study>(module, "_Study")
      .def(py::init(&study_of), py::arg("path"), py::arg("text"), py::arg("scenario"), py::arg("directory"))
      .def_readonly("directory", &Study::directory)
      .def("check", &check)
      .def("begin", &sweep::begin)
      .def("forget_failures",
           [](const Study& study) {
             for (const Member& member : study.members) forget_failure(member);
           })
      .def(
          "lock", [](const Study& study, std::size_t index) { return lock_of(study.members.at(index)); },
          py::arg("index"))
      .def(
          "state",
          [](const Study& study, std::size_t index) {
            return std::string(name_of(sweep::state_of(study.members.at(index))));
          },
          py::arg("index"))
      .def(
          "prepare", [](const Study& study, std::size_t index) { prepare(study.members.at(index)); },
          py::arg("index"))
      .def(
          "directory_of",
          [](const Study& study, std::size_t index) { return study.members.at(index).directory; },
          py::arg("index"))
      .def(
          "overrides_of",
          [](const Study& study, std::size_t index) {
            const cli::RunOptions options = study.run_of(study.members.at(index));
            std::vector<std::string> overrides = options.scenario.overrides;
            overrides.push_back("run.seed=" + *options.scenario.seed);
            return overrides;
          },
          py::arg("index"))
      .def_property_readonly("scenario_path", [](const Study& study) { return study.scenario.path; })
      .def(
          "run",
          [](const Study& study, std::size_t index) {
            const py::gil_scoped_release release;
            const sweep::Outcome outcome = run_member(study, study.members.at(index));
            return std::string(name_of(outcome.ending));
          },
          py::arg("index"))
      .def(
          "write_tables", [](const Study& study) -> Typed<"dict[str, Any]"> { return write_tables(study); });
  module.def("_request_interruption", &cli::request_interruption, py::arg("is_wanted"));
}

}  // namespace hardball::python
