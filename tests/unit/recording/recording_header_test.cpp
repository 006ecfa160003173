// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/recording_header.hpp"
#include "hardball/world/step_levels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/gas.hpp"
#include "support/interacting.hpp"

namespace hardball::recording_header_test {
namespace {

using support::make_gas;

RecordingHeader header_with(const Interactions& interactions) {
  return recording_header(
      Simulation(support::interacting(make_gas({.count = 20, .packing_fraction = 0.05}), interactions)));
}

TEST(RecordingHeader, BeginsNow) {
  Simulation simulation(make_gas({.count = 20, .packing_fraction = 0.05}), {.engine = EngineKind::cells});
  simulation.run_until(2.5);
  const RecordingHeader header = recording_header(simulation);
  EXPECT_EQ(header.begin, 2.5);
  EXPECT_FALSE(header.until);
  EXPECT_EQ(header.cell_edge, simulation.cell_edges());
  EXPECT_NE(header.cell_edge, Vec3{});
}

TEST(RecordingHeader, HasTheRestitutionIfItIsOneNumber) {
  EXPECT_EQ(header_with({}).restitution, 1);
  EXPECT_EQ(header_with(Restitution(0.75)).restitution, 0.75);
  const auto bounce = [](double restitution) {
    return Bounce({.restitution = ConstantRestitution{restitution}, .contact_duration = 1e-3});
  };
  ResponseTable table(bounce(0.5), bounce(0.25));
  EXPECT_EQ(header_with(table).restitution, 0.5) << "walls are not asked";
  table.set(0, 1, bounce(0.5));
  EXPECT_EQ(header_with(table).restitution, 0.5);
  table.set(1, 2, bounce(0.625));
  EXPECT_TRUE(std::isnan(header_with(table).restitution));
  EXPECT_TRUE(std::isnan(header_with(ResponseTable(Merging())).restitution));
  const Bounce rough({.tangential_restitution = 0});
  EXPECT_TRUE(std::isnan(header_with(ResponseTable(rough)).restitution));
  Simulation simulation(make_gas({.count = 20, .packing_fraction = 0.05}));
  simulation.respond_with([](const Contact& contact) { return contact.before; });
  EXPECT_TRUE(std::isnan(recording_header(simulation).restitution));
  simulation.respond_with(nullptr);
  EXPECT_EQ(recording_header(simulation).restitution, 1);
}

TEST(RecordingHeader, HasBodiesWhereContactsMayChangeThem) {
  EXPECT_EQ(header_with({}).has_bodies, false);
  EXPECT_EQ(header_with(ResponseTable(Bounce(), Bounce())).has_bodies, false);
  ResponseTable table;
  table.set(0, 3, Merging());
  EXPECT_EQ(header_with(table).has_bodies, true);
  EXPECT_EQ(header_with(ResponseTable(Bounce(), Bounce({.tangential_restitution = -0.5}))).has_bodies, true)
      << "walls may be rough";
  Simulation simulation(make_gas({.count = 20, .packing_fraction = 0.05}));
  simulation.respond_with([](const Contact& contact) { return contact.before; });
  EXPECT_EQ(recording_header(simulation).has_bodies, true);
}

TEST(RecordingHeader, HasBonds) {
  StepTable steps;
  const StepTable::Number tether = steps.add_bond(StepPotential({.steps = {{2, 0}}, .is_tether = true}));
  World world(Box::open());
  for (const double x : {0.0, 3.0, 6.0}) world.add({.position = {x, 0, 0}, .radius = 1});
  Interactions interactions;
  interactions.set_steps(steps);
  world.set_interactions(interactions);
  add_bond(world, 2, 1, tether);
  add_bond(world, 0, 1, tether);
  const RecordingHeader header = recording_header(Simulation(world));
  const std::vector<std::array<SphereId, 2>> bonds{{0, 1}, {1, 2}};
  EXPECT_EQ(header.bonds, bonds);
}

TEST(RecordingHeader, HasGravityAndSurfaces) {
  const std::vector<Surface> surfaces{
      {Plane({0, 0, 1}), {1, 2, 3}, {0, 0, 0.25}, {.restitution = 0.5}},
      {OscillatingPlane({1, 0, 0}, 0.125, 2), {-20, 0, 0}},
      {Cylinder({0, 0, 1}, 30), {5, 5, 0}, {}, {.temperature = 2}},
      {HollowSphere(40), {5, 5, 5}},
      {Obstacle(1.5), {9, 9, 9}},
  };
  World world(Box::open(), {0, 0, -2}, surfaces);
  world.add({.position = {5, 5, 5}});
  const RecordingHeader header = recording_header(Simulation(support::interacting(world, Restitution(0.75))));
  EXPECT_EQ(header.gravity, (Vec3{0, 0, -2}));
  using Shape = RecordedSurface::Shape;
  EXPECT_EQ(header.surfaces,
            (std::vector<RecordedSurface>{
                {.shape = Shape::plane, .point = {1, 2, 3}, .velocity = {0, 0, 0.25}, .restitution = 0.5},
                {.shape = Shape::plane,
                 .point = {-20, 0, 0},
                 .direction = {1, 0, 0},
                 .amplitude = 0.125,
                 .frequency = 2,
                 .restitution = 0.75},
                {.shape = Shape::cylinder,
                 .point = {5, 5, 0},
                 .direction = {0, 0, 1},
                 .radius = 30,
                 .temperature = 2,
                 .restitution = 0.75},
                {.shape = Shape::sphere, .point = {5, 5, 5}, .radius = 40, .restitution = 0.75},
                {.shape = Shape::obstacle, .point = {9, 9, 9}, .radius = 1.5, .restitution = 0.75}}));
}

}  // namespace
}  // namespace hardball::recording_header_test
