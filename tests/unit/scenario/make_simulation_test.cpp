// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_simulation.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_world.hpp"
#include "support/interacting.hpp"

namespace hardball::make_simulation_test {
namespace {

Scenario scenario_with(const std::string& response) {
  return parse_scenario(R"(
[box]
size = [6, 6, 6]
boundary = ["periodic", "periodic", "periodic"]
[[species]]
name = "drop"
[[spheres]]
count = 30
radius = 0.5
placement = "random"
species = "drop"
temperature = 1
)" + response,
                        "gas.toml");
}

std::uint64_t hash_with(const Scenario& scenario, const EngineOptions& options) {
  Simulation simulation = make_simulation(scenario, make_world(scenario), options);
  simulation.run_until(2);
  return simulation.event_log_hash();
}

TEST(MakeSimulation, HasTheResponseOfTheScenario) {
  for (const char* response : {"[response]\nrestitution = 0.5\nelastic_below = 0.1",
                               "[response]\ntangential_restitution = 0.5", "[response]\nkind = \"merge\"",
                               "[[response.pairs]]\nbetween = [\"drop\", \"drop\"]\nkind = \"bounce\"\n"
                               "restitution = 0.7"}) {
    const Scenario scenario = scenario_with(response);
    Simulation expected{make_world(scenario)};
    expected.run_until(2);
    Simulation elastic(support::interacting(make_world(scenario), {}));
    elastic.run_until(2);
    EXPECT_NE(expected.event_log_hash(), elastic.event_log_hash()) << response;
    EXPECT_EQ(hash_with(scenario, {}), expected.event_log_hash()) << response;
    EXPECT_EQ(hash_with(scenario, {.engine = EngineKind::all_pairs}), expected.event_log_hash()) << response;
  }
}

}  // namespace
}  // namespace hardball::make_simulation_test
