// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Damaged and hostile files: an Error, or snapshots with proper numbers; never a crash, nor memory that the
// length of the file does not justify.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/io/zstd.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/trajectory/snapshot_format.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::hostile_snapshot_test {
namespace {

using namespace support;

World small_world() {
  World world(Box::periodic({10, 10, 10}));
  world.add({.position = {1, 2, 3}, .velocity = {0.1, 0, -2}, .radius = 0.5, .mass = 2});
  world.add(
      {.position = {4, 5, 6}, .velocity = {-0.3, 0, 0}, .radius = 0.25, .spin = {0, 1, 0}, .species = 1});
  world.add({.position = {7, 8, 9}, .radius = 1.0 / 3});
  return world;
}

// Reads all frames; false if they are refused.
bool is_readable(const std::filesystem::path& path) {
  try {
    const std::unique_ptr<SnapshotReader> reader = open_snapshots(path);
    for (std::size_t frame = 0; frame < reader->frames(); ++frame) {
      const Snapshot snapshot = reader->read(frame);
      for (const Sphere& sphere : snapshot.spheres) {
        EXPECT_TRUE(std::isfinite(length(sphere.position)) || length(sphere.position) > 1e150);
        EXPECT_TRUE(sphere.radius > 0 && sphere.mass > 0);
      }
    }
    return true;
  } catch (const Error& error) {
    EXPECT_NE(error.where().find(path.string()), std::string::npos) << error.what();
    EXPECT_FALSE(error.remedy().empty());
    return false;
  }
}

class DamagedFile : public testing::TestWithParam<std::string> {
 protected:
  DamagedFile() {
    Trajectory trajectory(path_);
    const int frames = has_single_frame(format_of(path_)) ? 1 : 2;
    for (int frame = 0; frame < frames; ++frame) trajectory.append(small_world(), Time(frame));
    trajectory.close();
    bytes_ = read_text(path_);
  }

  ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / ("file" + GetParam());
  std::string bytes_;
};

TEST_P(DamagedFile, IsRefusedOrReadWhereverItEnds) {
  ASSERT_TRUE(is_readable(path_));
  std::size_t refused = 0;
  for (std::size_t length = 0; length < bytes_.size(); ++length) {
    write_text(path_, bytes_.substr(0, length));
    if (!is_readable(path_)) ++refused;
  }
  EXPECT_GT(refused, bytes_.size() / 10);
}

TEST_P(DamagedFile, IsRefusedOrReadWhateverItsBytes) {
  std::mt19937 random(1997);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(random()) % limit; };
  const std::string telling = std::string("\0\xff\x80\x7f-+.e,:\"'n\n ", 16) + "019";
  std::size_t refused = 0;
  constexpr int kMutations = 2000;
  for (int mutation = 0; mutation < kMutations; ++mutation) {
    std::string bytes = bytes_;
    for (std::size_t changes = 1 + below(3); changes > 0 && !bytes.empty(); --changes) {
      const std::size_t at = below(bytes.size());
      switch (below(5)) {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes[at] = telling[below(telling.size())];
          break;
        case 2:
          bytes.erase(at, 1 + below(20));
          break;
        case 3:
          bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(40)));
          break;
        default:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      }
    }
    write_text(path_, bytes);
    if (!is_readable(path_)) ++refused;
  }
  EXPECT_GT(refused, kMutations / 10U);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedFile,
                         testing::Values(".xyz", ".xyz.zst", ".gsd", ".lammpstrj", ".csv", ".npy", ".sph",
                                         ".data", ".sph.zst"),
                         [](const testing::TestParamInfo<std::string>& test) {
                           std::string name;
                           for (const char c : test.param)
                             if (c != '.') name += c;
                           return name;
                         });

// What is wrong with a file of this name and these bytes.
std::string refusal_of(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  write_text(folder / name, bytes);
  return problem_of([&] { read_snapshot(folder / name); });
}

