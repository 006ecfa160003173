// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "python/bindings/simulation_class.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

constexpr const char* kSimulationSection = "simulation";
constexpr const char* kMeasuresSection = "measures";

std::string saved(const PythonSimulation& self) {
  return self.simulation().save();
}

std::unique_ptr<PythonSimulation> loaded(std::string_view simulation, const std::string* measures,
                                         const std::string& where) {
  std::unique_ptr<PythonSimulation> made =
      std::make_unique<PythonSimulation>(Simulation::load(simulation, where));
  if (measures != nullptr) made->restore_measures(*measures, where);
  return made;
}

void save_file(const PythonSimulation& self, const std::filesystem::path& path) {
  const std::vector<CheckpointSection> sections{{kSimulationSection, saved(self)},
                                                {kMeasuresSection, self.save_measures()}};
  write_checkpoint_file(path, sections);
}

std::unique_ptr<PythonSimulation> load_file(const std::filesystem::path& path) {
  const std::map<std::string, std::string> sections = read_checkpoint_file(path);
  const auto simulation = sections.find(kSimulationSection);
  if (simulation == sections.end()) {
    throw Error("there is no simulation in it", path.string(), "give a file that save has written");
  }
  const auto measures = sections.find(kMeasuresSection);
  return loaded(simulation->second, measures == sections.end() ? nullptr : &measures->second, path.string());
}

py::tuple state_of(const PythonSimulation& self) {
  return py::make_tuple(py::bytes(saved(self)), py::bytes(self.save_measures()),
                        self.response() ? self.response()->function() : py::none(), py::cast(self.until));
}

std::unique_ptr<PythonSimulation> with_state(const py::tuple& state) {
  const std::string where = "the pickled simulation";
  const auto measures = state[1].cast<std::string>();
  std::unique_ptr<PythonSimulation> made = loaded(state[0].cast<std::string>(), &measures, where);
  made->set_response(state[2]);
  made->until = state[3].cast<std::optional<double>>();
  return made;
}

}  // namespace

void bind_saving(SimulationClass& simulation) {
  simulation.def("_saved", [](const PythonSimulation& self) { return py::bytes(saved(self)); })
      .def("_save_file", &save_file)
      .def_static("_loaded",
                  [](const py::bytes& bytes) {
                    return loaded(std::string_view(bytes), nullptr, "the saved simulation");
                  })
      .def_static("_load_file", &load_file)
      .def("_copy", [](const PythonSimulation& self) { return PythonSimulation(self); })
      .def(py::pickle(&state_of, &with_state));
}

}  // namespace hardball::python
