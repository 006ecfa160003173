// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/trajectory/gsd_file.hpp"
#include "hardball/trajectory/gsd_reader.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/snapshot_schedule.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::trajectory_test {
namespace {

using namespace support;

// Spheres with numbers that take all digits, in a box with all boundaries.
World motley_world() {
  World world(Box({Boundary::periodic, Boundary::wall, Boundary::open}, {10, 7, 0}));
  world.add({.position = {9.1, 3.3, -1.0 / 3},
             .velocity = {0.1 + 0.2, 1e-60, -2.0 / 3},
             .radius = 1.0 / 7,
             .mass = std::numeric_limits<double>::infinity(),
             .species = 2});
  world.add({.position = {1, 2, 3}, .radius = 0.25});
  world.add({.position = {0.7, 5.5, 12.3}, .velocity = {-3, 0.3, 1e9 / 7}, .radius = 0.1, .mass = 1e-3});
  world.add({.position = {5, 5, 5},
             .velocity = {1, 0, 0},
             .radius = 0.5,
             .spin = {0.1, -2, 1e-7},
             .inertia_factor = 1.0 / 3});
  world.remove(1);
  return world;
}

void expect_same(const Snapshot& read, const Snapshot& written, SnapshotFormat format) {
  ASSERT_EQ(read.spheres.size(), written.spheres.size());
  const bool is_sph = format == SnapshotFormat::sph;
  // These files have densities instead of masses, types instead of species, and ids from one on.
  const bool is_data = format == SnapshotFormat::lammps_data;
  for (std::size_t i = 0; i < read.spheres.size(); ++i) {
    const Sphere& sphere = read.spheres[i];
    const Sphere& expected = written.spheres[i];
    EXPECT_EQ(sphere.radius, expected.radius);
    if (!is_data) {
      EXPECT_EQ(sphere.species, expected.species);
    }
    // These files have nothing else, and unfolded centers.
    if (is_sph) continue;
    EXPECT_EQ(sphere.position, expected.position);
    EXPECT_EQ(sphere.velocity, expected.velocity);
    EXPECT_EQ(sphere.spin, expected.spin);
    if (is_data) {
      // A division, a multiplication, and those of the volume.
      constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
      const double mass = std::min(expected.mass, kLargestMagnitude);
      EXPECT_NEAR(sphere.mass, mass, mass * kRounding);
      continue;
    }
    EXPECT_EQ(sphere.mass, expected.mass);
    EXPECT_EQ(sphere.inertia_factor, expected.inertia_factor);
  }
  EXPECT_EQ(read.has_velocities, !is_sph);
  if (is_sph) return;
  EXPECT_EQ(read.has_spins, written.has_spins);
  std::vector<std::int64_t> ids = written.ids;
  if (is_data && ids.front() == 0) {
    for (std::int64_t& id : ids) ++id;
  }
  EXPECT_EQ(read.ids, ids);
  EXPECT_EQ(read.images, written.images);
  const bool has_time = format == SnapshotFormat::extended_xyz ||
                        format == SnapshotFormat::extended_xyz_zst || format == SnapshotFormat::gsd;
  if (has_time) {
    EXPECT_EQ(read.time, written.time);
    EXPECT_EQ(read.box, written.box);
  }
}

class EveryFormat : public testing::TestWithParam<std::string> {
 protected:
  std::filesystem::path path() const { return folder_ / ("file" + GetParam()); }
  SnapshotFormat format() const { return format_of(path()); }
  bool is_read() const { return format() != SnapshotFormat::vtp; }
  // With their bytes.
  std::map<std::filesystem::path, std::string> files() const {
    std::map<std::filesystem::path, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
      if (entry.is_regular_file()) files.emplace(entry.path(), read_text(entry.path()));
    }
    return files;
  }

  ScratchFolder folder_;
};

TEST_P(EveryFormat, KeepsEveryBit) {
  if (!is_read()) GTEST_SKIP() << "only written";
  const World world = motley_world();
  const std::size_t frames = has_single_frame(format()) ? 1 : 40;
  Trajectory trajectory(path());
  for (std::size_t frame = 0; frame < frames; ++frame) {
    trajectory.append(world, Time(0.3 * static_cast<double>(frame)));
  }
  // It is complete before it is closed.
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(path());
  ASSERT_EQ(reader->frames(), frames);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    SCOPED_TRACE(frame);
    expect_same(reader->read(frame), snapshot_of(world, Time(0.3 * static_cast<double>(frame))), format());
  }
  expect_same(reader->read(0), snapshot_of(world, Time(0)), format());
}

