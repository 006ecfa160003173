// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What a closed mesh feels of a gas in equilibrium.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/measurement.hpp"

namespace hardball::mesh_forces_test {
namespace {

constexpr double kRadius = support::kDiameter / 2;
constexpr std::size_t kSpheres = 200;

// The gas of a box with walls in a mesh of the same size.
World gas_in_mesh(double& size) {
  const World gas =
      support::make_gas({.count = kSpheres, .packing_fraction = 0.2, .seed = 25, .boundary = Boundary::wall});
  size = gas.box().size().x;
  const auto mesh = std::make_shared<const Mesh>(box_mesh({size, size, size}));
  World world(Box::open(), {},
              {Surface(MeshShape(mesh, MeshSide::inside), {0.5 * size, 0.5 * size, 0.5 * size})});
  gas.for_each_by_id([&](Slot slot) {
    const Path& path = gas.path(slot);
    world.add({.position = path.position, .velocity = path.velocity, .radius = gas.base_radius(slot)});
  });
  return world;
}

TEST(MeshWithGas, FeelsItsPressureAndNeitherForceNorTorque) {
  double size = 0;
  const World world = gas_in_mesh(size);
  Simulation simulation(world);
  Measures measures({.names = {"wall_forces"}, .face_forces = true});
  simulation.run({.contacts = 400000}, measures);
  const Measurement found = measures.results(simulation.world(), simulation.now()).front();
  const auto expect_zero = [&](const std::string& name) {
    const Quantity& quantity = support::quantity(found, name);
    EXPECT_GT(quantity.error, 0) << name;
    EXPECT_LT(std::fabs(quantity.value), 4 * quantity.error) << name;
  };
  for (const char* const axis : kAxisNames) {
    expect_zero(std::string("mesh_0_force_") + axis);
    expect_zero(std::string("mesh_0_torque_") + axis);
  }
  // The sum rule of wall_pressure_test.cpp.
  const double t = simulation.time();
  const double open = size - 2 * kRadius;
  const double pressure = support::quantity(found, "mesh_0_pressure").value;
  const double expected = 2 * kinetic_energy(world, Time(0)) + simulation.tally().virial() / t;
  const double bound = 4 * std::sqrt(2 * kSpheres * open * open / 4) / t;
  EXPECT_LT(bound, 2e-3 * expected);
  EXPECT_NEAR(3 * pressure * size * size * open, expected, bound);
  // The halves of each side are alike. Successive hits are nearly independent: the factor allows for what
  // they are not, and for the scatter of impulses.
  const std::vector<FaceForces> faces = measures.face_forces(simulation.world(), simulation.now());
  ASSERT_EQ(faces.size(), 1U);
  ASSERT_EQ(faces.front().pressures.size(), 12U);
  for (std::size_t face = 0; face < 12; ++face) {
    const auto hits = static_cast<double>(faces.front().contacts[face]);
    EXPECT_GT(hits, 2000);
    EXPECT_NEAR(faces.front().pressures[face] / pressure, 1, 4 * 1.5 / std::sqrt(hits));
  }
}

}  // namespace
}  // namespace hardball::mesh_forces_test
