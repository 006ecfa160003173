// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/summary.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/cli/number_or_null.hpp"
#include "apps/cli/response_text.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/version.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/walls.hpp"

namespace hardball::cli {
namespace {

long measure_peak_rss() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr long kBytesPerUnit = 1024;  // Linux counts kilobytes
  return usage.ru_maxrss * kBytesPerUnit;
}

}  // namespace

FinalState final_state(const Scenario& scenario, const Simulation& simulation) {
  std::vector<std::size_t> species_counts = simulation.species_counts();
  species_counts.resize(scenario.species.size());
  return {.world = simulation.setting(),
          .spheres = simulation.size(),
          .now = simulation.now(),
          .counters = simulation.counters(),
          .domains = simulation.blocks().size(),
          .windows = simulation.windows(),
          .at_rest_since = {},
          .sums = simulation.sums(),
          .totals = simulation.totals(),
          .step_energy = step_energy(simulation.setting()),
          .has_spins = simulation.has_spins(),
          .audit = simulation.audit(),
          .species_counts = species_counts,
          .thermostat = simulation.thermostat(),
          .growth = simulation.growth(),
          .engine = simulation.engine(),
          .cell_edge = simulation.cell_edge(),
          .memory_bytes = simulation.memory_bytes()};
}

Summary::Summary(const Scenario& scenario, const std::vector<std::string>& overrides, const FinalState& state,
                 const Seconds& seconds, const std::vector<std::string>& notes)
    : scenario_name_(scenario.name),
      scenario_text_(scenario.text),
      overrides_(overrides),
      seed_(scenario.seed),
      spheres_(state.spheres),
      is_flat_(state.world.box().is_flat()),
      time_(state.at_rest_since ? *scenario.until : state.now.value()),
      at_rest_since_(state.at_rest_since),
      is_unsettled_(scenario.settles && !state.at_rest_since),
      counters_(state.counters),
      domains_(state.domains),
      windows_(state.windows),
      mergers_(state.sums.tally.mergers()),
      passes_(state.sums.tally.passes()),
      has_steps_(state.world.has_steps()),
      steps_passed_(state.sums.tally.steps_passed()),
      steps_refused_(state.sums.tally.steps_refused()),
      step_energy_(state.step_energy),
      hash_(state.sums.hash.value()),
      initial_energy_(state.sums.tally.initial_energy()),
      final_energy_(state.totals.energy.value()),
      momentum_(state.totals.total_momentum()),
      max_overlap_(
          std::max({state.sums.tally.max_overlap(), state.audit.max_overlap, state.audit.max_escape})),
      rotational_energy_(state.has_spins ? state.totals.rotational_energy.value() : kNoNumber),
      packing_fraction_(hardball::packing_fraction(state.world, state.totals.sphere_volume.value())),
      walls_(summarize_walls(state.world, state.sums.tally, state.now)),
      thermostat_(state.thermostat),
      growth_(state.growth),
      growth_work_(state.sums.tally.growth_work()),
      shear_(state.world.box().shear()),
      shear_work_(state.sums.tally.shear_work(state.totals.kinetic_energy.value())),
      engine_(name_of(state.engine)),
      cell_edge_(state.cell_edge > 0 ? state.cell_edge : kNoNumber),
      seconds_(seconds),
      notes_(notes),
      bytes_per_sphere_(static_cast<double>(state.memory_bytes) / static_cast<double>(spheres_)),
      peak_rss_bytes_(measure_peak_rss()) {
  for (std::size_t k = 0; k < state.species_counts.size(); ++k)
    species_.push_back({scenario.species[k].name, state.species_counts[k]});
  const Box& box = state.world.box();
  const Tally& tally = state.sums.tally;
  const bool is_bounded = !box.is_any(Boundary::open);
  // Of spheres that grow, that of the last epoch.
  compressibility_ = box.is_all(Boundary::periodic) && state.world.surfaces().empty() && !state.growth
                         ? tally.compressibility(state.now)
                         : kNoNumber;
  if (shear_.is_present()) shear_displacement_ = box.images().displacement_in_box(state.now);
  wall_pressure_ = is_bounded && box.is_any(Boundary::wall) ? tally.wall_pressure(box, state.now) : kNoNumber;
}

