// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Faces of the box with properties of their own, through the program.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"

namespace hardball::faces_test {
namespace {

using nlohmann::json;
using namespace support;
using FacesOfTheBox = ProgramTest;

const std::string kSlab = R"([box]
boundary = ["periodic", "periodic", "wall"]
size = [6, 6, 8]
[box.faces]
z_min = { temperature = 1.0, velocity = [-1.0, 0.0, 0.0] }
z_max = { restitution = 0.9, velocity = [1.0, 0.0, 0.0] }
[[spheres]]
count = 50
radius = 0.5
placement = "random"
temperature = 1.0
[run]
until = 20.0
)";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(FacesOfTheBox, AreDescribedByCheckWithWhatDoesNothing) {
  write_text(folder_ / "slab.toml", kSlab);
  const std::string checked = run_program(folder_, {"check", "slab.toml"}).output;
  EXPECT_TRUE(has(checked, "thermal at kT = 1, moving with (-1, 0, 0)\n")) << checked;
  EXPECT_TRUE(has(checked, "restitution 0.9, moving with (1, 0, 0), which does nothing")) << checked;
  const std::string rough =
      run_program(folder_, {"check", "slab.toml", "--set", "response.tangential_restitution=0.5"}).output;
  EXPECT_FALSE(has(rough, "does nothing")) << rough;
  const std::string falling =
      run_program(folder_, {"check", "slab.toml", "--set", "box.gravity=[0, 0, -1]"}).output;
  EXPECT_TRUE(has(falling, "the run may end by inelastic collapse")) << falling;
}

TEST_F(FacesOfTheBox, AreMeasuredAndTheSameForAllEngines) {
  write_text(folder_ / "slab.toml", kSlab);
  const ProgramOutcome run = run_program(folder_, {"run", "slab.toml", "--out", "out", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  const json walls = json::parse(run.output)["walls"];
  ASSERT_EQ(walls.size(), 2U);
  EXPECT_EQ(walls[0]["name"], "z_min");
  EXPECT_NE(walls[0]["work"], 0);
  const std::string profiles = read_text(folder_ / "out" / "measures" / "flow_profiles.csv");
  EXPECT_TRUE(has(profiles, "flow_velocity_x_at_z")) << profiles;
  const std::string report = read_text(folder_ / "out" / "report.html");
  EXPECT_TRUE(has(report, "Profiles between driven faces"));
  EXPECT_FALSE(has(report, "standard errors of theory")) << "there is none out of equilibrium";
  const ProgramOutcome verified = run_program(folder_, {"verify", "slab.toml"});
  EXPECT_EQ(verified.exit_code, 0) << verified.output;
  EXPECT_TRUE(has(verified.output, "paper"));
}

}  // namespace
}  // namespace hardball::faces_test
