// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/output_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/replace_file.hpp"
#include "support/file_size_limit.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::output_file_test {
namespace {

using namespace support;

std::string message_of(const RunFailure& failure) {
  return failure.what();
}

TEST(OutputFile, ContainsWhatWasAppended) {
  const ScratchFolder folder;
  OutputFile file(folder / "file");
  file.append("one ");
  file.append("two");
  EXPECT_EQ(read_text(folder / "file"), "");
  file.flush();
  EXPECT_EQ(read_text(folder / "file"), "one two");
  file.append(" three");
  file.close();
  EXPECT_EQ(read_text(folder / "file"), "one two three");
  EXPECT_FALSE(file.is_open());
}

TEST(OutputFile, IsNotWrittenThroughALink) {
  const ScratchFolder folder;
  write_text(folder / "precious", "kept");
  if (kIsPosix) {
    std::filesystem::create_symlink("precious", folder / "link");
    EXPECT_THROW(OutputFile(folder / "link"), Error);
  }
  std::filesystem::create_hard_link(folder / "precious", folder / "name");
  OutputFile file(folder / "name");
  file.append("new");
  file.close();
  EXPECT_EQ(read_text(folder / "precious"), "kept");
  EXPECT_EQ(read_text(folder / "name"), "new");
}

TEST(ReplaceFile, WritesThroughNoLink) {
  if (!kIsPosix) GTEST_SKIP() << "not everybody can make symbolic links here";
  const ScratchFolder folder;
  write_text(folder / "precious", "kept");
  std::filesystem::create_symlink("precious", folder / "file");
  std::filesystem::create_symlink("precious", folder / "file.part");
  EXPECT_THROW(replace_file(folder / "file", "new"), RunFailure);
  EXPECT_EQ(read_text(folder / "precious"), "kept");
  EXPECT_FALSE(std::filesystem::exists(folder / "file.part")) << "is removed, as any unfinished file";
  replace_file(folder / "file", "new");
  EXPECT_EQ(read_text(folder / "precious"), "kept");
  EXPECT_EQ(read_text(folder / "file"), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "file"));
}

TEST(OutputFile, GoesOnWhereItIsCutBackTo) {
  const ScratchFolder folder;
  write_text(folder / "file", "one two");
  OutputFile file(folder / "file", FilePosition{4});
  EXPECT_EQ(file.size(), 4U);
  file.append("three");
  EXPECT_EQ(file.size(), 9U);
  file.close();
  EXPECT_EQ(read_text(folder / "file"), "one three");
}

TEST(OutputFile, DoesNotGoOnWhereItNeverWas) {
  const ScratchFolder folder;
  EXPECT_THROW(OutputFile(folder / "file", FilePosition{0}), Error) << "there is none";
  write_text(folder / "file", "one");
  EXPECT_THROW(OutputFile(folder / "file", FilePosition{4}), Error);
  EXPECT_EQ(read_text(folder / "file"), "one");
}

TEST(OutputFile, DoesNotGoOnAfterOtherBytes) {
  const ScratchFolder folder;
  constexpr std::uint64_t kHead = 2;
  FilePosition position;
  {
    OutputFile file(folder / "file");
    file.append("one two");
    position = file.position(kHead);
    file.append(" three");
    file.close();
  }
  for (const auto& [text, is_same] : {std::pair<std::string, bool>{"one two three", true},
                                      {"two two three", false},
                                      {"XXe two XXXXX", true},
                                      {"one Two three", false},
                                      {"one tw", false}}) {
    write_text(folder / "file", text);
    if (is_same) {
      EXPECT_NO_THROW(OutputFile(folder / "file", position, kHead));
    } else {
      EXPECT_THROW(OutputFile(folder / "file", position, kHead), Error);
    }
    EXPECT_EQ(read_text(folder / "file"), text);
  }
}