TEST_P(EveryFormat, KeepsFramesOfChangingSpheres) {
  if (!is_read() || has_single_frame(format())) GTEST_SKIP() << "only written, or has a single frame";
  World world(Box::periodic({10, 10, 10}));
  for (int i = 0; i < 5; ++i) world.add({.position = {i + 0.5, 1, 1}, .radius = 0.125});
  std::vector<Snapshot> written;
  Trajectory trajectory(path());
  const auto append = [&] {
    written.push_back(snapshot_of(world, Time(static_cast<double>(written.size()))));
    trajectory.append(written.back());
  };
  append();
  SphereEdit(world, Time(1), 1).reshape(1, 0.25, 2, 0.4);
  append();
  world.remove(3);
  append();
  SphereEdit(world, Time(3), 0).store_spin(0, {1, 2, 3});
  append();
  for (const SphereId id : {0U, 1U, 2U, 4U}) world.remove(id);
  append();
  trajectory.close();
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(path());
  ASSERT_EQ(reader->frames(), written.size());
  for (std::size_t frame = 0; frame + 1 < written.size(); ++frame) {
    SCOPED_TRACE(frame);
    expect_same(reader->read(frame), written[frame], format());
  }
  EXPECT_TRUE(reader->read(written.size() - 1).spheres.empty());
}

TEST_P(EveryFormat, GoesOnFromAPosition) {
  if (has_single_frame(format())) GTEST_SKIP() << "has a single frame";
  const World world = motley_world();
  const std::size_t frames = 30;
  const auto append = [&](Trajectory& trajectory, std::size_t frame) {
    trajectory.append(world, Time(0.3 * static_cast<double>(frame)));
  };
  const std::filesystem::path undisturbed = folder_ / ("undisturbed" + GetParam());
  Trajectory whole(undisturbed);
  for (std::size_t frame = 0; frame < frames; ++frame) append(whole, frame);
  whole.close();
  for (const std::size_t cut : {0U, 1U, 7U, 29U, 30U}) {
    SCOPED_TRACE(cut);
    TrajectoryPosition position;
    {
      Trajectory first(path());
      for (std::size_t frame = 0; frame < frames; ++frame) {
        if (frame == cut) position = first.position();
        append(first, frame);
      }
      if (cut == frames) position = first.position();
      // Killed: not closed.
    }
    EXPECT_EQ(position.frames, cut);
    Trajectory second(path(), position);
    EXPECT_EQ(second.position(), position);
    if (is_read() && cut > 0) {
      EXPECT_EQ(open_snapshots(path())->frames(), cut);
    }
    for (std::size_t frame = cut; frame < frames; ++frame) append(second, frame);
    second.close();
    if (format() == SnapshotFormat::vtp) {
      const auto text = [&](const std::string& name) {
        return read_text(folder_ / (name + "/00000029.vtp"));
      };
      EXPECT_EQ(text("file"), text("undisturbed"));
      std::string index = read_text(path());
      for (std::size_t at = 0; (at = index.find("file/", at)) != std::string::npos;)
        index.replace(at, 5, "undisturbed/");
      EXPECT_EQ(index, read_text(undisturbed));
    } else {
      EXPECT_TRUE(read_text(path()) == read_text(undisturbed));
    }
  }
}

TEST_P(EveryFormat, RefusesAPositionBeyondItsEnd) {
  if (has_single_frame(format())) GTEST_SKIP() << "has a single frame";
  TrajectoryPosition position;
  {
    Trajectory trajectory(path());
    trajectory.append(motley_world(), Time(0));
    position = trajectory.position();
  }
  TrajectoryPosition beyond = position;
  ++beyond.frames;
  ++beyond.file.bytes;
  EXPECT_THROW(Trajectory(path(), beyond), Error);
  Trajectory::remove(path());
  EXPECT_FALSE(std::filesystem::exists(path()));
  EXPECT_THROW(Trajectory(path(), position), Error);
}

