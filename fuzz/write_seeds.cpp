// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Writes the seeds of the corpora of binary formats, from random worlds, into the folder given.
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "support/random_world.hpp"
#include "support/scratch_folder.hpp"

namespace hardball {
namespace {

using support::RandomWorld;

constexpr std::uint64_t kSeeds = 15;

// The targets that read snapshots, and how the names of such files end.
constexpr std::array<std::pair<const char*, const char*>, 8> kSnapshots{{{"extended_xyz", ".xyz"},
                                                                         {"extended_xyz_zst", ".xyz.zst"},
                                                                         {"gsd", ".gsd"},
                                                                         {"lammps", ".lammpstrj"},
                                                                         {"lammps_data", ".data"},
                                                                         {"csv", ".csv"},
                                                                         {"npy", ".npy"},
                                                                         {"sph", ".sph"}}};

RandomWorld any_world(std::uint64_t seed) {
  if (seed % 3 == 0) return support::make_furnished_world(seed);
  if (seed % 3 == 1) return support::make_responsive_world(seed);
  return support::make_responsive_flat_world(seed);
}

// At most as many contacts as keep the files small.
RunLimits few_contacts(double until) {
  return {.until = Time(until), .contacts = 20, .steps = 10000};
}

// The state of a recording without the checksum of the file, which is another where it is read.
std::string without_checksum(std::string state) {
  constexpr std::size_t kPlace = 4 + 1 + 8;  // after the version, a flag, and the length
  HARDBALL_CHECK(state.at(kPlace) == 1);
  return state.replace(kPlace, 1 + 8, 1, '\0');
}

void write_seeds_of_world(const std::filesystem::path& corpus, const std::string& name,
                          const RandomWorld& made, const std::optional<Thermostat>& thermostat) {
  using support::write_text;
  const support::ScratchFolder folder;
  Simulation simulation(made.world);
  simulation.set_thermostat(thermostat);
  for (const auto& [target, ending] : kSnapshots) {
    Trajectory frames(corpus / target / (name + ending));
    frames.append(simulation.world(), simulation.now());
    frames.close();
  }
  RecordingWriter recording(corpus / "recording" / name, {.has_bodies = true, .name = name},
                            simulation.world());
  simulation.observe(recording_observer(recording, simulation));
  simulation.run(few_contacts(made.until));
  write_text(corpus / "recording_state" / name, without_checksum(recording.save()));
  recording.close(simulation.time());
  const std::string state = simulation.save();
  write_text(corpus / "simulation" / name, state);
  write_checkpoint_file(corpus / "checkpoint" / name,
                        std::vector<CheckpointSection>{{"simulation", state}, {"name", name}, {"none", ""}});
}

// Of each measure in each box, unchanged.
void write_measured_seeds(const std::filesystem::path& corpus) {
  constexpr std::size_t kBoxes = 3;
  for (std::size_t which = 0; which < kBoxes * measure_names().size(); ++which) {
    support::write_text(corpus / "measured_run" / std::to_string(which),
                        std::string(1, static_cast<char>(which)));
  }
}

// Of worlds of all kinds, with any division or engine, and changes.
void write_seeds_of_choices(const std::filesystem::path& corpus) {
  constexpr std::size_t kBytes = 24;
  Random random(kSeeds);
  for (std::uint64_t seed = 0; seed < 2 * kSeeds; ++seed) {
    std::string bytes;
    for (std::size_t k = 0; k < kBytes; ++k) bytes += static_cast<char>(256 * random.uniform() - 128);
    for (const char* target : {"domains", "engines"})
      support::write_text(corpus / target / std::to_string(seed), bytes);
  }
}

}  // namespace
}  // namespace hardball

int main(int count, char** arguments) {
  using namespace hardball;
  if (count != 2) return 2;
  const std::filesystem::path corpus = arguments[1];
  for (const char* target :
       {"checkpoint", "domains", "engines", "measured_run", "recording", "recording_state", "simulation"}) {
    std::filesystem::create_directories(corpus / target);
  }
  for (const auto& [target, ending] : kSnapshots) std::filesystem::create_directories(corpus / target);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RandomWorld made = any_world(seed);
    std::optional<Thermostat> thermostat;
    if (seed % 4 == 0) thermostat = Thermostat(Andersen(1, 5 / made.until), seed);
    if (seed % 4 == 2) thermostat = Thermostat(Heating(1 / made.until, made.until / 5), seed);
    write_seeds_of_world(corpus, "world" + std::to_string(seed), made, thermostat);
  }
  write_measured_seeds(corpus);
  write_seeds_of_choices(corpus);
}
