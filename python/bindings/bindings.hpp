// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

/// What each file adds to the module. Classes come before those that mention them, so that signatures in
/// docstrings name them as Python does.
namespace hardball::python {

void bind_errors(pybind11::module_& module);
void bind_processes(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_box(pybind11::module_& module);
void bind_steps(pybind11::module_& module);
void bind_responses(pybind11::module_& module);
void bind_thermostats(pybind11::module_& module);
void bind_motions(pybind11::module_& module);
void bind_measurements(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_packing(pybind11::module_& module);
void bind_robots(pybind11::module_& module);
void bind_frames(pybind11::module_& module);
void bind_commands(pybind11::module_& module);
void bind_sweep(pybind11::module_& module);

}  // namespace hardball::python
