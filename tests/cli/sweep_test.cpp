// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// hardball sweep: many runs of one scenario, in directories that are the state.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "apps/sweep/study.hpp"
#include "apps/sweep/tables.hpp"
#include "cli/program.hpp"
#include "support/key_rows.hpp"

namespace hardball::sweep_test {
namespace {

using nlohmann::json;
using namespace support;

using Table = std::vector<std::map<std::string, std::string>>;

// A table by its heads. Precondition: no cell is quoted.
Table table_of(const std::string& text) {
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream rest(line);
    for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> heads = cells_of(line);
  Table table;
  while (std::getline(lines, line)) {
    std::vector<std::string> cells = cells_of(line);
    cells.resize(heads.size());
    std::map<std::string, std::string>& row = table.emplace_back();
    for (std::size_t k = 0; k < heads.size(); ++k) row[heads[k]] = cells[k];
  }
  return table;
}

class Sweep : public ProgramTest {
 protected:
  Sweep() { write_text(folder_ / "gas.toml", gas_in_cube(60, 6) + "[run]\nuntil = 10.0\n"); }

  // Writes a study of the gas.
  void write_study(const std::string& sweep, const std::string& name = "study.toml",
                   const std::string& head = "seed = 7\nquantities = [\"pressure.compressibility\"]\n") {
    write_text(folder_ / name, "scenario = \"gas.toml\"\n" + head + "[sweep]\n" + sweep);
  }

  // What is to be run, by the values and the replica of each member.
  std::map<std::string, json> to_run(const Arguments& more = {}) {
    std::map<std::string, json> members;
    const json listed = json_of({"sweep", "study.toml", "--dry-run", "--json"}, more);
    for (const json& each : listed["to_run"]) members[each["values"].dump() + each["replica"].dump()] = each;
    return members;
  }

  json sweep(const Arguments& more = {}) {
    return json_of({"sweep", "study.toml", "--json", "--quiet"}, more);
  }

  // The tables that must not depend on how members were run.
  std::pair<std::string, std::string> tables(const std::string& directory) {
    return {text(directory + "/runs.csv"), text(directory + "/points.csv")};
  }

