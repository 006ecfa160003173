// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The program measured_engine: spheres in a box, in a process that runs on command and reports the time
// taken. grid.py, which describes the protocol, runs several such processes in turn.
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "bench/hardware_counters.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRadius = 0.5;
constexpr std::size_t kMinSpheres = 2;
constexpr std::size_t kMaxSpheres = 1'000'000'000;

struct NamedCounter {
  std::string_view name;
  std::uint64_t Counters::*value;
};

constexpr NamedCounter kCounters[] = {
    {"collision", &Counters::collision},
    {"wall", &Counters::wall},
    {"enter", &Counters::enter},
    {"leave", &Counters::leave},
    {"stale", &Counters::stale},
    {"predictions", &Counters::predictions},
    {"contact_predictions", &Counters::contact_predictions},
    {"enter_predictions", &Counters::enter_predictions},
    {"queue_operations", &Counters::queue_operations},
    {"rebuilds", &Counters::rebuilds},
};

struct Options {
  std::size_t spheres = 0;
  std::size_t dimensions = 3;
  double packing_fraction = 0;
  double equilibration = 0;  // collisions per sphere
  std::uint64_t seed = 1;
  std::string engine = "auto";
  std::optional<std::string> instructions;
  std::size_t threads = 1;
  std::optional<double> cell_edge;
  std::optional<std::string> placement;
  std::string boundary = "periodic";
  double radius_ratio = 1;
};

SphereGroup group_of(std::size_t dimensions, std::size_t count, double radius, Placement placement) {
  SphereGroup group;
  group.dimensions = dimensions;
  group.count = count;
  group.radius = radius;
  group.placement = placement;
  group.velocity_rule = VelocityRule::temperature;
  group.velocity_scale = 1;
  group.where = "--packing-fraction";
  return group;
}

World make_start(const Options& options) {
  check_positive(options.packing_fraction, "the packing fraction", "--packing-fraction");
  check_positive(options.radius_ratio, "the ratio", "--radius-ratio");
  // Spheres of two sizes do not fit on a lattice.
  const bool is_mixture = options.radius_ratio != 1;
  if (options.dimensions != 2 && options.dimensions != 3) {
    throw Error("the number is " + to_text(options.dimensions), "--dimensions", "give 2 or 3");
  }
  const bool is_flat = options.dimensions == 2;
  const Placement placement = value_named<Placement>(options.placement.value_or(is_mixture ? "random"
                                                                                : is_flat  ? "hexagonal"
                                                                                           : "fcc"),
                                                     "--placement");
  const std::size_t others = is_mixture ? options.spheres / 2 : 0;
  Scenario scenario;
  scenario.run.seed = options.seed;
  double volume = 0;
  const auto add = [&](std::size_t count, double radius) {
    if (count == 0) return;
    scenario.spheres.push_back(group_of(options.dimensions, count, radius, placement));
    const double of_each =
        is_flat ? std::numbers::pi * radius * radius : 4 * std::numbers::pi / 3 * radius * radius * radius;
    volume += static_cast<double>(count) * of_each;
  };
  add(options.spheres - others, kRadius);
  add(others, kRadius * options.radius_ratio);
  const double box_volume = volume / options.packing_fraction;
  const double box_edge = is_flat ? std::sqrt(box_volume) : std::cbrt(box_volume);
  const Boundary boundary = value_named<Boundary>(options.boundary, "--boundary");
  if (boundary != Boundary::wall && boundary != Boundary::periodic)
    throw Error("the box is unbounded", "--boundary", "choose one of periodic, wall");
  scenario.box.fill({boundary, box_edge});
  if (is_flat) scenario.box[2] = {Boundary::flat, std::nullopt};
  return make_world(scenario);
}

template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void equilibrate(Simulation& simulation, double collisions_per_sphere) {
  const auto wanted =
      static_cast<std::uint64_t>(collisions_per_sphere * static_cast<double>(simulation.size()) / 2);
  // Wall contacts are not counted.
  while (simulation.counters().collision < wanted) {
    simulation.run_contacts(wanted - simulation.counters().collision);
  }
}

long peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#if defined(__APPLE__)
  return usage.ru_maxrss;
#else
  constexpr long kBytesPerUnit = 1024;  // Linux counts kilobytes
  return usage.ru_maxrss * kBytesPerUnit;
#endif
}

Json ready_report(const Simulation& simulation, double setup_seconds) {
  Json json;
  json["engine"] = name_of(simulation.engine());
  json["cell_edge"] = simulation.cell_edge() > 0 ? Json(simulation.cell_edge()) : Json(nullptr);
  json["setup_seconds"] = setup_seconds;
  json["bytes_per_sphere"] =
      static_cast<double>(simulation.memory_bytes()) / static_cast<double>(simulation.size());
  json["peak_rss_bytes"] = peak_rss_bytes();
  json["compiler"] = HARDBALL_COMPILER;
  json["flags"] = HARDBALL_FLAGS;
  return json;
}

