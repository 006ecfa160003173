// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// How often points of a gas meet the features of a mesh, which is known exactly.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "hardball/interaction/passing.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/world/walls.hpp"

namespace hardball::meshes_test {
namespace {

// Spheres that pass through each other keep the uniform distribution around a cube with which they start,
// whether they mix or not. So they meet each part of its surface, seen from their centers, in proportion to
// its area: faces of 6 a^2, quarters of cylinders of 6 pi a r in all, and the octants of a sphere of 4 pi
// r^2. The centers have the volume L^3 less that of the cube with all within r of it. Source: Steiner's
// formula.
TEST(Cube, IsMetAtFacesEdgesAndVerticesByTheirShares) {
  constexpr double kEdge = 1.5;
  constexpr double kRadius = 0.4;
  constexpr double kPeriod = 4;
  constexpr double kPi = std::numbers::pi;
  const auto mesh = std::make_shared<const Mesh>(box_mesh({kEdge, kEdge, kEdge}));
  const Surface cube(MeshShape(mesh, MeshSide::outside), {2.1, 1.7, 0.3});
  World world(Box::periodic({kPeriod, kPeriod, kPeriod}), {}, {cube});
  ResponseTable table;
  table.set(0, 0, Passing());
  world.set_interactions(Interactions(table));
  Random random(17);
  while (world.size() < 200) {
    const Vec3 place{kPeriod * random.uniform(), kPeriod * random.uniform(), kPeriod * random.uniform()};
    if (!is_clear_of_surfaces(world, place, kRadius, Time(0))) continue;
    world.add({.position = place, .velocity = random.direction(), .radius = kRadius, .mass = 1});
  }
  Simulation simulation(world, {.engine = EngineKind::cells});
  std::array<double, 3> hits{};
  double total = 0;
  double tilted = 0;
  const auto faces = static_cast<std::uint32_t>(mesh->triangles().size());
  const auto edges = static_cast<std::uint32_t>(mesh->edges().size());
  simulation.on_contact([&](const Contact& contact) {
    if (contact.is_collision()) return;
    ++total;
    ++hits[contact.feature < faces ? 0 : contact.feature < faces + edges ? 1 : 2];
    if (contact.feature < faces) {
      const Vec3& n = contact.wall_normal;
      tilted = std::max(tilted, 1 - std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}));
    } else if (contact.feature < faces + edges) {
      EXPECT_FALSE(mesh->is_inner(contact.feature - faces)) << "a diagonal";
    }
    EXPECT_LT(std::fabs(contact.overlap()), 1e-13);
  });
  const double duration = 800;
  simulation.run_until(duration);
  const double of_faces = 6 * kEdge * kEdge;
  const double of_edges = 6 * kPi * kEdge * kRadius;
  const double of_vertices = 4 * kPi * kRadius * kRadius;
  const double area = of_faces + of_edges + of_vertices;
  const double volume = kPeriod * kPeriod * kPeriod - kEdge * kEdge * kEdge - of_faces * kRadius -
                        3 * kPi * kEdge * kRadius * kRadius - 4 * kPi / 3 * kRadius * kRadius * kRadius;
  // Successive hits of one sphere are nearly independent; the factor allows for what they are not.
  const auto expect_share = [&](double found, double share) {
    EXPECT_NEAR(found / total, share, 5 * 1.3 * std::sqrt(share * (1 - share) / total));
  };
  expect_share(hits[0], of_faces / area);
  expect_share(hits[1], of_edges / area);
  expect_share(hits[2], of_vertices / area);
  const double expected = static_cast<double>(world.size()) * duration * area / (4 * volume);
  EXPECT_NEAR(total / expected, 1, 0.02);
  EXPECT_LT(tilted, 1e-15);
  for (SphereId id = 0; id < world.size(); ++id) EXPECT_NEAR(length(simulation.velocity(id)), 1, 1e-11);
}

}  // namespace
}  // namespace hardball::meshes_test