  void expect_refused(const std::vector<std::string>& fragments, const Arguments& more = {}) {
    expect_refusal(program({"sweep", "study.toml"}, more), fragments);
  }
};

TEST_F(Sweep, SeedsFollowFromValuesAlone) {
  write_study(
      "replicas = 2\n[sweep.product]\n\"spheres.0.radius\" = [0.4, 0.5]\n\"box.gravity\" = [[0, 0, 0]]\n"
      "\"run.until\" = [1, 2.0]\n");
  const auto few = to_run();
  ASSERT_EQ(few.size(), 8U);
  // Other values, in another order, and written in another way.
  write_study(
      "replicas = 3\n[sweep.product]\n\"run.until\" = [2, 3, 1.0]\n\"spheres.0.radius\" = [0.3, 0.5, 4e-1]\n"
      "\"box.gravity\" = [[0.0, 0, 0]]\n");
  const auto many = to_run();
  ASSERT_EQ(many.size(), 27U);
  std::set<std::uint64_t> seeds;
  for (const auto& [values, member] : few) {
    ASSERT_TRUE(many.contains(values)) << values;
    EXPECT_EQ(member["seed"], many.at(values)["seed"]);
  }
  for (const auto& [values, member] : many) seeds.insert(member["seed"].get<std::uint64_t>());
  EXPECT_EQ(seeds.size(), 27U);
  EXPECT_LT(*seeds.rbegin(), std::uint64_t{1} << 48);
  EXPECT_FALSE(exists("study"));
  write_study("[sweep.product]\n\"run.until\" = [1]\n", "study.toml", "seed = 8\n");
  const auto other = to_run();
  write_study("[sweep.product]\n\"run.until\" = [1]\n");
  EXPECT_NE(to_run().begin()->second["seed"], other.begin()->second["seed"]);
}

TEST_F(Sweep, RangesAndRowsGiveValues) {
  write_study(R"([sweep.product]
"run.until" = { from = 0.1, to = 0.5, count = 5 }
[sweep.zip]
"spheres.0.count" = { from = 10, to = 1000, count = 3, scale = "log" }
"spheres.0.radius" = [0.1, 0.05, 0.01]
)");
  std::set<std::string> untils;
  std::set<std::string> rows;
  for (const auto& [values, member] : to_run()) {
    untils.insert(member["values"]["run.until"].dump());
    rows.insert(member["values"]["spheres.0.count"].dump() + " " +
                member["values"]["spheres.0.radius"].dump());
  }
  EXPECT_EQ(untils, (std::set<std::string>{"0.1", "0.2", "0.3", "0.4", "0.5"}));
  EXPECT_EQ(rows, (std::set<std::string>{"10 0.1", "100 0.05", "1000 0.01"}));
}

TEST_F(Sweep, TabulatesMeansWithErrorsBetweenAndWithinRuns) {
  write_study("replicas = 3\n[sweep.product]\n\"spheres.0.radius\" = [0.4, 0.5]\n", "study.toml",
              "quantities = [\"pressure.compressibility\", \"energy.final\"]\n");
  const json said = sweep();
  EXPECT_EQ(said["members"], 6);
  EXPECT_EQ(said["finished"], 6);
  const Table runs = table_of(text("study/runs.csv"));
  const Table points = table_of(text("study/points.csv"));
  ASSERT_EQ(runs.size(), 6U);
  ASSERT_EQ(points.size(), 2U);
  const auto number = [](const std::string& cell) { return std::stod(cell); };
  for (std::size_t point = 0; point < 2; ++point) {
    double sum = 0;
    double squared_errors = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& run = runs[3 * point + k];
      EXPECT_EQ(run.at("status"), "finished");
      EXPECT_EQ(run.at("spheres.0.radius"), points[point].at("spheres.0.radius"));
      const json summary = json::parse(text("study/" + run.at("member") + "/summary.json"));
      EXPECT_EQ(run.at("event_log_hash"), summary["event_log_hash"]);
      EXPECT_EQ(number(run.at("energy.final")), summary["energy"]["final"]);
      EXPECT_EQ(run.at("energy.final_error"), "");
      sum += number(run.at("pressure.compressibility"));
      squared_errors += std::pow(number(run.at("pressure.compressibility_error")), 2);
    }
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k)
      squares += std::pow(number(runs[3 * point + k].at("pressure.compressibility")) - sum / 3, 2);
    const auto found = [&](const char* end) {
      return number(points[point].at(std::string("pressure.compressibility") + end));
    };
    EXPECT_NEAR(found(""), sum / 3, 1e-14);
    EXPECT_NEAR(found("_error_between"), std::sqrt(squares / 2 / 3), 1e-14);
    EXPECT_NEAR(found("_error_within"), std::sqrt(squared_errors) / 3, 1e-14);
    EXPECT_NEAR(found("_error_ratio"), found("_error_between") / found("_error_within"), 1e-13);
    EXPECT_EQ(points[point].at("energy.final_error_within"), "");
    EXPECT_EQ(points[point].at("runs"), "3");
  }
  // The pressure grows with the radius.
  EXPECT_GT(number(points[1].at("pressure.compressibility")),
            number(points[0].at("pressure.compressibility")));
  expect_in(text("study/report.html"), "pressure.compressibility");
  EXPECT_EQ(json::parse(text("study/0002/values.json")),
            (json{{"spheres.0.radius", 0.4}, {"replica", 2}, {"seed", std::stoull(runs[1].at("seed"))}}));
  // A member is the run that anyone could start by hand.
  run_program(folder_, {"run", "gas.toml", "--set", "spheres.0.radius=0.4", "--seed", runs[1].at("seed"),
                        "--out", "own"});
  EXPECT_EQ(json::parse(text("own/summary.json"))["event_log_hash"], runs[1].at("event_log_hash"));
}

