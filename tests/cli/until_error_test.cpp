// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A run ends when what it measures is known well enough.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"

namespace hardball::until_error_test {
namespace {

using nlohmann::json;
using namespace support;

class UntilError : public ProgramTest {
 protected:
  UntilError() {
    write_text(folder_ / "gas.toml", gas_in_cube(108, 7.0) +
                                         "[run]\nuntil = 1000.0\n[measures]\nnames = [\"pressure\", "
                                         "\"collision_rate\"]\n");
  }

  Arguments run(const std::string& wanted, const Arguments& more = {"--out", "out", "--overwrite"}) const {
    Arguments arguments{"run", "gas.toml", "--quiet", "--json", "--set", "run.until_error=" + wanted};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  // As in quantities.csv: the error of a quantity.
  double error_of(const std::string& quantity) const {
    const std::string table = text("out/measures/quantities.csv");
    std::size_t at = table.find("," + quantity + ",");
    EXPECT_NE(at, std::string::npos) << table;
    for (int commas = 0; commas < 3; ++commas) at = table.find(',', at) + 1;
    return std::stod(table.substr(at));
  }
};

TEST_F(UntilError, EndsSoonerTheMoreIsAllowed) {
  const json precise = json_of(run("{ compressibility = 0.02 }"));
  EXPECT_EQ(precise["errors_reached_at"], precise["time"]);
  EXPECT_LT(error_of("compressibility"), 0.02);
  EXPECT_GT(error_of("compressibility"), 0.01);
  const json rough = json_of(run("{ compressibility = 0.1 }"));
  EXPECT_LT(rough["time"], precise["time"]);
  EXPECT_LT(precise["time"], 500);
  // Without files, too.
  EXPECT_EQ(json_of(run("{ compressibility = 0.1 }", {}))["time"], rough["time"]);
  // Nothing else is different in the run.
  const Arguments until{"run",    "gas.toml", "--quiet",
                        "--json", "--until",  to_text(rough["time"].get<double>())};
  EXPECT_EQ(json_of(until)["event_log_hash"], rough["event_log_hash"]);
}

TEST_F(UntilError, WaitsForAllQuantities) {
  const double compressibility = json_of(run("{ compressibility = 0.1 }"))["time"];
  const double rate = json_of(run("{ collision_rate = 0.02 }"))["time"];
  EXPECT_NE(compressibility, rate);
  EXPECT_EQ(json_of(run("{ compressibility = 0.1, collision_rate = 0.02 }"))["time"],
            std::max(compressibility, rate));
}

TEST_F(UntilError, IsTheSameWhereverTheRunIsCut) {
  const json whole = json_of(run("{ compressibility = 0.05 }"));
  const std::string table = text("out/measures/quantities.csv");
  const double middle = 0.5 * whole["time"].get<double>();
  succeed(run("{ compressibility = 0.05 }"), {"--set", "output.checkpoint_at=[" + to_text(middle) + "]"});
  const json resumed =
      json_of({"resume", "out", "--quiet", "--json", "--from", "checkpoints/" + to_text(middle) + ".hbc"});
  EXPECT_EQ(resumed["time"], whole["time"]);
  EXPECT_EQ(resumed["event_log_hash"], whole["event_log_hash"]);
  EXPECT_EQ(text("out/measures/quantities.csv"), table);
  EXPECT_EQ(json_of({"resume", "out", "--quiet", "--json"})["time"], whole["time"]) << "it is whole";
}

TEST_F(UntilError, SaysWhatIsNotKnownAtTheEnd) {
  const ProgramOutcome outcome = succeed(
      {"run", "gas.toml", "--quiet", "--until", "20", "--set", "run.until_error={compressibility=1e-6}"});
  expect_in(outcome.output, "the error of pressure.compressibility is ");
  expect_in(outcome.output, ", not below the 1e-06 of run.until_error");
}

TEST_F(UntilError, NamesWhatIsMeasured) {
  expect_refusal(program(run("{ compresibility = 0.1 }")),
                 {"gas.toml: ", "\"compresibility\"", "did you mean \"compressibility\"?"});
  expect_refusal(program(run("{ compressibility = 0.1 }"), {"--set", "measures.names=[]"}),
                 {"until_error", "nothing is measured", "[measures]"});
  expect_refusal(program(run("0.1")), {"until_error is a number", "{ compressibility = 0.02 }"});
  expect_refusal(program(run("{ compressibility = 0 }")), {"until_error is 0", "positive"});
}

}  // namespace
}  // namespace hardball::until_error_test
