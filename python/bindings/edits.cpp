// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/spheres.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

// Once in a while.
void throw_if_interrupted(std::size_t count) {
  if (count % 256 == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
}

void set_velocities(PythonSimulation& self, const ArrayLike& ids, const ArrayLike& velocities) {
  const bool is_flat = self.simulation().setting().box().is_flat();
  if (const std::optional<std::uint32_t> one = plain_count(ids)) {
    if (const std::optional<Vec3> velocity = plain_vector(velocities, is_flat)) {
      self.warn_of_edit("set_velocity");
      const VelocityEdit edit{*one, *velocity};
      return self.change_velocities({&edit, 1});
    }
  }
  const std::vector<std::uint32_t> spheres = counts_of(ids, "ids", kNoSphere);
  const std::vector<Vec3> vectors = vectors_of(velocities, "velocities", is_flat, spheres.size());
  std::vector<VelocityEdit> edits;
  edits.reserve(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) edits.push_back({spheres[i], vectors[i]});
  self.warn_of_edit("set_velocity");
  self.change_velocities(edits);
}

void set_thermostat(PythonSimulation& self, const OptionalThermostat& thermostat, std::uint64_t seed) {
  self.warn_of_edit("set_thermostat");
  self.set_thermostat(thermostat, seed);
}

void respond_with(PythonSimulation& self, const OptionalResponse& response) {
  self.check_not_recording("respond_with");
  self.warn_of_edit("respond_with");
  self.set_response(response);
}

py::object add(PythonSimulation& self, const ArrayLike& position, const ArrayLike& velocity,
               const ArrayLike& radius, const ArrayLike& mass, const ArrayLike& spin,
               const ArrayLike& species, const OptionalArrayLike& moment) {
  const Doubles centers = doubles(position, "position");
  const bool is_one = centers.ndim() == 1;
  const py::object rows = is_one ? centers.attr("reshape")(1, centers.size()) : py::object(centers);
  const bool is_flat = self.simulation().world().box().is_flat();
  const std::vector<Sphere> spheres =
      spheres_of(rows, velocity, radius, mass, spin, species, moment, is_flat);
  self.check_spheres_may_change("add");
  Simulation& simulation = self.simulation_to_edit();
  std::vector<SphereId> ids;
  for (const Sphere& sphere : spheres) {
    ids.push_back(simulation.add(sphere));
    throw_if_interrupted(ids.size());
  }
  if (is_one) return py::int_(ids.front());
  return array_around(std::move(ids));
}

void remove(PythonSimulation& self, const ArrayLike& ids) {
  const std::vector<std::uint32_t> spheres = counts_of(ids, "ids", kNoSphere);
  self.check_spheres_may_change("remove");
  Simulation& simulation = self.simulation_to_edit();
  std::vector<std::uint32_t> sorted = spheres;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end()) {
    throw Error("sphere " + std::to_string(*twice) + " is given twice", "remove", "give each once");
  }
  for (const SphereId id : sorted) static_cast<void>(simulation.world().slot_of(id));
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    simulation.remove(spheres[i]);
    throw_if_interrupted(i);
  }
}

void set_user_data(PythonSimulation& self, const ArrayLike& ids, const ArrayLike& data) {
  const std::vector<std::uint32_t> spheres = counts_of(ids, "ids", kNoSphere);
  const std::vector<std::uint64_t> numbers = bits_of(data, "data", spheres.size());
  Simulation& simulation = self.simulation_to_edit();
  for (const SphereId id : spheres) static_cast<void>(simulation.world().slot_of(id));
  for (std::size_t i = 0; i < spheres.size(); ++i) simulation.set_user_data(spheres[i], numbers[i]);
}

void grow(PythonSimulation& self, double rate, std::optional<double> packing_fraction,
          std::optional<double> compressibility) {
  GrowthRules rules;
  rules.rate = rate;
  if (packing_fraction) rules.until_packing_fraction = *packing_fraction;
  if (compressibility) rules.until_compressibility = *compressibility;
  self.check_spheres_may_change("grow");
  self.simulation_to_edit().grow(rules);
}

}  // namespace

