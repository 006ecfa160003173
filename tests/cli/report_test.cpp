// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The report of a run.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "cli/program.hpp"
#include "support/page.hpp"

namespace hardball::report_test {
namespace {

using nlohmann::json;
using namespace support;

const std::string kPeriodicGas =
    "# A gas of <300> spheres & more.\n" + gas_in_cube(300, 10) + "[run]\nuntil = 5.0\n";

class ReportFile : public ProgramTest {
 protected:
  ReportFile() { write_text(folder_ / "gas.toml", kPeriodicGas); }

  json run(const Arguments& more, const std::string& scenario = "gas.toml") {
    return json_of({"run", scenario, "--json", "--overwrite"}, more);
  }

  void expect_in_report(const std::string& part) const { expect_in(text("out/report.html"), part); }
};

TEST_F(ReportFile, IsWrittenBesideTheOthers) {
  const json summary = run({"--out", "out", "--seed", "7", "--set", "run.until=4"});
  EXPECT_EQ(faults_of_page(folder_ / "out/report.html"), "");
  expect_in_report("<h1>gas</h1>");
  expect_in_report("A gas of &lt;300&gt; spheres &amp; more.</p>");
  expect_in_report("<strong>Sound.</strong>");
  expect_in_report("<dd>" + summary["event_log_hash"].get<std::string>() + "</dd>");
  expect_in_report("<code>--seed 7</code>");
  expect_in_report("<code>--set run.until=4</code>");
  expect_in_report("<th scope=\"row\">seed</th><td>7</td>");
  expect_in_report("mean free time");
  expect_in_report("compressibility");
  expect_in_report("<h2 id=\"choice\">");
  EXPECT_FALSE(exists("out/report.html.part"));
}

// The theory of a quantity is the same wherever the report has it, for unequal masses, too.
TEST_F(ReportFile, HasOneTheoryForOneQuantity) {
  write_text(folder_ / "mixture.toml", R"([box]
size = [12.0, 12.0, 12.0]
boundary = ["periodic", "periodic", "periodic"]
[[spheres]]
count = 300
radius = 0.5
placement = "random"
temperature = 1.0
[[spheres]]
count = 20
radius = 1.0
mass = 8.0
placement = "random"
temperature = 1.0
[run]
until = 20.0
)");
  run({"--out", "out"}, "mixture.toml");
  const std::string html = read_text(folder_ / "out/report.html");
  // The third cell of each row with this heading.
  const auto theories = [&](const std::string& heading) {
    std::vector<std::string> found;
    const std::string row = "<th scope=\"row\">" + heading;
    for (std::size_t at = html.find(row); at != std::string::npos; at = html.find(row, at + 1)) {
      // Not the beginning of a longer name.
      if (html.compare(at + row.size(), 2, "</") != 0 && html.compare(at + row.size(), 2, " <") != 0)
        continue;
      const std::size_t theory = html.find("<td>", html.find("</td>", at)) + 4;
      const std::string cell = html.substr(theory, html.find("</td>", theory) - theory);
      found.push_back(cell.substr(0, cell.find(" ±")));
    }
    return found;
  };
  const std::vector<std::string> of_rates = theories("collisions per sphere and time");
  ASSERT_EQ(of_rates.size(), 1U);
  EXPECT_NE(of_rates.front(), "–");
  EXPECT_EQ(of_rates.front(), theories("collision rate").front());
  for (const char* quantity : {"compressibility", "mean free time", "mean free path"}) {
    const std::vector<std::string> found = theories(quantity);
    ASSERT_EQ(found.size(), 2U) << quantity;
    EXPECT_EQ(found[0], found[1]) << quantity;
  }
}

// Several domains have more work, on copies of spheres.
TEST_F(ReportFile, ComparesWorkWithTheoryWhereOneEngineDidIt) {
  for (const char* threads : {"1", "2"}) {
    run({"--out", "out", "--overwrite", "--engine", "cells", "--cell-edge", "1.5", "--threads", threads});
    const std::string html = read_text(folder_ / "out/report.html");
    EXPECT_EQ(html.find("pair predictions per sphere and time") != std::string::npos,
              threads == std::string("1"));
  }
}

TEST_F(ReportFile, ChangesNoContact) {
  const json with = run({"--out", "out"});
  const json without = run({"--out", "out", "--set", "output.report=false"});
  EXPECT_EQ(with["event_log_hash"], without["event_log_hash"]);
  EXPECT_EQ(with["events"], without["events"]);
  EXPECT_EQ(with["energy"], without["energy"]);
}

TEST_F(ReportFile, CanBeSwitchedOff) {
  run({"--out", "out"});
  EXPECT_TRUE(exists("out/report.html"));
  run({"--out", "out", "--set", "output.report=false"});
  EXPECT_FALSE(exists("out/report.html")) << "nor is there that of an earlier run";
  EXPECT_TRUE(exists("out/summary.json"));
  run({});
  EXPECT_FALSE(exists("report.html"));
}

TEST_F(ReportFile, OfEveryKindOfRunIsValid) {
  int number = 0;
  for (const Arguments& kind :
       std::vector<Arguments>{{"--set", R"(box.boundary=["wall", "wall", "wall"])"},
                              {"--set", R"(box.boundary=["open", "open", "open"])"},
                              {"--set", R"(box.boundary=["wall", "periodic", "open"])", "--engine", "paper"},
                              {"--engine", "neighbors"},
                              {"--engine", "all-pairs"},
                              {"--set", "response.restitution=0.5"},
                              {"--set", "spheres.0.count=1"},
                              {"--set", "spheres.0.temperature=0"},
                              {"--until", "0"}}) {
    const std::string out = "out" + std::to_string(number++);
    Arguments arguments = kind;
    arguments.insert(arguments.end(), {"--out", out});
    run(arguments);
    EXPECT_EQ(faults_of_page(folder_ / (out + "/report.html")), "") << kind[1];
    const std::string html = read_text(folder_ / (out + "/report.html"));
    // A gas that spreads through open space, or cools, is in no steady state.
    const bool is_steady = kind[1].find("open") == std::string::npos && kind[1] != "response.restitution=0.5";
    EXPECT_NE(html.find(is_steady ? "<strong>Sound.</strong>" : "<strong>Not in equilibrium.</strong>"),
              std::string::npos)
        << kind[1];
    for (const char* word : {"nan", "inf<", "inf "})
      EXPECT_EQ(html.find(word), std::string::npos) << kind[1] << word;
  }
}

TEST_F(ReportFile, EscapesTheNameOfTheScenario) {
  write_text(folder_ / "a<b>&'c'\xff.toml", kPeriodicGas);
  run({"--out", "out"}, "a<b>&'c'\xff.toml");
  EXPECT_EQ(faults_of_page(folder_ / "out/report.html"), "");
  expect_in_report("<h1>a&lt;b&gt;&amp;'c'\uFFFD</h1>");
}

TEST_F(ReportFile, SaysThatTheRunWasInterrupted) {
  using namespace std::chrono_literals;
  const Program program(folder_, {"run", "gas.toml", "--unit-costs", "standard", "--until", "1e6", "--out",
                                  "out", "--set", "output.event_log=true"});
  const std::filesystem::path events = folder_ / "out/events.npy";
  for (int i = 0; i < 2000; ++i) {
    if (exists("out/events.npy") && std::filesystem::file_size(events) > 1000) break;
    std::this_thread::sleep_for(10ms);
  }
  kill(program.process(), SIGINT);
  EXPECT_EQ(program.wait().exit_code, 1);
  EXPECT_EQ(faults_of_page(folder_ / "out/report.html"), "");
  expect_in_report("<strong>Interrupted.</strong>");
  expect_in_report(" of 1·10<sup>6</sup>");
}

TEST_F(ReportFile, IsCompleteOrAbsent) {
  // The report is then the largest file.
  write_text(folder_ / "gas.toml", kSmallGas + "[measures]\nnames = []\n");
  run({"--out", "out"});
  const std::uintmax_t size = std::filesystem::file_size(folder_ / "out/report.html");
  const ProgramOutcome outcome =
      Program(folder_, {"run", "gas.toml", "--out", "out", "--overwrite"}, HARDBALL_PROGRAM, size / 2).wait();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.messages.find("report.html"), std::string::npos) << outcome.messages;
  EXPECT_FALSE(exists("out/report.html"));
  EXPECT_FALSE(exists("out/report.html.part"));
  EXPECT_FALSE(exists("out/summary.json")) << "the run has not ended, and can be resumed";
  EXPECT_EQ(run_program(folder_, {"resume", "out"}).exit_code, 0);
  EXPECT_TRUE(exists("out/report.html"));
}

TEST_F(ReportFile, DoesNotReplaceADirectory) {
  std::filesystem::create_directories(folder_ / "out/report.html");
  expect_refusal(run_program(folder_, {"run", "gas.toml", "--out", "out"}),
                 {"out/report.html: is a directory"});
}

}  // namespace
}  // namespace hardball::report_test
