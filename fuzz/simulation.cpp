// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include "fuzz/target.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  Simulation simulation = Simulation::load(bytes);
  Measures none({.names = {}});
  run_saved(simulation, none);
}