// Whatever bit has changed in a file, it is refused as it is, or the change is undone.
TEST_P(EveryFormat, GoesOnToTheSameBytesOrIsRefusedUntouched) {
  if (has_single_frame(format())) GTEST_SKIP() << "has a single frame";
  const World world = motley_world();
  const auto append = [&](Trajectory& trajectory, int frame) { trajectory.append(world, Time(0.3 * frame)); };
  TrajectoryPosition position;
  {
    Trajectory trajectory(path());
    for (int frame = 0; frame < 4; ++frame) {
      if (frame == 2) position = trajectory.position();
      append(trajectory, frame);
    }
  }
  const std::map<std::filesystem::path, std::string> whole = files();
  std::size_t refused = 0;
  for (const auto& [name, text] : whole) {
    // Each replacement of a collection waits for the disk.
    const std::size_t step = format() == SnapshotFormat::vtp ? text.size() / 3 : 11;
    for (std::size_t at = 0; at < text.size(); at += step) {
      SCOPED_TRACE(name.string() + ", byte " + to_text(at));
      std::string changed = text;
      changed[at] = static_cast<char>(changed[at] ^ (1 << at % 8));
      write_text(name, changed);
      try {
        Trajectory trajectory(path(), position);
        append(trajectory, 2);
        append(trajectory, 3);
        trajectory.close();
        ASSERT_TRUE(files() == whole);
      } catch (const Error&) {
        ++refused;
        ASSERT_TRUE(read_text(name) == changed);
        write_text(name, text);
        ASSERT_TRUE(files() == whole);
      }
    }
  }
  EXPECT_GT(refused, 5U);
}

TEST_P(EveryFormat, IsUntouchedUntilItGoesOn) {
  if (has_single_frame(format())) GTEST_SKIP() << "has a single frame";
  TrajectoryPosition position;
  {
    Trajectory trajectory(path());
    for (int frame = 0; frame < 20; ++frame) {
      if (frame == 3) position = trajectory.position();
      trajectory.append(motley_world(), Time(frame));
    }
  }
  const std::map<std::filesystem::path, std::string> whole = files();
  { const Trajectory opened(path(), position); }
  EXPECT_TRUE(files() == whole);
}

TEST_P(EveryFormat, GoesOnAfterItsLastFrame) {
  const World world = motley_world();
  {
    Trajectory trajectory(path());
    trajectory.append(world, Time(0));
    trajectory.close();
  }
  if (!is_read() || has_single_frame(format())) {
    EXPECT_THROW(Trajectory::after_last_frame(path()), Error);
    return;
  }
  Trajectory::after_last_frame(path()).append(world, Time(0.25));
  const std::filesystem::path whole = folder_ / ("whole" + GetParam());
  Trajectory trajectory(whole);
  for (const double time : {0.0, 0.25}) trajectory.append(world, Time(time));
  trajectory.close();
  EXPECT_EQ(read_text(path()), read_text(whole));
  write_text(path(), read_text(path()) + "words");
  if (format() != SnapshotFormat::gsd) {
    EXPECT_THROW(Trajectory::after_last_frame(path()), Error);
  }
}

TEST_P(EveryFormat, IsRemovedWhole) {
  {
    Trajectory trajectory(path());
    trajectory.append(motley_world(), Time(0));
    trajectory.close();
  }
  Trajectory::remove(path());
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  Trajectory::remove(path());
}

INSTANTIATE_TEST_SUITE_P(All, EveryFormat,
                         testing::Values(".xyz", ".xyz.zst", ".gsd", ".lammpstrj", ".lammpstrj.zst", ".pvd",
                                         ".csv", ".npy", ".sph", ".data"),
                         [](const testing::TestParamInfo<std::string>& test) {
                           std::string name;
                           for (const char c : test.param)
                             if (c != '.') name += c;
                           return name;
                         });

TEST(Trajectory, ReplacesAnEarlierOneAndLeavesOtherFilesAlone) {
  const ScratchFolder folder;
  for (const int frames : {3, 1}) {
    Trajectory trajectory(folder / "run.pvd");
    for (int i = 0; i < frames; ++i) trajectory.append(motley_world(), Time(0));
    if (frames == 3) write_text(folder / "run/notes.txt", "mine");
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "run/00000000.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run/00000001.vtp"));
  EXPECT_EQ(read_text(folder / "run/notes.txt"), "mine");
}

TEST(Trajectory, RemovesNoFramesThatItHasNotListed) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "run");
  write_text(folder / "run/00000000.vtp", "mine");
  Trajectory::remove(folder / "run.pvd");
  EXPECT_EQ(read_text(folder / "run/00000000.vtp"), "mine");
}

