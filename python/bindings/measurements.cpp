// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/statistics/measurement.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/call_text.hpp"
#include "python/bindings/pickling.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

constexpr int kUsualDigits = 6;
constexpr int kDigitsOfErrors = 2;

// How many digits there are down to those of the error.
int digits_of(const Quantity& quantity) {
  const double digits = std::floor(std::log10(std::fabs(quantity.value))) -
                        std::floor(std::log10(quantity.error)) + kDigitsOfErrors;
  return std::isfinite(digits) ? static_cast<int>(std::clamp(digits, 1.0, 17.0)) : kUsualDigits;
}

// Rounded according to the error.
std::string text_of(const Quantity& quantity) {
  std::string text = rounded_text(quantity.value, digits_of(quantity));
  if (!std::isnan(quantity.error)) text += " +- " + rounded_text(quantity.error, kDigitsOfErrors);
  if (quantity.unit != "1") text += " " + quantity.unit;
  if (!std::isnan(quantity.theory)) text += ", theory " + rounded_text(quantity.theory, kUsualDigits);
  return text;
}

std::string text_of(const Measurement& measurement) {
  std::string text = "<hardball.Measurement: " + measurement.title;
  for (const Quantity& quantity : measurement.quantities) {
    text += "\n  " + quantity.name + ": " + text_of(quantity);
  }
  if (measurement.columns.empty()) return text + ">";
  const std::size_t rows = measurement.columns.front().values.size();
  text += "\n  " + to_text(rows) + (rows == 1 ? " row of " : " rows of ");
  for (const Column& column : measurement.columns) {
    text += (&column == &measurement.columns.front() ? "" : ", ") + column.name;
  }
  return text + ">";
}

// Quantities and arrays keep the measurement alive.
py::dict quantities_of(const py::object& self) {
  py::dict all;
  for (const Quantity& quantity : self.cast<const Measurement&>().quantities) {
    all[py::str(quantity.name)] = py::cast(quantity, py::return_value_policy::reference_internal, self);
  }
  return all;
}

py::dict columns_of(const py::object& self) {
  py::dict all;
  for (const Column& column : self.cast<const Measurement&>().columns) {
    const auto size = static_cast<py::ssize_t>(column.values.size());
    all[py::str(column.name)] = read_only(py::array_t<double>(size, column.values.data(), self));
  }
  return all;
}

}  // namespace

void bind_measurements(py::module_& module) {
  py::class_<Quantity>(module, "Quantity", doc::Quantity)
      .def_readonly("name", &Quantity::name, doc::Quantity_name)
      .def_readonly("unit", &Quantity::unit, doc::Quantity_unit)
      .def_readonly("value", &Quantity::value)
      .def_readonly("error", &Quantity::error, doc::Quantity_error)
      .def_readonly("theory", &Quantity::theory, doc::Quantity_theory)
      .def_readonly("tolerance", &Quantity::tolerance, doc::Quantity_tolerance)
      .def_readonly("reason", &Quantity::reason, doc::Quantity_reason)
      .def("__float__", [](const Quantity& self) { return self.value; })
      .def(
          "__format__",
          [](const Quantity& self, const py::str& form) {
            return py::str(py::module_::import("builtins").attr("format")(self.value, form));
          },
          py::arg("form"))
      .def(pickled<Quantity>())
      .def("__repr__", [](const Quantity& self) {
        return "<hardball.Quantity " + self.name + ": " + text_of(self) + ">";
      });
  py::class_<Measurement>(module, "Measurement", doc::Measurement)
      .def_readonly("name", &Measurement::name, doc::Measurement_name)
      .def_readonly("title", &Measurement::title, doc::Measurement_title)
      .def_readonly("formula", &Measurement::formula, doc::Measurement_formula)
      .def_readonly("source", &Measurement::source, doc::Measurement_source)
      .def_property_readonly(
          "quantities",
          [](const py::object& self) -> Typed<"dict[str, Quantity]"> { return quantities_of(self); },
          "The measured numbers by their names.")
      .def_property_readonly(
          "columns", [](const py::object& self) -> Typed<"dict[str, NDArray[numpy.float64]]"> {
            return columns_of(self);
          },
          "The measured function as a table: arrays by their names. The first is the "
          "argument; errors and theory follow their values. May be empty.")
      .def_property_readonly(
          "units", [](const Measurement& self) -> Typed<"dict[str, str]"> {
            py::dict all;
            for (const Quantity& quantity : self.quantities) all[py::str(quantity.name)] = quantity.unit;
            for (const Column& column : self.columns) all[py::str(column.name)] = column.unit;
            return all;
          },
          "The units of quantities and columns: products of powers of L, T and M; '1' for pure numbers.")
      .def(
          "to_frame", [](const py::object& self) -> Typed<"pandas.DataFrame"> {
            return py::module_::import("pandas").attr("DataFrame")(columns_of(self));
          },
          "The columns as a data frame; needs pandas.")
      .def(
          "__getitem__",
          [](const py::object& self, const std::string& name) {
            for (const py::dict& all : {quantities_of(self), columns_of(self)}) {
              if (all.contains(name)) return py::object(all[py::str(name)]);
            }
            std::string known;
            for (const py::dict& all : {quantities_of(self), columns_of(self)}) {
              for (const auto& [key, value] : all)
                known += (known.empty() ? "" : ", ") + py::str(key).cast<std::string>();
            }
            throw py::key_error("there is no quantity or column " + name + "; choose among " + known);
          },
          py::arg("name"), "The quantity or column of this name. KeyError: there is none.")
      .def(
          "__contains__",
          [](const py::object& self, const std::string& name) {
            return quantities_of(self).contains(name) || columns_of(self).contains(name);
          },
          py::arg("name"), "Whether there is a quantity or column of this name.")
      .def(pickled<Measurement>())
      .def_readonly("duration", &Measurement::duration, doc::Measurement_duration)
      .def_readonly("transient", &Measurement::transient, doc::Measurement_transient)
      .def_readonly("is_transient_over", &Measurement::is_transient_over, doc::Measurement_is_transient_over)
      .def_readonly("unsettled", &Measurement::unsettled, doc::Measurement_unsettled)
      .def("__repr__", [](const Measurement& self) { return text_of(self); });
  py::class_<FaceForces>(module, "FaceForces", doc::FaceForces)
      .def_readonly("wall", &FaceForces::wall, doc::FaceForces_wall)
      .def_property_readonly(
          "point", [](const FaceForces& self) { return array_of(self.point); }, doc::FaceForces_point)
      .def_property_readonly(
          "forces", [](const FaceForces& self) { return read_only(array_around(self.forces)); },
          "On each triangle: the mean force [M L T^-2]. Shape (n, 3).")
      .def_property_readonly(
          "pressures", [](const FaceForces& self) { return read_only(array_around(self.pressures)); },
          doc::FaceForces_pressures)
      .def_property_readonly(
          "contacts", [](const FaceForces& self) { return read_only(array_around(self.contacts)); },
          doc::FaceForces_contacts)
      .def(
          "to_vtp", [](const FaceForces& self) { return py::bytes(vtp_text(self)); }, doc::vtp_text)
      .def("__repr__", [](const FaceForces& self) {
        return "<hardball.FaceForces of " + to_text(self.forces.size()) + " triangles of " + self.wall + ">";
      });
  module.def(
      "measure_names",
      [] {
        const auto names = measure_names();
        return std::vector<std::string>(names.begin(), names.end());
      },
      doc::measure_names);
}

}  // namespace hardball::python
