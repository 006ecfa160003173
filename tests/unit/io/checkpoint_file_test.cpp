// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/checkpoint_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::checkpoint_file_test {
namespace {

using namespace support;

// Sections that compress well, somewhat, and not at all.
std::vector<CheckpointSection> sections() {
  Random random(1);
  std::string noise;
  std::string words;
  constexpr int kBytes = 2000;
  for (int i = 0; i < kBytes; ++i) {
    noise += static_cast<char>(random.bits() & 0xff);
    words += static_cast<char>('a' + (random.bits() & 3));
  }
  return {{"zeros", std::string(kBytes * kBytes, '\0')}, {"words", words}, {"noise", noise}, {"empty", ""}};
}

TEST(CheckpointFile, GivesBackItsSections) {
  const ScratchFolder folder;
  write_checkpoint_file(folder / "file", sections());
  const std::map<std::string, std::string> read = read_checkpoint_file(folder / "file");
  ASSERT_EQ(read.size(), sections().size());
  for (const CheckpointSection& section : sections()) EXPECT_EQ(read.at(section.name), section.bytes);
  EXPECT_FALSE(std::filesystem::exists(folder / "file.part"));
}

TEST(CheckpointFile, IsReplacedAsAWhole) {
  const ScratchFolder folder;
  write_checkpoint_file(folder / "file", sections());
  const std::vector<CheckpointSection> other{{"other", "text"}};
  write_checkpoint_file(folder / "file", other);
  EXPECT_EQ(read_checkpoint_file(folder / "file").at("other"), "text");
  // What a killed process may leave.
  write_text(folder / "file.part", "half");
  write_checkpoint_file(folder / "file", other);
  EXPECT_FALSE(std::filesystem::exists(folder / "file.part"));
}

TEST(CheckpointFile, IsAsBeforeIfItCannotBeWritten) {
  const ScratchFolder folder;
  write_checkpoint_file(folder / "file", sections());
  std::filesystem::create_directory(folder / "file.part");
  EXPECT_THROW(write_checkpoint_file(folder / "file", sections()), RunFailure);
  EXPECT_EQ(read_checkpoint_file(folder / "file").size(), sections().size());
}

TEST(CheckpointFile, ThatIsDamagedIsRefused) {
  const ScratchFolder folder;
  const std::vector<CheckpointSection> few{{"words", sections()[1].bytes}, {"text", "text"}};
  write_checkpoint_file(folder / "file", few);
  const std::string file = read_text(folder / "file");
  for (std::size_t length = 0; length < file.size(); ++length) {
    EXPECT_THROW(read_checkpoint(file.substr(0, length), "file"), Error) << length;
  }
  EXPECT_THROW(read_checkpoint(file + 'x', "file"), Error);
  for (std::size_t byte = 0; byte < file.size(); ++byte) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = file;
      flipped[byte] = static_cast<char>(flipped[byte] ^ (1 << bit));
      EXPECT_THROW(read_checkpoint(flipped, "file"), Error) << "byte " << byte << ", bit " << bit;
    }
  }
}

TEST(CheckpointFile, ThatIsMissingIsRefused) {
  const ScratchFolder folder;
  EXPECT_THROW(read_checkpoint_file(folder / "file"), Error);
  EXPECT_THROW(read_checkpoint_file(folder.path()), Error) << "a directory";
}

// Checkpoints that programs of before the first release have written.

TEST(EarlierCheckpoints, OfBeforeTheFirstReleaseAreRefusedByName) {
  const std::string path = HARDBALL_TEST_SUPPORT "/checkpoints/before_first_release.hbc";
  const std::string saved = read_checkpoint_file(path).at("simulation");
  const Error error = error_of([&] { static_cast<void>(Simulation::load(saved, path)); });
  EXPECT_EQ(error.problem(), "has version 3 of the format, of before the first release");
  EXPECT_EQ(error.where(), path);
  EXPECT_EQ(error.remedy(), "start the run again, or end it with the program that wrote it");
}

}  // namespace
}  // namespace hardball::checkpoint_file_test
