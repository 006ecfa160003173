// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/queries/queries.hpp"

#include <pybind11/stl.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

template <class Found>
std::string body_text(const Found& found) {
  return (found.kind == EventKind::collision ? "sphere " : "wall ") + std::to_string(found.body);
}

BodyKind kind_name(EventKind kind) {
  return py::str(kind == EventKind::collision ? "collision" : "wall");
}

bool is_flat(const PythonSimulation& self) {
  return self.simulation().world().box().is_flat();
}

}  // namespace

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

void bind_queries(SimulationClass& simulation) {
  simulation
      .def("next_event", &PythonSimulation::next_event,
           py::arg("until") = std::numeric_limits<double>::infinity(), doc::Simulation_next_contact)
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
          [](const PythonSimulation& self, SphereId id, const ArrayLike& velocity, double until) {
            return self.first_contact(id, vector_of(velocity, "velocity", is_flat(self)), until);
          },
          py::arg("id"), py::arg("velocity"), py::arg("until"), doc::first_contact)
      .def(
          "ray",
          [](const PythonSimulation& self, const ArrayLike& origin, const ArrayLike& direction, double most) {
            return self.ray(vector_of(origin, "origin", is_flat(self)),
                            vector_of(direction, "direction", is_flat(self)), most);
          },
          py::arg("origin"), py::arg("direction"), py::arg("most"), doc::ray)
      .def(
          "clearance",
          [](const PythonSimulation& self, const Typed<"int | ArrayLike">& of) {
            if (PyIndex_Check(of.ptr()) != 0 && !py::hasattr(of, "__len__")) {
              return self.simulation().clearance(counts_of(of, "of", kNoSphere).front());
            }
            return self.simulation().clearance(vector_of(of, "point", is_flat(self)));
          },
          py::arg("of"), (std::string("`of` is a point, or the id of a sphere. ") + doc::clearance).c_str());
}

}  // namespace hardball::python
