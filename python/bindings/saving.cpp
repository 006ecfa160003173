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

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "python/bindings/simulation_class.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

constexpr const char* kSimulationSection = "simulation";
constexpr const char* kMeasuresSection = "measures";
constexpr const char* kUntilSection = "until";

std::string saved(const PythonSimulation& self) {
  const std::vector<CheckpointSection> sections{{kSimulationSection, self.simulation().save()},
                                                {kMeasuresSection, self.save_measures()},
                                                {kUntilSection, archived(self.until())}};
  return checkpoint_of(sections);
}

std::unique_ptr<PythonSimulation> loaded(const std::map<std::string, std::string>& sections,
                                         const std::string& where) {
  const auto simulation = sections.find(kSimulationSection);
  if (simulation == sections.end()) {
    throw Error("it contains no simulation", where, "give the bytes or the file of save");
  }
  auto made = std::make_unique<PythonSimulation>(Simulation::load(simulation->second, where));
  if (const auto measures = sections.find(kMeasuresSection); measures != sections.end()) {
    made->restore_measures(measures->second, where);
  }
  if (const auto saved_until = sections.find(kUntilSection); saved_until != sections.end()) {
    std::optional<double> until;
    restore(saved_until->second, where, until);
    made->set_until(until);
  }
  return made;
}

}  // namespace

void bind_saving(SimulationClass& simulation) {
  simulation.def("_saved", [](const PythonSimulation& self) { return py::bytes(saved(self)); })
      .def("_save_file", [](const PythonSimulation& self,
                            const std::filesystem::path& path) { replace_file(path, saved(self)); })
      .def_static("_loaded",
                  [](const py::bytes& bytes) {
                    const std::string where = "the saved simulation";
                    return loaded(read_checkpoint(std::string_view(bytes), where), where);
                  })
      .def_static(
          "_load_file",
          [](const std::filesystem::path& path) { return loaded(read_checkpoint_file(path), path.string()); })
      .def("_copy", [](const PythonSimulation& self) { return PythonSimulation(self); })
      .def_property_readonly("_response", [](const PythonSimulation& self) -> py::object {
        self.simulation();
        return self.response() ? self.response()->function() : py::none();
      });
}

}  // namespace hardball::python
