// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The measures that `hardball run` writes.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"
#include "hardball/measure/measure_settings.hpp"

namespace hardball::measures_test {
namespace {

using support::Arguments;
using support::Outcome;
using support::read_text;
using support::run_program;
using support::ScratchFolder;
using support::write_text;

class MeasuredRun : public testing::Test {
 protected:
  MeasuredRun() { write_text(folder_ / "gas.toml", support::kSmallGas); }

  std::string hash(const Arguments& more = {}) {
    Arguments arguments{"run", "gas.toml", "--json", "--overwrite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(folder_, arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    return nlohmann::json::parse(outcome.output)["event_log_hash"];
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / "out" / name); }

  ScratchFolder folder_;
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
  EXPECT_NE(table.find("\n2,"), std::string::npos) << table;
  EXPECT_NE(table.find("\n5,"), std::string::npos) << table;
  EXPECT_EQ(table.find("\n1,"), std::string::npos) << table;
}

TEST_F(MeasuredRun, RefusesAnUnknownMeasureAndNamesTheNearest) {
  const Outcome outcome = run_program(folder_, {"run", "gas.toml", "--set", "measures.names=[\"presure\"]"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.messages.find("did you mean \"pressure\"?"), std::string::npos) << outcome.messages;
  for (const char* setting :
       {"measures.every=0", "measures.from=-1", "measures.evry=1", "measures.names=1"}) {
    EXPECT_EQ(run_program(folder_, {"run", "gas.toml", "--set", setting}).exit_code, 2) << setting;
  }
}

TEST_F(MeasuredRun, WritesWhatItHasWhenInterrupted) {
  support::Program program(
      folder_, {"run", "gas.toml", "--unit-costs", "standard", "--out", "out", "--until", "1e12"});
  for (int i = 0; i < 60000 && !exists("measures"); ++i) usleep(1000);
  usleep(200000);
  kill(program.process(), SIGTERM);
  EXPECT_EQ(program.wait().exit_code, 1);
  EXPECT_TRUE(exists("measures/quantities.csv"));
  EXPECT_TRUE(exists("measures/pressure.csv"));
}

}  // namespace
}  // namespace hardball::measures_test