TEST(OutputFile, LooksAtNoMoreThanTheEndOfALongFile) {
  const ScratchFolder folder;
  FilePosition position;
  {
    OutputFile file(folder / "file");
    file.append(std::string(3 << 20, 'x'));
    position = file.position();
  }
  const auto change = [&](std::uint64_t at) {
    OutputFile file(folder / "file", FilePosition{3 << 20});
    file.overwrite(at, "y");
  };
  change((2 << 20) - 1);
  EXPECT_NO_THROW(OutputFile(folder / "file", position));
  change(2 << 20);
  EXPECT_THROW(OutputFile(folder / "file", position), Error);
}

TEST(OutputFile, EmptiesAnExistingFile) {
  const ScratchFolder folder;
  write_text(folder / "file", "something old and long");
  OutputFile file(folder / "file");
  file.append("new");
  file.close();
  EXPECT_EQ(read_text(folder / "file"), "new");
}

TEST(OutputFile, WritesLargeAmountsOnItsOwn) {
  const ScratchFolder folder;
  OutputFile file(folder / "file");
  const std::string piece(1000, 'x');
  for (int i = 0; i < 5000; ++i) file.append(piece);
  EXPECT_GT(std::filesystem::file_size(folder / "file"), 3'000'000U);
  file.close();
  EXPECT_EQ(std::filesystem::file_size(folder / "file"), 5'000'000U);
}

TEST(OutputFile, OverwritesAndContinuesAtTheEnd) {
  const ScratchFolder folder;
  OutputFile file(folder / "file");
  file.append("count 0, a");
  file.flush();
  file.overwrite(6, "2");
  file.append(", b");
  file.close();
  EXPECT_EQ(read_text(folder / "file"), "count 2, a, b");
}

TEST(OutputFile, MayBeClosedTwice) {
  const ScratchFolder folder;
  OutputFile file(folder / "file");
  file.close();
  EXPECT_NO_THROW(file.close());
}

TEST(OutputFile, WithoutCloseKeepsWhatIsComplete) {
  const ScratchFolder folder;
  {
    OutputFile file(folder / "file");
    file.append("whole\n");
    file.flush_complete();
    file.append("half");
    file.flush();
    file.append(" and more");
  }
  EXPECT_EQ(read_text(folder / "file"), "whole\n");
}

TEST(OutputFile, MovesWithItsContents) {
  const ScratchFolder folder;
  OutputFile first(folder / "file");
  first.append("one");
  OutputFile second(std::move(first));
  second.append(" two");
  second.close();
  EXPECT_EQ(read_text(folder / "file"), "one two");
}

TEST(OutputFile, CannotBeCreatedInAMissingFolder) {
  const ScratchFolder folder;
  const Error error = error_of([&] { OutputFile file(folder / "missing/file"); });
  EXPECT_EQ(error.where(), (folder / "missing/file").string());
  EXPECT_NE(error.problem().find("No such file or directory"), std::string::npos) << error.what();
}

TEST(OutputFile, SaysThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  OutputFile file("/dev/full");
  file.append("text");
  try {
    file.flush();
    FAIL() << "a full disk accepted the text";
  } catch (const RunFailure& failure) {
    EXPECT_NE(message_of(failure).find("/dev/full"), std::string::npos) << failure.what();
    EXPECT_NE(message_of(failure).find("No space left on device"), std::string::npos) << failure.what();
  }
  EXPECT_FALSE(file.is_open());
}

TEST(OutputFile, IsTruncatedToWhatIsComplete) {
  if (!kIsPosix) GTEST_SKIP() << "files have no limit here";
  const ScratchFolder folder;
  OutputFile file(folder / "file");
  file.append("whole\n");
  file.flush_complete();
  {
    const FileSizeLimit limit(100);
    EXPECT_THROW(
        {
          file.append(std::string(1000, 'x'));
          file.flush();
        },
        RunFailure);
  }
  EXPECT_EQ(read_text(folder / "file"), "whole\n");
  EXPECT_NO_THROW(file.close());
}

}  // namespace
}  // namespace hardball::output_file_test