TEST_F(Sweep, OneRunHasNoErrorBetweenRuns) {
  write_study("");
  sweep();
  const Table points = table_of(text("study/points.csv"));
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].at("pressure.compressibility_error_between"), "");
  EXPECT_NE(points[0].at("pressure.compressibility_error_within"), "");
  EXPECT_EQ(points[0].at("pressure.compressibility_error_ratio"), "");
}

TEST(Combined, IsHonestAboutMissingErrors) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const sweep::PointEstimate two = sweep::combined({{1, 0.5}, {3, none}});
  EXPECT_EQ(two.mean, 2);
  EXPECT_EQ(two.between, 1);
  EXPECT_TRUE(std::isnan(two.within) && std::isnan(two.ratio()));
  EXPECT_TRUE(std::isnan(sweep::combined({}).mean));
}

TEST_F(Sweep, TheDirectoryIsTheState) {
  write_study("[sweep.product]\n\"spheres.0.radius\" = [0.4, 0.5]\n");
  sweep();
  const auto written = std::filesystem::last_write_time(folder_ / "study/0002/summary.json");
  write_study("replicas = 2\n[sweep.product]\n\"spheres.0.radius\" = [0.3, 0.4, 0.5]\n");
  EXPECT_EQ(to_run().size(), 4U);
  sweep();
  EXPECT_EQ(std::filesystem::last_write_time(folder_ / "study/0002/summary.json"), written);
  // In the order of the study, under the names that they have.
  std::string names;
  for (const auto& row : table_of(text("study/runs.csv"))) names += row.at("member") + " ";
  EXPECT_EQ(names, "0003 0004 0001 0005 0002 0006 ");
  write_study("[sweep.product]\n\"spheres.0.radius\" = [0.3, 0.4]\n");
  expect_refused({"study: has the member ", "which the study lacks; name another directory"});
  write_study("replicas = 2\n[sweep.product]\n\"spheres.0.radius\" = [0.3, 0.4, 0.5]\n", "study.toml",
              "seed = 8\n");
  expect_refused({"study: was begun with the seed 7"});
  write_study("replicas = 2\n[sweep.product]\n\"spheres.0.radius\" = [0.3, 0.4, 0.5]\n");
  write_text(folder_ / "gas.toml", gas_in_cube(60, 6) + "[run]\nuntil = 11.0\n");
  expect_refused({"study: was begun with another scenario"});
}

TEST_F(Sweep, AMemberThatFailsDoesNotStopOthers) {
  write_study("[sweep.product]\n\"spheres.0.radius\" = [0.4, 0.5, 0.3]\n");
  succeed({"sweep", "study.toml", "--prepare"});
  EXPECT_TRUE(exists("study/0003/values.json"));
  // Files of another run.
  write_text(folder_ / "study/0002/trajectory.xyz", "");
  const ProgramOutcome outcome = program({"sweep", "study.toml"});
  EXPECT_EQ(outcome.exit_code, 1);
  expect_in(outcome.messages, "member 0002 has failed: study/0002: holds trajectory.xyz of another run");
  expect_in(text("study/0002/failed.txt"), "holds trajectory.xyz");
  expect_in(text("study/runs.csv"), ",failed,");
  expect_in(text("study/report.html"), "holds trajectory.xyz");
  EXPECT_TRUE(exists("study/0003/summary.json"));
  // It is run again only if that is wanted.
  std::filesystem::remove(folder_ / "study/0002/trajectory.xyz");
  EXPECT_EQ(program({"sweep", "study.toml"}).exit_code, 1);
  EXPECT_FALSE(exists("study/0002/summary.json"));
  EXPECT_EQ(sweep({"--retry"})["finished"], 3);
  EXPECT_FALSE(exists("study/0002/failed.txt"));
}

