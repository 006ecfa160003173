// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/bindings.hpp"

PYBIND11_MODULE(_hardball, module) {
  using namespace hardball::python;
  module.doc() = "The part of the package hardball that is written in C++; import hardball instead.";
  module.attr("__version__") = HARDBALL_VERSION;
  bind_errors(module);
  bind_processes(module);
  bind_meshes(module);
  bind_box(module);
  bind_steps(module);
  bind_responses(module);
  bind_thermostats(module);
  bind_motions(module);
  bind_measurements(module);
  bind_simulation(module);
  bind_packing(module);
  bind_robots(module);
  bind_frames(module);
  bind_commands(module);
  bind_sweep(module);
}
