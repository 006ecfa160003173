// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/wall_summary.hpp"

#include <cmath>
#include <limits>

#include "hardball/measure/wall_forces.hpp"

namespace hardball::cli {

std::vector<WallSummary> summarize_walls(const World& world, const Tally& tally, const Time& now) {
  std::vector<WallSummary> walls;
  const double elapsed = tally.elapsed(now);
  for (const std::uint32_t wall : measured_walls(world)) {
    WallSummary summary;
    summary.name = wall_name(world, wall);
    summary.shape = wall < kFaces ? "face" : std::string(world.surface(wall).name());
    summary.tally = tally.wall(wall);
    summary.area = wall_area(world, wall);
    summary.force = summary.tally.normal_impulse / elapsed;
    summary.pressure =
        std::isfinite(summary.area) ? summary.force / summary.area : std::numeric_limits<double>::quiet_NaN();
    walls.push_back(summary);
  }
  return walls;
}

}  // namespace hardball::cli