TEST(Trajectory, NeedsANameThatSaysItsFormat) {
  EXPECT_THROW(Trajectory("trajectory.dcd"), Error);
  EXPECT_THROW(Trajectory("trajectory"), Error);
}

// A kill leaves what was written before it: of a frame, some or all of the chunks with or without the index
// that has moved behind them, and then the entries or the header. The index moves with frames 14 and 32.
TEST(Trajectory, OfGsdKilledAtAnyWriteGoesOnToTheSameBytes) {
  constexpr std::uint64_t kFrames = 36;
  const ScratchFolder folder;
  const World world = motley_world();
  const auto append = [&](Trajectory& trajectory, std::uint64_t frame) {
    trajectory.append(world, Time(0.3 * static_cast<double>(frame)));
  };
  std::vector<std::string> bytes;                         // after each frame
  std::map<std::uint64_t, TrajectoryPosition> positions;  // by the number of frames before
  std::set<std::uint64_t> index_locations;
  {
    Trajectory trajectory(folder / "run.gsd");
    for (std::uint64_t frame = 0;; ++frame) {
      bytes.push_back(read_text(folder / "run.gsd"));
      if (std::set<std::uint64_t>{0, 1, 13, 14, 31, 33}.contains(frame))
        positions[frame] = trajectory.position();
      index_locations.insert(gsd::File(folder / "run.gsd").header().index_location);
      if (frame == kFrames) break;
      append(trajectory, frame);
    }
  }
  ASSERT_EQ(index_locations.size(), 3U);
  const auto expect_to_go_on = [&](std::uint64_t from, const std::string& killed) {
    write_text(folder / "killed.gsd", killed);
    Trajectory trajectory(folder / "killed.gsd", positions.at(from));
    for (std::uint64_t frame = from; frame < kFrames; ++frame) append(trajectory, frame);
    trajectory.close();
    ASSERT_TRUE(read_text(folder / "killed.gsd") == bytes.back());
  };
  for (const auto& [from, position] : positions) {
    for (std::uint64_t frame = from; frame < kFrames; frame += frame % 14 < 3 ? 1 : 5) {
      SCOPED_TRACE("checkpoint at frame " + to_text(from) + ", killed in frame " + to_text(frame));
      const std::string& before = bytes[frame];
      const std::string& after = bytes[frame + 1];
      const std::size_t added = after.size() - before.size();
      for (const std::size_t written : {std::size_t{0}, std::size_t{1}, added / 2, added}) {
        expect_to_go_on(from, before + after.substr(before.size(), written));
      }
    }
    expect_to_go_on(from, bytes.back());
    // Killed while it was cut back: with the index that it had, with the header, too, or shortened as well.
    const std::string& then = bytes[from];
    const gsd::Header header = gsd::header_at(then.data());
    const std::size_t length = header.index_entries * gsd::Entry::kBytes;
    std::string killed = bytes.back();
    killed.replace(header.index_location, length, then, header.index_location, length);
    expect_to_go_on(from, killed);
    expect_to_go_on(from, then + bytes.back().substr(then.size()));
    expect_to_go_on(from, then);
    write_text(folder / "killed.gsd", bytes.back());
    EXPECT_EQ(Trajectory(folder / "killed.gsd", position).position(), position);
    EXPECT_TRUE(read_text(folder / "killed.gsd") == then);
  }
}

World world_in_shear() {
  Box box = Box::periodic({6, 5, 7});
  box.set_shear({.rate = 0.3, .offset = 1});
  World world(box);
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    world.add({.position = {6 * random.uniform(), 5 * random.uniform(), 7 * random.uniform()},
               .velocity = random.direction(),
               .radius = 0.01});
  }
  return world;
}

// In the cell of a sheared box, tilted as images are displaced, centers and image flags give what has never
// been folded.
TEST(Trajectory, TiltsTheCellOfAShearedBox) {
  const World world = world_in_shear();
  for (const double time : {0.0, 1.2, 7.0, 1000.0}) {
    const Snapshot snapshot = snapshot_of(world, Time(time));
    const SnapshotBox& box = *snapshot.box;
    EXPECT_NEAR(std::remainder(box.tilt - world.box().images().displacement(Time(time)).high, 6), 0, 1e-9);
    EXPECT_LE(std::fabs(box.tilt), 3);
    for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
      const Vec3& position = snapshot.spheres[i].position;
      const double along = position.x - (box.corner().x + box.tilt * position.y / 5);
      ASSERT_GE(along, -1e-12);
      ASSERT_LE(along, 6 + 1e-12);
      const Image& image = snapshot.images[i];
      const Vec3 unfolded =
          position + Vec3{image[0] * 6.0 + image[1] * box.tilt, image[1] * 5.0, image[2] * 7.0};
      const Slot slot = world.slot_of(static_cast<SphereId>(snapshot.ids[i]));
      ASSERT_LT(length(unfolded - unwrapped_position(world, slot, Time(time))), 1e-9);
    }
  }
}

