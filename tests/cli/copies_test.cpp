// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A program that mpirun starts several times, and whose copies do not find each other.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "cli/program.hpp"

namespace hardball::copies_test {
namespace {

namespace fs = std::filesystem;
using namespace support;

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

// The program alone in a folder, without the plug-in that was built with it, and a scenario in another.
class Copies : public testing::Test {
 protected:
  Copies() {
    fs::copy_file(HARDBALL_PROGRAM, program_);
    write_text(folder_ / "gas.toml", kSmallGas);
  }

  void add_plugin(const fs::path& file) const { fs::copy_file(file, plugin_); }

  ProgramOutcome run(const Arguments& arguments) const {
    return Program(folder_, arguments, program_.string()).wait();
  }

  void expect_refusal(const std::string& message) const {
    for (const Arguments& arguments : {Arguments{"run", "gas.toml", "--out", "out"}, {"resume", "out"}}) {
      const ProgramOutcome outcome = run(arguments);
      EXPECT_EQ(outcome.exit_code, 2);
      EXPECT_EQ(outcome.messages, "hardball: " + message + "\n");
    }
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    EXPECT_EQ(run({"check", "gas.toml"}).exit_code, 0);
  }

  ScratchFolder own_;
  fs::path program_ = own_ / "hardball";
  fs::path plugin_ = own_ / "hardball_mpi.so";
  ScratchFolder folder_;
};

TEST_F(Copies, AreRefusedWithoutAPlugin) {
  for (const std::string name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const Variable size(name, "4");
    expect_refusal(name +
                   ": mpirun has started 4 copies of the program, each of which would run all of the system, "
                   "as there is no plug-in for MPI, hardball_mpi.so; run ./dev mpi, which installs Open MPI "
                   "(libopenmpi-dev and openmpi-bin in Debian) and builds the plug-in, or unset " +
                   name);
  }
  const Variable rank("PMIX_RANK", "0");
  expect_refusal(
      "PMIX_RANK: mpirun may have started several copies of the program, each of which would run all of the "
      "system, as there is no plug-in for MPI, hardball_mpi.so; run ./dev mpi, which installs Open MPI "
      "(libopenmpi-dev and openmpi-bin in Debian) and builds the plug-in, or unset PMIX_RANK");
}

TEST_F(Copies, AreRefusedWithAPluginThatCannotBeLoaded) {
  write_text(plugin_, "no library");
  const Variable size("OMPI_COMM_WORLD_SIZE", "2");
  const Variable rank("PMIX_RANK", "1");
  expect_refusal(
      "OMPI_COMM_WORLD_SIZE: mpirun has started 2 copies of the program, each of which would run all of the "
      "system, as the plug-in for MPI cannot be loaded (" +
      fs::canonical(plugin_).string() +
      ": file too short); install Open MPI (openmpi-bin in Debian), or build the plug-in with ./dev mpi, or "
      "unset OMPI_COMM_WORLD_SIZE and PMIX_RANK");
}

TEST_F(Copies, AreRefusedWithAPluginOfAnotherVersion) {
  add_plugin(HARDBALL_LATER_PLUGIN);
  const Variable size("OMPI_COMM_WORLD_SIZE", "2");
  expect_refusal(
      "OMPI_COMM_WORLD_SIZE: mpirun has started 2 copies of the program, each of which would run all of the "
      "system, as " +
      fs::canonical(plugin_).string() +
      " has version 2, and the program needs version 1; build both from the same source, as ./dev mpi does, "
      "or unset OMPI_COMM_WORLD_SIZE");
}

TEST_F(Copies, AreRefusedWithAPluginForAnotherMpi) {
  add_plugin(HARDBALL_LONELY_PLUGIN);
  const Variable size("PMI_SIZE", "2");
  expect_refusal(
      "PMI_SIZE: mpirun has started 2 copies of the program, each of which would run all of the system, as "
      "the plug-in for MPI is built for Fake MPI 1.0, which finds one process; use the mpirun of Fake MPI "
      "1.0, or build the plug-in for the MPI of this mpirun, or unset PMI_SIZE");
}

TEST_F(Copies, OfWhichThereIsOneRun) {
  const Variable tasks("SLURM_NTASKS", "4");
  {
    const Variable size("OMPI_COMM_WORLD_SIZE", "1");
    EXPECT_EQ(run({"run", "gas.toml", "--quiet"}).exit_code, 0);
  }
  add_plugin(HARDBALL_LONELY_PLUGIN);
  const Variable rank("PMIX_RANK", "0");
  EXPECT_EQ(run({"run", "gas.toml", "--quiet"}).exit_code, 0);
}

TEST_F(Copies, LoadNothingWhereThereAreNone) {
  write_text(plugin_, "no library");
  EXPECT_EQ(run({"run", "gas.toml", "--quiet"}).exit_code, 0);
}

TEST(Program, LinksNoMpi) {
  const ScratchFolder folder;
  const ProgramOutcome libraries = Program(folder, {HARDBALL_PROGRAM}, "/usr/bin/ldd").wait();
  EXPECT_EQ(libraries.exit_code, 0);
  EXPECT_NE(libraries.output.find("libstdc++"), std::string::npos);
  EXPECT_EQ(libraries.output.find("libmpi"), std::string::npos) << libraries.output;
}

}  // namespace
}  // namespace hardball::copies_test
