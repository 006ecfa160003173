// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "documentation.hpp"
#include "hardball/interaction/step_potential.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/call_text.hpp"
#include "python/bindings/pickling.hpp"

namespace hardball::python {
namespace {

namespace py = pybind11;

using Steps = std::vector<std::pair<double, double>>;

StepPotential make_step_potential(const Steps& steps, double core, bool tether) {
  StepRules rules{.core = core, .is_tether = tether};
  for (const auto& [ratio, energy] : steps) rules.steps.push_back({ratio, energy});
  return StepPotential(rules);
}

Steps steps_of(const StepPotential& potential) {
  Steps steps;
  for (const Step& step : potential.rules().steps) steps.emplace_back(step.ratio, step.energy);
  return steps;
}

std::string text_of(const StepPotential& potential) {
  std::string steps;
  for (const Step& step : potential.rules().steps) {
    if (!steps.empty()) steps += ", ";
    steps += "(" + to_text(step.ratio) + ", " + to_text(step.energy) + ")";
  }
  CallText call("StepPotential");
  call.add("[" + steps + "]");
  if (potential.rules().core != 1) call.add("core", potential.rules().core);
  if (potential.is_tether()) call.add("tether", std::string("True"));
  return call.text();
}

}  // namespace

void bind_steps(py::module_& module) {
  py::class_<StepPotential>(module, "StepPotential", doc::StepPotential)
      .def(py::init(&make_step_potential), py::arg("steps"), py::kw_only(), py::arg("core") = 1.0,
           py::arg("tether") = false,
           "`steps` are pairs of a ratio, the distance of the centers over the sum of the radii, and the "
           "energy [M L^2 T^-2] inside of it, from the inside to the outside. The spheres bounce off each "
           "other at the ratio `core`, zero if they may take the same place. With `tether` they never part "
           "beyond the last step.")
      .def_static("sensor", &StepPotential::sensor, doc::StepPotential_sensor)
      .def_property_readonly("steps", &steps_of, "Pairs of ratio and energy, from the inside to the outside.")
      .def_property_readonly(
          "core", [](const StepPotential& self) { return self.rules().core; }, doc::StepRules_core)
      .def_property_readonly("tether", &StepPotential::is_tether, doc::StepRules_is_tether)
      .def(py::pickle(
          [](const StepPotential& self) {
            return py::make_tuple(steps_of(self), self.rules().core, self.is_tether());
          },
          [](const py::tuple& state) {
            return make_step_potential(state[0].cast<Steps>(), state[1].cast<double>(),
                                       state[2].cast<bool>());
          }))
      .def("__repr__", [](const StepPotential& self) { return text_of(self); });
  py::class_<StepTable>(module, "StepTable", doc::StepTable)
      .def(py::init<>())
      .def("set", &StepTable::set, py::arg("first"), py::arg("second"), py::arg("potential"),
           doc::StepTable_set)
      .def("set_for_all", &StepTable::set_for_all, py::arg("potential"), doc::StepTable_set_for_all)
      .def("add_bond", &StepTable::add_bond, py::arg("potential"), doc::StepTable_add_bond)
      .def("__len__", &StepTable::size)
      .def(
          "__getitem__",
          [](const StepTable& self, std::size_t number) {
            if (number >= self.size()) throw py::index_error();
            return self[static_cast<StepTable::Number>(number)];
          },
          py::arg("number"))
      .def(pickled<StepTable>())
      .def("__repr__", [](const StepTable& self) {
        std::string text = "<hardball.StepTable";
        for (std::size_t number = 0; number < self.size(); ++number)
          text += (number == 0 ? ": " : ", ") + text_of(self[static_cast<StepTable::Number>(number)]);
        return text + ">";
      });
  py::class_<StepAttempt>(module, "StepAttempt", doc::StepAttempt)
      .def_readonly("potential", &StepAttempt::potential, doc::StepAttempt_potential)
      .def_readonly("step", &StepAttempt::step, doc::StepAttempt_step)
      .def_readonly("is_outward", &StepAttempt::is_outward, doc::StepAttempt_is_outward)
      .def_readonly("passes", &StepAttempt::passes, doc::StepAttempt_passes)
      .def_readonly("rise", &StepAttempt::rise, doc::StepAttempt_rise)
      .def("__repr__", [](const StepAttempt& self) {
        return "<hardball.StepAttempt: step " + std::to_string(self.step) +
               (self.is_outward ? " outward, " : " inward, ") + (self.passes ? "passed" : "refused") + ">";
      });
}

}  // namespace hardball::python
