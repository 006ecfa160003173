// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/forecast.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/number_or_null.hpp"
#include "apps/cli/outlook.hpp"
#include "apps/cli/response_text.hpp"
#include "apps/cli/results.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/warnings.hpp"
#include "hardball/error.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/scenario/make_surfaces.hpp"
#include "hardball/theory.hpp"
#include "hardball/tuning/cell_counts.hpp"

namespace hardball::cli {
namespace {

using Json = nlohmann::ordered_json;

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
  if (material.tangential_restitution)
    text += ", tangential restitution " + readable(*material.tangential_restitution);
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
  const bool drags =
      face.material.temperature || face.material.tangential_restitution || are_walls_rough(scenario);
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

// The mean radius of all spheres, the least and the largest [L].
struct Radii {
  double mean = 0;
  double least = 0;
  double most = 0;
};

Radii radii_of(const World& world) {
  double sum = 0;
  Radii radii{.least = world.base_radius(0), .most = world.base_radius(0)};
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const double radius = world.base_radius(slot);
    sum += radius;
    radii.least = std::min(radii.least, radius);
    radii.most = std::max(radii.most, radius);
  }
  const bool are_equal = radii.least == radii.most;
  radii.mean = are_equal ? radii.least : sum / static_cast<double>(world.size());
  return radii;
}

std::string describe(const Radii& radii) {
  if (radii.least == radii.most) return readable(radii.least);
  return readable(radii.mean) + " on average, " + readable(radii.least) + " to " + readable(radii.most);
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

// What the scenario has of the features, among others that no sample of its spheres shows.
Features features_of(const Scenario& scenario, const Outlook& outlook, const Kinds& kinds) {
  Features features = outlook.simulation.world().features() | scenario.features();
  features.add(Feature::thermostat, scenario.thermostat.has_value());
  features.add(Feature::kinematic, kinds.kinematic > 0);
  return features;
}

std::vector<std::string> names_of(Features features) {
  std::vector<std::string> names;
  for (std::size_t number = 0; number < kFeatures; ++number) {
    const auto feature = static_cast<Feature>(number);
    if (features.has(feature)) names.emplace_back(description(feature).name);
  }
  return names;
}

Json json_of(const Box& box) {
  Json json{{"boundary", Json::array()}, {"size", Json::array()}};
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    json["boundary"].push_back(name_of(box.boundary(axis)));
    json["size"].push_back(box.is_open(axis) ? Json(nullptr) : Json(box.size()[axis]));
  }
  return json;
}

std::string describe(const DrivenMotion& motion, const Scenario& scenario) {
  std::string text(motion.motion().name());
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) text += ", " + to_text(count) + " " + what + (count == 1 ? "" : "s");
  };
  add(motion.spheres().size(), "sphere");
  add(motion.surfaces().size(), "wall");
  const bool has_chords = std::isfinite(motion.chord()) && scenario.run.until;
  return has_chords ? text + ", chords of " + readable(motion.chord()) : text;
}

// The rows of the table, and their values as JSON.
class Rows {
 public:
  void add(std::string_view name, const std::string& text, std::string_view key, const Json& value) {
    rows_.push_back({std::string(name), text, "/" + std::string(key), value.dump()});
  }
  void add(std::string_view name, const std::string& text, std::string_view key) {
    add(name, text, key, text);
  }
  void add(std::string_view name, double number, std::string_view key) {
    add(name, readable(number), key, number_or_null(number));
  }
  void add_heading(std::string_view name) { rows_.push_back({std::string(name)}); }

  std::vector<TableRow> take() { return std::move(rows_); }

 private:
  std::vector<TableRow> rows_;
};

}  // namespace

