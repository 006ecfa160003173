// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/io/snapshot_format.hpp"
#include "hardball/io/snapshot_reader.hpp"
#include "hardball/scenario/make_simulation.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/world/audit.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/event_records.hpp"
#include "python/bindings/python_simulation.hpp"
#include "python/bindings/responses.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr const char* kSimulationSection = "simulation";
constexpr const char* kMeasuresSection = "measures";

// In the order of EngineKind.
constexpr std::array<const char*, 5> kEngines{"auto", "cells", "neighbors", "all-pairs", "paper"};

EngineKind engine_of(const std::string& name) {
  for (std::size_t i = 0; i < kEngines.size(); ++i) {
    if (name == kEngines[i]) return static_cast<EngineKind>(i);
  }
  throw Error("there is no '" + name + "'", "engine",
              "choose one of 'auto', 'cells', 'neighbors', 'all-pairs', 'paper'");
}

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

// --- spheres ---

std::vector<Sphere> spheres_of(const py::object& positions, const py::object& velocities,
                               const py::object& radius, const py::object& mass, const py::object& spin,
                               const py::object& species, const py::object& moment, bool is_flat) {
  const std::vector<Vec3> centers = vectors_of(positions, "positions");
  const std::size_t count = centers.size();
  const std::vector<Vec3> all_velocities = vectors_of(velocities, "velocities", count);
  const std::vector<double> radii = numbers_of(radius, "radius", count);
  const std::vector<double> masses = numbers_of(mass, "mass", count);
  const std::vector<Vec3> spins = vectors_of(spin, "spin", count);
  const std::vector<std::uint32_t> kinds =
      counts_of(species, "species", count, std::numeric_limits<SpeciesId>::max());
  const std::vector<double> moments =
      moment.is_none() ? std::vector<double>(count, is_flat ? kUniformDiscMoment : kUniformSphereMoment)
                       : numbers_of(moment, "moment", count);
  std::vector<Sphere> spheres;
  spheres.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    spheres.push_back({.position = centers[i],
                       .velocity = all_velocities[i],
                       .radius = radii[i],
                       .mass = masses[i],
                       .spin = spins[i],
                       .species = static_cast<SpeciesId>(kinds[i]),
                       .moment = moments[i]});
  }
  return spheres;
}

template <class Number, class Value>
py::object numbers_by_id(const World& world, Value&& value) {
  std::vector<Number> numbers;
  numbers.reserve(world.size());
  world.for_each_by_id([&](Slot slot) { numbers.push_back(value(slot)); });
  return read_only(array_around(std::move(numbers)));
}

template <class Value>
py::object vectors_by_id(const World& world, Value&& value) {
  std::vector<Vec3> vectors;
  vectors.reserve(world.size());
  world.for_each_by_id([&](Slot slot) { vectors.push_back(value(slot)); });
  return read_only(array_around(std::move(vectors)));
}

// --- making simulations ---

OnProgress interruptible() {
  return [](double) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
}

std::unique_ptr<PythonSimulation> owned(Simulation simulation) {
  return std::make_unique<PythonSimulation>(std::move(simulation));
}

Simulation started(World world, const EngineOptions& options) {
  const py::gil_scoped_release release;
  return Simulation(std::move(world), options, interruptible());
}

ThermostatKind thermostat_of(const py::handle& object) {
  if (py::isinstance<Andersen>(object)) return object.cast<Andersen>();
  if (py::isinstance<Rescale>(object)) return object.cast<Rescale>();
  if (py::isinstance<Heating>(object)) return object.cast<Heating>();
  throw Error("it is not a thermostat", "thermostat", "give an Andersen, a Rescale, a Heating or None");
}

void set_thermostat(PythonSimulation& self, const py::object& thermostat, std::uint64_t seed) {
  self.simulation_to_edit().set_thermostat(
      thermostat.is_none() ? std::nullopt : std::optional(Thermostat(thermostat_of(thermostat), seed)));
}

