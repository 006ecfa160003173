// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The scenarios that come with the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/scenario/scenario.hpp"

namespace hardball::scenarios_test {
namespace {

using nlohmann::json;
using namespace support;

std::string path_of(const std::string& scenario) {
  return HARDBALL_SCENARIOS "/" + scenario + ".toml";
}

std::vector<std::string> all_scenarios() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(HARDBALL_SCENARIOS)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class ShippedScenarios : public ProgramTest {
 protected:
  json run(const std::string& scenario, const Arguments& more = {}) const {
    return json_of({"run", path_of(scenario), "--json"}, more);
  }
};

class EveryScenario : public ProgramTest, public testing::WithParamInterface<std::string> {};

TEST_P(EveryScenario, IsAcceptedByCheck) {
  const ProgramOutcome outcome = run_program(folder_, {"check", path_of(GetParam())});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  for (const char* line : {"radius", " fraction ", "mean free time", "engine", "memory", "collisions"}) {
    EXPECT_NE(outcome.output.find(line), std::string::npos) << outcome.output;
  }
  const bool has_lists = outcome.output.find("neighbors") != std::string::npos;
  EXPECT_NE(outcome.output.find(has_lists ? "skin of lists" : "cell edge"), std::string::npos)
      << outcome.output;
}

TEST_P(EveryScenario, IsTheSameWithAllEngines) {
  const Scenario scenario = load_scenario(path_of(GetParam()));
  // A part of each will do: all engines run it, all pairs and the paper's among them.
  const double until = *scenario.run.until / 4;
  const ProgramOutcome outcome =
      run_program(folder_, {"verify", path_of(GetParam()), "--until", to_text(until)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages << outcome.output;
  for (const char* line : {"three domains", "edge", "paper", "all-pairs", "all runs are the same"}) {
    EXPECT_NE(outcome.output.find(line), std::string::npos) << outcome.output;
  }
  EXPECT_FALSE(std::regex_search(outcome.output, std::regex("[^ \n][0-9a-f]{16} +[0-9]+ ")))
      << "the name of a run touches its hash:\n"
      << outcome.output;
}

TEST_F(ShippedScenarios, AreVerifiedWithoutDomainsThatCannotShareTheSpheres) {
  const ProgramOutcome outcome = run_program(folder_, {"verify", path_of("square_well"), "--until", "0.05"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages << outcome.output;
  EXPECT_NE(outcome.output.find("threads cannot share spheres with potentials of steps"), std::string::npos)
      << outcome.output;
}

INSTANTIATE_TEST_SUITE_P(All, EveryScenario, testing::ValuesIn(all_scenarios()),
                         [](const testing::TestParamInfo<std::string>& test) { return test.param; });

TEST_F(ShippedScenarios, HaveRadiiThatCheckDescribes) {
  const ProgramOutcome equal = run_program(folder_, {"check", path_of("paper")});
  EXPECT_NE(equal.output.find(" 1.5\n"), std::string::npos) << equal.output;
  const ProgramOutcome mixed = run_program(folder_, {"check", path_of("mixture")});
  EXPECT_NE(mixed.output.find("0.4491 on average, 0.4 to 2\n"), std::string::npos) << mixed.output;
}

TEST_F(ShippedScenarios, HaveASchemaThatCheckPrints) {
  const ProgramOutcome outcome = run_program(folder_, {"check", "--schema"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output, read_text(HARDBALL_SCENARIOS "/scenario.schema.json"));
  EXPECT_EQ(outcome.messages, "");
}

// A drop that grows at a wall, or beside a sphere that bounces off it, reaches into that.
TEST_F(ShippedScenarios, MayHaveSpheresThatGrowIntoOthers) {
  write_text(folder_ / "drops.toml", kSmallGas + "[response]\nkind = \"merge\"\n");
  const ProgramOutcome outcome =
      run_program(folder_, {"verify", "drops.toml", "--until", "20", "--set", "spheres.0.count=100"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("all runs are the same"), std::string::npos) << outcome.output;
}

TEST_F(ShippedScenarios, CradleCollidesOncePerUnitOfTime) {
  EXPECT_EQ(run("newtons_cradle", {"--until", "999.5"})["events"]["collision"], 999);
  EXPECT_EQ(run("newtons_cradle", {"--until", "1000"})["events"]["collision"], 1000);
}

TEST_F(ShippedScenarios, GranularGasCools) {
  const json summary = run("granular_gas");
  EXPECT_LT(summary["energy"]["final"], 0.1 * summary["energy"]["initial"].get<double>());
}

TEST_F(ShippedScenarios, HeatedGranularGasIsHeatedToItsSteadyTemperature) {
  const json summary = run("heated_granular_gas");
  EXPECT_EQ(summary["thermostat"]["kind"], "heating");
  EXPECT_NEAR(summary["thermostat"]["events"].get<double>(), 600, 1);
  // 3/2 N kT with kT = 1. Of 1000 spheres it scatters by sqrt(2 / 3N), 2.6%.
  EXPECT_NEAR(summary["energy"]["final"].get<double>() / 1500, 1, 0.12);
  EXPECT_GT(summary["thermostat"]["energy"], 5000);
}

TEST_F(ShippedScenarios, PistonCompressesAdiabatically) {
  const json summary = run("piston");
  ASSERT_EQ(summary["motions"].size(), 1U);
  EXPECT_EQ(summary["motions"][0]["kind"], "keyframes");
  EXPECT_EQ(summary["motions"][0]["walls"], 1);
  const double before = summary["energy"]["initial"].get<double>();
  const double after = summary["energy"]["final"].get<double>();
  const double work = summary["motions"][0]["work"].get<double>();
  EXPECT_NEAR(after - before, work, 1e-9 * work);
  // T V^(2/3) of the volume of the centers, and the correction for the volume of the spheres; the work of 500
  // spheres scatters.
  const double compression = std::pow(39.5 / 19.5, 2.0 / 3) * std::exp(2.0 / 3 * 4 * 0.002);
  EXPECT_NEAR(after / before / compression, 1, 0.03);
}

TEST_F(ShippedScenarios, MixerStirs) {
  const json summary = run("mixer");
  ASSERT_EQ(summary["motions"].size(), 1U);
  EXPECT_EQ(summary["motions"][0]["name"], "stirrer");
  EXPECT_EQ(summary["motions"][0]["spheres"], 7);
  EXPECT_GT(summary["motions"][0]["work"], 0);
  EXPECT_LT(summary["max_overlap"], 1e-9);
}

TEST_F(ShippedScenarios, GrowingSpheresReachTheirPackingFraction) {
  const json summary = run("growing_spheres");
  EXPECT_EQ(summary["growth"]["state"], "reached");
  EXPECT_NEAR(summary["packing_fraction"].get<double>(), 0.62, 1e-12);
  const double given = summary["growth"]["work"].get<double>() + summary["growth"]["energy"].get<double>();
  const double change = summary["energy"]["final"].get<double>() - summary["energy"]["initial"].get<double>();
  EXPECT_NEAR(change, given, 1e-9 * summary["growth"]["work"].get<double>());
}

TEST_F(ShippedScenarios, TransportIsThatOfEnskog) {
  const ProgramOutcome outcome =
      run_program(folder_, {"run", path_of("transport"), "--out", "out", "--set", "run.until=60"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  const std::string quantities = read_text(folder_ / "out" / "measures" / "quantities.csv");
  for (const std::string name :
       {"diffusion,diffusion_constant_of_infinite_system", "viscosity,viscosity_over_enskog",
        "bulk_viscosity,bulk_viscosity_lag", "thermal_conductivity,thermal_conductivity"})
    EXPECT_NE(quantities.find("\n" + name + ","), std::string::npos) << name << "\n" << quantities;
  EXPECT_NE(read_text(folder_ / "out" / "report.html").find("Thermal conductivity"), std::string::npos);
}

TEST_F(ShippedScenarios, DiluteGasHasThePressureOfTheory) {
  // Carnahan and Starling at a packing fraction of 0.01. The virial of 7,000 collisions scatters by about 1%.
  EXPECT_NEAR(run("dilute_gas")["compressibility"].get<double>() - 1, 0.0410, 4 * 0.0410 / std::sqrt(7000));
}

}  // namespace
}  // namespace hardball::scenarios_test
