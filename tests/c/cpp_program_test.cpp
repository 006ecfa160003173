// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A program in C++ that uses both APIs: the same world has the same history in both.
#include "checks.h"
#include "hardball/hardball.hpp"

namespace {

constexpr char kScenario[] = R"(
[box]
size = [12, 12, 12]
boundary = ["periodic", "wall", "periodic"]
[response]
restitution = 0.9
[thermostat]
kind = "andersen"
temperature = 1
rate = 0.5
[[spheres]]
count = 300
radius = 0.4
placement = "random"
temperature = 1
)";

void a_scenario_has_one_history() {
  const hardball::Scenario scenario = hardball::parse_scenario(kScenario, "scenario.toml");
  hardball::Simulation in_cpp = hardball::make_simulation(scenario, hardball::make_world(scenario));
  in_cpp.run_until(3);
  hb_simulation* in_c = nullptr;
  OK(hb_start_scenario(kScenario, "scenario.toml", nullptr, 0, nullptr, &in_c, nullptr));
  for (int frame = 1; frame <= 30; ++frame) OK(hb_run_until(in_c, frame / 10.0));
  CHECK(hb_collisions(in_c) > 100 && hb_wall_contacts(in_c) > 50);
  CHECK(hb_hash(in_c) == in_cpp.event_log_hash());

  // Each reads what the other saves.
  const std::string saved = in_cpp.save();
  hb_simulation* loaded = nullptr;
  OK(hb_load(saved.data(), saved.size(), &loaded));
  OK(hb_run_until(loaded, 4));
  in_cpp.run_until(4);
  CHECK(hb_hash(loaded) == in_cpp.event_log_hash());
  hb_free(loaded);
  hb_free(in_c);
}

void a_world_has_one_history() {
  hardball::World world(hardball::Box::walls({20, 20, 20}), {0, 0, -1});
  world.set_interactions(hardball::Restitution(0.95, 0.01));
  hb_setting setting = HB_SETTING_INIT;
  for (int axis = 0; axis < 3; ++axis) {
    setting.size[axis] = 20;
    setting.boundary[axis] = HB_BOUNDARY_WALL;
  }
  setting.gravity[2] = -1;
  setting.restitution = 0.95;
  setting.elastic_below = 0.01;
  hb_world* same = nullptr;
  OK(hb_world_new(&setting, &same));
  hardball::Random random(7);
  for (const hardball::Vec3& place :
       hardball::place_on_lattice(world.box(), {{0, 0, 0}, {20, 20, 20}}, 200, 0.5, "here")) {
    const hardball::Vec3 velocity = random.direction();
    world.add({.position = place, .velocity = velocity, .radius = 0.5});
    hb_sphere sphere = HB_SPHERE_INIT;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sphere.position[axis] = place[axis];
      sphere.velocity[axis] = velocity[axis];
    }
    sphere.radius = 0.5;
    OK(hb_world_add(same, &sphere, nullptr));
  }
  hardball::Simulation in_cpp(world);
  hb_simulation* in_c = nullptr;
  OK(hb_start(same, nullptr, &in_c));
  in_cpp.run_until(5);
  OK(hb_run_until(in_c, 5));
  CHECK(hb_collisions(in_c) > 50);
  CHECK(hb_hash(in_c) == in_cpp.event_log_hash());
  hb_free(in_c);
  hb_world_free(same);
}

// A stop function in C++ may throw: the exception ends the run, and does not leave the library.
extern "C" int throw_an_exception(void*) {
  throw 7;
}
void no_exception_leaves_the_library() {
  hb_simulation* simulation = two_spheres();
  hb_limits limits = HB_LIMITS_INIT;
  limits.stop = throw_an_exception;
  CHECK(hb_run(simulation, &limits, nullptr) == HB_BROKEN_INVARIANT);
  CHECK(std::strstr(hb_last_error()->message, "stop function") != nullptr);
  OK(hb_run_until(simulation, 4));
  CHECK(hb_collisions(simulation) == 1);
  hb_free(simulation);

  // So much memory there is not.
  hb_world* world = box_with_walls();
  hb_spheres spheres = HB_SPHERES_INIT;
  const double place[3] = {5, 5, 5};
  spheres.count = 0;
  spheres.positions = {place, 0, HB_F64};
  OK(hb_world_add_many(world, &spheres, nullptr));
  OK(hb_start(world, nullptr, &simulation));
  const hb_id id = 0;
  CHECK(hb_read(simulation, HB_FIELD_MASS, &id, SIZE_MAX / 2, {&spheres, 8, HB_F64}) == HB_NO_MEMORY);
  CHECK(std::strstr(hb_last_error()->problem, "memory") != nullptr);
  hb_free(simulation);
  hb_world_free(world);
}

}  // namespace

int main() {
  a_scenario_has_one_history();
  a_world_has_one_history();
  no_exception_leaves_the_library();
  return 0;
}