std::vector<TableRow> check_rows(const CheckOptions& options) {
  const Scenario scenario = read_scenario(options.scenario);
  const Outlook outlook = look_ahead(options.engine, scenario, options.output.quiet);
  write_notes(outlook.notes, options.output.quiet);
  const Simulation& simulation = outlook.simulation;
  const GasStatistics& statistics = outlook.statistics;
  const auto spheres = static_cast<double>(statistics.spheres);
  const double until = *scenario.run.until;
  const bool has_lists = simulation.engine() == EngineKind::neighbors;
  const double length = length_of(outlook);
  const World space(statistics.box, scenario.gravity, make_surfaces(scenario, statistics.box));
  Rows rows;
  rows.add("scenario", scenario.name, "scenario");
  rows.add("spheres", to_text(statistics.spheres), "spheres", statistics.spheres);
  rows.add("box", describe(space.box()), "box", json_of(space.box()));
  const Shear& shear = space.box().shear();
  if (shear.is_present()) {
    rows.add("shear",
             "rate " + readable(shear.rate) + ", a strain of " + readable(shear.rate * until) + " in all",
             "shear_rate", shear.rate);
  }
  const Vec3& gravity = space.motion().gravity();
  if (gravity != Vec3{}) {
    rows.add("gravity", to_text(gravity.x) + ", " + to_text(gravity.y) + ", " + to_text(gravity.z), "gravity",
             {gravity.x, gravity.y, gravity.z});
  }
  const auto add_wall = [&](std::string_view name, const std::string& text) {
    rows.add(name, text, "walls/-", {{"name", name}, {"what", text}});
  };
  for (Face face = 0; face < kFaces; ++face) {
    if (space.box().has_own_properties(face))
      add_wall(kFaceNames[face], describe(space.box().face(face), scenario));
  }
  for (std::uint32_t k = 0; k < space.surfaces().size(); ++k)
    add_wall(wall_name(space, kFaces + k), describe(space.surfaces()[k]));
  for (const DrivenMotion& motion : simulation.motions()) {
    const std::string text = describe(motion, scenario);
    rows.add("motion " + motion.name(), text, "motions/-", {{"name", motion.name()}, {"what", text}});
  }
  if (const auto& growth = scenario.growth) rows.add("growth", describe(*growth), "growth");
  if (simulation.thermostat())
    rows.add("thermostat", describe(simulation.thermostat()->kind()), "thermostat");
  for (const ResponseText& text_of : response_texts(scenario))
    rows.add(text_of.who, text_of.what, "responses/-", {{"who", text_of.who}, {"what", text_of.what}});
  const Kinds kinds = kinds_of(scenario, outlook);
  if (!kinds.species.empty()) {
    Json counts = Json::object();
    for (std::size_t k = 0; k < kinds.species.size(); ++k)
      counts[scenario.species[k].name] = kinds.species[k];
    rows.add("species", species_text(scenario, kinds.species), "species", counts);
  }
  if (kinds.kinematic > 0) {
    rows.add("kinematic", to_text(kinds.kinematic) + (kinds.kinematic == 1 ? " sphere" : " spheres"),
             "kinematic", kinds.kinematic);
  }
  const Features features = features_of(scenario, outlook, kinds);
  const auto add_names = [&](std::string_view name, Features some) {
    const std::vector<std::string> names = names_of(some);
    if (!names.empty()) rows.add(name, fmt::format("{}", fmt::join(names, ", ")), name, names);
  };
  add_names("features", features);
  add_names("excluded", excluded_by(features));
  const Radii radii = radii_of(simulation.world());
  rows.add("radius", describe(radii), "radius",
           {{"mean", radii.mean}, {"least", radii.least}, {"most", radii.most}});
  rows.add(statistics.is_flat() ? "area fraction" : "packing fraction", statistics.packing_fraction(),
           "packing_fraction");
  rows.add("mean speed", statistics.mean_speed, "mean_speed");
  rows.add("mean free path", mean_free_path(statistics), "mean_free_path");
  rows.add("mean free time", mean_free_time(statistics), "mean_free_time");
  rows.add("engine", std::string(name_of(simulation.engine())), "engine");
  if (length > 0)
    rows.add(has_lists ? "skin of lists" : "cell edge", length, has_lists ? "skin" : "cell_edge");
  const double bytes = memory_bytes(outlook);
  rows.add("memory", fmt::format("{:.4g} MB, {:.0f} bytes per sphere", bytes / 1e6, bytes / spheres),
           "memory_bytes", std::round(bytes));
  rows.add("until", until, "until");
  rows.add_heading("expected from the density and speed at the start:");
  rows.add("  collisions", spheres * until / mean_free_time(statistics) / 2, "expected/collisions");
  rows.add("  wall contacts", spheres * until * wall_rate(statistics), "expected/wall_contacts");
  if (length > 0 && !has_lists) {
    const CellCounts counts = expected_counts(statistics, length);
    rows.add("  cells entered", spheres * until * counts.enter, "expected/cells_entered");
    rows.add("  pair predictions", spheres * until * counts.predictions(), "expected/pair_predictions");
  }
  const Forecast forecast = forecast_by_trial(scenario, outlook);
  rows.add("  time on one core", "about " + to_one_digit(forecast.seconds) + " s", "expected/seconds",
           number_or_null(forecast.seconds));
  const auto add_note = [&](const std::string& note) { rows.add("note", note, "notes/-"); };
  if (!forecast.failure.empty()) add_note("a trial of this run failed: " + forecast.failure);
  for (const std::string& note : outlook.notes) add_note(note);
  for (const std::string& warning : warnings_of(scenario, statistics)) add_note(warning);
  for (const std::string& warning : warnings_of_meshes(simulation.world())) add_note(warning);
  if (!outlook.is_sample) {
    for (const std::string& warning : warnings_of_motions(simulation, statistics, until)) add_note(warning);
  }
  if (scenario.has_steps())
    add_note("the numbers expected are those of hard spheres: steps of potentials add events");
  if (outlook.is_sample) {
    add_note(fmt::format(
        "too many spheres to place here: the memory is estimated from a sample of {}, and whether "
        "all fit is not checked",
        simulation.size()));
  }
  return rows.take();
}

ExitCode check(const CheckOptions& options) {
  catch_signals();
  const std::vector<TableRow> rows = check_rows(options);
  if (options.output.json) {
    Json json;
    for (const TableRow& row : rows) {
      if (!row.key.empty()) json[Json::json_pointer(row.key)] = Json::parse(row.json);
    }
    write_output(json.dump(2) + "\n");
    return ExitCode::done;
  }
  std::string text;
  for (const TableRow& row : rows)
    text += row.text.empty() ? row.name + "\n" : table_line(row.name, row.text);
  write_output(text);
  return ExitCode::done;
}

}  // namespace hardball::cli
