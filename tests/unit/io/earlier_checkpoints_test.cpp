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

}  // namespace
}  // namespace hardball::earlier_checkpoints_test
