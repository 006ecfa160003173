// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "documentation.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/processes/in_all.hpp"
#include "hardball/scenario/make_simulation.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/shared_scenario.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/world/step_levels.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/event_records.hpp"
#include "python/bindings/processes.hpp"
#include "python/bindings/responses.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/spheres.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

OnProgress interruptible() {
  return [](double) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
}

std::unique_ptr<PythonSimulation> owned(Simulation simulation) {
  return std::make_unique<PythonSimulation>(std::move(simulation));
}

Simulation started(World world, const EngineOptions& options, Processes& processes) {
  const py::gil_scoped_release release;
  return Simulation(std::move(world), options, processes, interruptible());
}

// A table, or one potential for all spheres.
StepTable step_table_of(const py::object& object) {
  if (object.is_none()) return {};
  if (py::isinstance<StepTable>(object)) return object.cast<StepTable>();
  if (!py::isinstance<StepPotential>(object))
    throw Error("it is neither a StepTable nor a StepPotential", "steps", "give one of them");
  StepTable table;
  table.set_for_all(object.cast<StepPotential>());
  return table;
}

std::unique_ptr<PythonSimulation> make_simulation(
    const Box& box, const ArrayLike& positions, const ArrayLike& velocities, const ArrayLike& radius,
    const ArrayLike& mass, const ArrayLike& spin, const ArrayLike& species, const OptionalArrayLike& moment,
    const ArrayLike& gravity, std::vector<Surface> surfaces,
    const std::vector<std::pair<SpeciesId, SpeciesId>>& passing,
    const Typed<"StepTable | StepPotential | None">& steps,
    const std::vector<std::tuple<SphereId, SphereId, std::uint32_t>>& bonds, const OptionalResponse& response,
    const OptionalThermostat& thermostat, std::uint64_t seed, const std::string& engine,
    std::optional<double> cell_edge, Processes* processes) {
  World world(box, vector_of(gravity, "gravity", box.is_flat()), std::move(surfaces));
  const std::vector<Sphere> spheres =
      spheres_of(positions, velocities, radius, mass, spin, species, moment, box.is_flat());
  world.reserve(spheres.size());
  for (const Sphere& sphere : spheres) world.add(sphere);
  const std::optional<ResponseTable> built_in = response_table_of(response);
  ResponseTable table = built_in.value_or(ResponseTable());
  for (const auto& [first, second] : passing) table.set(first, second, Passing());
  Interactions interactions(table);
  interactions.set_steps(step_table_of(steps));
  world.set_interactions(interactions);
  for (const auto& [first, second, potential] : bonds) {
    if (potential >= StepTable::kNone)
      throw Error("there is no potential " + to_text(potential), "bonds", "give a number of add_bond");
    add_bond(world, first, second, static_cast<StepTable::Number>(potential));
  }
  const EngineOptions options{.engine = value_named<EngineKind>(engine, "engine"), .cell_edge = cell_edge};
  Processes& shared = processes_or_one(processes);
  if (shared.size() > 1) {
    require_same(shared, archived(world, seed, engine, cell_edge), "simulation",
                 "give all processes the same arguments, and random numbers the same seed");
  }
  std::unique_ptr<PythonSimulation> simulation = owned(started(std::move(world), options, shared));
  if (!built_in) simulation->set_response(response);
  if (!thermostat.is_none()) simulation->set_thermostat(thermostat, seed);
  return simulation;
}

std::unique_ptr<PythonSimulation> from_scenario(const cli::ScenarioChoice& choice, const std::string& engine,
                                                std::optional<double> cell_edge, Processes* processes) {
  const EngineOptions options{.engine = value_named<EngineKind>(engine, "engine"), .cell_edge = cell_edge};
  Processes& shared = processes_or_one(processes);
  Scenario scenario;
  in_all(shared, [&] {
    scenario = choice.text ? parse_scenario(*choice.text, choice.path, choice.overrides)
                           : load_scenario(choice.path, choice.overrides);
  });
  require_same_scenario(scenario, shared);
  std::string notes;
  const auto simulation = [&] {
    const py::gil_scoped_release release;
    const auto on_note = [&](const std::string& note) { notes += notes.empty() ? note : "; " + note; };
    return make_simulation(scenario, make_share(scenario, shared, interruptible(), on_note), options,
                           interruptible(), shared);
  };
  std::unique_ptr<PythonSimulation> made = owned(simulation());
  if (!notes.empty() && PyErr_WarnEx(PyExc_UserWarning, notes.c_str(), 1) != 0) throw py::error_already_set();
  made->set_until(scenario.run.until);
  made->set_origin(std::make_shared<const Origin>(Origin{std::move(scenario), choice}));
  return made;
}