TEST(Trajectory, ReadsTiltedCells) {
  const ScratchFolder folder;
  const World world = world_in_shear();
  const Snapshot written = snapshot_of(world, Time(7));
  ASSERT_NE(written.box->tilt, 0);
  for (const char* name : {"tilted.xyz", "tilted.lammpstrj", "tilted.gsd", "tilted.data"}) {
    SCOPED_TRACE(name);
    Trajectory(folder / name).append(world, Time(7));
    const Snapshot read = open_snapshots(folder / name)->read(0);
    ASSERT_TRUE(read.box);
    EXPECT_NEAR(read.box->tilt, written.box->tilt, 1e-6);
    EXPECT_LT(length(read.box->low - written.box->low), 1e-6);
    EXPECT_LT(length(read.box->size - written.box->size), 1e-6);
    ASSERT_EQ(read.spheres.size(), written.spheres.size());
    for (std::size_t i = 0; i < read.spheres.size(); ++i) {
      EXPECT_EQ(read.spheres[i].position, written.spheres[i].position);
      EXPECT_EQ(read.images[i], written.images[i]);
    }
  }
  write_text(
      folder / "triclinic.lammpstrj",
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1 0\n0 1 0.5\n"
      "0 1 0\nITEM: ATOMS id x y z vx vy vz radius\n");
  EXPECT_THROW(open_snapshots(folder / "triclinic.lammpstrj")->read(0), Error);
}

TEST(LammpsDump, IsRefusedWhereItDoesNotSayHowTheBoxEnds) {
  const ScratchFolder folder;
  const auto box_of = [&](const std::string& boundaries) {
    write_text(folder / "dump.lammpstrj", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS" +
                                              boundaries +
                                              "\n0 1\n0 1\n0 1\nITEM: ATOMS id x y z vx vy vz radius\n");
    return *open_snapshots(folder / "dump.lammpstrj")->read(0).box;
  };
  EXPECT_EQ(box_of(" pp ff pp").is_periodic, (std::array{true, false, true}));
  EXPECT_FALSE(box_of(" pp ff fm").is_periodic[2]);
  EXPECT_TRUE(box_of(" pp ff fm").is_unbounded);
  for (const char* const unknown :
       {"", " pp pp", " pp pp yes", " pf pp pp", " pp fp ff", " pp pp p", " periodic ff ff"}) {
    EXPECT_THROW(box_of(unknown), Error) << unknown;
  }
}

TEST(Trajectory, KeepsSpheresWithinTheBoxInSinglePrecision) {
  const ScratchFolder folder;
  World world(Box::periodic({10, 10, 10}));
  world.add({.position = {std::nextafter(10.0, 0.0), 0, 5}, .radius = 0.5});
  Trajectory trajectory(folder / "run.gsd");
  trajectory.append(world, Time(0));
  gsd::File file(folder / "run.gsd");
  const std::string bytes = file.read(*file.find(0, "particles/position"));
  const auto coordinate = [&](std::size_t axis) {
    return std::bit_cast<float>(read_little_endian<std::uint32_t>(&bytes[4 * axis]));
  };
  EXPECT_LT(coordinate(0), 5.0F);
  EXPECT_GT(coordinate(0), 4.9999F);
  EXPECT_EQ(coordinate(1), -5.0F);
  EXPECT_EQ(coordinate(2), 0.0F);
}

// A GSD file as other programs write it, chunk by chunk, in the order of frames and names.
class GsdChunks {
 public:
  template <class Number>
  void add(std::uint64_t frame, gsd::Chunk chunk, gsd::Type type, std::uint32_t columns,
           const std::vector<Number>& numbers) {
    gsd::Entry entry{frame,   numbers.size() / columns,          kBegin + chunks_.size(),
                     columns, static_cast<std::uint16_t>(chunk), static_cast<std::uint8_t>(type)};
    gsd::append_entry(entries_, entry);
    for (const Number number : numbers) append_little_endian(chunks_, number);
  }
  void add(std::uint64_t frame, gsd::Chunk chunk, std::uint32_t columns, const std::vector<float>& numbers) {
    std::vector<std::uint32_t> bits;
    for (const float number : numbers) bits.push_back(std::bit_cast<std::uint32_t>(number));
    add(frame, chunk, gsd::Type::float32, columns, bits);
  }

