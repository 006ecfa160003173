// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>

#include "apps/cli/response_text.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/version.hpp"
#include "hardball/measure/units.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/theory.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/world.hpp"

namespace hardball::cli {
namespace {

std::string date_now() {
  using namespace std::chrono;
  const system_clock::time_point now = system_clock::now();
  const sys_days day = floor<days>(now);
  const year_month_day date(day);
  const hh_mm_ss time(floor<minutes>(now - day));
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02} UTC", int{date.year()}, unsigned{date.month()},
                     unsigned{date.day()}, time.hours().count(), time.minutes().count());
}

std::vector<std::string> changes(const ScenarioChoice& choice) {
  std::vector<std::string> all;
  for (const std::string& change : choice.overrides) all.push_back("--set " + change);
  if (choice.until) all.push_back("--until " + *choice.until);
  if (choice.seed) all.push_back("--seed " + *choice.seed);
  return all;
}

// --- rates and kinetic theory ---

// Whether the theory of fluids in equilibrium applies: many elastic spheres, enclosed, below the freezing
// density.
bool has_theory(const World& world, const GasStatistics& statistics) {
  constexpr std::size_t kFewSpheres = 100;
  const Box& box = statistics.box;
  const double freezing = box.is_flat() ? FluidTheory::kFreezingOfDiscs : FluidTheory::kFreezing;
  return world.interactions().are_elastic() && statistics.spheres >= kFewSpheres &&
         statistics.packing_fraction() <= freezing && !box.is_any(Boundary::open);
}

bool has_one_mass(const SpeciesList& species) {
  for (std::size_t s = 0; s < species.size(); ++s) {
    if (species.mass(s) != species.mass(0)) return false;  // or it is NaN
  }
  return true;
}

// The mean pressure on the walls [M L^-1 T^-2]: each contact transfers 4 k T / v on average, in two
// dimensions pi k T / v.
double expected_wall_pressure(const GasStatistics& statistics, double kinetic_energy) {
  double area = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (statistics.box.is_wall(axis)) area += 2 * statistics.box.face_area(axis);
  }
  const auto spheres = static_cast<double>(statistics.spheres);
  const double temperature =
      2 * kinetic_energy / (static_cast<double>(statistics.box.dimensions()) * spheres);
  const double transferred =
      (statistics.is_flat() ? std::numbers::pi : 4) * temperature / statistics.mean_speed;
  return spheres * wall_rate(statistics) * transferred / area;
}

// Counts over the whole run.
std::vector<Quantity> rates(const Simulation& simulation, const GasStatistics& statistics,
                            const Summary& summary) {
  std::vector<Quantity> all;
  const World& world = simulation.world();
  const SpeciesList species(world);
  const FluidTheory fluid(world, species);
  const bool theory = is_uniform(world) && !world.box().is_sheared() && !simulation.thermostat() &&
                      !simulation.growth() && has_theory(world, statistics) && world.kinematic_count() == 0 &&
                      (fluid.holds() || (has_one_mass(species) && !world.interactions().has_passing()));
  const auto add = [&](const std::string& name, const std::string& unit, double value, double expected) {
    if (std::isfinite(value)) all.push_back({name, unit, value, kNoNumber, theory ? expected : kNoNumber});
  };
  const Counters counters = simulation.counters();
  const double span = static_cast<double>(simulation.size()) * simulation.time();
  const auto rate = [&](std::uint64_t count) { return static_cast<double>(count) / span; };
  const double collision_rate = 2 * rate(counters.collision);
  // Between walls the fluid is not homogeneous: there the theory that chooses cells, of equal masses, must
  // do.
  const double temperature = thermal_motion(world, simulation.now()).temperature();
  const double expected_rate =
      fluid.holds() ? fluid.collision_rate(temperature) : 1 / mean_free_time(statistics);
  const double expected_path =
      fluid.holds() ? fluid.mean_speed(temperature) / expected_rate : mean_free_path(statistics);
  add("collisions per sphere and time", "T^-1", collision_rate, expected_rate);
  add("mean free time", "T", 1 / collision_rate, 1 / expected_rate);
  if (world.interactions().are_elastic()) {
    add("mean free path", "L", statistics.mean_speed / collision_rate, expected_path);
  }
  add("compressibility", "1", summary.state.compressibility, fluid.compressibility());
  if (std::isfinite(summary.state.wall_pressure)) {
    add("wall contacts per sphere and time", "T^-1", rate(counters.wall), wall_rate(statistics));
    add("pressure on the walls", pressure_unit(statistics.box), summary.state.wall_pressure,
        expected_wall_pressure(statistics, kinetic_energy(simulation.world(), simulation.now())));
  }
  // Several domains have more work than the one engine that the theory is of.
  if (simulation.engine() == EngineKind::cells && counters.rebuilds == 0 && summary.state.domains == 1) {
    const CellCounts expected = expected_counts(statistics, simulation.cell_edge());
    add("cells entered per sphere and time", "T^-1", rate(counters.enter), expected.enter);
    add("stale events per sphere and time", "T^-1", rate(counters.stale), expected.stale);
    add("pair predictions per sphere and time", "T^-1", rate(counters.predictions), expected.predictions());
  }
  return all;
}