std::string Summary::json() const {
  nlohmann::ordered_json json;
  json["spheres"] = spheres_;
  json["time"] = time_;
  if (at_rest_since_) json["at_rest_since"] = *at_rest_since_;
  json["events"] = {{"collision", counters_.collision},
                    {"wall", counters_.wall},
                    {"enter", counters_.enter},
                    {"leave", counters_.leave},
                    {"stale", counters_.stale}};
  if (mergers_ > 0) json["events"]["merger"] = mergers_;
  if (passes_ > 0) json["events"]["pass"] = passes_;
  if (has_steps_) {
    json["events"]["step_passed"] = steps_passed_;
    json["events"]["step_refused"] = steps_refused_;
  }
  for (const SpeciesCount& species : species_) json["species"][species.name] = species.spheres;
  json["predictions"] = counters_.predictions;
  json["event_log_hash"] = hash_text(hash_);
  json["energy"] = {{"initial", initial_energy_}, {"final", final_energy_}};
  if (std::isfinite(rotational_energy_)) json["energy"]["rotational"] = rotational_energy_;
  if (has_steps_) json["energy"]["potential"] = step_energy_;
  json["momentum"] = {momentum_.x, momentum_.y, momentum_.z};
  json["max_overlap"] = max_overlap_;
  json["packing_fraction"] = number_or_null(packing_fraction_);
  json["compressibility"] = number_or_null(compressibility_);
  json["wall_pressure"] = number_or_null(wall_pressure_);
  if (!walls_.empty()) json["walls"] = nlohmann::ordered_json::array();
  for (const WallSummary& wall : walls_) {
    const Vec3& impulse = wall.tally.impulse;
    json["walls"].push_back({{"name", wall.name},
                             {"contacts", wall.tally.contacts},
                             {"impulse", {impulse.x, impulse.y, impulse.z}},
                             {"force", number_or_null(wall.force)},
                             {"pressure", number_or_null(wall.pressure)},
                             {"work", wall.tally.work},
                             {"heat", wall.tally.heat}});
  }
  if (thermostat_) {
    json["thermostat"] = {{"kind", hardball::name_of(thermostat_->kind())},
                          {"events", thermostat_->events()},
                          {"energy", thermostat_->energy()}};
  }
  if (growth_) {
    json["growth"] = {{"state", hardball::name_of(growth_->state())},
                      {"epochs", growth_->epochs()},
                      {"compressibility", number_or_null(growth_->compressibility())},
                      {"work", growth_work_},
                      {"energy", growth_->energy()}};
  }
  if (shear_.is_present()) {
    json["shear"] = {{"rate", shear_.rate},
                     {"strain", shear_.rate * time_},
                     {"work", shear_work_},
                     {"displacement", shear_displacement_}};
  }
  json["engine"] = engine_;
  json["cell_edge"] = number_or_null(cell_edge_);
  json["seconds"] = {{"setup", seconds_.setup}, {"run", seconds_.run}};
  json["collisions_per_second"] = number_or_null(static_cast<double>(counters_.collision) / seconds_.run);
  json["bytes_per_sphere"] = number_or_null(bytes_per_sphere_);
  json["peak_rss_bytes"] = peak_rss_bytes_;
  if (!notes_.empty()) json["notes"] = notes_;
  json["seed"] = seed_;
  json["version"] = version();
  json["commit"] = commit();
  json["scenario"] = {{"file", scenario_name_}, {"set", overrides_}, {"text", scenario_text_}};
  // The name of a file may contain any bytes.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string Summary::table() const {
  std::string text;
  const auto add = [&](std::string_view name, const std::string& value) { text += table_line(name, value); };
  const auto add_if_meant = [&](std::string_view name, double value) {
    if (std::isfinite(value)) add(name, fmt::format("{:.6g}", value));
  };
  add("spheres", fmt::format("{}", spheres_));
  for (const SpeciesCount& species : species_) add("  " + species.name, fmt::format("{}", species.spheres));
  add("time", fmt::format("{:.6g}", time_));
  if (at_rest_since_)
    add("  at rest since", fmt::format("{:.6g}: nothing happens after that", *at_rest_since_));
  if (is_unsettled_) add("  not at rest", "at the end: a heap that is needs a longer run");
  add("collisions", fmt::format("{}", counters_.collision));
  if (mergers_ > 0) add("  mergers", fmt::format("{}", mergers_));
  if (passes_ > 0) add("  passes", fmt::format("{}", passes_));
  if (has_steps_) add("  at steps", fmt::format("{} passed, {} refused", steps_passed_, steps_refused_));
  add("wall contacts", fmt::format("{}", counters_.wall));
  add("cells entered, left", fmt::format("{}, {}", counters_.enter, counters_.leave));
  add("stale events", fmt::format("{}", counters_.stale));
  add("pair predictions", fmt::format("{}", counters_.predictions));
  if (domains_ > 1) {
    add("domains", fmt::format("{}", domains_));
    add("windows",
        fmt::format("{}, {} failed, {} single steps", windows_.windows, windows_.failed, windows_.steps));
  }
  add("event log hash", hash_text(hash_));
  add("energy", fmt::format("{:.10g} at the start, {:.10g} at the end", initial_energy_, final_energy_));
  if (std::isfinite(rotational_energy_))
    add("  of rotation", fmt::format("{:.10g} at the end", rotational_energy_));
  if (has_steps_) add("  of potentials", fmt::format("{:.10g} at the end", step_energy_));
  add("momentum", fmt::format("{:.3g}, {:.3g}, {:.3g}", momentum_.x, momentum_.y, momentum_.z));
  add("deepest overlap", fmt::format("{:.2g} diameters", max_overlap_));
  add_if_meant(is_flat_ ? "area fraction" : "packing fraction", packing_fraction_);
  add_if_meant("PV/NkT", compressibility_);
  add_if_meant("pressure on walls", wall_pressure_);
  for (const WallSummary& wall : walls_) {
    add(wall.name, fmt::format("{} contacts, force {:.6g}, work {:.6g}, heat {:.6g}", wall.tally.contacts,
                               wall.force, wall.tally.work, wall.tally.heat));
  }
  if (thermostat_) {
    add("thermostat",
        fmt::format("{}, {} events, energy given {:.6g}", hardball::name_of(thermostat_->kind()),
                    thermostat_->events(), thermostat_->energy()));
  }
  if (growth_) {
    add("growth", fmt::format("{}, {} epochs, the last with PV/NkT = {:.6g}", name_of(growth_->state()),
                              growth_->epochs(), growth_->compressibility()));
    add("  energy",
        fmt::format("{:.6g} by growing, {:.6g} by halving velocities", growth_work_, growth_->energy()));
  }
  if (shear_.is_present())
    add("shear", fmt::format("strain {:.6g}, work {:.6g}", shear_.rate * time_, shear_work_));
  add("engine", engine_);
  add_if_meant("cell edge", cell_edge_);
  if (counters_.rebuilds > 0) add("cells rebuilt", fmt::format("{} times", counters_.rebuilds));
  add("seconds", fmt::format("{:.3g} setup, {:.3g} run", seconds_.setup, seconds_.run));
  add_if_meant("collisions per second", static_cast<double>(counters_.collision) / seconds_.run);
  add("memory", fmt::format("{:.0f} bytes per sphere, {:.1f} MB at the peak", bytes_per_sphere_,
                            static_cast<double>(peak_rss_bytes_) / 1e6));
  for (const std::string& note : notes_) add("note", note);
  return text;
}

}  // namespace hardball::cli
