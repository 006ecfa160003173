// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Checkpoints that earlier versions of the program have written.
#include <gtest/gtest.h>

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
  EXPECT_EQ(simulation.event_log_hash(), 0xd914d9e07cac2c37);
  constexpr std::size_t kMeasuresOfVersion1 = 14;
  EXPECT_EQ(measures.results(simulation.world(), simulation.now()).size(), kMeasuresOfVersion1);
}

// Gases of three species at time 10, of which one passes through itself: all others with one restitution, and
// with drops that merge, rough grains and walls of their own.
TEST(EarlierCheckpoints, OfVersion2GoOnWithTheirInteractions) {
  for (const auto& [name, hash] : {std::pair{"plain", 0x865c238ca80a5ae6}, {"pairs", 0x82241bdf6f599470}}) {
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

}  // namespace
}  // namespace hardball::earlier_checkpoints_test