TEST_F(Sweep, PartsOfASweepGiveItsTables) {
  const std::string study = "replicas = 2\n[sweep.product]\n\"spheres.0.radius\" = [0.3, 0.4, 0.5]\n";
  write_study(study);
  sweep({"--out", "whole", "--workers", "1"});
  {
    const Program second(folder_, {"sweep", "study.toml", "--out", "parts", "--member", "2", "--of", "3"});
    const ProgramOutcome first =
        program({"sweep", "study.toml", "--out", "parts", "--member", "3", "--of", "3"});
    EXPECT_EQ(first.exit_code, 0) << first.messages;
    second.wait();
  }
  EXPECT_FALSE(exists("parts/points.csv"));
  sweep({"--out", "parts", "--member", "1", "--of", "3"});
  succeed({"sweep", "study.toml", "--out", "parts", "--table"});
  EXPECT_EQ(tables("parts"), tables("whole"));
}

TEST_F(Sweep, SweepsOfOneDirectoryShareTheWork) {
  write_study("replicas = 3\n[sweep.product]\n\"spheres.0.radius\" = [0.3, 0.4, 0.5]\n");
  sweep({"--out", "alone"});
  const Program other(folder_, {"sweep", "study.toml", "--out", "shared"});
  const Program another(folder_, {"sweep", "study.toml", "--out", "shared"});
  EXPECT_EQ(other.wait().exit_code, 0);
  EXPECT_EQ(another.wait().exit_code, 0);
  EXPECT_EQ(tables("shared"), tables("alone"));
}

TEST_F(Sweep, ResumesAfterSignalsToTheSameTables) {
  write_text(folder_ / "gas.toml", gas_in_cube(300, 10) +
                                       "[run]\nuntil = 60.0\n[output]\nevent_log = true\n"
                                       "checkpoint_every = 0.05\n");
  write_study("replicas = 2\n[sweep.product]\n\"spheres.0.radius\" = [0.4, 0.5]\n");
  sweep({"--out", "whole"});
  const Arguments parts{"sweep", "study.toml", "--out", "parts", "--workers", "2"};
  const auto has_checkpoint = [&] {
    for (const char* member : {"0001", "0002", "0003", "0004"}) {
      const std::string folder = std::string("parts/") + member;
      if (exists(folder + "/checkpoint.hbc") && !exists(folder + "/summary.json")) return true;
    }
    return false;
  };
  for (const int signal : {SIGKILL, SIGTERM, SIGKILL}) {
    const Program program(folder_, parts);
    for (int i = 0; i < 20000 && !has_checkpoint(); ++i) usleep(1000);
    usleep(100'000);
    kill(program.process(), signal);
    const ProgramOutcome outcome = program.wait();
    if (outcome.exit_code == 0) break;  // a fast machine
    // Otherwise the signal came before the program expected it.
    if (outcome.exit_code == 1) expect_in(outcome.messages, "interrupted; the same command resumes it");
  }
  succeed(parts);
  EXPECT_EQ(tables("parts"), tables("whole"));
  EXPECT_EQ(text("parts/0003/events.npy"), text("whole/0003/events.npy"));
}

TEST_F(Sweep, AnInterruptedRunIsNotFinished) {
  write_study("");
  sweep();
  json summary = json::parse(text("study/0001/summary.json"));
  const sweep::Member member{.directory = folder_ / "study/0001", .until = 10};
  EXPECT_EQ(sweep::state_of(member), sweep::State::finished);
  summary["time"] = 3.0;
  write_text(folder_ / "study/0001/summary.json", summary.dump());
  EXPECT_EQ(sweep::state_of(member), sweep::State::interrupted);
  std::filesystem::remove(folder_ / "study/0001/checkpoint.hbc");
  EXPECT_EQ(sweep::state_of(member), sweep::State::fresh);
}

TEST_F(Sweep, FindsBadValuesBeforeTheFirstRun) {
  write_study("replicas = 2\n[sweep.product]\n\"spheres.0.radius\" = [0.5, 50]\n");
  expect_refused({"study.toml: member 0003, spheres.0.radius = 50, replica 1: "});
  write_study("[sweep.product]\n\"spheres.0.radus\" = [0.5]\n");
  expect_refused(
      {"study.toml: member 0001, spheres.0.radus = 0.5, replica 1: --set spheres.0.radus: unknown key"});
  EXPECT_FALSE(exists("study"));
}

TEST_F(Sweep, RefusesWhatIsNoStudy) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"replica = 2\n", {"study.toml:5:1: unknown key 'replica' in [sweep]; did you mean 'replicas'?"}},
      {"replicas = 0\n", {"study.toml:5:12: replicas is 0"}},
      {"[sweep.product]\n\"run.until\" = 5\n", {"study.toml:6:1: run.until has no values"}},
      {"[sweep.product]\n\"run.until\" = []\n", {"run.until has no values"}},
      {"[sweep.product]\n\"run.until\" = [1, 1.0]\n", {"study.toml:6:19: run.until is 1 twice"}},
      {"[sweep.product]\n\"run.until\" = [inf]\n", {"the value is inf"}},
      {"[sweep.product]\n\"response\" = [{ restitution = 0.9 }]\n",
       {"a table is no value of a sweep", "name a key within it"}},
      {"[sweep.product]\n\"run.seed\" = [1, 2]\n", {"run.seed is not for sweeps"}},
      {"[sweep.product]\n\"run.until\" = { from = 0, to = 1, count = 3, scale = \"log\" }\n",
       {"a logarithmic range reaches from 0 to 1"}},
      {"[sweep.product]\n\"run.until\" = { from = 1, to = 2 }\n", {"key 'count' is missing in range"}},
      {"[sweep.zip]\n\"run.until\" = [1, 2]\n\"spheres.0.radius\" = [0.4]\n",
       {"spheres.0.radius has 1 values, and run.until has 2"}},
      {"[sweep.zip]\n\"run.until\" = [1, 1]\n", {"[sweep.zip] has the same values twice"}},
      {"[sweep.zip]\n\"run.until\" = [1]\n[sweep.product]\n\"run.until\" = [2]\n",
       {"run.until is in [sweep.product], too"}},
      {"[sweep.product]\n\"run.until\" = { from = 1, to = 2, count = 1e6 }\n\"box.x\" = [1, 2]\n",
       {"the sweep has 2000000 members"}},
  };
  for (const auto& [study, fragments] : cases) {
    write_study(study);
    SCOPED_TRACE(study);
    expect_refused(fragments);
  }
  write_text(folder_ / "study.toml", "scenario = \"gas.toml\"\n");
  expect_refused({"study.toml: table [sweep] is missing"});
  write_text(folder_ / "study.toml", "scenario = \"none.toml\"\n[sweep]\n");
  expect_refused({"none.toml: "});
}

