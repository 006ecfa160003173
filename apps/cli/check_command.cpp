// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/outlook.hpp"
#include "apps/cli/response_text.hpp"
#include "apps/cli/results.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/trial.hpp"
#include "apps/cli/warnings.hpp"
#include "hardball/error.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/scenario/make_surfaces.hpp"
#include "hardball/theory.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"

namespace hardball::cli {
namespace {

std::string readable(double number) {
  return fmt::format("{:.4g}", number);
}

// 20 rather than 2e+01.
std::string to_one_digit(double number) {
  return to_text(std::stod(fmt::format("{:.1g}", number)));
}

std::string describe(const Box& box) {
  std::string text;
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    if (axis > 0) text += " x ";
    if (!box.is_open(axis)) text += to_text(box.size()[axis]) + " ";
    text += name_of(box.boundary(axis));
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

// The values by which an object is described: ", axis (0, 0, 1), radius 2".
std::string values_of(const auto& object) {
  std::string text;
  for_each_value(object, [&]<class Value>(const auto& field, const Value& value) {
    if constexpr (std::is_same_v<Value, Vec3>)
      text += ", " + std::string(field.name) + " " + describe(value);
    else if (field.is_required || value != 0)
      text += ", " + std::string(field.name) + " " + readable(static_cast<double>(value));
  });
  return text;
}

std::string describe(const Surface& surface) {
  std::string text = "at " + describe(surface.point());
  text += std::visit([](const auto& shape) { return values_of(shape); }, surface.shape());
  if (surface.velocity() != Vec3{}) text += ", moving with " + describe(surface.velocity());
  return text + describe(surface.material());
}

std::string describe(const GrowthRules& rules) {
  std::string text = "rate " + readable(rules.rate);
  if (std::isfinite(rules.until_packing_fraction))
    text += ", to the packing fraction " + readable(rules.until_packing_fraction);
  if (std::isfinite(rules.until_compressibility))
    text += ", to PV/NkT = " + readable(rules.until_compressibility);
  return text;
}

std::string describe(const ThermostatKind& kind) {
  return std::string(hardball::name_of(kind)) +
         std::visit([](const auto& its) { return values_of(its); }, kind);
}

// The radius of all spheres, or the mean, the least and the largest.
std::string describe_radii(const World& world) {
  double sum = 0;
  double least = world.base_radius(0);
  double most = least;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const double radius = world.base_radius(slot);
    sum += radius;
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  if (least == most) return readable(least);
  return readable(sum / static_cast<double>(world.size())) + " on average, " + readable(least) + " to " +
         readable(most);
}

// How many spheres of each species there are, and how many of infinite mass.
struct Kinds {
  std::vector<std::size_t> species;
  std::size_t kinematic = 0;
};

Kinds kinds_of(const Scenario& scenario, const Outlook& outlook) {
  const World& world = outlook.simulation.world();
  Kinds kinds;
  if (outlook.is_sample) {
    kinds.species.resize(scenario.species.size());
    for (const SphereGroup& group : scenario.spheres) {
      if (!kinds.species.empty()) kinds.species[group.species] += group.count;
      if (group.is_kinematic) kinds.kinematic += group.count;
    }
    return kinds;
  }
  kinds.species = species_counts(scenario, world);
  for (Slot slot = 0; slot < world.size(); ++slot) kinds.kinematic += world.is_kinematic(slot) ? 1U : 0U;
  return kinds;
}

// The cost of a run of a gas whose spheres were not placed [s].
double seconds_by_theory(const Outlook& outlook, double until, double length) {
  const GasStatistics& statistics = outlook.statistics;
  const UnitCosts& costs = outlook.options.unit_costs;
  constexpr double kNanosecond = 1e-9;
  const double rate =
      outlook.simulation.engine() == EngineKind::neighbors
          ? cost_rate(expected_neighbor_counts(statistics, length), costs)
          : cost_rate(expected_counts(statistics, length), costs_with_memory(statistics, costs));
  return kNanosecond * static_cast<double>(statistics.spheres) * until * rate;
}

// What the scenario has of the features, among others that no sample of its spheres shows.
Features features_of(const Scenario& scenario, const Outlook& outlook, const Kinds& kinds) {
  Features features = outlook.simulation.world().features() | scenario.features();
  features.add(Feature::thermostat, scenario.thermostat.has_value());
  features.add(Feature::kinematic, kinds.kinematic > 0);
  return features;
}

// "gravity, thermal walls".
std::string names_of(Features features) {
  std::string names;
  for (std::size_t number = 0; number < kFeatures; ++number) {
    const auto feature = static_cast<Feature>(number);
    if (features.has(feature)) names += (names.empty() ? "" : ", ") + std::string(description(feature).name);
  }
  return names;
}

// The edge of the cells, or the skin of lists; zero if the engine has neither.
double length_of(const Outlook& outlook) {
  const Simulation& simulation = outlook.simulation;
  const EngineOptions& options = outlook.options;
  if (!outlook.is_sample || simulation.engine() == EngineKind::all_pairs) {
    return simulation.engine() == EngineKind::neighbors ? simulation.skin() : simulation.cell_edge();
  }
  if (simulation.engine() == EngineKind::neighbors)
    return optimal_skin(outlook.statistics, options.unit_costs);
  return options.cell_edge.value_or(optimal_cell_edge(outlook.statistics, options.unit_costs));
}

}  // namespace

std::vector<TableRow> check_rows(const CheckOptions& options) {
  const Scenario scenario = read_scenario(options.scenario);
  const Outlook outlook = look_ahead(options.engine, scenario, options.quiet);
  write_notes(outlook.notes, options.quiet);
  const Simulation& simulation = outlook.simulation;
  const GasStatistics& statistics = outlook.statistics;
  const auto spheres = static_cast<double>(statistics.spheres);
  const double until = *scenario.run.until;
  const bool has_lists = simulation.engine() == EngineKind::neighbors;
  const double length = length_of(outlook);
  const double bytes_per_sphere =
      static_cast<double>(simulation.memory_bytes()) / static_cast<double>(simulation.size());
  const World space(statistics.box, scenario.gravity, make_surfaces(scenario, statistics.box));
  std::vector<TableRow> rows;
  const auto add = [&](std::string_view name, const std::string& value) {
    rows.push_back({std::string(name), value});
  };
  add("scenario", scenario.name);
  add("spheres", to_text(statistics.spheres));
  add("box", describe(space.box()));
  const Shear& shear = space.box().shear();
  if (shear.is_present()) {
    add("shear",
        "rate " + readable(shear.rate) + ", a strain of " + readable(shear.rate * until) + " in all");
  }
  const Vec3& gravity = space.motion().gravity();
  if (gravity != Vec3{}) {
    add("gravity", to_text(gravity.x) + ", " + to_text(gravity.y) + ", " + to_text(gravity.z));
  }
  for (Face face = 0; face < kFaces; ++face) {
    if (space.box().has_own_properties(face))
      add(kFaceNames[face], describe(space.box().face(face), scenario));
  }
  for (std::uint32_t k = 0; k < space.surfaces().size(); ++k) {
    add(wall_name(space, kFaces + k), describe(space.surfaces()[k]));
  }
  if (const auto& growth = scenario.growth) add("growth", describe(*growth));
  if (simulation.thermostat()) add("thermostat", describe(simulation.thermostat()->kind()));
  for (const ResponseText& text_of : response_texts(scenario)) add(text_of.who, text_of.what);
  const Kinds kinds = kinds_of(scenario, outlook);
  if (!kinds.species.empty()) add("species", species_text(scenario, kinds.species));
  if (kinds.kinematic > 0) {
    add("kinematic", to_text(kinds.kinematic) + (kinds.kinematic == 1 ? " sphere" : " spheres"));
  }
  const Features features = features_of(scenario, outlook, kinds);
  if (!features.is_empty()) add("features", names_of(features));
  const Features excluded = excluded_by(features);
  if (!excluded.is_empty()) add("excluded", names_of(excluded));
  add("radius", describe_radii(simulation.world()));
  add(statistics.is_flat() ? "area fraction" : "packing fraction", readable(statistics.packing_fraction()));
  add("mean speed", readable(statistics.mean_speed));
  add("mean free path", readable(mean_free_path(statistics)));
  add("mean free time", readable(mean_free_time(statistics)));
  add("engine", std::string(name_of(simulation.engine())));
  if (length > 0) add(has_lists ? "skin of lists" : "cell edge", readable(length));
  add("memory",
      fmt::format("{:.4g} MB, {:.0f} bytes per sphere", bytes_per_sphere * spheres / 1e6, bytes_per_sphere));
  add("until", readable(until));
  add("expected from the density and speed at the start:", "");
  add("  collisions", readable(spheres * until / mean_free_time(statistics) / 2));
  add("  wall contacts", readable(spheres * until * wall_rate(statistics)));
  if (length > 0 && !has_lists) {
    const CellCounts counts = expected_counts(statistics, length);
    add("  cells entered", readable(spheres * until * counts.enter));
    add("  pair predictions", readable(spheres * until * counts.predictions()));
  }
  if (outlook.is_sample) {
    add("  time on one core", "about " + to_one_digit(seconds_by_theory(outlook, until, length)) + " s");
  } else {
    const Trial trial = try_out(scenario, outlook);
    add("  time on one core", "about " + to_one_digit(expected_seconds(scenario, outlook, trial)) + " s");
    if (!trial.failure.empty()) add("note", "a trial of this run failed: " + trial.failure);
  }
  for (const std::string& note : outlook.notes) add("note", note);
  for (const std::string& warning : warnings_of(scenario, statistics)) add("note", warning);
  if (scenario.has_steps())
    add("note", "the numbers expected are those of hard spheres: steps of potentials add events");
  if (outlook.is_sample) {
    add("note",
        fmt::format(
            "too many spheres to place here: the memory is estimated from a sample of {}, and whether "
            "all fit is not checked",
            simulation.size()));
  }
  return rows;
}

ExitCode check(const CheckOptions& options) {
  catch_signals();
  std::string text;
  for (const auto& [name, value] : check_rows(options))
    text += value.empty() ? name + "\n" : table_line(name, value);
  write_output(text);
  return ExitCode::done;
}

}  // namespace hardball::cli
