// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// The names of all measures, in the order of their results.
HARDBALL_EXPORT std::span<const std::string_view> measure_names();

/// What to measure in a run, and when.
struct MeasureSettings {
  /// Some of measure_names(); "all" means all but those of transport: "diffusion", "viscosity",
  /// "bulk_viscosity", "thermal_conductivity" and "mutual_diffusion".
  std::vector<std::string> names = {"all"};
  /// The time between samples [T]; if absent, each measure has its own, see SamplingSchedule.
  std::optional<double> every = {};
  /// When measuring starts [T].
  double from = 0;
  /// Whether spheres are placed for the start, on a lattice or at random, rather than taken from an
  /// equilibrium. Of a fluid, means then begin when the spheres have left their places.
  bool is_start_placed = false;
  /// Whether the energy of the start is drawn at random: that of random places in potentials of steps or
  /// under gravity, or of random spins. Errors then say how far runs with other random numbers are.
  bool is_energy_random = false;
  static void persist(auto& archive, auto& self) {
    archive(self.names, self.every, self.from, self.is_start_placed, self.is_energy_random);
  }
};

}  // namespace hardball
