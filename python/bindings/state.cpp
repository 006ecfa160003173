// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

// value(slot) for all spheres, in the order of ids.
template <class Value>
auto by_id(const World& world, Value&& value) {
  std::vector<std::remove_cvref_t<decltype(value(Slot{}))>> values;
  values.reserve(world.size());
  world.for_each_by_id([&](Slot slot) { values.push_back(value(slot)); });
  return read_only(array_around(std::move(values)));
}

// The row of a sphere in all arrays. Error: there is no such sphere.
std::size_t index_of(const World& world, SphereId id) {
  static_cast<void>(world.slot_of(id));
  const auto ranks = std::views::iota(std::size_t{0}, world.size());
  const auto id_of = [&](std::size_t rank) { return world.id(world.slot_of_rank(rank)); };
  return *std::ranges::lower_bound(ranks, id, {}, id_of);
}

py::object indices_of(const PythonSimulation& self, const ArrayLike& ids) {
  const std::vector<std::uint32_t> spheres = counts_of(ids, "ids", kNoSphere);
  const bool is_one = doubles(ids, "ids").ndim() == 0;
  const World& world = self.simulation().world();
  std::vector<std::int64_t> indices;
  indices.reserve(spheres.size());
  for (const SphereId id : spheres) indices.push_back(static_cast<std::int64_t>(index_of(world, id)));
  if (is_one) return py::int_(indices.front());
  return array_around(std::move(indices));
}

void set_all_velocities(PythonSimulation& self, const ArrayLike& velocities) {
  const World& world = self.simulation().world();
  const std::vector<Vec3> vectors = vectors_of(velocities, "velocities", world.box().is_flat(), world.size());
  std::vector<VelocityEdit> edits;
  edits.reserve(vectors.size());
  world.for_each_by_id([&](Slot slot) { edits.push_back({world.id(slot), vectors[edits.size()]}); });
  self.warn_of_edit("velocities");
  self.change_velocities(edits);
}

std::optional<double> time_or_none(const py::object& time) {
  if (time.is_none()) return std::nullopt;
  const Doubles number = doubles(time, "until");
  if (number.ndim() != 0) throw Error("it is not one number", "until", "give a time, or None");
  return *number.data();
}

py::dict certificate(const PythonSimulation& self) {
  const Simulation& simulation = self.simulation();
  const World& world = simulation.world();
  const Audit found = audit(world, simulation.now());
  const Tally& tally = simulation.tally();
  py::dict all;
  all["event_log_hash"] = hash_text(simulation.event_log_hash());
  all["collisions"] = tally.collisions();
  all["wall_contacts"] = tally.wall_contacts();
  all["mergers"] = tally.mergers();
  all["steps_passed"] = tally.steps_passed();
  all["steps_refused"] = tally.steps_refused();
  all["initial_energy"] = tally.initial_energy();
  all["energy"] = energy(world, simulation.now());
  all["momentum"] = array_of(momentum(world, simulation.now()));
  all["max_overlap"] = std::max({tally.max_overlap(), found.max_overlap, found.max_escape});
  all["is_sound"] = found.is_sound();
  return all;
}

