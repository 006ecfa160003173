// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/wall_forces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/interaction/bounce.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/measure/tally.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/world/walls.hpp"
#include "support/measurement.hpp"

namespace hardball::wall_forces_test {
namespace {

using support::has_quantity;
using support::quantity;

constexpr double kEnd = 20;

// The triangles of a box, of which those at both ends along z are groups of their own.
std::shared_ptr<const Mesh> grouped_box(const Vec3& size) {
  MeshParts parts = box_mesh(size);
  parts.group_names = {"sides", "far end", "far_end"};
  for (const MeshParts::Triangle& triangle : parts.triangles) {
    const auto at_end = [&](double sign) {
      return std::ranges::all_of(triangle,
                                 [&](std::uint32_t corner) { return sign * parts.vertices[corner].z > 0; });
    };
    parts.groups.push_back(at_end(-1) ? 1 : at_end(1) ? 2 : 0);
  }
  return std::make_shared<const Mesh>(std::move(parts));
}

MeshShape warm_at_one_end(const std::shared_ptr<const Mesh>& mesh, MeshSide side) {
  MeshShape shape(mesh, side);
  SurfaceMaterial warm{.temperature = 2};
  warm.seed = 3;
  shape.set_group_material("far end", warm);
  return shape;
}

void fill(World& world, const Vec3& middle, const Vec3& room, std::size_t count) {
  Random random(5);
  const double radius = 0.3;
  while (world.size() < count) {
    const Vec3 place = middle + Vec3{room.x * (random.uniform() - 0.5), room.y * (random.uniform() - 0.5),
                                     room.z * (random.uniform() - 0.5)};
    bool is_free = is_clear_of_surfaces(world, place, radius, Time(0));
    for (Slot slot = 0; slot < world.size(); ++slot)
      is_free = is_free && length(world.path(slot).position - place) > 2 * radius;
    if (is_free) world.add({.position = place, .velocity = random.normal_vector(kAxes), .radius = radius});
  }
}

// Smooth spheres that fall in a box that moves, around an obstacle at rest.
World moving_world() {
  const Vec3 size{5, 4, 3};
  const Vec3 middle{20, -10, 3};
  World world(Box::open(), {0, 0, -0.2},
              {Surface(warm_at_one_end(grouped_box(size), MeshSide::inside), middle, {0.05, 0.04, -0.03}),
               Surface(Obstacle(0.5), middle + Vec3{0.5, 0, 0})});
  fill(world, middle, size, 12);
  return world;
}

// A box around which rough spheres move, and whose images lie across the borders of a periodic box.
World periodic_world() {
  const Vec3 size{3, 1.5, 2.4};
  const Vec3 period{5, 5, 5};
  World world(Box::periodic(period), {},
              {Surface(warm_at_one_end(grouped_box(size), MeshSide::outside), {4.8, 0.1, 4.9})});
  // So that spheres do not overlap across the borders.
  fill(world, 0.5 * period, 0.88 * period, 30);
  const Bounce rough({.tangential_restitution = 0.5});
  world.set_interactions(Interactions(ResponseTable(rough, rough)));
  return world;
}

// What the contacts with a wall sum up to, one after the other.
struct Sums {
  double contacts = 0;
  ExactSum normal;
  std::array<ExactSum, kAxes> impulse;
  std::array<ExactSum, kAxes> angular;
  ExactSum work;
  ExactSum heat;
};

struct Found {
  Simulation simulation;
  std::vector<Sums> groups;  // of the mesh, then the whole
  std::vector<Sums> faces;
  Measurement forces;
  std::vector<FaceForces> of_faces;
};

Found observed(const World& world, const EngineOptions& options = {},
               const MeasureSettings& settings = {.names = {"wall_forces"}, .face_forces = true}) {
  Simulation simulation(world, options);
  const Surface& surface = world.surfaces()[0];
  const Mesh& mesh = surface.mesh()->mesh();
  std::vector<Sums> groups(mesh.group_count() + 1);
  std::vector<Sums> faces(mesh.triangles().size());
  simulation.on_contact([&](const Contact& contact) {
    if (contact.is_collision() || contact.second != kFaces) return;
    const Vec3 impulse = -1 * contact.impulse();
    // By the path of the point of the mesh and its nearest image, as the mesh is smaller than half a period.
    const Vec3 place = surface.point() + contact.time.value() * surface.velocity();
    Vec3 arm = contact.point() - place;
    for (std::size_t axis = 0; axis < kAxes && world.box().is_periodic(axis); ++axis)
      arm[axis] -= world.box().size()[axis] * std::round(arm[axis] / world.box().size()[axis]);
    EXPECT_LT(length(contact.wall_arm - arm), 1e-12);
    const std::uint32_t triangle = mesh.triangle_of(contact.feature);
    EXPECT_EQ(contact.triangle, triangle);
    EXPECT_EQ(contact.group, mesh.group(triangle));
    const auto square = [](const Vec3& vector) { return dot(vector, vector); };
    const double moment =
        contact.first_inertia_factor * contact.first_mass * contact.first_radius * contact.first_radius;
    const double gained =
        contact.first_mass / 2 * (square(contact.after.first) - square(contact.before.first)) +
        moment / 2 * (square(contact.spins_after.first) - square(contact.spins_before.first));
    const double work = -dot(impulse, surface.velocity());
    for (Sums* const sums : {&groups[contact.group], &groups.back(), &faces[triangle]}) {
      ++sums->contacts;
      sums->normal += dot(impulse, contact.wall_normal);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        sums->impulse[axis] += impulse[axis];
        sums->angular[axis] += cross(arm, impulse)[axis];
      }
      sums->work += work;
      sums->heat += gained - work;
    }
  });
  Measures measures(settings);
  simulation.run_until(kEnd, measures);
  Measurement forces = measures.results(simulation.world(), simulation.now()).front();
  std::vector<FaceForces> of_faces = measures.face_forces(simulation.world(), simulation.now());
  return {std::move(simulation), std::move(groups), std::move(faces), std::move(forces), std::move(of_faces)};
}

void expect_tally(const WallTally& tally, const Sums& sums) {
  EXPECT_EQ(static_cast<double>(tally.contacts), sums.contacts);
  EXPECT_NEAR(tally.normal_impulse, sums.normal.value(), 1e-10);
  EXPECT_NEAR(tally.work, sums.work.value(), 1e-10);
  EXPECT_NEAR(tally.heat, sums.heat.value(), 1e-9);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_NEAR(tally.impulse[axis], sums.impulse[axis].value(), 1e-10);
    EXPECT_NEAR(tally.angular_impulse[axis], sums.angular[axis].value(), 1e-10);
  }
}