  std::string bytes() const {
    std::string names;
    for (const std::string_view name : gsd::kChunkNames) names += std::string(name) + '\0';
    names.resize(kNames);
    std::string index = entries_;
    index.resize(kIndex);
    return gsd::bytes_of(gsd::Header{gsd::kHeaderBytes, kIndex / gsd::Entry::kBytes,
                                     gsd::kHeaderBytes + kIndex, kNames / gsd::kNameBytes}) +
           index + names + chunks_;
  }

 private:
  static constexpr std::size_t kIndex = 32 * gsd::Entry::kBytes;
  static constexpr std::size_t kNames = 16 * gsd::kNameBytes;
  static constexpr std::size_t kBegin = gsd::kHeaderBytes + kIndex + kNames;

  std::string entries_;
  std::string chunks_;
};

Snapshot frame_of(const GsdChunks& chunks, std::size_t frame) {
  const ScratchFolder folder;
  write_text(folder / "other.gsd", chunks.bytes());
  return open_snapshots(folder / "other.gsd")->read(frame);
}

TEST(GsdOfOthers, KeepsTheBoxWhereTheNumberOfSpheresChanges) {
  GsdChunks chunks;
  chunks.add(0, gsd::Chunk::box, 1, {8, 7, 6, 0, 0, 0});
  chunks.add<std::uint32_t>(0, gsd::Chunk::count, gsd::Type::uint32, 1, {2});
  chunks.add(0, gsd::Chunk::position, 3, {-3, 0, 0, 0, 0, 0});
  chunks.add(0, gsd::Chunk::diameter, 1, {0.5, 0.5});
  chunks.add<std::uint32_t>(1, gsd::Chunk::count, gsd::Type::uint32, 1, {3});
  chunks.add(1, gsd::Chunk::position, 3, {-3, 0, 0, 0, 0.5, 0, 2, 2, 2});
  chunks.add(2, gsd::Chunk::position, 3, {-2, 0, 0, 0, 0, 0});
  const Snapshot more = frame_of(chunks, 1);
  ASSERT_TRUE(more.box);
  EXPECT_EQ(more.box->size, (Vec3{8, 7, 6}));
  EXPECT_EQ(more.box->is_periodic, (std::array<bool, kAxes>{true, true, true}));
  ASSERT_EQ(more.spheres.size(), 3U);
  EXPECT_EQ(more.spheres[1].position, (Vec3{4, 4, 3}));
  EXPECT_EQ(more.spheres[1].radius, 0.5);
  EXPECT_EQ(more.spheres[1].mass, 1);
  const Snapshot as_first = frame_of(chunks, 2);
  ASSERT_EQ(as_first.spheres.size(), 2U);
  EXPECT_EQ(as_first.spheres[0].position, (Vec3{2, 3.5, 3}));
  EXPECT_EQ(as_first.spheres[0].radius, 0.25);
}

TEST(GsdOfOthers, HasAUnitCubeWhereItSaysNothing) {
  GsdChunks chunks;
  chunks.add<std::uint32_t>(0, gsd::Chunk::count, gsd::Type::uint32, 1, {1});
  chunks.add(0, gsd::Chunk::position, 3, {0.25, 0, 0});
  const Snapshot snapshot = frame_of(chunks, 0);
  ASSERT_TRUE(snapshot.box);
  EXPECT_EQ(snapshot.box->size, (Vec3{1, 1, 1}));
  EXPECT_EQ(snapshot.spheres.at(0).position, (Vec3{0.75, 0.5, 0.5}));
}

