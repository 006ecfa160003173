// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/thermostats.hpp"

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/call_text.hpp"

namespace py = pybind11;

namespace hardball::python {

ThermostatKind thermostat_of(const py::handle& object) {
  if (py::isinstance<Andersen>(object)) return object.cast<Andersen>();
  if (py::isinstance<Rescale>(object)) return object.cast<Rescale>();
  if (py::isinstance<Heating>(object)) return object.cast<Heating>();
  throw Error("it is not a thermostat", "thermostat", "give an Andersen, a Rescale, a Heating or None");
}

void bind_thermostats(py::module_& module) {
  py::class_<Andersen>(module, "Andersen", doc::Andersen)
      .def(py::init<double, double>(), py::arg("temperature"), py::arg("rate"), doc::Andersen_Andersen)
      .def_property_readonly("temperature", &Andersen::temperature, "k T [M L^2 T^-2].")
      .def_property_readonly("rate", &Andersen::rate, "The rate of each sphere's events [1/T].")
      .def("__repr__", [](const Andersen& self) {
        return CallText("Andersen").add("temperature", self.temperature()).add("rate", self.rate()).text();
      });
  py::class_<Rescale>(module, "Rescale", doc::Rescale)
      .def(py::init<double, double, std::size_t>(), py::arg("temperature"), py::arg("every"),
           py::arg("slabs") = 0, doc::Rescale_Rescale)
      .def_property_readonly("temperature", &Rescale::temperature, "k T [M L^2 T^-2].")
      .def_property_readonly("every", &Rescale::every, "The interval [T].")
      .def_property_readonly("slabs", &Rescale::slabs, "The number of slabs across y, zero for none.")
      .def("__repr__", [](const Rescale& self) {
        CallText call("Rescale");
        call.add("temperature", self.temperature()).add("every", self.every());
        if (self.slabs() > 0) call.add("slabs", static_cast<double>(self.slabs()));
        return call.text();
      });
  py::class_<Heating>(module, "Heating", doc::Heating)
      .def(py::init<double, double>(), py::arg("strength"), py::arg("every"), doc::Heating_Heating)
      .def_property_readonly("strength", &Heating::strength, "[L^2 T^-3]")
      .def_property_readonly("every", &Heating::every, "The interval [T].")
      .def("__repr__", [](const Heating& self) {
        return CallText("Heating").add("strength", self.strength()).add("every", self.every()).text();
      });
}

}  // namespace hardball::python
