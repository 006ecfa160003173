// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/cli/number_or_null.hpp"
#include "apps/cli/response_text.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/version.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/platform/program.hpp"
#include "hardball/simulation.hpp"
#include "hardball/theory.hpp"
#include "hardball/world.hpp"

namespace hardball::cli {
namespace {

// Summaries of measured_walls from the tally at `now`. The world may be without spheres.
std::vector<WallSummary> summarize_walls(const Scenario& scenario, const World& world, const Tally& tally,
                                         const Time& now) {
  std::vector<WallSummary> walls;
  const double elapsed = tally.elapsed(now);
  for (const std::uint32_t wall : measured_walls(world)) {
    const bool is_surface = wall >= kFaces;
    const std::string shape = is_surface ? std::string(world.surface(wall).name()) : "face";
    const Vec3 offset = is_surface && wall - kFaces < scenario.surfaces.size()
                            ? scenario.surfaces[wall - kFaces].torque_offset
                            : Vec3{};
    const auto summarize = [&](const std::string& name, const WallTally& of_it, double area) {
      WallSummary summary{.name = name, .shape = shape, .tally = of_it, .area = area};
      summary.force = of_it.normal_impulse / elapsed;
      summary.pressure = std::isfinite(area) ? summary.force / area : kNoNumber;
      if (is_surface) summary.torque = (1 / elapsed) * (of_it.angular_impulse - cross(offset, of_it.impulse));
      return summary;
    };
    walls.push_back(summarize(wall_name(world, wall), tally.wall(wall), wall_area(world, wall)));
    const std::vector<std::string> names = group_names(world, wall);
    const std::vector<double> areas = group_areas(world, wall);
    for (std::size_t group = 0; group < names.size(); ++group) {
      if (names[group].empty()) continue;
      walls.back().groups.push_back(summarize(names[group], tally.wall(wall, group), areas[group]));
    }
  }
  return walls;
}

nlohmann::ordered_json to_json(const WallSummary& wall) {
  const Vec3& impulse = wall.tally.impulse;
  nlohmann::ordered_json json{{"name", wall.name},
                              {"contacts", wall.tally.contacts},
                              {"impulse", {impulse.x, impulse.y, impulse.z}},
                              {"force", number_or_null(wall.force)},
                              {"pressure", number_or_null(wall.pressure)},
                              {"work", wall.tally.work},
                              {"heat", wall.tally.heat}};
  if (wall.torque) {
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      json["torque"].push_back(number_or_null((*wall.torque)[axis]));
  }
  for (const WallSummary& group : wall.groups) json["groups"].push_back(to_json(group));
  return json;
}

}  // namespace

FinalState final_state(const Scenario& scenario, const Simulation& simulation) {
  const World& world = simulation.setting();
  const Box& box = world.box();
  FinalState state{.spheres = simulation.size(),
                   .box = box,
                   .now = simulation.now(),
                   .counters = simulation.counters(),
                   .domains = simulation.blocks().size(),
                   .windows = simulation.windows(),
                   .sums = simulation.sums(),
                   .totals = simulation.totals(),
                   .has_steps = world.has_steps(),
                   .step_energy = step_energy(world),
                   .species_counts = simulation.species_counts(),
                   .thermostat = simulation.thermostat(),
                   .growth = simulation.growth(),
                   .engine = simulation.engine(),
                   .peak_rss_bytes = platform::peak_memory()};
  const auto if_meant = [](bool is_meant, double number) { return is_meant ? number : kNoNumber; };
  const Tally& tally = state.sums.tally;
  const Audit audit = simulation.audit();
  state.max_overlap = std::max({tally.max_overlap(), audit.max_overlap, audit.max_escape});
  state.rotational_energy = if_meant(simulation.has_spins(), state.totals.rotational_energy.value());
  state.packing_fraction = packing_fraction(world, state.totals.sphere_volume.value());
  // Of spheres that grow, that of the last epoch.
  const bool is_periodic = box.is_all(Boundary::periodic) && world.surfaces().empty();
  state.compressibility = is_periodic && !state.growth ? tally.compressibility(state.now) : kNoNumber;
  const bool has_walls = box.is_any(Boundary::wall) && !box.is_any(Boundary::open);
  state.wall_pressure = has_walls ? tally.wall_pressure(box, state.now) : kNoNumber;
  state.cell_edge = if_meant(simulation.cell_edge() > 0, simulation.cell_edge());
  state.walls = summarize_walls(scenario, world, tally, state.now);
  for (const DrivenMotion& motion : simulation.motions()) {
    state.motions.push_back({motion.name(), std::string(motion.motion().name()), motion.spheres().size(),
                             motion.surfaces().size(), simulation.work_of(motion), motion.stopped_at()});
  }
  state.species_counts.resize(scenario.species.size());
  state.bytes_per_sphere =
      static_cast<double>(simulation.memory_bytes()) / static_cast<double>(state.spheres);
  return state;
}

std::string Summary::json() const {
  const Tally& tally = state.sums.tally;
  const Vec3 momentum = state.totals.total_momentum();
  const Shear& shear = state.box.shear();
  nlohmann::ordered_json json;
  json["spheres"] = state.spheres;
  json["time"] = end_time();
  if (state.at_rest_since) json["at_rest_since"] = *state.at_rest_since;
  if (state.errors_reached_at) json["errors_reached_at"] = *state.errors_reached_at;
  json["events"] = {{"collision", state.counters.collision},
                    {"wall", state.counters.wall},
                    {"enter", state.counters.enter},
                    {"leave", state.counters.leave},
                    {"stale", state.counters.stale}};
  if (tally.mergers() > 0) json["events"]["merger"] = tally.mergers();
  if (tally.passes() > 0) json["events"]["pass"] = tally.passes();
  if (state.has_steps) {
    json["events"]["step_passed"] = tally.steps_passed();
    json["events"]["step_refused"] = tally.steps_refused();
  }
  for (std::size_t k = 0; k < state.species_counts.size(); ++k)
    json["species"][scenario.species[k].name] = state.species_counts[k];
  json["predictions"] = state.counters.predictions;
  json["event_log_hash"] = hash_text(state.sums.hash.value());
  json["energy"] = {{"initial", tally.initial_energy()}, {"final", state.totals.energy.value()}};
  if (std::isfinite(state.rotational_energy)) json["energy"]["rotational"] = state.rotational_energy;
  if (state.has_steps) json["energy"]["potential"] = state.step_energy;
  json["momentum"] = {momentum.x, momentum.y, momentum.z};
  json["max_overlap"] = state.max_overlap;
  json["packing_fraction"] = number_or_null(state.packing_fraction);
  json["compressibility"] = number_or_null(state.compressibility);
  json["wall_pressure"] = number_or_null(state.wall_pressure);
  if (!state.walls.empty()) json["walls"] = nlohmann::ordered_json::array();
  for (const WallSummary& wall : state.walls) json["walls"].push_back(to_json(wall));
  for (const MotionSummary& motion : state.motions) {
    json["motions"].push_back({{"name", motion.name},
                               {"kind", motion.kind},
                               {"spheres", motion.spheres},
                               {"walls", motion.walls},
                               {"work", motion.work}});
    if (motion.stopped_at) json["motions"].back()["stopped_at"] = *motion.stopped_at;
  }
  if (state.thermostat) {
    json["thermostat"] = {{"kind", hardball::name_of(state.thermostat->kind())},
                          {"events", state.thermostat->events()},
                          {"energy", state.thermostat->energy()}};
  }
  if (state.growth) {
    json["growth"] = {{"state", hardball::name_of(state.growth->state())},
                      {"epochs", state.growth->epochs()},
                      {"compressibility", number_or_null(state.growth->compressibility())},
                      {"work", tally.growth_work()},
                      {"energy", state.growth->energy()}};
  }
  if (shear.is_present()) {
    json["shear"] = {{"rate", shear.rate},
                     {"strain", shear.rate * end_time()},
                     {"work", tally.shear_work(state.totals.kinetic_energy.value())},
                     {"displacement", state.box.images().displacement_in_box(state.now)}};
  }
  json["engine"] = name_of(state.engine);
  json["cell_edge"] = number_or_null(state.cell_edge);
  json["seconds"] = {{"setup", seconds.setup}, {"run", seconds.run}};
  json["collisions_per_second"] = number_or_null(collisions_per_second());
  json["bytes_per_sphere"] = number_or_null(state.bytes_per_sphere);
  json["peak_rss_bytes"] = state.peak_rss_bytes;
  if (!notes.empty()) json["notes"] = notes;
  json["seed"] = scenario.run.seed;
  json["version"] = version();
  json["commit"] = commit();
  json["scenario"] = {{"file", scenario.name}, {"set", overrides}, {"text", scenario.text}};
  // The name of a file may contain any bytes.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string Summary::table() const {
  const Tally& tally = state.sums.tally;
  const Vec3 momentum = state.totals.total_momentum();
  const Shear& shear = state.box.shear();
  std::string text;
  const auto add = [&](std::string_view name, const std::string& value) { text += table_line(name, value); };
  const auto add_if_meant = [&](std::string_view name, double value) {
    if (std::isfinite(value)) add(name, fmt::format("{:.6g}", value));
  };
  add("spheres", fmt::format("{}", state.spheres));
  for (std::size_t k = 0; k < state.species_counts.size(); ++k)
    add("  " + scenario.species[k].name, fmt::format("{}", state.species_counts[k]));
  add("time", fmt::format("{:.6g}", end_time()));
  if (state.at_rest_since)
    add("  at rest since", fmt::format("{:.6g}: nothing happens after that", *state.at_rest_since));
  if (state.errors_reached_at) add("  errors", "as small as until_error wants");
  if (scenario.settles && !state.at_rest_since)
    add("  not at rest", "at the end: a heap that is needs a longer run");
  add("collisions", fmt::format("{}", state.counters.collision));
  if (tally.mergers() > 0) add("  mergers", fmt::format("{}", tally.mergers()));
  if (tally.passes() > 0) add("  passes", fmt::format("{}", tally.passes()));
  if (state.has_steps)
    add("  at steps", fmt::format("{} passed, {} refused", tally.steps_passed(), tally.steps_refused()));
  add("wall contacts", fmt::format("{}", state.counters.wall));
  add("cells entered, left", fmt::format("{}, {}", state.counters.enter, state.counters.leave));
  add("stale events", fmt::format("{}", state.counters.stale));
  add("pair predictions", fmt::format("{}", state.counters.predictions));
  if (state.domains > 1) {
    add("domains", fmt::format("{}", state.domains));
    add("windows", fmt::format("{}, {} failed, {} single steps", state.windows.windows, state.windows.failed,
                               state.windows.steps));
  }
  add("event log hash", hash_text(state.sums.hash.value()));
  add("energy", fmt::format("{:.10g} at the start, {:.10g} at the end", tally.initial_energy(),
                            state.totals.energy.value()));
  if (std::isfinite(state.rotational_energy))
    add("  of rotation", fmt::format("{:.10g} at the end", state.rotational_energy));
  if (state.has_steps) add("  of potentials", fmt::format("{:.10g} at the end", state.step_energy));
  add("momentum", fmt::format("{:.3g}, {:.3g}, {:.3g}", momentum.x, momentum.y, momentum.z));
  add("deepest overlap", fmt::format("{:.2g} diameters", state.max_overlap));
  add_if_meant(state.box.is_flat() ? "area fraction" : "packing fraction", state.packing_fraction);
  add_if_meant("PV/NkT", state.compressibility);
  add_if_meant("pressure on walls", state.wall_pressure);
  const auto add_wall = [&](const std::string& name, const WallSummary& wall) {
    add(name, fmt::format("{} contacts, force {:.6g}, work {:.6g}, heat {:.6g}", wall.tally.contacts,
                          wall.force, wall.tally.work, wall.tally.heat));
  };
  for (const WallSummary& wall : state.walls) {
    add_wall(wall.name, wall);
    for (const WallSummary& group : wall.groups) add_wall("  " + group.name, group);
  }
  for (const MotionSummary& motion : state.motions)
    add("motion " + motion.name,
        fmt::format("{}, work {:.6g}{}", motion.kind, motion.work,
                    motion.stopped_at ? fmt::format(", stopped at time {:.6g}", *motion.stopped_at) : ""));
  if (state.thermostat) {
    add("thermostat",
        fmt::format("{}, {} events, energy given {:.6g}", hardball::name_of(state.thermostat->kind()),
                    state.thermostat->events(), state.thermostat->energy()));
  }
  if (state.growth) {
    add("growth", fmt::format("{}, {} epochs, the last with PV/NkT = {:.6g}", name_of(state.growth->state()),
                              state.growth->epochs(), state.growth->compressibility()));
    add("  energy", fmt::format("{:.6g} by growing, {:.6g} by halving velocities", tally.growth_work(),
                                state.growth->energy()));
  }
  if (shear.is_present())
    add("shear", fmt::format("strain {:.6g}, work {:.6g}", shear.rate * end_time(),
                             tally.shear_work(state.totals.kinetic_energy.value())));
  add("engine", std::string(name_of(state.engine)));
  add_if_meant("cell edge", state.cell_edge);
  if (state.counters.rebuilds > 0) add("cells rebuilt", fmt::format("{} times", state.counters.rebuilds));
  add("seconds", fmt::format("{:.3g} setup, {:.3g} run", seconds.setup, seconds.run));
  add_if_meant("collisions per second", collisions_per_second());
  add("memory", fmt::format("{:.0f} bytes per sphere, {:.1f} MB at the peak", state.bytes_per_sphere,
                            static_cast<double>(state.peak_rss_bytes) / 1e6));
  for (const std::string& note : notes) add("note", note);
  return text;
}

}  // namespace hardball::cli