std::unique_ptr<PythonSimulation> make(const Box& box, const py::object& positions,
                                       const py::object& velocities, const py::object& radius,
                                       const py::object& mass, const py::object& spin,
                                       const py::object& species, const py::object& moment,
                                       const py::object& gravity, std::vector<Surface> surfaces,
                                       const std::vector<std::pair<SpeciesId, SpeciesId>>& passing,
                                       const py::object& response, const py::object& thermostat,
                                       std::uint64_t seed, const std::string& engine,
                                       std::optional<double> cell_edge) {
  World world(box, vector_of(gravity, "gravity"), std::move(surfaces));
  const std::vector<Sphere> spheres =
      spheres_of(positions, velocities, radius, mass, spin, species, moment, box.is_flat());
  world.reserve(spheres.size());
  for (const Sphere& sphere : spheres) world.add(sphere);
  for (const auto& [first, second] : passing) world.let_pass(first, second);
  EngineOptions options{.engine = engine_of(engine), .cell_edge = cell_edge};
  const bool is_built_in = set_response(response, options);
  std::unique_ptr<PythonSimulation> simulation = owned(started(std::move(world), options));
  if (!is_built_in) simulation->set_response(response);
  if (!thermostat.is_none()) set_thermostat(*simulation, thermostat, seed);
  return simulation;
}