Json run_slice(Simulation& simulation, std::uint64_t contacts, HardwareCounters& hardware_counters) {
  const Counters before = simulation.counters();
  const Time start = simulation.now();
  hardware_counters.start();
  const double seconds = seconds_of([&] { simulation.run_contacts(contacts); });
  const HardwareCounts counted = hardware_counters.stop();
  const Counters done = simulation.counters() - before;
  const auto number_or_null = [](const std::optional<std::uint64_t>& number) {
    return number ? Json(*number) : Json(nullptr);
  };
  Json json;
  json["collisions"] = done.collision;
  json["seconds"] = seconds;
  json["simulated_time"] = duration(start, simulation.now());
  json["cycles"] = number_or_null(counted.cycles);
  json["instructions"] = number_or_null(counted.instructions);
  for (const auto& [name, counter] : kCounters) json["counters"][std::string(name)] = done.*counter;
  return json;
}

// The caller waits for each answer.
void print(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

std::uint64_t parse_contacts(std::string_view text) {
  std::uint64_t contacts = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), contacts);
  if (status != std::errc() || end != text.data() + text.size() || contacts == 0) {
    throw Error("'" + std::string(text) + "' is not accepted", "run", "give a positive number of contacts");
  }
  return contacts;
}

void obey(Simulation& simulation) {
  constexpr std::string_view kRun = "run ";
  HardwareCounters hardware_counters;
  for (std::string line; std::getline(std::cin, line);) {
    if (line == "finish") {
      print(Json{{"event_log_hash", hash_text(simulation.event_log_hash())}}.dump());
      return;
    }
    if (!line.starts_with(kRun)) {
      throw Error("there is no command '" + line + "'", "standard input", "give run CONTACTS or finish");
    }
    const std::uint64_t contacts = parse_contacts(std::string_view(line).substr(kRun.size()));
    print(run_slice(simulation, contacts, hardware_counters).dump());
  }
}

void run(const Options& options) {
  if (options.spheres < kMinSpheres || options.spheres > kMaxSpheres) {
    throw Error("the number is " + to_text(options.spheres), "--spheres",
                "give a number from " + to_text(kMinSpheres) + " to " + to_text(kMaxSpheres));
  }
  check_finite(options.equilibration, "the number", "--equilibration");
  if (options.equilibration < 0) {
    throw Error("the number is " + to_text(options.equilibration), "--equilibration", "give zero or more");
  }
  EngineOptions engine_options;
  engine_options.engine = value_named<EngineKind>(options.engine, "--engine");
  if (options.instructions)
    engine_options.instructions = value_named<InstructionSet>(*options.instructions, "--instructions");
  engine_options.threads = options.threads;
  engine_options.cell_edge = options.cell_edge;
  World start = make_start(options);
  std::optional<Simulation> simulation;
  const double setup_seconds = seconds_of([&] { simulation.emplace(std::move(start), engine_options); });
  if (options.equilibration > 0) equilibrate(*simulation, options.equilibration);
  print("ready " + ready_report(*simulation, setup_seconds).dump());
  obey(*simulation);
}

int parse_and_run(int argument_count, char** arguments) {
  Options options;
  CLI::App app("Runs equal spheres of diameter 1 by commands on standard input: run CONTACTS, finish.",
               "measured_engine");
  app.add_option("--spheres", options.spheres, "How many")->required();
  app.add_option("--dimensions", options.dimensions, "3, or 2 for discs");
  app.add_option("--packing-fraction", options.packing_fraction, "Their volume over the box's")->required();
  app.add_option("--equilibration", options.equilibration, "Collisions per sphere before measuring");
  app.add_option("--seed", options.seed, "Seed of the random numbers");
  app.add_option("--engine", options.engine, "One of " + all_names<EngineKind>());
  app.add_option("--instructions", options.instructions,
                 "One of " + all_names<InstructionSet>() + "; the fastest by default");
  app.add_option("--threads", options.threads, "How many threads run them; 0 for as many as pay");
  app.add_option("--cell-edge", options.cell_edge, "Edge of the cells, instead of the best");
  app.add_option("--placement", options.placement, "One of " + all_names<Placement>());
  app.add_option("--boundary", options.boundary, "One of periodic, wall");
  app.add_option("--radius-ratio", options.radius_ratio,
                 "Ratio of the radii of the two halves of the spheres");
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    // Requests for help are "errors" with exit status 0.
    if (error.get_exit_code() == 0) return app.exit(error);
    throw Error(error.what(), "command line", "see measured_engine --help");
  }
  run(options);
  return 0;
}

}  // namespace
}  // namespace hardball::bench

int main(int argument_count, char** arguments) {
  constexpr int kFailed = 1;
  constexpr int kBadInput = 2;
  const auto complain = [](const std::exception& error) {
    std::fputs("measured_engine: ", stderr);
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
  };
  try {
    return hardball::bench::parse_and_run(argument_count, arguments);
  } catch (const hardball::Error& error) {
    complain(error);
    return kBadInput;
  } catch (const std::exception& error) {
    complain(error);
    return kFailed;
  }
}