void expect_measured(const Measurement& found, const std::string& name, const Sums& sums) {
  const auto expect = [&](const std::string& what, double sum) {
    if (sum == 0 && !has_quantity(found, name + what)) return;
    EXPECT_NEAR(quantity(found, name + what).value, sum / kEnd, 1e-10) << name << what;
  };
  EXPECT_EQ(quantity(found, name + "_contacts").value, sums.contacts);
  expect("_force", sums.normal.value());
  expect("_power", sums.work.value());
  expect("_heat", sums.heat.value());
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    expect(std::string("_force_") + kAxisNames[axis], sums.impulse[axis].value());
    expect(std::string("_torque_") + kAxisNames[axis], sums.angular[axis].value());
  }
}

const std::vector<std::string> kGroups{"mesh_0_sides", "mesh_0_group_1", "mesh_0_group_2", "mesh_0"};

TEST(ForcesOnMeshes, AreSumsOverContacts) {
  for (const World& world : {moving_world(), periodic_world()}) {
    const Found found = observed(world);
    EXPECT_GT(found.groups.back().contacts, 60);
    const Tally& tally = found.simulation.tally();
    ASSERT_EQ(tally.group_count(kFaces), 3U);
    for (std::size_t group = 0; group < 3; ++group) {
      EXPECT_GT(found.groups[group].contacts, 3);
      expect_tally(tally.wall(kFaces, group), found.groups[group]);
    }
    expect_tally(tally.wall(kFaces), found.groups.back());
    for (std::size_t k = 0; k < kGroups.size(); ++k)
      expect_measured(found.forces, kGroups[k], found.groups[k]);
  }
}

// The sums are exact, so those of the groups are those of the whole, in whichever order they are added.
TEST(ForcesOnMeshes, OfGroupsAreThoseOfTheWhole) {
  const Found found = observed(moving_world());
  const Tally& tally = found.simulation.tally();
  std::uint64_t contacts = 0;
  Vec3 angular;
  double heat = 0;
  for (std::size_t group = 0; group < 3; ++group) {
    contacts += tally.wall(kFaces, group).contacts;
    angular += tally.wall(kFaces, group).angular_impulse;
    heat += tally.wall(kFaces, group).heat;
  }
  const WallTally whole = tally.wall(kFaces);
  EXPECT_EQ(contacts, whole.contacts);
  EXPECT_NEAR(heat, whole.heat, 1e-13 * std::fabs(heat));
  EXPECT_LT(length(angular - whole.angular_impulse), 1e-14 * length(whole.angular_impulse));
}