std::unique_ptr<PythonSimulation> from_scenario(const Scenario& scenario, const std::string& engine,
                                                std::optional<double> cell_edge) {
  EngineOptions options{.engine = engine_of(engine), .cell_edge = cell_edge};
  respond_as_described(scenario, options);
  const auto simulation = [&] {
    const py::gil_scoped_release release;
    return make_simulation(scenario, make_world(scenario, interruptible()), options, interruptible());
  };
  std::unique_ptr<PythonSimulation> made = owned(simulation());
  made->until = scenario.until;
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

// --- saving ---

std::string saved(const PythonSimulation& self) {
  return self.simulation().save();
}

std::unique_ptr<PythonSimulation> loaded(std::string_view simulation, const std::string* measures,
                                         const std::string& where) {
  std::unique_ptr<PythonSimulation> made = owned(Simulation::load(simulation, where));
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

// --- queries and edits ---

template <class Found>
std::string body_text(const Found& found) {
  return (found.kind == EventKind::collision ? "sphere " : "wall ") + std::to_string(found.body);
}

const char* kind_name(EventKind kind) {
  return kind == EventKind::collision ? "collision" : "wall";
}

void set_velocities(PythonSimulation& self, const py::object& ids, const py::object& velocities) {
  const std::vector<std::uint32_t> spheres = counts_of(ids, "ids", kNoSphere);
  const std::vector<Vec3> vectors = vectors_of(velocities, "velocities", spheres.size());
  std::vector<VelocityEdit> edits;
  edits.reserve(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) edits.push_back({spheres[i], vectors[i]});
  self.simulation_to_edit().change_velocities(edits);
}

py::object add(PythonSimulation& self, const py::object& position, const py::object& velocity,
               const py::object& radius, const py::object& mass, const py::object& spin,
               const py::object& species, const py::object& moment) {
  Simulation& simulation = self.simulation_to_edit();
  const Doubles centers = doubles(position, "position");
  const bool is_one = centers.ndim() == 1;
  const py::object rows = is_one ? centers.attr("reshape")(1, centers.size()) : py::object(centers);
  std::vector<SphereId> ids;
  for (const Sphere& sphere :
       spheres_of(rows, velocity, radius, mass, spin, species, moment, simulation.world().box().is_flat())) {
    ids.push_back(simulation.add(sphere));
  }
  if (is_one) return py::int_(ids.front());
  return array_around(std::move(ids));
}

void remove(PythonSimulation& self, const py::object& ids) {
  Simulation& simulation = self.simulation_to_edit();
  for (const SphereId id : counts_of(ids, "ids", kNoSphere)) simulation.remove(id);
}

py::dict certificate(const PythonSimulation& self) {
  const Simulation& simulation = self.simulation();
  const World& world = simulation.world();
  const Audit found = audit(world, simulation.now());
  const Tally& tally = simulation.tally();
  const Counters counters = simulation.counters();
  py::dict all;
  all["event_log_hash"] = hash_text(simulation.event_log_hash());
  all["collisions"] = counters.collision;
  all["wall_contacts"] = counters.wall;
  all["mergers"] = tally.mergers();
  all["initial_energy"] = tally.initial_energy();
  all["energy"] = world.energy(simulation.now());
  all["momentum"] = array_of(world.momentum(simulation.now()));
  all["max_overlap"] = std::max({tally.max_overlap(), found.max_overlap, found.max_escape});
  all["is_sound"] = found.is_sound();
  return all;
}

void bind_answers(py::module_& module) {
  py::class_<NextContact>(module, "NextContact", doc::NextContact)
      .def_readonly("time", &NextContact::time, doc::NextContact_time)
      .def_property_readonly(
          "kind", [](const NextContact& self) { return kind_name(self.kind); }, "'collision' or 'wall'.")
      .def_property_readonly(
          "first",
          [](const NextContact& self) {
            return self.first == kNoSphere ? std::nullopt : std::optional(self.first);
          },
          "The sphere; None if it is not in the simulation.")
      .def_readonly("second", &NextContact::second, doc::NextContact_second)
      .def("__repr__", [](const NextContact& self) {
        return "<hardball.NextContact at " + to_text(self.time) + ": " +
               (self.first == kNoSphere ? "the sphere" : "sphere " + std::to_string(self.first)) +
               (self.kind == EventKind::collision ? " and sphere " : " and wall ") +
               std::to_string(self.second) + ">";
      });
  py::class_<RayHit>(module, "RayHit", doc::RayHit)
      .def_property_readonly(
          "kind", [](const RayHit& self) { return kind_name(self.kind); },
          "What is hit: 'collision' for a sphere, or 'wall'.")
      .def_readonly("body", &RayHit::body, doc::RayHit_body)
      .def_readonly("distance", &RayHit::distance, doc::RayHit_distance)
      .def_property_readonly(
          "point", [](const RayHit& self) { return array_of(self.point); }, doc::RayHit_point)
      .def_property_readonly(
          "normal", [](const RayHit& self) { return array_of(self.normal); }, doc::RayHit_normal)
      .def("__repr__", [](const RayHit& self) {
        return "<hardball.RayHit: " + body_text(self) + " at the distance " + to_text(self.distance) + ">";
      });
  py::class_<Clearance>(module, "Clearance", doc::Clearance)
      .def_readonly("distance", &Clearance::distance, doc::Clearance_distance)
      .def_property_readonly(
          "kind", [](const Clearance& self) { return kind_name(self.kind); },
          "What is nearest: 'collision' for a sphere, or 'wall'.")
      .def_readonly("body", &Clearance::body, doc::Clearance_body)
      .def("__repr__", [](const Clearance& self) {
        return "<hardball.Clearance: " + to_text(self.distance) + " to " + body_text(self) + ">";
      });
}

using Class = py::class_<PythonSimulation>;

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

// Properties that are arrays in the order of ids.
void bind_arrays(Class& simulation) {
  const auto of_world = [&](const char* name, auto make, const char* documentation) {
    simulation.def_property_readonly(
        name,
        [name, make](PythonSimulation& self) {
          return self.of_state(name,
                               [&] { return make(self.simulation().world(), self.simulation().now()); });
        },
        documentation);
  };
  of_world(
      "positions",
      [](const World& world, const Time& now) {
        return vectors_by_id(world, [&](Slot slot) { return world.position(slot, now); });
      },
      doc::Simulation_positions);
  of_world(
      "unwrapped_positions",
      [](const World& world, const Time& now) {
        return vectors_by_id(world, [&](Slot slot) { return world.unwrapped_position(slot, now); });
      },
      "All centres now as if they had never been folded into the box [L]. Shape (size, 3).");
  of_world(
      "velocities",
      [](const World& world, const Time& now) {
        return vectors_by_id(world, [&](Slot slot) { return world.velocity(slot, now); });
      },
      "All velocities now, in the order of ids [L/T]. Shape (size, 3).");
  of_world(
      "spins",
      [](const World& world, const Time&) {
        return vectors_by_id(world, [&](Slot slot) { return world.spin(slot); });
      },
      "All angular velocities, in the order of ids [1/T]. Shape (size, 3).");
  of_world(
      "radii",
      [](const World& world, const Time&) {
        return numbers_by_id<double>(world, [&](Slot slot) { return world.radius(slot); });
      },
      "In the order of ids [L].");
  of_world(
      "masses",
      [](const World& world, const Time&) {
        return numbers_by_id<double>(world, [&](Slot slot) { return world.mass(slot); });
      },
      "In the order of ids [M]; infinite for kinematic spheres.");
  of_world(
      "species",
      [](const World& world, const Time&) {
        return numbers_by_id<std::uint8_t>(world, [&](Slot slot) { return world.species(slot); });
      },
      "In the order of ids.");
  of_world(
      "ids",
      [](const World& world, const Time&) {
        return numbers_by_id<std::uint32_t>(world, [&](Slot slot) { return world.id(slot); });
      },
      "The ids of all spheres, ascending: 0 to size-1, until spheres are added, removed or merged.");
}

void bind_numbers(Class& simulation) {
  const auto number = [&](const char* name, auto get, const char* documentation) {
    simulation.def_property_readonly(
        name, [get](const PythonSimulation& self) { return get(self.simulation()); }, documentation);
  };
  number(
      "time", [](const Simulation& self) { return self.time(); }, "Now [T].");
  number(
      "box", [](const Simulation& self) { return self.world().box(); }, doc::Box);
  number(
      "event_log_hash", [](const Simulation& self) { return hash_text(self.event_log_hash()); },
      "Hash of all contacts so far, in 16 hexadecimal digits: that of the same run by any engine, on any "
      "machine, from the command line or from C++.");
  number(
      "collisions", [](const Simulation& self) { return self.counters().collision; },
      "How many collisions of two spheres have happened.");
  number(
      "wall_contacts", [](const Simulation& self) { return self.counters().wall; },
      "How many contacts with walls have happened.");
  number(
      "energy", [](const Simulation& self) { return self.world().energy(self.now()); }, doc::World_energy);
  number(
      "kinetic_energy", [](const Simulation& self) { return self.world().kinetic_energy(self.now()); },
      "Sum of m v^2 / 2 [M L^2 T^-2]; kinematic spheres are no part. Cost: O(n).");
  number(
      "momentum", [](const Simulation& self) { return array_of(self.world().momentum(self.now())); },
      "Sum of m v [M L/T]. Cost: O(n).");
  number(
      "compressibility", [](const Simulation& self) { return self.tally().compressibility(self.now()); },
      doc::Tally_compressibility);
  number(
      "engine", [](const Simulation& self) { return kEngines[static_cast<std::size_t>(self.engine())]; },
      "The engine in use: 'cells', 'neighbors', 'all-pairs' or 'paper'.");
  number(
      "cell_edge", [](const Simulation& self) { return self.cell_edge(); }, doc::Simulation_cell_edge);
  number(
      "memory_bytes", [](const Simulation& self) { return self.memory_bytes(); },
      "Memory that the simulation takes.");
  simulation.def_property_readonly("certificate", &certificate,
                                   "What shows that the run is sound: hash, conserved quantities, and the "
                                   "deepest overlap of two bodies so far, in diameters. Cost: O(n).");
}

void bind_queries(Class& simulation) {
  simulation
      .def("next_event", &PythonSimulation::next_event, py::arg("until") = kInfinity,
           doc::Simulation_next_contact)
      .def(
          "positions_at",
          [](PythonSimulation& self, double time) {
            return read_only(array_around(self.positions_at(time)));
          },
          py::arg("time"), doc::Simulation_positions_at)
      .def(
          "contacts_within",
          [](PythonSimulation& self, double duration, std::optional<std::uint64_t> most) {
            return self.contacts_within(duration, most.value_or(std::numeric_limits<std::uint64_t>::max()));
          },
          py::arg("duration"), py::arg("most") = py::none(), doc::Simulation_contacts_within)
      .def(
          "first_contact",
          [](const PythonSimulation& self, SphereId id, const py::object& velocity, double until) {
            return self.simulation().first_contact(id, vector_of(velocity, "velocity"), until);
          },
          py::arg("id"), py::arg("velocity"), py::arg("until"), doc::Simulation_first_contact)
      .def(
          "ray",
          [](const PythonSimulation& self, const py::object& origin, const py::object& direction,
             double most) {
            return self.simulation().ray(vector_of(origin, "origin"), vector_of(direction, "direction"),
                                         most);
          },
          py::arg("origin"), py::arg("direction"), py::arg("most"), doc::Simulation_ray)
      .def(
          "clearance",
          [](const PythonSimulation& self, const py::object& of) {
            if (PyLong_Check(of.ptr()) != 0) return self.simulation().clearance(of.cast<SphereId>());
            return self.simulation().clearance(vector_of(of, "point"));
          },
          py::arg("of"), "The sphere or wall nearest to a point now, or to the sphere with this id.");
}

void bind_edits(Class& simulation) {
  const py::tuple zero = py::make_tuple(0.0, 0.0, 0.0);
  simulation
      .def(
          "set_velocity", &set_velocities, py::arg("ids"), py::arg("velocities"),
          "Changes the velocity of a sphere, or of several [L/T], now: ids of shape (n,), velocities of "
          "shape "
          "(n, 3), or one for all. Error: no such sphere; a sphere is given twice; then nothing has changed.")
      .def(
          "add", &add, py::arg("position"), py::arg("velocity") = zero, py::arg("radius") = 1.0,
          py::arg("mass") = 1.0, py::arg("spin") = zero, py::arg("species") = 0,
          py::arg("moment") = py::none(),
          "Adds a sphere, now, and returns its id; or several, with positions of shape (n, 3). Cost: O(size) "
          "each. Error: it overlaps another; the spheres before it have been added.")
      .def("remove", &remove, py::arg("ids"),
           "Removes the sphere with this id, now, or several. Cost: O(size) each. Error: no such sphere.")
      .def("set_thermostat", &set_thermostat, py::arg("thermostat"), py::arg("seed") = 1,
           "Replaces the thermostat, which starts now; None for none.")
      .def("respond_with", &PythonSimulation::set_response, py::arg("response"),
           "Replaces the response: a Bounce, a Merging, a ResponseTable, a coefficient of restitution, or a "
           "function that is given a Contact and returns the velocities of both bodies, or an Outcome; None "
           "for that of the start. A Python function costs a few microseconds for each contact.")
      .def("on_contact", &PythonSimulation::set_listener, py::arg("listener"),
           "Sets a function that is called with the Contact after every collision and wall contact; None for "
           "none. It may query the simulation and edit it. If it throws, the run ends after that contact.");
}

void bind_state(Class& simulation) {
  simulation.def("_saved", [](const PythonSimulation& self) { return py::bytes(saved(self)); })
      .def("_save_file", &save_file)
      .def_static("_loaded",
                  [](const py::bytes& bytes) {
                    return loaded(std::string_view(bytes), nullptr, "the saved simulation");
                  })
      .def_static("_load_file", &load_file)
      .def("_copy", [](const PythonSimulation& self) { return PythonSimulation(self); })
      .def(py::pickle(&state_of, &with_state))
      .def(
          "results",
          [](const PythonSimulation& self) {
            py::dict all;
            for (Measurement& measurement : self.results()) {
              const py::str name(measurement.name);
              all[name] = std::move(measurement);
            }
            return all;
          },
          "What has been measured up to now, by the names of the measures. Cost: that of a copy of the "
          "measures.")
      .def_readwrite("until", &PythonSimulation::until, "Where a run ends that is given no limit [T].")
      .def("__len__", [](const PythonSimulation& self) { return self.simulation().size(); })
      .def("__contains__",
           [](const PythonSimulation& self, SphereId id) { return self.simulation().contains(id); });
}

}  // namespace

void bind_simulation(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(EventRecord, time, kind, first, second, normal_speed, impulse);
  bind_answers(module);
  const py::tuple zero = py::make_tuple(0.0, 0.0, 0.0);
  Class simulation(module, "Simulation", doc::Simulation, py::custom_type_setup(&collect_garbage));
  simulation
      .def(py::init(&make), py::arg("box"), py::kw_only(), py::arg("positions"), py::arg("velocities") = zero,
           py::arg("radius") = 1.0, py::arg("mass") = 1.0, py::arg("spin") = zero, py::arg("species") = 0,
           py::arg("moment") = py::none(), py::arg("gravity") = zero,
           py::arg("surfaces") = std::vector<Surface>(),
           py::arg("passing") = std::vector<std::pair<SpeciesId, SpeciesId>>(),
           py::arg("response") = py::none(), py::arg("thermostat") = py::none(), py::arg("seed") = 1,
           py::arg("engine") = "auto", py::arg("cell_edge") = py::none())
      // Subclasses are made of what the functions below return.
      .def(py::init(
          [](PythonSimulation& made) { return std::make_unique<PythonSimulation>(std::move(made)); }))
      .def_static("_from_scenario_file",
                  [](const std::filesystem::path& path, const std::vector<std::string>& overrides,
                     const std::string& engine, std::optional<double> cell_edge) {
                    return from_scenario(load_scenario(path, overrides), engine, cell_edge);
                  })
      .def_static(
          "_from_scenario_text",
          [](const std::string& text, const std::string& name, const std::vector<std::string>& overrides,
             const std::string& engine, std::optional<double> cell_edge) {
            return from_scenario(parse_scenario(text, name, overrides), engine, cell_edge);
          })
      .def_static("_box_of_file", &box_of_file)
      .def("_run", &PythonSimulation::run, py::arg("until"), py::arg("collisions"), py::arg("contacts"),
           py::arg("record"), py::arg("on_progress"))
      .def("_step", &PythonSimulation::step, py::arg("until"))
      .def("_measure",
           [](PythonSimulation& self, std::vector<std::string> names, std::optional<double> every,
              double from) { self.set_measures({.names = std::move(names), .every = every, .from = from}); });
  bind_arrays(simulation);
  bind_numbers(simulation);
  bind_queries(simulation);
  bind_edits(simulation);
  bind_state(simulation);
}

}  // namespace hardball::python
