// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// hardball tune: what it prints and writes. The speed of cells is not tested.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/written.hpp"

namespace hardball::tune_test {
namespace {

using namespace support;

// So few spheres that no candidate is collected twice (broadphase/candidates.hpp), however large the cells.
const std::string kGas = gas_in_cube(250, 13.68) + "[run]\nuntil = 50.0\n";

// Costs so high that the rounds, whose length follows from the expected cost, are short.
const std::string kHighCosts = "contact=140000,enter=55000,cell=19000,prediction=5500";

class Tune : public ProgramTest {
 protected:
  Tune() { write_text(folder_ / "gas.toml", kGas); }

  ProgramOutcome tune(const Arguments& more = {}, const std::string& budget = "1") {
    return program({"tune", "gas.toml", "--unit-costs", kHighCosts, "--budget", budget}, more);
  }
};

std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

TEST_F(Tune, PrintsTheChoiceThePapersAndTheBest) {
  const ProgramOutcome outcome = tune();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  for (const char* word : {"packing fraction", "unit costs", "contact=1.4e+05", "predicted", "measured",
                           "counted", " auto", " paper", " best", "auto chooses", "mean free path [L]",
                           "[L]         [s/T]                [1/T]                 [1] "}) {
    EXPECT_NE(outcome.output.find(word), std::string::npos) << word;
  }
}

TEST_F(Tune, WritesATableInWhichPredictionsAgreeWithCounts) {
  const ProgramOutcome outcome = tune({"--out", "new/out"}, "3");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  const auto rows = read_csv(read_text(folder_ / "new/out/tune.csv"));
  ASSERT_GE(rows.size(), 8U) << "the larger edges coincide in a small box";
  const auto column = [&](const std::string& name) {
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
      if (rows[0][i].starts_with(name)) return i;
    }
    ADD_FAILURE() << "no column " << name;
    return std::size_t{0};
  };
  const auto number = [&](std::size_t row, const std::string& name) {
    return std::strtod(rows[row][column(name)].c_str(), nullptr);
  };
  for (std::size_t row = 1; row < rows.size(); ++row) {
    if (row > 1) {
      EXPECT_GT(number(row, "cell_edge"), number(row - 1, "cell_edge"));
    }
    EXPECT_GT(number(row, "measured_median"), 0);
    EXPECT_LE(number(row, "measured_least"), number(row, "measured_median"));
    EXPECT_GE(number(row, "measured_most"), number(row, "measured_median"));
    // Counted over a short time.
    EXPECT_NEAR(number(row, "counted_after_contact") / number(row, "predicted_after_contact"), 1, 0.2);
    EXPECT_NEAR(number(row, "counted_enter") / number(row, "predicted_enter"), 1, 0.3);
  }
}

TEST_F(Tune, DrawsAFigure) {
  const ProgramOutcome outcome = tune({"--out", "out"});
  ASSERT_EQ(outcome.exit_code, 0);
  for (const std::string file : {"out/tune.csv", "out/tune.svg"})
    expect_written(outcome.output, folder_, file, "");
  const std::string figure = read_text(folder_ / "out/tune.svg");
  EXPECT_NE(figure.find("<svg"), std::string::npos);
  EXPECT_NE(figure.find("auto"), std::string::npos);
  EXPECT_TRUE(figure.ends_with("</svg>\n"));
}

TEST_F(Tune, RefusesAWorldInWhichNothingMoves) {
  const ProgramOutcome outcome = tune({"--set", "spheres.0.temperature=0.0"});
  expect_refusal(outcome, {"nothing moves"});
}

// Which leaves time for one round only.
TEST_F(Tune, EndsWhenItsBudgetIsSpent) {
  const ProgramOutcome outcome = tune({"--out", "out"}, "1e-9");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(outcome.output.find("rounds                  1\n"), std::string::npos) << outcome.output;
  const std::size_t rows = read_csv(read_text(folder_ / "out/tune.csv")).size();
  EXPECT_GE(rows, 2U);
  EXPECT_LE(rows, 3U) << "the edge chosen, and the paper's";
}

TEST_F(Tune, RefusesABudgetThatIsNone) {
  for (const char* budget : {"0", "-1", "inf", "nan", "soon"}) {
    expect_refusal(tune({}, budget), {"--budget: "});
  }
}

TEST_F(Tune, SaysWhatARunWouldMeet) {
  const ProgramOutcome outcome =
      tune({"--set", "box.boundary=['wall', 'wall', 'wall']", "--set", "box.gravity=[0.0, 0.0, -0.01]",
            "--set", "response.restitution=0.99", "--set", "response.settle=false", "--until", "0.1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(outcome.output.find("by inelastic collapse"), std::string::npos) << outcome.output;
}

TEST_F(Tune, RefusesADirectoryThatIsAFile) {
  const ProgramOutcome outcome = tune({"--out", "gas.toml"});
  expect_refusal(outcome, {"gas.toml"});
  EXPECT_EQ(outcome.output, "");
}

// Spheres that fly apart in open space: no cells suit where they are in the end.
TEST_F(Tune, RefusesSpheresThatHaveFlownTooFarApart) {
  write_text(folder_ / "apart.toml",
             "[box]\nboundary = ['open', 'open', 'open']\nsize = [1e4, 1.0, 1e4]\n"
             "[[spheres]]\ncount = 2\nradius = 0.1\nplacement = 'random'\ntemperature = 1.0\n"
             "[run]\nuntil = 1e60\n");
  expect_refusal(run_program(folder_, {"tune", "apart.toml"}), {"no cells fit the spheres"});
}

}  // namespace
}  // namespace hardball::tune_test