TEST(ForcesOnMeshes, OfAnyOrderAreTheSameBits) {
  Simulation simulation(moving_world());
  std::vector<Contact> contacts;
  Tally whole;
  whole.begin(simulation.world(), Time(0));
  simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
  simulation.run_until(kEnd);
  Tally parts = whole;
  Tally odd = whole.part();
  for (std::size_t k = 0; k < contacts.size(); ++k) whole.record(contacts[k]);
  for (std::size_t k = contacts.size(); k-- > 0;) (k % 2 == 0 ? parts : odd).record(contacts[k]);
  parts.add(odd);
  for (std::size_t wall = 0; wall < whole.wall_count(); ++wall) {
    for (std::size_t group = 0; group < whole.group_count(wall); ++group) {
      const WallTally a = whole.wall(wall, group);
      const WallTally b = parts.wall(wall, group);
      EXPECT_EQ(a.contacts, b.contacts);
      EXPECT_EQ(a.angular_impulse, b.angular_impulse);
      EXPECT_EQ(a.impulse, b.impulse);
      EXPECT_EQ(a.heat, b.heat);
    }
    EXPECT_EQ(whole.wall(wall).angular_impulse, parts.wall(wall).angular_impulse);
  }
  EXPECT_EQ(archived(whole), archived(parts));
  EXPECT_TRUE(whole.matches(simulation.world()));
  EXPECT_FALSE(whole.matches(periodic_world()));
}

TEST(ForcesOnMeshes, AreTheSameBitsForAllEnginesAndThreads) {
  for (const World& world : {moving_world(), periodic_world()}) {
    const Found one = observed(world, {.engine = EngineKind::all_pairs});
    const auto expect_same = [&](const EngineOptions& options) {
      const Found other = observed(world, options);
      EXPECT_EQ(archived(other.simulation.tally()), archived(one.simulation.tally()));
      EXPECT_EQ(quantities_csv({{other.forces}}), quantities_csv({{one.forces}}));
      ASSERT_EQ(other.of_faces.size(), 1U);
      EXPECT_EQ(vtp_text(other.of_faces[0]), vtp_text(one.of_faces[0]));
    };
    expect_same({.engine = EngineKind::cells});
    expect_same({.engine = EngineKind::neighbors});
    expect_same({.engine = EngineKind::cells, .threads = 2});
  }
}

TEST(ForcesOnFaces, AddUpToThoseOnTheMesh) {
  for (const World& world : {moving_world(), periodic_world()}) {
    const Found found = observed(world);
    ASSERT_EQ(found.of_faces.size(), 1U);
    const FaceForces& forces = found.of_faces[0];
    const Surface& surface = world.surfaces()[0];
    EXPECT_EQ(forces.wall, "mesh_0");
    EXPECT_LT(length(forces.point - (surface.point() + kEnd * surface.velocity())), 1e-12);
    Vec3 force;
    double normal = 0;
    double contacts = 0;
    for (std::size_t triangle = 0; triangle < forces.forces.size(); ++triangle) {
      const Sums& sums = found.faces[triangle];
      const auto& [a, b, c] = forces.mesh->triangles()[triangle];
      const auto corner = [&](std::uint32_t k) { return forces.mesh->vertices()[k]; };
      const double area = length(cross(corner(b) - corner(a), corner(c) - corner(a))) / 2;
      for (std::size_t axis = 0; axis < kAxes; ++axis)
        EXPECT_NEAR(forces.forces[triangle][axis], sums.impulse[axis].value() / kEnd, 1e-12);
      EXPECT_NEAR(forces.pressures[triangle], sums.normal.value() / kEnd / area, 1e-12);
      EXPECT_EQ(static_cast<double>(forces.contacts[triangle]), sums.contacts);
      force += forces.forces[triangle];
      normal += forces.pressures[triangle] * area;
      contacts += static_cast<double>(forces.contacts[triangle]);
    }
    EXPECT_EQ(contacts, quantity(found.forces, "mesh_0_contacts").value);
    EXPECT_NEAR(normal, quantity(found.forces, "mesh_0_force").value, 1e-12);
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      EXPECT_NEAR(force[axis], quantity(found.forces, std::string("mesh_0_force_") + kAxisNames[axis]).value,
                  1e-12);
  }
}

