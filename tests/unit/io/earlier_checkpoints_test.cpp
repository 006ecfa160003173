// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Checkpoints that programs of before the first release have written.
#include <gtest/gtest.h>

#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::earlier_checkpoints_test {
namespace {

TEST(EarlierCheckpoints, OfBeforeTheFirstReleaseAreRefusedByName) {
  const std::string path = HARDBALL_TEST_SUPPORT "/checkpoints/before_first_release.hbc";
  const std::string saved = read_checkpoint_file(path).at("simulation");
  try {
    static_cast<void>(Simulation::load(saved, path));
    FAIL() << "it was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.problem(), "has version 3 of the format, of before the first release");
    EXPECT_EQ(error.where(), path);
    EXPECT_EQ(error.remedy(), "start the run again, or end it with the program that wrote it");
  }
}

}  // namespace
}  // namespace hardball::earlier_checkpoints_test