// As the package gsd of Python writes what equals the defaults of the schema, and bonds.
TEST(GsdOfOthers, MayLeaveOutTheOriginAndGiveBondsASign) {
  GsdChunks chunks;
  chunks.add(0, gsd::Chunk::box, 1, {8, 8, 8, 0, 0, 0});
  chunks.add<std::uint32_t>(0, gsd::Chunk::count, gsd::Type::uint32, 1, {1});
  chunks.add<std::uint32_t>(1, gsd::Chunk::count, gsd::Type::uint32, 1, {2});
  chunks.add(1, gsd::Chunk::position, 3, {0, 0, 0, 1, 0, 0});
  chunks.add<std::uint32_t>(1, gsd::Chunk::bond_count, gsd::Type::uint32, 1, {1});
  chunks.add<std::uint32_t>(1, gsd::Chunk::bonds, gsd::Type::int32, 2, {0, 1});
  EXPECT_EQ(frame_of(chunks, 0).spheres.at(0).position, (Vec3{4, 4, 4}));
  EXPECT_EQ(frame_of(chunks, 1).bonds, (std::vector<std::array<std::int64_t, 2>>{{0, 1}}));
}

TEST(GsdOfOthers, IsNotReadWithExactNumbersOfAnotherFrame) {
  GsdChunks chunks;
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  chunks.add(0, gsd::Chunk::box, 1, {8, 8, 8, 0, 0, 0});
  chunks.add<std::uint32_t>(0, gsd::Chunk::count, gsd::Type::uint32, 1, {1});
  chunks.add(0, gsd::Chunk::position, 3, {1, 0, 0});
  chunks.add(0, gsd::Chunk::diameter, 1, {0.5});
  chunks.add<std::uint64_t>(0, gsd::Chunk::size, gsd::Type::float64, 1, {bits(8), bits(8), bits(8)});
  chunks.add<std::uint64_t>(0, gsd::Chunk::exact_position, gsd::Type::float64, 3,
                            {bits(5), bits(4), bits(4)});
  chunks.add<std::uint64_t>(0, gsd::Chunk::exact_radius, gsd::Type::float64, 1, {bits(0.25)});
  chunks.add(1, gsd::Chunk::box, 1, {6, 6, 6, 0, 0, 0});
  chunks.add(1, gsd::Chunk::position, 3, {2, 0, 0});
  chunks.add(1, gsd::Chunk::diameter, 1, {1});
  EXPECT_EQ(frame_of(chunks, 0).spheres.at(0).position, (Vec3{5, 4, 4}));
  const Snapshot later = frame_of(chunks, 1);
  EXPECT_EQ(later.box->size, (Vec3{6, 6, 6}));
  EXPECT_EQ(later.spheres.at(0).position, (Vec3{5, 3, 3}));
  EXPECT_EQ(later.spheres.at(0).radius, 0.5);
}

TEST(GsdOfOthers, IsRefusedWithABoxThatIsNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::vector<float>& box : std::vector<std::vector<float>>{{8, 8, 8, 0, 0.25, 0},
                                                                       {8, 8, 8, 0, 0, 1},
                                                                       {8, 0, 8, 0, 0, 0},
                                                                       {8, 8, -8, 0, 0, 0},
                                                                       {nan, 8, 8, 0, 0, 0},
                                                                       {8, 8, 8, nan, 0, 0}}) {
    GsdChunks chunks;
    chunks.add(0, gsd::Chunk::box, 1, box);
    chunks.add<std::uint32_t>(0, gsd::Chunk::count, gsd::Type::uint32, 1, {1});
    chunks.add(0, gsd::Chunk::position, 3, {0, 0, 0});
    EXPECT_THROW(frame_of(chunks, 0), Error) << testing::PrintToString(box);
  }
}

TEST(Trajectory, OfGsdKeepsBonds) {
  const ScratchFolder folder;
  Snapshot snapshot;
  for (const double x : {1.0, 3.0, 5.0, 7.0}) snapshot.spheres.push_back({.position = {x, 1, 1}});
  snapshot.ids = {2, 3, 5, 9};
  snapshot.box = SnapshotBox{.low = {}, .size = {10, 10, 10}};
  using Bonds = std::vector<std::array<std::int64_t, 2>>;
  const std::vector<Bonds> bonds{{{2, 3}, {5, 9}}, {{2, 3}, {5, 9}}, {{2, 9}}, {}, {{2, 3}, {5, 9}}};
  {
    Trajectory trajectory(folder / "run.gsd");
    for (const Bonds& of_frame : bonds) {
      snapshot.bonds = of_frame;
      trajectory.append(snapshot);
    }
    trajectory.close();
  }
  GsdReader reader(folder / "run.gsd");
  for (std::size_t frame = 0; frame < bonds.size(); ++frame)
    EXPECT_EQ(reader.read(frame).bonds, bonds[frame]) << frame;
  snapshot.bonds = {{2, 4}};
  Trajectory other(folder / "other.gsd");
  EXPECT_THROW(other.append(snapshot), Error);
}

