// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/paper/paper_engine.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/random_world.hpp"

namespace hardball::support {

/// A way to run a world; all ways must give the same history.
struct EngineVariant {
  EngineOptions options;
  std::string name;
};

/// All engines, cells from half a diameter to larger than the box, and neighbor lists where they
/// suit the world.
inline std::vector<EngineVariant> engine_variants(const World& world) {
  std::vector<EngineVariant> variants;
  const auto add = [&](EngineKind engine, std::optional<double> edge) {
    EngineVariant variant;
    variant.options.engine = engine;
    variant.options.cell_edge = edge;
    variant.name = engine == EngineKind::all_pairs   ? "all pairs"
                   : engine == EngineKind::paper     ? "paper"
                   : engine == EngineKind::neighbors ? "neighbors"
                                                     : "cells";
    if (edge) variant.name += ", edge " + to_text(*edge);
    variants.push_back(variant);
  };
  const double diameter = world.size() > 0 ? 2 * world.largest_bounding_radius() : 1;
  double extent = 20 * diameter;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_open(axis)) extent = std::max(extent, 1.5 * world.box().size()[axis]);
  }
  add(EngineKind::all_pairs, std::nullopt);
  if (goes_with(Feature::paper, world.features())) {
    add(EngineKind::paper, diameter);
    add(EngineKind::paper, 2.5 * diameter);
  }
  for (const double edge : {0.5 * diameter, diameter, 1.3 * diameter, 3.1 * diameter, extent})
    add(EngineKind::cells, edge);
  if (world.size() > 0 && NeighborList::supports(world)) {
    add(EngineKind::neighbors, std::nullopt);
    add(EngineKind::neighbors, 0.05 * diameter);
    add(EngineKind::neighbors, diameter);
  }
  add(EngineKind::automatic, std::nullopt);
  return variants;
}

/// Some ways to divide a world among domains, in one thread or two.
inline std::vector<EngineVariant> divided_variants() {
  std::vector<EngineVariant> variants;
  const auto add = [&](EngineKind engine, const Division& division) {
    EngineVariant variant;
    variant.options.engine = engine;
    variant.options.division = division;
    variant.name = to_text(division.domains) + " domains";
    variants.push_back(variant);
  };
  add(EngineKind::automatic, {.domains = 2, .halo = 1.05, .window = 0.5});
  add(EngineKind::cells, {.domains = 3, .threads = 2, .halo = 2, .window = 0.1});
  add(EngineKind::cells, {.domains = 7, .halo = 1.3, .window = 2});
  return variants;
}

/// The outcome of a run.
struct History {
  std::uint64_t hash = 0;
  std::uint64_t contacts = 0;
  /// The message of the RunFailure that ended it; empty if it reached the limit.
  std::string failure;
  double time = 0;
  std::vector<Path> paths;
  std::vector<Vec3> spins;
  std::vector<double> radii;
  /// Whatever else must be the same.
  std::vector<double> more = {};
};

/// Runs to the limits, or to an inelastic collapse.
inline History run_on(Simulation& simulation, const RunLimits& limits) {
  History history;
  try {
    simulation.run(limits);
  } catch (const RunFailure& failure) {
    history.failure = failure.what();
  }
  history.hash = simulation.event_log_hash();
  history.contacts = simulation.counters().contacts();
  history.time = simulation.time();
  simulation.world().for_each_by_id([&](Slot slot) {
    history.paths.push_back(simulation.world().path(slot));
    history.spins.push_back(simulation.world().spin(slot));
    history.radii.push_back(simulation.world().base_radius(slot));
  });
  return history;
}

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

/// Where two histories differ first; empty if they are the same to the last bit.
inline std::string difference(const History& a, const History& b) {
  if (a.contacts != b.contacts) return "contacts: " + to_text(a.contacts) + " and " + to_text(b.contacts);
  if (a.hash != b.hash) return "hashes";
  if (a.failure != b.failure) return "failures: '" + a.failure + "' and '" + b.failure + "'";
  if (!same_bits(a.time, b.time)) return "times: " + to_text(a.time) + " and " + to_text(b.time);
  if (a.paths.size() != b.paths.size()) return "numbers of spheres";
  for (std::size_t i = 0; i < a.paths.size(); ++i) {
    const bool same = same_bits(a.paths[i].position, b.paths[i].position) &&
                      same_bits(a.paths[i].velocity, b.paths[i].velocity) &&
                      a.paths[i].time == b.paths[i].time && same_bits(a.spins[i], b.spins[i]) &&
                      same_bits(a.radii[i], b.radii[i]);
    if (!same) return "the paths of sphere " + to_text(i);
  }
  if (a.more.size() != b.more.size()) return "numbers of other results";
  for (std::size_t i = 0; i < a.more.size(); ++i) {
    if (!same_bits(a.more[i], b.more[i]))
      return "result " + to_text(i) + ": " + to_text(a.more[i]) + " and " + to_text(b.more[i]);
  }
  return "";
}

/// Runs to the limits; if it reaches them, the engine must be sound.
inline History validated_run(Simulation& simulation, const RunLimits& limits) {
  History history = run_on(simulation, limits);
  if (history.failure.empty()) simulation.validate();
  return history;
}

/// The history of a world, in which all ways to run it must agree: run(simulation, variant, is_first) returns
/// that by one of them. Only where that is allowed may cells be refused as too small. Nothing after a
/// failure.
template <class Run>
std::optional<History> one_history(const World& world, const std::vector<EngineVariant>& variants, Run&& run,
                                   bool may_refuse_cells = false) {
  std::optional<History> expected;
  for (const EngineVariant& variant : variants) {
    SCOPED_TRACE(variant.name);
    try {
      Simulation simulation(world, variant.options);
      const History history = run(simulation, variant, !expected);
      if (!expected) expected = history;
      EXPECT_EQ(difference(*expected, history), "");
    } catch (const Error& error) {
      EXPECT_TRUE(may_refuse_cells && error.where() == "cell edge") << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    if (testing::Test::HasFailure()) return std::nullopt;
  }
  return expected;
}

/// The history up to the limits.
inline std::optional<History> one_history(const World& world, const std::vector<EngineVariant>& variants,
                                          const RunLimits& limits, bool may_refuse_cells = false) {
  const auto run = [&](Simulation& simulation, const EngineVariant&, bool) {
    return validated_run(simulation, limits);
  };
  return one_history(world, variants, run, may_refuse_cells);
}

/// The log of a run.
inline std::vector<Contact> record(Simulation& simulation, const RunLimits& limits) {
  std::vector<Contact> log;
  simulation.on_contact([&log](const Contact& contact) { log.push_back(contact); });
  run_on(simulation, limits);
  simulation.on_contact(nullptr);
  return log;
}

}  // namespace hardball::support
