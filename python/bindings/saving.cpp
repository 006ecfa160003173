// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/processes/in_all.hpp"
#include "hardball/simulation/simulation_checkpoint.hpp"
#include "python/bindings/processes.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

constexpr const char* kSimulationSection = "simulation";
constexpr const char* kDividedSection = "distributed";  // in a checkpoint of several processes
constexpr const char* kMeasuresSection = "measures";
constexpr const char* kUntilSection = "until";

std::string saved(const PythonSimulation& self) {
  const std::vector<CheckpointSection> sections{{kSimulationSection, self.simulation().save()},
                                                {kMeasuresSection, self.save_measures()},
                                                {kUntilSection, archived(self.until())}};
  return checkpoint_of(sections);
}

// A simulation with what Python adds to it, of which find(name) returns the section if it is there.
template <class Find>
std::unique_ptr<PythonSimulation> with_additions(Simulation simulation, const std::string& where,
                                                 Find&& find) {
  auto made = std::make_unique<PythonSimulation>(std::move(simulation));
  if (const std::optional<std::string> measures = find(kMeasuresSection))
    made->restore_measures(*measures, where);
  if (const std::optional<std::string> saved_until = find(kUntilSection)) {
    std::optional<double> until;
    restore(*saved_until, where, until);
    made->set_until(until);
  }
  return made;
}

[[noreturn]] void refuse_other_file(const std::string& where) {
  throw Error("it contains no simulation", where, "give the bytes or the file of save");
}

std::unique_ptr<PythonSimulation> loaded(std::string_view bytes, Processes& processes) {
  const std::string where = "the saved simulation";
  std::map<std::string, std::string> sections;
  in_all(processes, [&] {
    sections = read_checkpoint(bytes, where);
    if (!sections.contains(kSimulationSection)) refuse_other_file(where);
  });
  const std::string& simulation = sections[kSimulationSection];
  require_same(processes, simulation, "saved simulation");
  return with_additions(Simulation::load(simulation, where, processes), where, [&](const char* name) {
    const auto found = sections.find(name);
    return found == sections.end() ? std::nullopt : std::optional(found->second);
  });
}

std::unique_ptr<PythonSimulation> loaded_file(const std::filesystem::path& path, Processes& processes) {
  const std::string where = path.string();
  std::optional<CheckpointReader> checkpoint;
  const auto contains = [&](const char* name) { return std::ranges::count(checkpoint->names(), name) > 0; };
  in_all(processes, [&] {
    checkpoint.emplace(path);
    if (!contains(kSimulationSection) && !contains(kDividedSection)) refuse_other_file(where);
  });
  return with_additions(read_simulation(*checkpoint, where, processes, 1), where, [&](const char* name) {
    return contains(name) ? std::optional(checkpoint->section(name)) : std::nullopt;
  });
}

}  // namespace

void bind_saving(SimulationClass& simulation) {
  simulation.def("_saved", [](const PythonSimulation& self) { return py::bytes(saved(self)); })
      .def("_save_file",
           [](const PythonSimulation& self, const std::filesystem::path& path) {
             const std::string bytes = saved(self);
             in_first(self.simulation().processes(), [&] { replace_file(path, bytes); });
           })
      .def_static("_loaded",
                  [](const py::bytes& bytes, Processes* processes) {
                    return loaded(std::string_view(bytes), processes_or_one(processes));
                  })
      .def_static("_load_file",
                  [](const std::filesystem::path& path, Processes* processes) {
                    return loaded_file(path, processes_or_one(processes));
                  })
      .def("_copy", [](const PythonSimulation& self) { return PythonSimulation(self); })
      .def_property_readonly(
          "_response", [](const PythonSimulation& self) -> Typed<"Callable[..., Any] | None"> {
            self.simulation();
            return self.response() ? self.response()->function() : py::none();
          });
}

}  // namespace hardball::python
