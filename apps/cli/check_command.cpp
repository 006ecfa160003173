// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "apps/cli/commands.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/tuning/cell_edge.hpp"

namespace hardball::cli {
namespace {

std::string readable(double number) {
  return fmt::format("{:.4g}", number);
}

std::string describe(const Box& box) {
  constexpr std::array<const char*, 3> kNames{"wall", "periodic", "open"};
  std::string text;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (axis > 0) text += " x ";
    if (!box.is_open(axis)) text += to_text(box.size()[axis]) + " ";
    text += kNames[static_cast<std::size_t>(box.boundary(axis))];
  }
  return text;
}

// Contacts with walls per unit of time in a gas: a quarter of density times mean speed for each unit of area.
double wall_rate(const Box& box, const Moments& moments) {
  double faces_per_length = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_wall(axis)) faces_per_length += 2 / box.size()[axis];
  }
  return static_cast<double>(moments.spheres) * moments.mean_speed / 4 * faces_per_length;
}

}  // namespace

ExitCode check(const Options& options) {
  const Scenario scenario = read_scenario(options);
  const Simulation simulation =
      make_simulation(scenario, make_world(scenario), read_engine_options(options, scenario));
  const Moments moments = moments_of(simulation.world(), simulation.now());
  const auto spheres = static_cast<double>(moments.spheres);
  const double until = *scenario.until;
  const double edge = simulation.cell_edge();
  const auto bytes = static_cast<double>(simulation.memory_bytes());
  std::string text;
  const auto add = [&](std::string_view name, const std::string& value) { text += table_line(name, value); };
  add("scenario", scenario.name);
  add("spheres", to_text(moments.spheres));
  add("box", describe(simulation.world().box()));
  add("packing fraction", readable(moments.packing_fraction()));
  add("mean speed", readable(moments.mean_speed));
  add("mean free path", readable(moments.mean_free_path()));
  add("mean free time", readable(moments.mean_free_time()));
  add("engine", name_of(simulation.engine()));
  if (edge > 0) add("cell edge", readable(edge));
  add("memory", fmt::format("{:.4g} MB, {:.0f} bytes per sphere", bytes / 1e6, bytes / spheres));
  add("until", readable(until));
  text += "expected from the density and speed at the start:\n";
  add("  collisions", readable(spheres * until / moments.mean_free_time() / 2));
  add("  wall contacts", readable(wall_rate(simulation.world().box(), moments) * until));
  // Half the mean speed is the mean of its part along an axis.
  if (edge > 0) add("  cells entered", readable(spheres * until * 3 * moments.mean_speed / 2 / edge));
  write_output(text);
  return ExitCode::done;
}

}  // namespace hardball::cli
