// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The measures that `hardball run` writes.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "hardball/measure/measures.hpp"

namespace hardball::measures_test {
namespace {

using namespace support;

class MeasuredRun : public ProgramTest {
 protected:
  MeasuredRun() { write_text(folder_ / "gas.toml", kSmallGas); }

  std::string hash(const Arguments& more = {}) {
    return json_of({"run", "gas.toml", "--json", "--overwrite"}, more)["event_log_hash"];
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / "out" / name); }
};

TEST_F(MeasuredRun, WritesAllMeasuresIntoItsDirectoryAndChangesNothing) {
  const std::string expected = hash();
  EXPECT_FALSE(exists("measures"));
  EXPECT_EQ(hash({"--out", "out"}), expected);
  // There are no wave vectors between walls, no walls but those of the box, and no potentials.
  EXPECT_FALSE(exists("measures/structure_factor.csv"));
  for (const std::string_view name : measure_names()) {
    if (name == "structure_factor" || name == "wall_forces" || name == "flow_profiles" || name == "steps")
      continue;
    if (name == "diffusion") break;  // from here on those of transport, which are taken by name
    const std::string table = read_text(folder_ / "out" / "measures" / (std::string(name) + ".csv"));
    EXPECT_NE(table.find("]"), std::string::npos) << name;
    EXPECT_LT(table.find("["), table.find("\n")) << name;
  }
  const std::string quantities = read_text(folder_ / "out" / "measures" / "quantities.csv");
  EXPECT_TRUE(quantities.starts_with(
      "measure,name,value,error,theory,unit,transient [T],tolerance,reason\npressure,compressibility,"));
}

TEST_F(MeasuredRun, FindsTheSameWithEveryEngineAndWithSnapshots) {
  const auto found = [&](const Arguments& more) {
    Arguments arguments{"--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    hash(arguments);
    return read_text(folder_ / "out" / "measures" / "quantities.csv") +
           read_text(folder_ / "out" / "measures" / "velocity_autocorrelation.csv");
  };
  const std::string expected = found({});
  EXPECT_EQ(found({"--engine", "all-pairs"}), expected);
  EXPECT_EQ(found({"--engine", "paper"}), expected);
  EXPECT_EQ(found({"--set", "output.snapshots_every=0.3"}), expected);
}

// Files are what they are, however a run is interrupted and resumed, and for any number of threads.
TEST_F(MeasuredRun, WritesTheForcesOnTrianglesOnRequest) {
  write_text(folder_ / "box.toml", R"(
[box]
boundary = ["open", "open", "open"]
[[walls]]
shape = "box"
size = [4.0, 3.0, 2.0]
point = [1.0, 2.0, 3.0]
velocity = [0.0, 0.0, 0.1]
spheres = "inside"
[[spheres]]
count = 20
radius = 0.2
placement = "random"
mean_speed = 1.0
[measures]
names = ["wall_forces"]
face_forces = true
)");
  const auto run = [&](const std::string& until, const Arguments& more = {}) {
    return json_of({"run", "box.toml", "--out", "out", "--overwrite", "--json", "--until", until}, more);
  };
  const auto files = [&] {
    return read_text(folder_ / "out/measures/mesh_0_face_forces.vtp") +
           read_text(folder_ / "out/measures/quantities.csv");
  };
  const nlohmann::json wall = run("20")["walls"][0];
  const std::string expected = files();
  EXPECT_NE(expected.find("Name=\"force\""), std::string::npos);
  run("20", {"--threads", "2"});
  EXPECT_EQ(files(), expected);
  run("9");
  json_of({"resume", "out", "--until", "20", "--json"});
  EXPECT_EQ(files(), expected);
  // About a point below by one, the torque differs by that times the force.
  const nlohmann::json other = run("20", {"--set", "walls.0.torque_about=[1, 2, 2]"})["walls"][0];
  const auto difference = [&](int axis) {
    return other["torque"][axis].get<double>() - wall["torque"][axis].get<double>();
  };
  EXPECT_NEAR(difference(0), -wall["impulse"][1].get<double>() / 20, 1e-12);
  EXPECT_NEAR(difference(1), wall["impulse"][0].get<double>() / 20, 1e-12);
  EXPECT_NEAR(difference(2), 0, 1e-12);
  run("1", {"--set", "measures.face_forces=false"});
  EXPECT_FALSE(exists("measures/mesh_0_face_forces.vtp"));
  EXPECT_TRUE(exists("measures/quantities.csv"));
}

TEST_F(MeasuredRun, MeasuresWhatIsRequestedAndRemovesFilesOfAnEarlierRun) {
  hash({"--out", "out"});
  hash({"--out", "out", "--set", "measures.names=[\"pressure\"]"});
  EXPECT_TRUE(exists("measures/pressure.csv"));
  EXPECT_FALSE(exists("measures/temperature.csv"));
  hash({"--out", "out", "--set", "measures.names=[]"});
  EXPECT_FALSE(exists("measures"));
}

TEST_F(MeasuredRun, StartsAtTheRequestedTime) {
  hash({"--out", "out", "--set", "measures.names=[\"temperature\"]", "--set", "measures.from=2", "--set",
        "measures.every=1"});
  const std::string table = read_text(folder_ / "out" / "measures" / "temperature.csv");
  for (const char* const within : {"\n2.", "\n3.", "\n4."}) {
    EXPECT_NE(table.find(within), std::string::npos) << table << " has a sample in each unit of time";
  }
  EXPECT_EQ(table.find("\n1."), std::string::npos) << table;
}

TEST_F(MeasuredRun, RefusesAnUnknownMeasureAndNamesTheNearest) {
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--set", "measures.names=[\"presure\"]"}),
                 {"did you mean \"pressure\"?"});
  for (const char* setting :
       {"measures.every=0", "measures.from=-1", "measures.evry=1", "measures.names=1"}) {
    EXPECT_EQ(run_program(folder_, {"run", "gas.toml", "--set", setting}).exit_code, 2) << setting;
  }
}

