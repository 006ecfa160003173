// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Gases between faces of the box that are thermal, rough or move.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"

namespace hardball::faces_test {
namespace {

constexpr Face kFloor = face_of(2, false);
constexpr Face kCeiling = face_of(2, true);

// Spheres of diameter one at a packing fraction of 0.1 or so, at kT = 1.
World gas_between(const FaceProperties& floor, const FaceProperties& ceiling, std::size_t spheres,
                  std::uint64_t seed) {
  const Vec3 size{6, 6, static_cast<double>(spheres) * 0.145};
  Box box({Boundary::periodic, Boundary::periodic, Boundary::wall}, size);
  box.set_face(kFloor, floor);
  box.set_face(kCeiling, ceiling);
  Random random(seed);
  const std::vector<double> radii(spheres, 0.5);
  World world(box);
  for (const Vec3& center : place_randomly(box, {{}, size}, radii, random, "gas")) {
    world.add({.position = center, .velocity = random.normal_vector(kAxes), .radius = 0.5});
  }
  return world;
}

struct Measured {
  Simulation simulation;
  std::vector<Measurement> results;

  const Quantity& quantity(const std::string& name) const {
    const auto has_it = [&](const Measurement& result) { return support::has_quantity(result, name); };
    return support::quantity(*std::ranges::find_if(results, has_it), name);
  }
  const std::vector<double>& column(const std::string& name) const {
    return support::values(support::named(results, "flow_profiles"), name);
  }
};

// After a time in which it forgets its start.
Measured measured(World world, double until, const EngineOptions& options = {}) {
  Simulation simulation(std::move(world), options);
  simulation.run_until(until / 4);
  Measures measures({.names = {"wall_forces", "flow_profiles", "temperature"}, .from = until / 4});
  simulation.run_until(until, measures);
  std::vector<Measurement> results = measures.results(simulation.world(), simulation.now());
  return {std::move(simulation), std::move(results)};
}

// Whether two numbers that should be opposite are, within four standard errors.
void expect_opposite(const Quantity& a, const Quantity& b) {
  EXPECT_GT(a.error, 0);
  EXPECT_LT(std::fabs(a.value + b.value), 4 * std::hypot(a.error, b.error)) << a.name << " and " << b.name;
}

// What the walls gave is what the spheres have.
void expect_balance(const Simulation& simulation) {
  double given = 0;
  double turned_over = simulation.tally().initial_energy();
  for (std::size_t number = 0; number < simulation.tally().wall_count(); ++number) {
    const WallTally wall = simulation.tally().wall(number);
    given += wall.work + wall.heat;
    turned_over += std::fabs(wall.work) + std::fabs(wall.heat);
  }
  const double gained = energy(simulation.world(), simulation.now()) - simulation.tally().initial_energy();
  EXPECT_NEAR(gained, given, 1e-12 * turned_over);
}

TEST(ThermalFaces, OfOneTemperatureBringTheGasToIt) {
  const FaceProperties warm{.material = {.temperature = 2, .seed = 1}};
  const Measured found = measured(gas_between(warm, warm, 80, 1), 1200);
  for (const char* name : {"temperature", "temperature_along_x", "temperature_along_z"}) {
    const Quantity& temperature = found.quantity(name);
    EXPECT_GT(temperature.error, 0);
    EXPECT_LT(temperature.error, 0.1);
    EXPECT_NEAR(temperature.value, 2, 4 * temperature.error) << name;
  }
  const std::vector<double>& local = found.column("temperature_at_z");
  const std::vector<double>& error = found.column("temperature_at_z_error");
  ASSERT_GT(local.size(), 10U);
  for (std::size_t slab = 0; slab < local.size(); ++slab)
    EXPECT_NEAR(local[slab], 2, 5 * error[slab]) << slab;
  EXPECT_NEAR(found.quantity("z_min_heat").value, 0, 4 * found.quantity("z_min_heat").error);
  expect_balance(found.simulation);
}

TEST(ThermalFaces, OfTwoTemperaturesConductHeat) {
  const Measured found = measured(gas_between({.material = {.temperature = 1, .seed = 2}},
                                              {.material = {.temperature = 4, .seed = 2}}, 80, 2),
                                  1200);
  const Quantity& cold = found.quantity("z_min_heat");
  const Quantity& hot = found.quantity("z_max_heat");
  EXPECT_LT(cold.value, -4 * cold.error) << "the gas gives heat to the cold face";
  EXPECT_GT(hot.value, 4 * hot.error);
  expect_opposite(cold, hot);
  EXPECT_EQ(found.quantity("z_min_power").value, 0) << "it does not move";
  // Next to a face the gas has a temperature between those of the faces, and it is hotter at the hotter one,
  // where it is less dense.
  const std::vector<double>& temperature = found.column("temperature_at_z");
  const std::vector<double>& density = found.column("number_density_at_z");
  EXPECT_GT(temperature.front(), 1);
  EXPECT_LT(temperature.back(), 4);
  EXPECT_GT(temperature.back(), temperature.front() + 1);
  EXPECT_LT(density[density.size() - 3], density[2]);
  expect_balance(found.simulation);
}

void expect_couette_flow(const Measured& found, double speed) {
  const Quantity& below = found.quantity("z_min_tangential_force_x");
  const Quantity& above = found.quantity("z_max_tangential_force_x");
  // The faces pull the gas along, and it holds them back.
  EXPECT_GT(below.value, 4 * below.error);
  EXPECT_LT(above.value, -4 * above.error);
  expect_opposite(below, above);
  const double area = 36;
  EXPECT_DOUBLE_EQ(found.quantity("z_max_shear_stress_x").value, above.value / area);
  // A face does the work of the force that it exerts.
  EXPECT_NEAR(found.quantity("z_max_power").value, -speed * above.value,
              1e-9 * std::fabs(speed * above.value));
  const std::vector<double>& flow = found.column("flow_velocity_x_at_z");
  EXPECT_LT(flow.front(), 0);
  EXPECT_GT(flow.front(), -speed) << "it slips";
  EXPECT_GT(flow.back(), 0);
  EXPECT_LT(flow.back(), speed);
  const std::vector<double>& across = found.column("flow_velocity_y_at_z");
  const std::vector<double>& error = found.column("flow_velocity_y_at_z_error");
  EXPECT_NEAR(across.front(), 0, 4 * error.front());
  expect_balance(found.simulation);
}

TEST(MovingFaces, ThatAreThermalMakeCouetteFlow) {
  const Measured found =
      measured(gas_between({.material = {.temperature = 1, .seed = 3}, .velocity = {-2, 0, 0}},
                           {.material = {.temperature = 1, .seed = 3}, .velocity = {2, 0, 0}}, 60, 3),
               1200);
  expect_couette_flow(found, 2);
  // What the faces do by work they take back as heat.
  const Quantity& heat = found.quantity("z_min_heat");
  EXPECT_LT(heat.value, -4 * heat.error);
  const std::vector<double>& temperature = found.column("temperature_at_z");
  EXPECT_GT(temperature[temperature.size() / 2], temperature.front()) << "friction heats the middle";
}

// Rough faces drag rough spheres: without a heat bath the gas becomes ever hotter.
TEST(MovingFaces, ThatAreRoughDragTheGas) {
  const Bounce rough({.tangential_restitution = 0});
  World world = gas_between({.velocity = {-1, 0, 0}}, {.velocity = {1, 0, 0}}, 60, 4);
  Simulation simulation(support::interacting(world, ResponseTable(rough, rough)));
  simulation.run_until(100);
  const WallTally floor = simulation.tally().wall(kFloor);
  const WallTally ceiling = simulation.tally().wall(kCeiling);
  EXPECT_GT(floor.work, 0);
  EXPECT_GT(ceiling.work, 0);
  EXPECT_GT(floor.impulse.x, 0) << "the gas holds the faces back";
  EXPECT_LT(ceiling.impulse.x, 0);
}

// All engines, the paper's among them, see the same faces.
TEST(MovingFaces, GiveOneHistory) {
  const World world = gas_between({.material = {.temperature = 1, .seed = 5}, .velocity = {-1, 0.5, 0}},
                                  {.material = {.restitution = 0.9}}, 40, 5);
  std::uint64_t expected = 0;
  for (const EngineKind engine :
       {EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs, EngineKind::paper}) {
    Simulation simulation(world, {.engine = engine});
    simulation.run_until(20);
    if (expected == 0) expected = simulation.event_log_hash();
    EXPECT_EQ(simulation.event_log_hash(), expected);
  }
}

}  // namespace
}  // namespace hardball::faces_test
