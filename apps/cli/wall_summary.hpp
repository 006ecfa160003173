// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "hardball/simulation.hpp"

namespace hardball::cli {

/// What spheres did at one wall, and it to them, over a run; NaN where it does not apply.
struct WallSummary {
  std::string name;   ///< As wall_name says.
  std::string shape;  ///< "face", "plane", "cylinder", "sphere" or "obstacle".
  WallTally tally;
  double area = 0;      ///< [L^2]
  double force = 0;     ///< Mean along the normal [M L T^-2].
  double pressure = 0;  ///< [M L^-1 T^-2]
};

/// Summaries of measured_walls from the tally at `now`. The world may be without spheres.
std::vector<WallSummary> summarize_walls(const World& world, const Tally& tally, const Time& now);

}  // namespace hardball::cli