TEST_F(MeasuredRun, WritesWhatItHasWhenInterrupted) {
  Program program(folder_,
                  {"run", "gas.toml", "--unit-costs", "standard", "--out", "out", "--until", "1e12"});
  for (int i = 0; i < 60000 && !exists("measures"); ++i) usleep(1000);
  usleep(200000);
  kill(program.process(), SIGTERM);
  EXPECT_EQ(program.wait().exit_code, 1);
  EXPECT_TRUE(exists("measures/quantities.csv"));
  EXPECT_TRUE(exists("measures/pressure.csv"));
}

// Numbers that are easily read as true and are not, with all measures as they are by default.
class HonestRun : public testing::Test {
 protected:
  // The quantities of a run, by measure and name, and the verdict of its report.
  struct Row {
    double value;
    double error;
    double theory;
    double tolerance;
    std::string reason;
  };
  void run(const std::string& scenario) {
    write_text(folder_ / "run.toml", scenario);
    const ProgramOutcome outcome = run_program(folder_, {"run", "run.toml", "--out", "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
    std::istringstream table(read_text(folder_ / "out/measures/quantities.csv"));
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
      std::vector<std::string> fields;
      std::istringstream row(line);
      for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
      fields.resize(9);
      rows_[fields[0] + "." + fields[1]] = {std::stod(fields[2]), std::stod(fields[3]), std::stod(fields[4]),
                                            std::stod(fields[7]), fields[8]};
    }
    const std::string html = read_text(folder_ / "out/report.html");
    const std::string begin = "<strong>";
    const std::size_t at = html.find(begin, html.find("class=\"verdict")) + begin.size();
    verdict_ = html.substr(at, html.find('<', at) - at);
    for (const auto& [name, row] : rows_) {
      EXPECT_TRUE(std::isfinite(row.error) || !row.reason.empty()) << name << " has neither error nor reason";
    }
  }
  const Row& row(const std::string& name) const { return rows_.at(name); }

  ScratchFolder folder_;
  std::map<std::string, Row> rows_;
  std::string verdict_;
};

TEST_F(HonestRun, SeesAGasThatIsRescaledAtAllTimes) {
  run(gas_in_cube(500, 13.782337338022653) +
      "[response]\nrestitution = 0.9\n[thermostat]\nkind = \"rescale\"\ntemperature = 1.0\nevery = 1.0\n"
      "[run]\nuntil = 300.0\nseed = 1\n");
  const Row& temperature = row("temperature.temperature");
  EXPECT_NEAR(temperature.value, 0.948, 0.001) << "the pressure over the density and Z says so, too";
  EXPECT_LT(temperature.error, 0.001);
  const double by_pressure = row("pressure.pressure").value / row("pressure.compressibility").value *
                             std::pow(13.782337338022653, 3) / 499;
  EXPECT_NEAR(temperature.value / by_pressure, 1, 0.002);
  const Row& speed = row("velocity_distribution.mean_speed");
  EXPECT_NEAR(speed.value, std::sqrt(8 * 0.948 / 3.14159265), 4 * speed.error + 0.005);
  const Row& by_displacement = row("mean_square_displacement.diffusion_constant");
  const Row& by_velocity = row("velocity_autocorrelation.diffusion_constant");
  EXPECT_LT(std::fabs(by_displacement.value - by_velocity.value),
            3 * std::hypot(by_displacement.error, by_velocity.error));
}

TEST_F(HonestRun, ComparesSpheresThatPassWithAnIdealGas) {
  run(gas_in_cube(1000, 13.782337338022653) +
      "species = \"a\"\n[[response.pairs]]\nkind = \"pass\"\nbetween = [\"a\", \"a\"]\n[[species]]\n"
      "name = \"a\"\n[run]\nuntil = 10.0\nseed = 1\n");
  EXPECT_EQ(row("pressure.compressibility").value, 1);
  EXPECT_EQ(row("pressure.compressibility").theory, 1);
  EXPECT_EQ(verdict_, "Sound.");
  EXPECT_TRUE(std::isnan(row("mean_square_displacement.diffusion_constant").value));
  EXPECT_TRUE(std::isnan(row("nearest_neighbor.mean_gap").value));
  EXPECT_TRUE(std::isnan(row("nearest_neighbor.mean_gap").theory));
}

TEST_F(HonestRun, HasNoDiffusionConstantOfAGasThatCools) {
  run(gas_in_cube(500, 23.567465337002876) +
      "[response]\nrestitution = 0.8\n[run]\nuntil = 3000.0\nseed = 1\n");
  for (const char* const measure : {"mean_square_displacement", "velocity_autocorrelation"}) {
    const Row& constant = row(std::string(measure) + ".diffusion_constant");
    EXPECT_TRUE(std::isnan(constant.value)) << measure;
    EXPECT_FALSE(constant.reason.empty()) << measure;
  }
  EXPECT_NEAR(row("temperature.temperature").value, 0.01926, 0.0001) << "the mean over time";
  EXPECT_EQ(verdict_, "Not in equilibrium.");
}

TEST_F(HonestRun, TellsACrystalOfDiscsThatHasNotMelted) {
  run("[box]\ndimensions = 2\nsize = [34.76067989503809, 34.76067989503809]\n"
      "boundary = [\"periodic\", \"periodic\"]\n[[spheres]]\ncount = 1000\nradius = 0.5\n"
      "placement = \"hexagonal\"\ntemperature = 1.0\n[run]\nuntil = 2.117361021828873\nseed = 1\n");
  EXPECT_EQ(verdict_, "Not in equilibrium.");
  for (const char* const name :
       {"pressure.compressibility", "collision_rate.collision_rate", "radial_distribution.contact_value"}) {
    EXPECT_TRUE(std::isnan(row(name).error)) << name;
    EXPECT_TRUE(std::isinf(row(name).tolerance)) << name << " is compared with no theory";
  }
}

TEST_F(HonestRun, HasNoNumbersThatCannotBe) {
  run(gas_in_cube(500, 8.114420609742195, "fcc") + "[run]\nuntil = 0.052891584188867725\nseed = 1\n");
  EXPECT_EQ(verdict_, "Not in equilibrium.");
  EXPECT_FALSE(row("radial_distribution.contact_value").value < 0);
  for (const auto& [name, row] : rows_) {
    EXPECT_FALSE(row.error > 0 && row.error < 1e-9 * std::fabs(row.value))
        << name << " has an error of rounding";
  }
}

}  // namespace
}  // namespace hardball::measures_test
