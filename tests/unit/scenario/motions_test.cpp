// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The tables [[motions]] of a scenario, and what refers to them.
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_simulation.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::scenario_motions_test {
namespace {

using namespace support;

const std::string kBox = R"([box]
boundary = ["open", "open", "open"]
)";
const std::string kGas = R"([[spheres]]
positions = [[1.0, 0.0, 5.0]]
radius = 0.5
speed = 0.0
)";
const std::string kStirrer = R"([[motions]]
kind = "rotation"
name = "stirrer"
point = [0.0, 0.0, 5.0]
axis = [0.0, 0.0, 2.0]
frequency = 0.25
tolerance = 1e-3
)";
const std::string kBlade = R"([[spheres]]
kinematic = true
motion = "stirrer"
radius = 0.2
positions = [[3.0, 0.0, 5.0], [4.0, 0.0, 5.0]]
)";

Simulation simulation_of(const std::string& text, const std::string& name = "mixer.toml") {
  const Scenario scenario = parse_scenario(text, name);
  return make_simulation(scenario, make_world(scenario), {}, {}, one_process());
}

TEST(MotionsOfAScenario, DriveSpheresAndWalls) {
  const std::string shaker = R"([[motions]]
kind = "oscillation"
name = "shaker"
direction = [0.0, 0.0, 1.0]
amplitude = 0.5
frequency = 0.25
tolerance = 1e-3
[[walls]]
shape = "plane"
point = [0.0, 0.0, 1.0]
normal = [0.0, 0.0, 1.0]
[[walls]]
shape = "plane"
point = [0.0, 0.0, 0.0]
normal = [0.0, 0.0, 1.0]
motion = "shaker"
)";
  Simulation simulation = simulation_of(kBox + kGas + kStirrer + kBlade + shaker);
  ASSERT_EQ(simulation.motions().size(), 2U);
  const DrivenMotion& stirrer = simulation.motions()[0];
  EXPECT_EQ(stirrer.name(), "stirrer");
  EXPECT_EQ(std::vector<SphereId>(stirrer.spheres().begin(), stirrer.spheres().end()),
            (std::vector<SphereId>{1, 2}));
  simulation.run_until(1);
  EXPECT_LT(length(simulation.position(2) - Vec3{0, 4, 5}), 1e-14);
  EXPECT_EQ(simulation.world().surface(kFaces).at_rest(Time(1)).point().z, 1);
  EXPECT_EQ(simulation.world().surface(kFaces + 1).at_rest(Time(1)).point().z, 0.5);
}

TEST(MotionsOfAScenario, ReadTablesBesideIt) {
  const ScratchFolder folder;
  write_text(folder / "lift.csv", "t,x,y,z\n0,1,1,1\n2,1,1,5\n4,1,1,1\n");
  const std::string lift = R"([[motions]]
kind = "keyframes"
name = "stirrer"
file = "lift.csv"
repeat = true
)";
  Simulation simulation = simulation_of(kBox + kGas + lift + kBlade, folder / "lift.toml");
  simulation.run_until(5);
  EXPECT_EQ(simulation.position(1), (Vec3{3, 0, 7}));
  write_text(folder / "lift.csv", "0,1,1,1\n2,1,1,x\n");
  const std::string damaged =
      refusal_of([&] { simulation_of(kBox + kGas + lift + kBlade, folder / "lift.toml"); });
  EXPECT_NE(damaged.find("lift.csv:2"), std::string::npos) << damaged;
  write_text(folder / "lift.csv", "0,1,1,1\n2,1,1,5\n");
  const std::string open =
      refusal_of([&] { simulation_of(kBox + kGas + lift + kBlade, folder / "lift.toml"); });
  EXPECT_NE(open.find("knot 1 (t = 2) is 4 away"), std::string::npos) << open;
}

