// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A run that is saved to a file halfway, and continues in what might be another process, a week later.
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hardball/checkpoint.hpp"
#include "hardball/measures.hpp"
#include "hardball/simulation.hpp"
#include "hardball/world.hpp"

namespace {

void print(const char* what, const hardball::Simulation& simulation, const hardball::Measures& measures) {
  const auto found = measures.results(simulation.world(), simulation.now());
  std::printf("%s: hash %016llx, Z %.17g\n", what,
              static_cast<unsigned long long>(simulation.event_log_hash()),
              found.front().quantities.front().value);
}

}  // namespace

int main() {
  hardball::World world(hardball::Box::periodic({12, 12, 12}));
  for (int i = 0; i < 216; ++i) {
    const hardball::Vec3 site{1.0 + 2 * (i % 6), 1.0 + 2 * (i / 6 % 6), 1.0 + 2 * (i / 36)};
    const double sign = i % 2 == 0 ? 1 : -1;
    world.add({.position = site, .velocity = {sign, sign * (i % 3 - 1), 0.5 * sign}, .radius = 0.6});
  }
  hardball::Simulation simulation(world);
  hardball::Measures measures({.names = {"pressure"}});
  simulation.run_until(20, measures);

  const std::filesystem::path file = std::filesystem::temp_directory_path() / "hardball_example.hbc";
  const std::vector<hardball::CheckpointSection> sections{{"simulation", simulation.save()},
                                                          {"measures", measures.save()}};
  hardball::write_checkpoint_file(file, sections);

  simulation.run_until(40, measures);
  print("at once", simulation, measures);

  const std::map<std::string, std::string> saved = hardball::read_checkpoint_file(file);
  hardball::Simulation loaded = hardball::Simulation::load(saved.at("simulation"), file.string());
  hardball::Measures its_measures = hardball::Measures::load(saved.at("measures"), file.string());
  loaded.run_until(40, its_measures);
  print("resumed", loaded, its_measures);
  std::filesystem::remove(file);
}
