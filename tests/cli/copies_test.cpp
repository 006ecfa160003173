// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A program without MPI that mpirun starts several times.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "cli/program.hpp"

namespace hardball::copies_test {
namespace {

using support::Outcome;
using support::run_program;

// An environment variable while the object lives.
class Variable {
 public:
  Variable(std::string name, const char* value) : name_(std::move(name)) { setenv(name_.c_str(), value, 1); }
  ~Variable() { unsetenv(name_.c_str()); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  std::string name_;
};

TEST(Copies, AreRefusedUnderMpirun) {
  const support::ScratchFolder folder;
  support::write_text(folder / "gas.toml", support::kSmallGas);
  for (const std::string name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const Variable size(name, "4");
    for (const support::Arguments& arguments :
         {support::Arguments{"run", "gas.toml", "--out", "out"}, {"resume", "out"}}) {
      const Outcome outcome = run_program(folder, arguments);
      EXPECT_EQ(outcome.exit_code, 2);
      EXPECT_EQ(
          outcome.messages,
          "hardball: " + name +
              ": mpirun has started 4 copies of a program that is built without MPI, each of which would run "
              "all of the system; use the program that ./dev mpi builds, build/mpi/hardball, or unset " +
              name + "\n");
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    EXPECT_EQ(run_program(folder, {"check", "gas.toml"}).exit_code, 0);
  }
}

TEST(Copies, OfWhichThereIsOneRun) {
  const support::ScratchFolder folder;
  support::write_text(folder / "gas.toml", support::kSmallGas);
  const Variable size("OMPI_COMM_WORLD_SIZE", "1");
  const Variable tasks("SLURM_NTASKS", "4");
  EXPECT_EQ(run_program(folder, {"run", "gas.toml", "--quiet"}).exit_code, 0);
}

}  // namespace
}  // namespace hardball::copies_test