TEST(Trajectory, ReadsSinglePrecisionWhereThereIsNoOther) {
  const ScratchFolder folder;
  World world(Box::periodic({10, 8, 6}));
  world.add({.position = {1, 2, 3}, .velocity = {0.5, 0, -1}, .radius = 0.25, .mass = 3});
  {
    Trajectory trajectory(folder / "run.gsd");
    trajectory.append(world, Time(0));
  }
  // Hides the exact chunks.
  std::string bytes = read_text(folder / "run.gsd");
  for (std::size_t at = 0; (at = bytes.find("log/", at)) != std::string::npos;) bytes.replace(at, 4, "bog/");
  write_text(folder / "run.gsd", bytes);
  const Snapshot snapshot = read_snapshot(folder / "run.gsd");
  ASSERT_EQ(snapshot.spheres.size(), 1U);
  EXPECT_EQ(snapshot.spheres[0].position, (Vec3{1, 2, 3}));
  EXPECT_EQ(snapshot.spheres[0].velocity, (Vec3{0.5, 0, -1}));
  EXPECT_EQ(snapshot.spheres[0].radius, 0.25);
  EXPECT_EQ(snapshot.spheres[0].mass, 3);
  EXPECT_FALSE(snapshot.time);
  EXPECT_EQ(snapshot.box->size, (Vec3{10, 8, 6}));
}

TEST(SnapshotSchedule, NeverSamplesUnlessAsked) {
  EXPECT_TRUE(SnapshotSchedule().is_never());
  EXPECT_EQ(SnapshotSchedule().time(0), SnapshotSchedule::kNoTime);
  EXPECT_EQ(SnapshotSchedule().contacts(0), SnapshotSchedule::kNoContacts);
}

TEST(SnapshotSchedule, IsLinear) {
  const SnapshotSchedule schedule = SnapshotSchedule::every(0.1);
  EXPECT_EQ(schedule.time(0), 0);
  EXPECT_EQ(schedule.time(7), 7 * 0.1);
  EXPECT_EQ(schedule.contacts(7), SnapshotSchedule::kNoContacts);
}

TEST(SnapshotSchedule, TakesTimesThatRoundingPutsPastTheEndForTheEnd) {
  const SnapshotSchedule schedule = SnapshotSchedule::every(0.1);
  ASSERT_GT(3 * 0.1, 0.3);
  EXPECT_EQ(schedule.time(3, 0.3), 0.3);
  EXPECT_GT(schedule.time(4, 0.3), 0.3);
}

TEST(SnapshotSchedule, IsEvenInTheLogarithmOfTime) {
  for (const std::uint64_t per_decade : {1U, 3U, 10U, 1000U}) {
    const SnapshotSchedule schedule = SnapshotSchedule::logarithmic(0.001, per_decade);
    EXPECT_EQ(schedule.time(0), 0);
    EXPECT_EQ(schedule.time(1), 0.001);
    // Decades are exact.
    EXPECT_EQ(schedule.time(1 + 3 * per_decade), 0.001 * 1000);
    EXPECT_EQ(schedule.time(1 + 9 * per_decade), 0.001 * 1e9);
    for (std::uint64_t k = 1; k <= 4 * per_decade; ++k) {
      EXPECT_LT(schedule.time(k - 1), schedule.time(k));
      const double expected =
          0.001 * std::pow(10, static_cast<double>(k - 1) / static_cast<double>(per_decade));
      EXPECT_NEAR(schedule.time(k) / expected, 1, 1e-12);
    }
  }
}

TEST(SnapshotSchedule, EndsWhereTimesOverflow) {
  const SnapshotSchedule schedule = SnapshotSchedule::logarithmic(1, 1);
  EXPECT_EQ(schedule.time(1'000'000'000'000), SnapshotSchedule::kNoTime);
}

TEST(SnapshotSchedule, CountsContacts) {
  const SnapshotSchedule schedule = SnapshotSchedule::every_contacts(1000);
  EXPECT_EQ(schedule.contacts(0), 0U);
  EXPECT_EQ(schedule.contacts(3), 3000U);
  EXPECT_EQ(schedule.time(3), SnapshotSchedule::kNoTime);
  EXPECT_EQ(schedule.contacts(SnapshotSchedule::kNoContacts / 10), SnapshotSchedule::kNoContacts);
}

}  // namespace
}  // namespace hardball::trajectory_test