// Properties that are arrays in the order of ids, made of get(world, slot, now) for each sphere.
void bind_arrays(SimulationClass& simulation) {
  const auto getter = [](const char* name, auto get) {
    return [name, get](PythonSimulation& self) {
      return self.of_state(name, [&] {
        const World& world = self.simulation().world();
        const Time& now = self.simulation().now();
        return by_id(world, [&](Slot slot) { return get(world, slot, now); });
      });
    };
  };
  const auto array = [&](const char* name, auto get, const char* documentation) {
    simulation.def_property_readonly(name, getter(name, get), documentation);
  };
  simulation.def_property("velocities",
                          getter("velocities", [](const World& world, Slot slot,
                                                  const Time& now) { return world.velocity(slot, now); }),
                          &set_all_velocities,
                          "All velocities now, in the order of ids [L/T]. Shape (size, 3). Assigning an "
                          "array, or one vector for all, "
                          "changes them as set_velocity does.");
  array(
      "positions", [](const World& world, Slot slot, const Time& now) { return world.position(slot, now); },
      (std::string(doc::Simulation_positions) + " Row index_of(id) is the sphere with this id.").c_str());
  array(
      "unwrapped_positions",
      [](const World& world, Slot slot, const Time& now) { return unwrapped_position(world, slot, now); },
      "All centers now as if they had never been folded into the box [L]. Shape (size, 3).");
  array(
      "spins", [](const World& world, Slot slot, const Time&) { return world.spin(slot); },
      "All angular velocities, in the order of ids [1/T]. Shape (size, 3).");
  array(
      "radii", [](const World& world, Slot slot, const Time& now) { return world.radius(slot, now); },
      "All radii, in the order of ids [L].");
  array(
      "masses", [](const World& world, Slot slot, const Time&) { return world.mass(slot); },
      "All masses, in the order of ids [M]; infinite for kinematic spheres.");
  array(
      "moments", [](const World& world, Slot slot, const Time&) { return world.inertia_factor(slot); },
      "Moments of inertia over mass and squared radius, in the order of ids [1].");
  array(
      "species", [](const World& world, Slot slot, const Time&) { return world.species(slot); },
      "All species, in the order of ids.");
  simulation.def_property_readonly(
      "user_data",
      [](PythonSimulation& self) {
        return self.of_state("user_data", [&] {
          const Simulation& of = self.simulation();
          const World& world = of.world();
          return by_id(world, [&](Slot slot) { return of.user_data(world.id(slot)); });
        });
      },
      "The numbers that set_user_data has attached to all spheres, in the order of ids; zero at first.");
  array(
      "ids", [](const World& world, Slot slot, const Time&) { return world.id(slot); },
      "The ids of all spheres, ascending: 0 to size-1, until spheres are removed or merge. Row k of every "
      "array is the sphere ids[k]; index_of is the inverse.");
}

void bind_numbers(SimulationClass& simulation) {
  const auto number = [&](const char* name, auto get, const char* documentation) {
    simulation.def_property_readonly(
        name, [get](const PythonSimulation& self) { return get(self.simulation()); }, documentation);
  };
  number(
      "time", [](const Simulation& self) { return self.time(); }, "The present time [T].");
  // Made once, as they take longer than a number.
  const auto object = [&](const char* name, auto get, const char* documentation) {
    simulation.def_property_readonly(
        name,
        [name, get](PythonSimulation& self) {
          return self.of_state(name, [&] { return get(self.simulation()); });
        },
        documentation);
  };
  object(
      "box", [](const Simulation& self) -> Typed<"Box"> { return py::cast(self.setting().box()); }, doc::Box);
  object(
      "gravity",
      [](const Simulation& self) { return read_only(array_of(self.setting().motion().gravity())); },
      "Acceleration of all spheres [L/T^2].");
  number(
      "event_log_hash", [](const Simulation& self) { return hash_text(self.event_log_hash()); },
      "Hash of all contacts so far, in 16 hexadecimal digits: that of the same run by any engine, on any "
      "machine, from the command line or from C++.");
  number(
      "collisions", [](const Simulation& self) { return self.tally().collisions(); },
      "The number of collisions of two spheres so far.");
  number(
      "wall_contacts", [](const Simulation& self) { return self.tally().wall_contacts(); },
      "The number of contacts with walls so far.");
  number(
      "energy", [](const Simulation& self) { return energy(self.world(), self.now()); },
      "Kinetic, rotational and potential energy of all spheres [M L^2 T^-2]. The potential energy of gravity "
      "is zero at the origin, and uses unwrapped positions in a periodic box. Cost: O(n).");
  number(
      "kinetic_energy", [](const Simulation& self) { return kinetic_energy(self.world(), self.now()); },
      "Sum of m v^2 / 2 [M L^2 T^-2]; without kinematic spheres. Cost: O(n).");
  number(
      "step_energy", [](const Simulation& self) { return step_energy(self.world()); },
      "The energy of all pairs of spheres that are inside of a step of their potential [M L^2 T^-2]; "
      "`energy` has it, too. Cost: O(n).");
  number(
      "bonds",
      [](const Simulation& self) {
        std::vector<std::tuple<SphereId, SphereId, int>> bonds;
        for (const Bond& bond : bonds_of(self.world()))
          bonds.emplace_back(bond.first, bond.second, bond.potential);
        return bonds;
      },
      "The spheres that are tied together, as they were given: two ids and the number of a potential for "
      "each.");
  number(
      "temperature",
      [](const Simulation& self) { return thermal_motion(self.world(), self.now()).temperature(); },
      "k T [M L^2 T^-2]: twice the kinetic energy relative to a common drift along axes without walls, over "
      "the degrees of freedom, like the measure of this name; NaN if there are none. Cost: O(n).");
  number(
      "packing_fraction", [](const Simulation& self) { return packing_fraction(self.world(), self.now()); },
      doc::packing_fraction);
  number(
      "momentum",
      [](const Simulation& self) { return read_only(array_of(momentum(self.world(), self.now()))); },
      "Sum of m v [M L/T]. Cost: O(n).");
  number(
      "compressibility", [](const Simulation& self) { return self.tally().compressibility(self.now()); },
      doc::Tally_compressibility);
  number(
      "engine", [](const Simulation& self) { return name_of(self.engine()); },
      "The engine in use: 'cells', 'neighbors', 'all-pairs' or 'paper'.");
  number(
      "cell_edge", [](const Simulation& self) { return self.cell_edge(); }, doc::Simulation_cell_edge);
  number(
      "memory_bytes", [](const Simulation& self) { return self.memory_bytes(); },
      "The memory that the simulation uses.");
}

}  // namespace