TEST(MotionsOfAScenario, AreRefusedWithTheirPlace) {
  const auto expect = [](const std::string& text, const std::string& where, const std::string& what) {
    const std::string found = refusal_of([&] { simulation_of(text); });
    EXPECT_EQ(found.find("mixer.toml:" + where), 0U) << found;
    EXPECT_NE(found.find(what), std::string::npos) << found;
  };
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const std::string blade = with(kBlade, "\"stirrer\"", "\"stirer\"");
  expect(kBox + kGas + kStirrer + blade, "16:10", "did you mean \"stirrer\"?");
  expect(kBox + kGas + kBlade, "9:10", "add [[motions]] with this name");
  expect(kBox + kGas + kStirrer, "7:1", "drives nothing");
  expect(kBox + kGas + kStirrer + kStirrer + kBlade, "16:8", "two motions \"stirrer\"");
  expect(kBox + kGas + kStirrer + with(kBlade, "kinematic = true\n", ""), "15:10", "not kinematic");
  expect(kBox + kGas + kStirrer + kBlade + "speed = 1.0\n", "19:9", "the motion gives the spheres");
  expect(kBox + kGas + with(kStirrer, "tolerance = 1e-3\n", "") + kBlade, "7:1", "tolerance");
  expect(kBox + kGas + with(kStirrer, "frequency = 0.25", "frequency = 0.0") + kBlade, "7:1", "frequency");
  expect(kBox + kGas + kStirrer + "amplitude = 1.0\n" + kBlade, "14:1", "amplitude");
  const std::string wall =
      "[[walls]]\nshape = \"plane\"\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n";
  expect(kBox + kGas + kStirrer + wall + "motion = \"stirrer\"\n", "7:1", "does not rotate");
  expect(kBox + kGas + kStirrer + wall + "motion = \"stirrer\"\nvelocity = [0.0, 0.0, 1.0]\n", "19:12",
         "the motion moves the wall");
}

TEST(MotionsOfAScenario, LetKinematicSpheresBeUnderGravity) {
  const std::string box = kBox + "gravity = [0.0, 0.0, -1.0]\n";
  Simulation simulation = simulation_of(box + kGas + kStirrer + kBlade);
  simulation.run_until(1);
  EXPECT_LT(length(simulation.position(2) - Vec3{0, 4, 5}), 1e-14);
  const std::string still = kBlade.substr(0, kBlade.find("motion")) + kBlade.substr(kBlade.find("radius"));
  const std::string undriven = refusal_of([&] { simulation_of(box + kGas + still + "speed = 0.0\n"); });
  EXPECT_EQ(undriven.find("mixer.toml:8:1"), 0U) << undriven;
  EXPECT_NE(undriven.find("does not fall"), std::string::npos) << undriven;
  const std::string table = "[[motions]]\nkind = \"keyframes\"\nname = \"stirrer\"\nfile = \"lift.csv\"\n";
  const std::string untold = refusal_of([&] { simulation_of(box + kGas + table + kBlade); });
  EXPECT_NE(untold.find("no tolerance"), std::string::npos) << untold;
}

// A wall that closes a tube, and comes down on a sphere that bounces ever faster.
TEST(MotionsOfAScenario, StopAtAPressure) {
  const auto tube = [](const std::string& keys) {
    return R"([box]
size = [4.0, 4.0, 8.0]
boundary = ["periodic", "periodic", "wall"]
[[motions]]
kind = "oscillation"
name = "piston"
direction = [0.0, 0.0, -1.0]
amplitude = 4.0
frequency = 0.05
tolerance = 1e-2
)" + keys +
           R"([[walls]]
shape = "plane"
point = [0.0, 0.0, 7.0]
normal = [0.0, 0.0, -1.0]
motion = "piston"
[[spheres]]
positions = [[2.0, 2.0, 1.0]]
velocities = [[0.0, 0.0, 3.0]]
radius = 0.5
)";
  };
  Simulation simulation = simulation_of(tube("stop_pressure = 0.5\nstop_interval = 2.0\n"));
  simulation.run_until(10);
  EXPECT_EQ(simulation.motions().front().stopped_at(), 4.0);
  EXPECT_EQ(simulation.world().surface(kFaces).velocity(), Vec3{});
  const auto refused = [&](const std::string& keys) {
    return refusal_of([&] { simulation_of(tube(keys)); });
  };
  EXPECT_NE(refused("stop_pressure = 0.5\n").find("stop_interval"), std::string::npos);
  EXPECT_NE(refused("stop_interval = 0.5\n").find("stop_pressure"), std::string::npos);
}

}  // namespace
}  // namespace hardball::scenario_motions_test