void bind_edits(SimulationClass& simulation) {
  const py::tuple zero = py::make_tuple(0.0, 0.0, 0.0);
  simulation
      .def(
          "set_velocity", &set_velocities, py::arg("ids"), py::arg("velocities"),
          "Changes the velocity of a sphere, or of several [L/T], now: ids of shape (n,), velocities of "
          "shape (n, 3), or one for all; in two dimensions also (n, 2). Ids are not rows of arrays once "
          "spheres have been removed or have merged: see index_of. Measures that have begun treat the change "
          "like the action of a thermostat, and a UserWarning says once that their results average over the "
          "states before and after. Error, and nothing changes: no such sphere; a sphere is given twice; "
          "velocities have another shape.")
      .def("add", &add, py::arg("position"), py::arg("velocity") = zero, py::arg("radius") = 1.0,
           py::arg("mass") = 1.0, py::arg("spin") = zero, py::arg("species") = 0,
           py::arg("moment") = py::none(),
           "Adds a sphere, now, and returns its id; or several, with positions of shape (n, 3), or in two "
           "dimensions (n, 2). Cost: that of a collision each. Error: a sphere overlaps another, and those "
           "before it stay added; measures are on.")
      .def("remove", &remove, py::arg("ids"),
           "Removes the sphere with this id, now, or several. The others keep their ids, but in arrays those "
           "above move up a row: see index_of. Cost: that of a collision each. Error, and nothing changes: "
           "no such sphere; one is given twice; measures are on.")
      .def("set_user_data", &set_user_data, py::arg("ids"), py::arg("data"),
           "Attaches a number from 0 to 2^64 - 1 to a sphere, or to several: ids of shape (n,), data of "
           "shape (n,), or one number for all. Queries take its bits for the groups of a sphere. It changes "
           "no history, and is saved. Error, and nothing changes: no such sphere; another shape; not a whole "
           "number.")
      .def("set_thermostat", &set_thermostat, py::arg("thermostat"), py::arg("seed") = 1,
           "Replaces the thermostat, which starts now; None removes it. Warns as set_velocity does.")
      .def_property(
          "thermostat",
          [](const PythonSimulation& self) -> OptionalThermostat {
            const std::optional<Thermostat>& thermostat = self.simulation().thermostat();
            return thermostat ? py::cast(thermostat->kind()) : py::none();
          },
          [](PythonSimulation& self, const OptionalThermostat& thermostat) {
            set_thermostat(self, thermostat, 1);
          },
          "The Andersen, Rescale or Heating in use, or None. Assigning one replaces it, as set_thermostat "
          "does.")
      .def(
          "grow", &grow, py::arg("rate") = GrowthRules().rate, py::kw_only(),
          py::arg("packing_fraction") = py::none(), py::arg("compressibility") = py::none(),
          "Lets all spheres grow from now on, in proportion: the mean diameter by `rate` times the thermal "
          "speed, sqrt(kT/m); negative where they shrink, and then a packing fraction is needed. Growth ends "
          "at `packing_fraction`, where PV/NkT exceeds `compressibility`, or where the largest sphere just "
          "fits; see `growth`. Collisions heat spheres that grow; whenever their speed has doubled, all "
          "velocities are halved. Error: measures are on; anything that growth excludes, such as gravity.")
      .def(
          "stop_growing", [](PythonSimulation& self) { self.simulation_to_edit().stop_growing(); },
          "Ends a growth: from now on spheres keep the sizes that they have. Measures need this, also after "
          "growth has reached its end.")
      .def("respond_with", &respond_with, py::arg("response"),
           "Replaces the response: a Bounce, a Merging, a ResponseTable, a coefficient of restitution, or a "
           "function that takes a Contact and returns the velocities of both bodies, or an Outcome. None "
           "restores the last one that was not a function. A Python function costs a few microseconds for "
           "each contact. Warns as set_velocity does.")
      .def_property(
          "response",
          [](const PythonSimulation& self) -> OptionalResponse {
            if (self.simulation().has_custom_response() && self.response())
              return self.response()->function();
            return py::cast(self.simulation().setting().interactions().table());
          },
          &respond_with,
          "What contacts do: a ResponseTable, a copy of the one in use, or the function that was given. "
          "Assigning "
          "any response replaces it, as respond_with does.")
      .def("_set_response", &PythonSimulation::set_response)
      .def(
          "on_contact",
          [](PythonSimulation& self, const Typed<"Callable[[Contact], object] | None">& listener) {
            self.set_listener(listener);
          },
          py::arg("listener"),
          "Sets a function that is called with the Contact after every collision and wall contact; None "
          "removes it. It may query and edit the simulation. If it raises, the run ends after that contact.");
}

}  // namespace hardball::python
