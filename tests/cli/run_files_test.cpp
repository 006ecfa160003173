// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The files of a run, whatever their number and order, cut back to a checkpoint.
#include "apps/cli/run_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::cli::run_files_test {
namespace {

using namespace support;

using Files = std::map<std::string, std::string>;

constexpr std::array kFormats{SnapshotFormat::extended_xyz, SnapshotFormat::extended_xyz_zst,
                              SnapshotFormat::gsd, SnapshotFormat::lammps, SnapshotFormat::vtp};

// By name, with their bytes; without the lock.
Files files_in(const std::filesystem::path& directory) {
  Files files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    const std::string name = entry.path().lexically_relative(directory).string();
    if (entry.is_regular_file() && name != "run.lock") files[name] = read_text(entry.path());
  }
  return files;
}

World two_spheres() {
  World world(Box::periodic({4, 4, 4}));
  world.add({.position = {1, 1, 1}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {3, 3, 3}, .velocity = {0, 1, 0.25}, .radius = 0.25});
  return world;
}

Scenario scenario_of(const std::vector<SnapshotFormat>& formats) {
  Scenario scenario;
  scenario.output.trajectory = formats;
  scenario.measures.names.clear();
  return scenario;
}

// As checkpoints keep it.
FilesState saved(RunFiles& files) {
  FilesState state;
  restore(archived(files.save()), "test", state);
  return state;
}

// Writes `frames` frames; the state after the first `kept`.
FilesState written(const std::filesystem::path& directory, const Scenario& scenario, int kept, int frames) {
  const Simulation simulation(two_spheres());
  RunFiles files(directory, scenario, simulation, false);
  FilesState state;
  for (int frame = 0; frame < frames; ++frame) {
    if (frame == kept) state = saved(files);
    files.write_snapshot(simulation, simulation.time());
  }
  return state;
}

TEST(RunFiles, OfAnyFormatsInAnyOrderAreCutBackToWhatEachOfThemWas) {
  for (unsigned subset = 1; subset < 1U << kFormats.size(); ++subset) {
    std::vector<SnapshotFormat> formats;
    for (std::size_t k = 0; k < kFormats.size(); ++k) {
      if ((subset >> k & 1) != 0) formats.push_back(kFormats[k]);
    }
    const ScratchFolder folder;
    const Scenario in_order = scenario_of(formats);
    const FilesState state = written(folder / "run", in_order, 2, 5);
    const Files whole = files_in(folder / "run");
    ASSERT_GE(whole.size(), formats.size());
    // A file that is taken for another does not hold what is expected of it.
    while (std::ranges::next_permutation(formats).found) {
      EXPECT_NO_THROW(RunFiles(folder / "run", scenario_of(formats), state));
    }
    std::ranges::reverse(formats);
    RunFiles files(folder / "run", scenario_of(formats), state);
    const Simulation simulation(two_spheres());
    for (int frame = 2; frame < 5; ++frame) files.write_snapshot(simulation, simulation.time());
    files.keep_current();
    EXPECT_TRUE(files_in(folder / "run") == whole) << subset;
  }
}

TEST(RunFiles, OfEveryOrderKnowTheirFilesByName) {
  std::vector<SnapshotFormat> formats(kFormats.begin(), kFormats.end());
  std::ranges::reverse(formats);
  const ScratchFolder folder;
  const FilesState state = written(folder / "run", scenario_of(formats), 2, 5);
  const Files whole = files_in(folder / "run");
  RunFiles files(folder / "run", scenario_of(formats), state);
  EXPECT_TRUE(files_in(folder / "run") == whole) << "untouched until something is written";
  const FilesState again = saved(files);
  ASSERT_EQ(again.trajectories.size(), state.trajectories.size());
  for (const auto& [name, position] : again.trajectories) {
    const auto before =
        std::ranges::find(state.trajectories, name, [](const auto& each) { return each.first; });
    ASSERT_NE(before, state.trajectories.end()) << name;
    EXPECT_EQ(position, before->second) << name;
  }
}

}  // namespace
}  // namespace hardball::cli::run_files_test
