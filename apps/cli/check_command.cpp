// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/response_text.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/kinetic_theory.hpp"

namespace hardball::cli {
namespace {

std::string readable(double number) {
  return fmt::format("{:.4g}", number);
}

std::string describe(const Box& box) {
  constexpr std::array<const char*, 3> kNames{"wall", "periodic", "open"};
  std::string text;
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    if (axis > 0) text += " x ";
    if (!box.is_open(axis)) text += to_text(box.size()[axis]) + " ";
    text += kNames[static_cast<std::size_t>(box.boundary(axis))];
  }
  if (box.is_flat()) text += ", two dimensions";
  return text;
}

std::string describe(const Vec3& vector) {
  return "(" + readable(vector.x) + ", " + readable(vector.y) + ", " + readable(vector.z) + ")";
}

std::string describe(const SurfaceMaterial& material) {
  std::string text;
  if (material.restitution) text += ", restitution " + readable(*material.restitution);
  if (material.temperature) text += ", thermal at kT = " + readable(*material.temperature);
  return text;
}

// Whether walls change the spins of spheres.
bool are_walls_rough(const Scenario& scenario) {
  constexpr double kSmooth = -1;
  const auto is_rough = [](const BounceRules& rules) {
    return rules.tangential_restitution && *rules.tangential_restitution != kSmooth;
  };
  return is_rough(scenario.bounce) || std::ranges::any_of(scenario.pairs, [&](const PairDescription& pair) {
           return !pair.second && is_rough(pair.bounce);
         });
}

std::string describe(const FaceProperties& face, const Scenario& scenario) {
  std::string text = "face" + describe(face.material);
  if (face.velocity == Vec3{}) return text;
  text += ", moving with " + describe(face.velocity);
  const bool drags = face.material.temperature || are_walls_rough(scenario);
  return text + (drags ? "" : ", which does nothing: it is not thermal, and the spheres are smooth");
}

std::string describe(const Surface& surface) {
  std::string text = "at " + describe(surface.point());
  std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.normal(); }) text += ", normal " + describe(shape.normal());
        if constexpr (requires { shape.axis(); }) text += ", axis " + describe(shape.axis());
        if constexpr (requires { shape.radius(); }) text += ", radius " + readable(shape.radius());
        if constexpr (requires { shape.amplitude(); }) {
          text += ", amplitude " + readable(shape.amplitude()) + ", frequency " + readable(shape.frequency());
        }
      },
      surface.shape());
  if (surface.velocity() != Vec3{}) text += ", moving with " + describe(surface.velocity());
  return text + describe(surface.material());
}

std::string describe(const ThermostatKind& kind) {
  std::string text(hardball::name_of(kind));
  std::visit(
      [&](const auto& its) {
        if constexpr (requires { its.temperature(); }) text += ", kT = " + readable(its.temperature());
        if constexpr (requires { its.rate(); }) text += ", rate " + readable(its.rate());
        if constexpr (requires { its.strength(); }) text += ", strength " + readable(its.strength());
        if constexpr (requires { its.every(); }) text += ", every " + readable(its.every());
      },
      kind);
  return text;
}

// The radius of all spheres, or the mean, the least and the largest.
std::string describe_radii(const World& world) {
  double sum = 0;
  double least = world.radius(0);
  double most = least;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const double radius = world.radius(slot);
    sum += radius;
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  if (least == most) return readable(least);
  return readable(sum / static_cast<double>(world.size())) + " on average, " + readable(least) + " to " +
         readable(most);
}

std::size_t kinematic_count(const World& world) {
  std::size_t count = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) count += world.is_kinematic(slot) ? 1U : 0U;
  return count;
}

}  // namespace

ExitCode check(const Options& options) {
  catch_signals();
  const Scenario scenario = read_scenario(options);
  const Simulation simulation = set_up(options, scenario).simulation;
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
  const Vec3& gravity = simulation.world().motion().gravity();
  if (gravity != Vec3{}) {
    add("gravity", to_text(gravity.x) + ", " + to_text(gravity.y) + ", " + to_text(gravity.z));
  }
  for (Face face = 0; face < kFaces; ++face) {
    const Box& box = simulation.world().box();
    if (box.has_own_properties(face)) add(kFaceNames[face], describe(box.face(face), scenario));
  }
  for (std::uint32_t k = 0; k < simulation.world().surfaces().size(); ++k) {
    add(wall_name(simulation.world(), kFaces + k), describe(simulation.world().surfaces()[k]));
  }
  if (simulation.thermostat()) add("thermostat", describe(simulation.thermostat()->kind()));
  for (const ResponseText& text_of : response_texts(scenario)) add(text_of.who, text_of.what);
  const std::string species = species_text(scenario, simulation.world());
  if (!species.empty()) add("species", species);
  const std::size_t kinematic = kinematic_count(simulation.world());
  if (kinematic > 0) add("kinematic", to_text(kinematic) + (kinematic == 1 ? " sphere" : " spheres"));
  add("radius", describe_radii(simulation.world()));
  add(simulation.world().box().is_flat() ? "area fraction" : "packing fraction",
      readable(moments.packing_fraction()));
  add("mean speed", readable(moments.mean_speed));
  add("mean free path", readable(mean_free_path(moments)));
  add("mean free time", readable(mean_free_time(moments)));
  add("engine", name_of(simulation.engine()));
  if (edge > 0) add("cell edge", readable(edge));
  if (simulation.slack() > 0) add("slack of lists", readable(simulation.slack()));
  add("memory", fmt::format("{:.4g} MB, {:.0f} bytes per sphere", bytes / 1e6, bytes / spheres));
  add("until", readable(until));
  text += "expected from the density and speed at the start:\n";
  add("  collisions", readable(spheres * until / mean_free_time(moments) / 2));
  add("  wall contacts", readable(spheres * until * wall_rate(moments)));
  if (edge > 0) {
    const CellCounts counts = expected_counts(moments, edge);
    add("  cells entered", readable(spheres * until * counts.enter));
    add("  pair predictions", readable(spheres * until * counts.predictions()));
  }
  write_output(text);
  return ExitCode::done;
}

}  // namespace hardball::cli
