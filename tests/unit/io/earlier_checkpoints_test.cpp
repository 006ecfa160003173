// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Checkpoints that earlier versions of the program have written.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "hardball/archive/archive.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::earlier_checkpoints_test {
namespace {

// A gas of two species with a thermal wall, spins, passing spheres, a thermostat and all measures, at
// time 10.
TEST(EarlierCheckpoints, OfVersion1GoOn) {
  const std::string path = HARDBALL_TEST_SUPPORT "/checkpoints/version_1.hbc";
  std::map<std::string, std::string> sections = read_checkpoint_file(path);
  Simulation simulation = Simulation::load(sections.at("simulation"), path);
  Measures measures;
  restore(sections.at("measures"), path, measures);
  EXPECT_EQ(simulation.time(), 10);
  simulation.run_until(20, measures);
  EXPECT_EQ(simulation.event_log_hash(), 0xc8f761808b5b7cc4);
  constexpr std::size_t kMeasuresOfVersion1 = 14;
  EXPECT_EQ(measures.results(simulation.world(), simulation.now()).size(), kMeasuresOfVersion1);
}

// Gases of three species at time 10, of which one passes through itself: all others with one restitution, and
// with drops that merge, rough grains and walls of their own.
TEST(EarlierCheckpoints, OfVersion2GoOnWithTheirInteractions) {
  for (const auto& [name, hash] : {std::pair{"plain", 0x6668903d6438d25a}, {"pairs", 0xbddcb8402bdcc7b1}}) {
    SCOPED_TRACE(name);
    const std::string path = std::string(HARDBALL_TEST_SUPPORT "/checkpoints/version_2_") + name + ".hbc";
    Simulation simulation = Simulation::load(read_checkpoint_file(path).at("simulation"), path);
    EXPECT_EQ(simulation.time(), 10);
    const Interactions& interactions = simulation.world().interactions();
    EXPECT_TRUE(interactions.pass(1, 1));
    EXPECT_FALSE(interactions.pass(0, 1));
    simulation.run_until(20);
    EXPECT_EQ(simulation.event_log_hash(), hash);
    Simulation again = Simulation::load(simulation.save());
    simulation.run_until(21);
    again.run_until(21);
    EXPECT_EQ(again.event_log_hash(), simulation.event_log_hash());
  }
}

// Inelastic mixtures with a thermostat at time 10. That version had a hash of all contacts in order, and sums
// of doubles: the hash of what has been is kept, and the sums agree at time 20 with those of an uninterrupted
// run of that version, which had other roundings.
TEST(EarlierCheckpoints, OfVersion3GoOnWithTheirHashAndSums) {
  struct Case {
    const char* name;
    std::uint64_t hash_at_10;
    std::uint64_t hash_at_20;
  };
  const auto relative = [](double a, double b) { return std::fabs(a - b) / std::fabs(b); };
  for (const Case& of : {Case{"walls", 0x8aeefbd913436ff0, 0xf4ed4849fc0350c3},
                         Case{"periodic", 0xd178f157b610a5e7, 0x5bc4f8425a6bda0a}}) {
    SCOPED_TRACE(of.name);
    const std::string path = std::string(HARDBALL_TEST_SUPPORT "/checkpoints/version_3_") + of.name + ".hbc";
    Simulation simulation = Simulation::load(read_checkpoint_file(path).at("simulation"), path);
    EXPECT_EQ(simulation.time(), 10);
    EXPECT_EQ(simulation.event_log_hash(), of.hash_at_10);
    simulation.run_until(20);
    EXPECT_EQ(simulation.event_log_hash(), of.hash_at_20);
    const Tally& tally = simulation.tally();
    constexpr double kRounding = 1e-12;
    if (simulation.world().box().is_wall(0)) {
      EXPECT_EQ(tally.collisions(), 987U);
      EXPECT_LT(
          relative(tally.wall_pressure(simulation.world().box(), simulation.now()), 0.19849284726389935),
          kRounding);
      const WallTally thermal = tally.wall(face_of(0, false));
      EXPECT_EQ(thermal.contacts, 131U);
      EXPECT_LT(relative(thermal.impulse.y, -38.4643764394453), kRounding);
      EXPECT_LT(relative(thermal.work, 19.23218821972265), kRounding);
      EXPECT_LT(relative(thermal.heat, 279.4008392076156), kRounding);
    } else {
      EXPECT_EQ(tally.collisions(), 2589U);
      EXPECT_LT(relative(tally.compressibility(simulation.now()), 1.500610565961651), kRounding);
    }
    Simulation again = Simulation::load(simulation.save());
    simulation.run_until(21);
    again.run_until(21);
    EXPECT_EQ(again.event_log_hash(), simulation.event_log_hash());
    EXPECT_EQ(again.tally().energy_integral(again.now()), simulation.tally().energy_integral(again.now()));
  }
}

}  // namespace
}  // namespace hardball::earlier_checkpoints_test
