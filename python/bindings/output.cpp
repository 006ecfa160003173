// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/processes/in_all.hpp"
#include "hardball/simulation/simulation_checkpoint.hpp"
#include "python/bindings/processes.hpp"
#include "python/bindings/simulation_class.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

// The simulation of a checkpoint in a directory of a run, whose files it continues.
std::unique_ptr<PythonSimulation> resumed(const std::filesystem::path& directory,
                                          const std::optional<std::string>& name, Processes& processes) {
  const std::filesystem::path path = directory / name.value_or(cli::kCheckpoint);
  std::optional<CheckpointReader> checkpoint;
  cli::RunState state;
  cli::FilesState files;
  in_all(processes, [&] {
    cli::require_checkpoint(path);
    checkpoint.emplace(path);
    restore(checkpoint->section("run"), path.string(), state);
    restore(checkpoint->section("files"), path.string(), files);
  });
  auto made = std::make_unique<PythonSimulation>(read_simulation(*checkpoint, path.string(), processes, 1));
  made->restore_measures(checkpoint->section("measures"), path.string());
  Origin origin = no_origin();
  origin.scenario.name = state.name;
  origin.scenario.text = state.text;
  origin.choice = state.choice;
  origin.choice.overrides.clear();
  origin = with_overrides(origin, state.choice.overrides);
  origin.scenario.output.directory = directory;
  made->set_until(origin.scenario.run.until);
  if (!origin.scenario.text.empty()) made->set_origin(std::make_shared<const Origin>(origin));
  made->continue_output(std::move(origin), files, state);
  return made;
}

}  // namespace

void bind_output(SimulationClass& simulation) {
  simulation
      .def(
          "_write",
          [](PythonSimulation& self, const std::filesystem::path& path, bool append) {
            self.write(path, append);
          },
          py::arg("path"), py::arg("append"))
      .def("_begin_output", &PythonSimulation::begin_output, py::arg("overrides"), py::arg("overwrite"))
      .def("_end_output", &PythonSimulation::end_output, py::arg("is_complete"))
      .def("_flush_recording", &PythonSimulation::flush_recording)
      .def_property_readonly("_output_directory", &PythonSimulation::output_directory)
      .def("_report", [](const PythonSimulation& self) { return py::bytes(self.end().report); })
      .def("_summary", [](const PythonSimulation& self) { return self.end().summary; })
      .def_static(
          "_resumed",
          [](const std::filesystem::path& directory, const std::optional<std::string>& checkpoint,
             Processes* processes) { return resumed(directory, checkpoint, processes_or_one(processes)); },
          py::arg("directory"), py::arg("checkpoint"), py::arg("processes"));
}

}  // namespace hardball::python
