// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"

/// Readers of what anybody may have written, for libFuzzer (./dev fuzz) and for the tests, which feed them
/// what is kept in corpus/. A target is one file, which defines `read`, and the folder of its name in
/// corpus/.
namespace hardball::fuzz {

/// Reads the bytes as the program would, and makes use of what they say. It returns, or throws an Error or a
/// RunFailure; anything else is a fault.
void read(std::string_view bytes);

/// More spheres are not simulated: to take long is no fault.
inline constexpr std::size_t kMaxSpheres = 200;

/// Runs a simulation for a few steps.
inline void run_a_little(Simulation& simulation) {
  if (simulation.size() <= kMaxSpheres) simulation.run({.steps = 300});
}

/// Runs a simulation from a saved state for a few steps, and calls everything that reads the state of the
/// measures. If no run reaches that state, it is enough that an error says so.
inline void run_saved(Simulation& simulation, Measures& measures) {
  if (simulation.size() > kMaxSpheres) return;
  try {
    simulation.run({.steps = 100}, measures);
    measures.sample_the_rest(simulation.world(), simulation.now());
    measures.results(simulation.world(), simulation.now());
  } catch (const BrokenInvariant&) {
  }
}

}  // namespace hardball::fuzz