void bind_state(SimulationClass& simulation) {
  bind_arrays(simulation);
  bind_numbers(simulation);
  simulation
      .def_property_readonly("certificate", &certificate,
                             "The evidence that the run is sound: hash, conserved quantities, and the "
                             "deepest overlap of two bodies so far, in diameters. Cost: O(n).")
      .def(
          "results", [](const PythonSimulation& self) -> Typed<"dict[str, Measurement]"> {
            py::dict all;
            for (Measurement& measurement : self.results()) {
              const py::str name(measurement.name);
              all[name] = std::move(measurement);
            }
            return all;
          },
          "The results so far, by the names of the measures. Cost: that of a copy of the "
          "measures.")
      .def(
          "face_forces", [](const PythonSimulation& self) -> Typed<"dict[str, FaceForces]"> {
            py::dict all;
            for (FaceForces& forces : self.face_forces()) {
              const py::str name(forces.wall);
              all[name] = std::move(forces);
            }
            return all;
          },
          "The forces on the triangles of meshes so far, by the names that the walls have in the results of "
          "wall_forces; none unless `measure` was called with face_forces.")
      .def("index_of", &indices_of, py::arg("ids"),
           "The row in positions, velocities and all other arrays of the sphere with this id, or of several: "
           "velocities[index_of(7)] is that of sphere 7. Rows equal ids only until spheres are removed or "
           "merge. Cost: O(log size) each. Error: no such sphere.")
      .def_property_readonly(
          "surfaces",
          [](const PythonSimulation& self) {
            const std::span<const Surface> surfaces = self.simulation().setting().surfaces();
            return std::vector<Surface>(surfaces.begin(), surfaces.end());
          },
          "The walls inside the box, and obstacles, as they were given: copies.")
      .def_property_readonly(
          "growth",
          [](const PythonSimulation& self) -> std::optional<std::string> {
            const std::optional<GrowthSchedule>& growth = self.simulation().growth();
            if (!growth) return std::nullopt;
            return std::string(name_of(growth->state()));
          },
          "None without growth; \"growing\" while spheres grow, \"measuring\" at first, while their density "
          "is measured; or why "
          "growth has ended: \"reached\" (the packing fraction), \"over_pressure\" or \"no_room\".")
      .def_property(
          "until", &PythonSimulation::until,
          [](PythonSimulation& self, const py::object& time) { self.set_until(time_or_none(time)); },
          "The time at which a run without limits ends [T].")
      .def_property(
          "threads", [](const PythonSimulation& self) { return self.simulation().options().threads; },
          [](PythonSimulation& self, std::size_t threads) {
            Simulation& edited = self.simulation_to_edit();
            const py::gil_scoped_release release;
            edited.set_threads(threads);
          },
          "How many threads share the work, or 0 for as many as pay. It changes the speed and never the "
          "history. A simulation that is loaded has one. Cost: O(n). Error: several where spheres merge, or "
          "the response is a function.")
      .def_property_readonly(
          "processes",
          [](const PythonSimulation& self) -> Processes& { return self.simulation().processes(); },
          py::return_value_policy::reference, doc::Simulation_processes)
      .def("__len__", [](const PythonSimulation& self) { return self.simulation().size(); })
      .def(
          "__contains__",
          [](const PythonSimulation& self, SphereId id) { return self.simulation().contains(id); },
          py::arg("id"));
}

}  // namespace hardball::python
