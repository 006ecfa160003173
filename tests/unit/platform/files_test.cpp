// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/platform/files.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "support/scratch_folder.hpp"

namespace hardball::files_test {
namespace {

using namespace support;
using platform::Access;
using platform::File;
using platform::LockFile;

TEST(File, HoldsItsBytesAsTheyAre) {
  const ScratchFolder folder;
  // Not a name in the letters of every code page.
  const std::filesystem::path path = folder.path() / std::filesystem::path(u8"k\u00fcgelchen \u7403");
  const std::string bytes("a\nb\r\n\x1a\0c", 8);
  File file(path, Access::create_new);
  ASSERT_TRUE(file.is_open());
  EXPECT_EQ(file.names(), 1U);
  EXPECT_TRUE(file.write(bytes) && file.sync());
  EXPECT_TRUE(file.seek(2) && file.write("B") && file.resize(6) && file.close());
  EXPECT_FALSE(file.is_open());
  EXPECT_EQ(read_text(path), std::string("a\nB\r\n\x1a", 6));
  const File read(path, Access::read);
  std::string part(9, '.');
  EXPECT_EQ(read.read_at(3, part.data(), part.size()), 3);
  EXPECT_EQ(part, "\r\n\x1a......");
  EXPECT_EQ(read.read_at(6, part.data(), part.size()), 0);
}

TEST(File, IsNotOpenIfThatIsImpossible) {
  const ScratchFolder folder;
  EXPECT_FALSE(File(folder / "file", Access::read).is_open());
  EXPECT_EQ(errno, ENOENT);
  EXPECT_FALSE(File(folder / "file", Access::write).is_open());
  EXPECT_EQ(errno, ENOENT);
  EXPECT_TRUE(File(folder / "file", Access::create).is_open());
  EXPECT_FALSE(File(folder / "file", Access::create_new).is_open());
  EXPECT_EQ(errno, EEXIST);
}

TEST(File, GivesWayToOneThatIsRenamed) {
  const ScratchFolder folder;
  write_text(folder / "file", "before");
  write_text(folder / "file.part", "after");
  EXPECT_TRUE(platform::rename_file(folder / "file.part", folder / "file"));
  EXPECT_EQ(read_text(folder / "file"), "after");
  EXPECT_FALSE(platform::rename_file(folder / "file.part", folder / "file"));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_TRUE(platform::remove_file(folder / "file"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LockFile, IsHeldByOneAtATime) {
  const ScratchFolder folder;
  std::optional<LockFile> first(folder / "lock");
  EXPECT_EQ(first->state(), LockFile::State::held);
  EXPECT_EQ(LockFile(folder / "lock").state(), LockFile::State::held_by_another);
  {
    const LockFile moved(std::move(*first));
    first.reset();
    EXPECT_EQ(LockFile(folder / "lock").state(), LockFile::State::held_by_another);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_EQ(LockFile(folder / "lock").state(), LockFile::State::held);
  EXPECT_EQ(LockFile(folder / "lost" / "lock").state(), LockFile::State::not_created);
}

}  // namespace
}  // namespace hardball::files_test
