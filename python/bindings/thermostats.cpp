// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/thermostats.hpp"

#include <cctype>
#include <optional>
#include <string>
#include <type_traits>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/call_text.hpp"

namespace py = pybind11;

namespace hardball::python {

namespace {

// The argument for a field; integers that are not given are zero.
template <class Get>
auto argument_for(const Field<Get>& field) {
  const py::arg argument(field.name.data());
  if constexpr (std::is_integral_v<typename Field<Get>::Value>)
    return argument = 0;
  else
    return argument;
}

// Binds a kind of thermostat, which is made from its fields.
template <class Kind>
void bind_kind(py::module_& module, const char* name, const char* meaning, const char* remark) {
  py::class_<Kind> kind(module, name, meaning);
  const auto with_fields = [&]<class... Get>(const Field<Get>&... field) {
    kind.def(py::init<typename Field<Get>::Value...>(), argument_for(field)..., remark);
    const auto documented = [](const auto& its) {
      std::string text = std::string(its.meaning);
      text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
      return text + (its.dimension.empty() ? "." : " [" + std::string(its.dimension) + "].");
    };
    (kind.def_property_readonly(field.name.data(), field.get, documented(field).c_str()), ...);
  };
  std::apply(with_fields, Kind::fields());
  kind.def("__repr__", [name = std::string(name)](const Kind& self) {
    CallText call(name);
    for_each_value(self, [&](const auto& field, const auto& value) {
      if (field.is_required || value != 0) call.add(field.name.data(), static_cast<double>(value));
    });
    return call.text();
  });
}

}  // namespace

ThermostatKind thermostat_of(const py::handle& object) {
  std::optional<ThermostatKind> given;
  for_each_alternative<ThermostatKind>([&]<class Kind>(std::type_identity<Kind>) {
    if (py::isinstance<Kind>(object)) given = object.cast<Kind>();
  });
  if (given) return *given;
  throw Error("it is not a thermostat", "thermostat", "give an Andersen, a Rescale, a Heating or None");
}

void bind_thermostats(py::module_& module) {
  bind_kind<Andersen>(module, "Andersen", doc::Andersen, doc::Andersen_Andersen);
  bind_kind<Rescale>(module, "Rescale", doc::Rescale, doc::Rescale_Rescale);
  bind_kind<Heating>(module, "Heating", doc::Heating, doc::Heating_Heating);
}

}  // namespace hardball::python