TEST_F(Sweep, RefusesOptionsThatDoNotGoTogether) {
  write_study("");
  expect_refused({"--member and --of go together"}, {"--member", "1"});
  expect_refused({"--member: the part is 3 of 2"}, {"--member", "3", "--of", "2"});
  expect_refused({"--workers: '0' is not accepted"}, {"--workers", "0"});
  expect_refused({"--table, --prepare and --dry-run exclude each other"}, {"--table", "--dry-run"});
  expect_refused({"--table is for all members"}, {"--table", "--member", "1", "--of", "2"});
  write_study("", "study.toml", "quantities = [\"pressure.compressibilty\"]\n");
  const ProgramOutcome outcome = program({"sweep", "study.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  expect_in(outcome.messages,
            "study.toml: no run has the quantity 'pressure.compressibilty'; did you mean "
            "'pressure.compressibility'?");
}

TEST(PageOfSweeps, HasTheRowsOfAllKeys) {
  const std::string page = read_text(HARDBALL_SCENARIOS "/../docs/sweeps.md");
  const TableDescription& study = sweep::study_keys();
  const TableDescription& sweep_keys = *study.keys.back().table;
  for (const TableDescription* table : {&study, &sweep_keys, &sweep::range_keys()})
    EXPECT_NE(page.find("\n" + rows_of(*table)), std::string::npos) << "docs/sweeps.md lacks:\n"
                                                                    << rows_of(*table);
}

}  // namespace
}  // namespace hardball::sweep_test