// --- the choice of cells or lists ---

report::CostCurve cost_curve(const std::function<double(double)>& cost, double chosen, double best) {
  constexpr int kPoints = 121;
  constexpr double kReach = 3;
  const double first = std::min(chosen, best) / kReach;
  const double last = std::max(chosen, best) * kReach;
  const double least = cost(best);
  report::CostCurve curve;
  for (int i = 0; i < kPoints; ++i) {
    const double length = first * std::pow(last / first, static_cast<double>(i) / (kPoints - 1));
    curve.length.push_back(length);
    curve.cost.push_back(cost(length) / least);
  }
  curve.marks.push_back({.x = chosen, .name = "in use"});
  return curve;
}

report::CostCurve choice(const Simulation& simulation, const GasStatistics& statistics,
                         const UnitCosts& costs) {
  if (!(statistics.mean_speed > 0)) return {};
  if (simulation.skin() > 0) {
    const double best = optimal_skin(statistics, costs);
    report::CostCurve curve =
        cost_curve([&](double skin) { return cost_rate(expected_neighbor_counts(statistics, skin), costs); },
                   simulation.skin(), best);
    curve.title = "Choice of the neighbor lists";
    curve.quantity = "skin of the lists";
    curve.explanation =
        "A sphere keeps its neighbor list while it moves by less than the skin: with a thin skin "
        "lists are rebuilt more often, with a thick one they are longer. The choice affects the speed but no "
        "contact.";
    return curve;
  }
  if (simulation.cell_edge() > 0) {
    const double best = optimal_cell_edge(statistics, costs);
    report::CostCurve curve =
        cost_curve([&](double edge) { return cost_rate(expected_counts(statistics, edge), costs); },
                   simulation.cell_edge(), best);
    curve.marks.push_back({.x = paper_cell_edge(statistics, costs), .name = "paper"});
    curve.title = "Choice of the cells";
    curve.quantity = "edge of the cells";
    curve.explanation =
        "Spheres enter small cells more often, and find more candidates in large ones. The choice affects "
        "the speed but no contact; hardball tune measures what is predicted here.";
    return curve;
  }
  return {};
}

// Distinguishes measured species that have one name.
void make_names_unique(std::vector<report::SpeciesReport>& species) {
  const std::vector<report::SpeciesReport> before = species;
  for (report::SpeciesReport& each : species) {
    if (each.name.empty() || ranges::count(before, each.name, &report::SpeciesReport::name) == 1) continue;
    each.name += fmt::format(" (radius {:.4g}, mass {:.4g})", each.radius, each.mass);
  }
}

