// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Uses a part of each public header; its exit status says whether all is as expected.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hardball/hardball.hpp"

namespace {

namespace fs = std::filesystem;

// Two equal spheres on one line, a distance of 2 between them, exchange their velocities at time 2.
bool spheres_collide() {
  hardball::World world;
  const hardball::SphereId moving = world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 0.5});
  const hardball::SphereId resting = world.add({.position = {3, 0, 0}, .velocity = {0, 0, 0}, .radius = 0.5});
  hardball::Simulation simulation(world);
  simulation.run_until(4);
  return simulation.counters().collision == 1 && simulation.position(moving).x == 2 &&
         simulation.position(resting).x == 5;
}

bool bad_input_is_refused() {
  try {
    hardball::parse_scenario("box = 1", "bad.toml");
  } catch (const hardball::Error& error) {
    return !error.remedy().empty();
  }
  return false;
}

hardball::Simulation gas() {
  const hardball::Scenario scenario = hardball::parse_scenario(
      R"(
[box]
size = [8, 8, 8]
boundary = ["periodic", "periodic", "wall"]
[[spheres]]
count = 50
radius = 0.5
placement = "random"
temperature = 1
)",
      "gas.toml");
  hardball::Simulation simulation = hardball::make_simulation(scenario, hardball::make_world(scenario));
  simulation.set_thermostat(hardball::Thermostat(hardball::Andersen(1, 0.1)));
  simulation.respond_with(hardball::ResponseTable(hardball::Bounce(hardball::Restitution(0.9))));
  return simulation;
}

// Runs a gas, and reads everything that it writes.
bool files_are_read(const fs::path& folder) {
  hardball::Simulation simulation = gas();
  hardball::Measures measures({.names = {"temperature", "wall_forces"}});
  hardball::NpyEventLog log(folder / "events.npy");
  hardball::RecordingWriter recording(folder / "gas.hbr", hardball::recording_header(simulation),
                                      simulation.world());
  std::uint64_t contacts = 0;
  simulation.on_contact([&](const hardball::Contact& contact) {
    ++contacts;
    log.append(contact);
    recording.record(contact, simulation.world());
  });
  simulation.observe({.change = [&](const hardball::VelocityChange& change) {
    recording.record(change, simulation.world());
  }});
  simulation.run_until(2, measures);
  log.close();
  recording.close(2);
  hardball::Trajectory trajectory(folder / "gas.xyz");
  trajectory.append(simulation.world(), simulation.now());
  trajectory.close();
  hardball::write_checkpoint_file(folder / "gas.hbc",
                                  std::vector<hardball::CheckpointSection>{{"simulation", simulation.save()},
                                                                           {"measures", measures.save()}});

  auto saved = hardball::read_checkpoint_file(folder / "gas.hbc");
  hardball::RecordingReader reader(folder / "gas.hbr");
  reader.verify();
  return hardball::Simulation::load(saved["simulation"]).event_log_hash() == simulation.event_log_hash() &&
         hardball::Measures::load(saved["measures"]).save() == measures.save() &&
         measures.results(simulation.world(), simulation.now()).size() == 2 && log.size() == contacts &&
         hardball::read_snapshot(folder / "gas.xyz").spheres.size() == simulation.size();
}

bool queries_answer() {
  const hardball::Simulation simulation = gas();
  hardball::Random random(1);
  return hardball::audit(simulation.world(), simulation.now()).is_sound() &&
         simulation.ray({4, 4, 4}, random.direction(), 100).has_value() &&
         simulation.clearance(hardball::Vec3{4, 4, 4}).has_value() &&
         hardball::place_on_lattice(simulation.world().box(), {{0, 0, 0}, {8, 8, 8}}, 32, 0.5, "here")
                 .size() == 32;
}

bool theory_answers() {
  const hardball::Simulation simulation = gas();
  double mean_free_time = 0;
  hardball::in_all(hardball::one_process(), [&] {
    mean_free_time = hardball::mean_free_time(hardball::gas_statistics(simulation.world(), simulation.now()));
  });
  return mean_free_time > 0 &&
         hardball::thermal_motion(simulation.world(), simulation.now()).temperature() > 0 &&
         !hardball::FluidTheory().holds() && !hardball::scenario_schema().empty();
}

}  // namespace

int main(int /*count*/, char** arguments) {
  static_assert(HARDBALL_VERSION_MAJOR >= 0);
  const fs::path folder = std::string(arguments[0]) + ".files";
  fs::create_directories(folder);
  const bool as_expected = spheres_collide() && bad_input_is_refused() && files_are_read(folder) &&
                           queries_answer() && theory_answers();
  fs::remove_all(folder);
  return as_expected ? 0 : 1;
}