TEST(HostileFile, MayNotClaimSpheresThatItDoesNotHave) {
  const std::string huge = "999999999999999999";
  EXPECT_NE(refusal_of("a.xyz", huge + "\nProperties=pos:R:3:velo:R:3:radius:R:1\n").find("ends after 0"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.sph", huge + "\n1 1 1\n").find("ends within"), std::string::npos);
  EXPECT_NE(
      refusal_of("a.lammpstrj", "ITEM: NUMBER OF ATOMS\n" + huge + "\nITEM: ATOMS x y z vx vy vz radius\n")
          .find("ends after 0"),
      std::string::npos);
  EXPECT_NE(
      refusal_of("a.data", "title\n" + huge + " atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\nAtoms\n\n")
          .find("ends after 0"),
      std::string::npos);
  const std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + huge + ", 7)}\n";
  std::string npy = "\x93NUMPY";
  npy += {'\x01', '\x00'};
  append_little_endian(npy, static_cast<std::uint16_t>(text.size()));
  EXPECT_NE(refusal_of("a.npy", npy + text).find("shorter than its header says"), std::string::npos);
}

TEST(HostileFile, MayNotClaimSpheresWithoutPositionsInGsd) {
  const ScratchFolder folder;
  {
    Trajectory trajectory(folder / "a.gsd");
    trajectory.append(small_world(), Time(0));
  }
  std::string bytes = read_text(folder / "a.gsd");
  // Makes N, the fourth chunk, 4e9.
  const std::size_t entry = 256 + 3 * 32;
  const auto location = read_little_endian<std::uint64_t>(&bytes[entry + 16]);
  bytes.replace(location, 4, "\xff\xff\xff\xee");
  EXPECT_NE(refusal_of("a.gsd", bytes).find("another type or shape"), std::string::npos);
  // And hides all others by their names.
  for (std::size_t at = 0; (at = bytes.find("particles/", at)) != std::string::npos; at += 10) {
    if (bytes.compare(at, 11, "particles/N") != 0) bytes[at] = 'q';
  }
  EXPECT_NE(refusal_of("a.gsd", bytes).find("no positions"), std::string::npos);
}

TEST(HostileFile, MayNotExpandWithoutEnd) {
  std::string compressed;
  const auto take = [&](std::string_view bytes) { compressed += bytes; };
  ZstdCompressor compressor;
  const std::string rows(1 << 20, '\n');
  for (int i = 0; i < 20; ++i) compressor.append(rows, take);
  compressor.end(take);
  ASSERT_LT(compressed.size(), 10000U);
  EXPECT_NE(refusal_of("a.xyz.zst", compressed).find("a hundred times"), std::string::npos);
}

TEST(HostileFile, MayNotLackTheEndOfItsCompressedData) {
  const ScratchFolder folder;
  {
    Trajectory trajectory(folder / "a.xyz.zst");
    trajectory.append(small_world(), Time(0));
  }
  // All text is there, but not its checksum.
  std::string bytes = read_text(folder / "a.xyz.zst");
  bytes.resize(bytes.size() - 4);
  EXPECT_NE(refusal_of("a.xyz.zst", bytes).find("incomplete"), std::string::npos);
}

TEST(HostileFile, MayNotHaveEndlessLines) {
  const std::string line(3 << 20, '1');
  for (const char* name : {"a.xyz", "a.csv", "a.sph", "a.lammpstrj", "a.data"}) {
    EXPECT_NE(refusal_of(name, line).find("longer than a megabyte"), std::string::npos) << name;
  }
}

TEST(HostileFile, IsNoFileAtAll) {
  const ScratchFolder folder;
  EXPECT_THROW(read_snapshot(folder / "missing.xyz"), Error);
  EXPECT_THROW(read_snapshot(folder / "missing.gsd"), Error);
  EXPECT_THROW(read_snapshot(folder / "missing.npy"), Error);
  EXPECT_THROW(read_snapshot(folder / "missing.xyz.zst"), Error);
  std::filesystem::create_directory(folder / "folder.xyz");
  EXPECT_THROW(read_snapshot(folder / "folder.xyz"), Error);
  EXPECT_THROW(read_snapshot(folder / "run.pvd"), Error);
}

}  // namespace
}  // namespace hardball::hostile_snapshot_test