// Those that measures distinguish; otherwise those of the scenario.
std::vector<report::SpeciesReport> species(const Scenario& scenario, const World& world) {
  std::vector<report::SpeciesReport> all;
  const SpeciesList measured(world);
  if (measured.size() > 1) {
    for (std::size_t k = 0; k < measured.size(); ++k) {
      const std::string name = scenario.species.empty() ? "" : scenario.species[measured.label(k)].name;
      all.push_back({name, measured.count(k), measured.radius(k), measured.mass(k)});
    }
    make_names_unique(all);
    return all;
  }
  const std::vector<std::size_t> counts = species_counts(scenario, world);
  for (std::size_t k = 0; k < counts.size(); ++k) all.push_back({scenario.species[k].name, counts[k]});
  return all;
}

report::SurfaceReport surface_report(const WallSummary& wall) {
  report::SurfaceReport report;
  report.name = wall.name;
  ranges::replace(report.name, '_', ' ');
  report.shape = wall.shape;
  report.contacts = wall.tally.contacts;
  report.area = wall.area;
  report.force = wall.force;
  report.pressure = wall.pressure;
  report.work = wall.tally.work + wall.tally.heat;
  return report;
}

}  // namespace

report::Report run_report(const ScenarioChoice& chosen, const Scenario& scenario,
                          const Simulation& simulation, const Summary& summary,
                          std::span<const Measurement> measurements, bool is_complete) {
  report::Report report;
  report.is_complete = is_complete;
  report.measurements.assign(measurements.begin(), measurements.end());
  report.name = std::filesystem::path(scenario.name).stem().string();
  report.scenario = scenario.text;
  report.changes = changes(chosen);
  report.program = "hardball " + version();
  report.date = date_now();
  report.until = *scenario.run.until;
  report.seed = scenario.run.seed;
  report.restitution = scenario.restitution();
  for (const ResponseText& text : response_texts(scenario)) report.responses.push_back({text.who, text.what});
  report.species = species(scenario, simulation.world());

  report.time = simulation.time();
  report.event_log_hash = simulation.event_log_hash();
  report.spheres = simulation.size();
  report.events = simulation.counters();
  report.mergers = simulation.tally().mergers();
  report.passes = simulation.tally().passes();
  report.rotational_energy = summary.state.rotational_energy;
  report.packing_fraction = summary.state.packing_fraction;
  report.initial_energy = simulation.tally().initial_energy();
  report.gravity = simulation.world().motion().gravity();
  report.final_energy = energy(simulation.world(), simulation.now());
  report.momentum = momentum(simulation.world(), simulation.now());
  report.max_overlap = summary.state.max_overlap;

  report.is_flat = simulation.world().box().is_flat();
  for (const WallSummary& wall : summary.state.walls) report.surfaces.push_back(surface_report(wall));

  if (const auto& thermostat = simulation.thermostat()) {
    report.thermostat = {.kind = std::string(hardball::name_of(thermostat->kind())),
                         .events = thermostat->events(),
                         .energy = thermostat->energy()};
  }

  const Shear& shear = simulation.world().box().shear();
  if (shear.is_present()) {
    const double energy = kinetic_energy(simulation.world(), simulation.now());
    report.shear = {.rate = shear.rate, .work = simulation.tally().shear_work(energy)};
  }
  if (const auto& growth = simulation.growth()) {
    report.growth = {.state = std::string(hardball::name_of(growth->state())),
                     .epochs = growth->epochs(),
                     .compressibility = growth->compressibility(),
                     .work = simulation.tally().growth_work(),
                     .energy = growth->energy()};
  }

  report.engine = name_of(simulation.engine());
  report.cell_edge = summary.state.cell_edge;
  report.skin = simulation.skin();
  report.setup_seconds = summary.seconds.setup;
  report.run_seconds = summary.seconds.run;
  report.bytes_per_sphere = summary.state.bytes_per_sphere;
  report.peak_bytes = static_cast<double>(summary.state.peak_rss_bytes);

  const GasStatistics statistics = gas_statistics(simulation.world(), simulation.now());
  report.rates = rates(simulation, statistics, summary);
  report.choice = choice(simulation, statistics, simulation.options().unit_costs);
  return report;
}

}  // namespace hardball::cli