// The box of the last frame of a file, as scenarios describe it.
py::dict box_of_file(const std::filesystem::path& path) {
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(path);
  const SnapshotBox box = box_of(reader->read(reader->frames() - 1));
  const std::size_t dimensions = box.is_flat ? 2 : 3;
  py::list size;
  py::list boundary;
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    size.append(box.size[axis]);
    boundary.append(box.is_periodic[axis] ? "periodic" : "open");
  }
  py::dict all;
  all["dimensions"] = dimensions;
  all["size"] = size;
  all["boundary"] = boundary;
  return all;
}

// Of an object that is being made, there is no simulation.
PythonSimulation* simulation_in(PyObject* self) {
  auto* const instance = reinterpret_cast<py::detail::instance*>(self);
  if (!instance->get_value_and_holder().holder_constructed()) return nullptr;
  return py::cast<PythonSimulation*>(py::handle(self));
}

// Lets Python find listeners and responses that refer to their own simulation, and nothing else to it.
void collect_garbage(PyHeapTypeObject* heap_type) {
  PyTypeObject& type = heap_type->ht_type;
  type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type.tp_traverse = [](PyObject* self, visitproc visit, void* argument) {
    // A class that is made at run time belongs to its objects.
    if (const int stop = visit(reinterpret_cast<PyObject*>(Py_TYPE(self)), argument)) return stop;
    const PythonSimulation* const simulation = simulation_in(self);
    if (simulation == nullptr) return 0;
    return simulation->visit_references([&](PyObject* object) { return visit(object, argument); });
  };
  type.tp_clear = [](PyObject* self) {
    if (PythonSimulation* const simulation = simulation_in(self)) simulation->drop_references();
    return 0;
  };
}

}  // namespace

void bind_simulation(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(EventRecord, time, kind, first, second, normal_speed, impulse);
  bind_answers(module);
  const py::tuple zero = py::make_tuple(0.0, 0.0, 0.0);
  SimulationClass simulation(module, "Simulation", doc::Simulation, py::custom_type_setup(&collect_garbage));
  simulation
      .def(py::init(&make_simulation), py::arg("box"), py::kw_only(), py::arg("positions"),
           py::arg("velocities") = zero, py::arg("radius") = 1.0, py::arg("mass") = 1.0,
           py::arg("spin") = zero, py::arg("species") = 0, py::arg("moment") = py::none(),
           py::arg("gravity") = zero, py::arg("surfaces") = std::vector<Surface>(),
           py::arg("passing") = std::vector<std::pair<SpeciesId, SpeciesId>>(), py::arg("steps") = py::none(),
           py::arg("bonds") = std::vector<std::tuple<SphereId, SphereId, std::uint32_t>>(),
           py::arg("response") = py::none(), py::arg("thermostat") = py::none(), py::arg("seed") = 1,
           py::arg("engine") = "auto", py::arg("cell_edge") = py::none(), py::arg("processes") = py::none())
      // Subclasses are made of what the functions below return.
      .def(py::init(
          [](PythonSimulation& made) { return std::make_unique<PythonSimulation>(std::move(made)); }))
      .def_static("_from_scenario_file",
                  [](const std::filesystem::path& path, const std::vector<std::string>& overrides,
                     const std::string& engine, std::optional<double> cell_edge, Processes* processes) {
                    return from_scenario({.path = path.string(), .overrides = overrides}, engine, cell_edge,
                                         processes);
                  })
      .def_static(
          "_from_scenario_text",
          [](const std::string& text, const std::string& name, const std::vector<std::string>& overrides,
             const std::string& engine, std::optional<double> cell_edge, Processes* processes) {
            return from_scenario({.path = name, .overrides = overrides, .text = text}, engine, cell_edge,
                                 processes);
          })
      .def_static("_box_of_file", &box_of_file)
      .def("_run", &PythonSimulation::run, py::arg("until"), py::arg("collisions"), py::arg("contacts"),
           py::arg("record"), py::arg("on_progress"))
      .def("_step", &PythonSimulation::step, py::arg("until"))
      .def("_measure", [](PythonSimulation& self, std::vector<std::string> names, std::optional<double> every,
                          double from, bool face_forces,
                          const std::vector<std::pair<std::uint32_t, py::object>>& torque_about) {
        MeasureSettings settings{
            .names = std::move(names), .every = every, .from = from, .face_forces = face_forces};
        const bool is_flat = self.simulation().setting().box().is_flat();
        for (const auto& [surface, offset] : torque_about)
          settings.torque_about.emplace_back(surface, vector_of(offset, "torque_about", is_flat));
        self.set_measures(settings);
      });
  bind_state(simulation);
  bind_queries(simulation);
  bind_edits(simulation);
  bind_driving(simulation);
  bind_saving(simulation);
  bind_replay(simulation);
  bind_output(simulation);
}

}  // namespace hardball::python