TEST(ForcesOnFaces, AreMeasuredOnRequest) {
  const Found found = observed(periodic_world(), {}, {.names = {"wall_forces"}});
  EXPECT_TRUE(found.of_faces.empty());
  Measures none({.names = {"temperature"}, .face_forces = true});
  none.sample(periodic_world(), Time(0));
  EXPECT_TRUE(none.face_forces(periodic_world(), Time(1)).empty());
}

// The angular momentum about two points differs by their distance times the momentum.
TEST(Torque, IsAboutTheGivenPoint) {
  const Vec3 offset{1, -2, 0.5};
  const World world = moving_world();
  const Found about_point = observed(world);
  const Found about_other = observed(world, {}, {.names = {"wall_forces"}, .torque_about = {{0, offset}}});
  const auto vector = [](const Found& found, const std::string& name) {
    return Vec3{quantity(found.forces, name + "_x").value, quantity(found.forces, name + "_y").value,
                quantity(found.forces, name + "_z").value};
  };
  const Vec3 expected =
      vector(about_point, "mesh_0_torque") - cross(offset, vector(about_point, "mesh_0_force"));
  EXPECT_LT(length(vector(about_other, "mesh_0_torque") - expected), 1e-12);
  EXPECT_THROW(observed(world, {}, {.names = {"wall_forces"}, .torque_about = {{2, offset}}}), Error);
  EXPECT_THROW(Measures({.torque_about = {{0, {0, 0, std::nan("")}}}}), Error);
}

TEST(Torque, OfSmoothSpheresOnAnObstacleIsZero) {
  const Found found = observed(moving_world());
  const WallTally obstacle = found.simulation.tally().wall(kFaces + 1);
  EXPECT_GT(obstacle.contacts, 10U);
  EXPECT_GT(length(obstacle.impulse), 0);
  EXPECT_EQ(obstacle.angular_impulse, Vec3{});
  EXPECT_TRUE(has_quantity(found.forces, "obstacle_1_force_x"));
  EXPECT_FALSE(has_quantity(found.forces, "obstacle_1_torque_x"));
}

// The point of a plane that oscillates stays in the plane.
TEST(Torque, OnAPlaneHasItsArmInThePlane) {
  World world(Box::open(), {0, 0, -1},
              {Surface(oscillating(Plane({0, 0, 1}), 0.1, 0.7), {1, 2, 0}), Surface(Plane({1, 0, 0}), {})});
  world.add({.position = {3, 0, 1}, .velocity = {-0.2, 0.1, 0}, .radius = 0.5});
  Simulation simulation(world);
  std::size_t contacts = 0;
  simulation.on_contact([&](const Contact& contact) {
    ++contacts;
    EXPECT_NEAR(dot(contact.wall_arm, contact.wall_normal), 0, 1e-15);
    const Vec3& point = world.surfaces()[contact.second - kFaces].point();
    const Vec3 away = contact.position - point - contact.wall_arm;
    EXPECT_LT(length(away - dot(away, contact.wall_normal) * contact.wall_normal), 1e-14);
  });
  simulation.run_until(20);
  EXPECT_GT(contacts, 5U);
  EXPECT_NE(simulation.tally().wall(kFaces).angular_impulse, Vec3{});
}

TEST(ForcesOnMeshes, GoOnAfterTheyWereSaved) {
  const World world = moving_world();
  const Found whole = observed(world);
  Simulation simulation(world);
  Measures measures({.names = {"wall_forces"}, .face_forces = true});
  simulation.run_until(kEnd / 2, measures);
  Measures loaded = Measures::load(measures.save());
  simulation.run_until(kEnd, loaded);
  EXPECT_EQ(quantities_csv({{loaded.results(simulation.world(), simulation.now()).front()}}),
            quantities_csv({{whole.forces}}));
  EXPECT_EQ(vtp_text(loaded.face_forces(simulation.world(), simulation.now()).front()),
            vtp_text(whole.of_faces.front()));
  EXPECT_THROW(loaded.check_spheres(periodic_world()), Error);
}

}  // namespace
}  // namespace hardball::wall_forces_test
