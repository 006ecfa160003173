// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "python/bindings/python_simulation.hpp"

namespace hardball::python {

using SimulationClass = pybind11::class_<PythonSimulation>;

/// The classes of what queries answer.
void bind_answers(pybind11::module_& module);

/// The parts of the class, each with what it needs.
void bind_state(SimulationClass& simulation);
void bind_queries(SimulationClass& simulation);
void bind_edits(SimulationClass& simulation);
void bind_driving(SimulationClass& simulation);
void bind_saving(SimulationClass& simulation);
void bind_replay(SimulationClass& simulation);
void bind_output(SimulationClass& simulation);

}  // namespace hardball::python
