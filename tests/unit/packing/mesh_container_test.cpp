// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Packings within meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <vector>

#include "hardball/packing/mesh_walls.hpp"
#include "hardball/packing/request_text.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "hardball/world/walls.hpp"
#include "support/packing.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"
#include "support/torus.hpp"

namespace hardball::mesh_container_test {
namespace {

std::shared_ptr<const Mesh> made(MeshParts parts) {
  return std::make_shared<const Mesh>(std::move(parts));
}

// A box from the origin to its size.
std::shared_ptr<const Mesh> box_from_origin(const Vec3& size) {
  MeshParts parts = box_mesh(size);
  for (Vec3& vertex : parts.vertices) vertex += 0.5 * size;
  return made(std::move(parts));
}

Container within(std::shared_ptr<const Mesh> mesh, double scale = 1) {
  return Container::within(std::move(mesh), scale, "a test");
}

template <class Act>
void expect_refused(Act&& act, const std::string& what) {
  const std::string message = support::refusal_of(act);
  EXPECT_NE(message.find(what), std::string::npos) << message;
}

// The least distance of a center from the walls of the container less its radius, over the radius.
double least_gap(const PackedSpheres& spheres) {
  const World world(spheres.container.box(), {}, spheres.container.surfaces());
  double least = 1;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double distance = distance_to_surfaces(world, spheres.positions[i], Time(0));
    least = std::min(least, distance / spheres.radii[i] - 1);
  }
  return least;
}

TEST(MeshContainer, HasTheNumbersOfItsMesh) {
  const Container box = within(box_from_origin({2, 3, 4}));
  EXPECT_EQ(box.volume(), 24);
  EXPECT_NEAR(box.wall_area(), 52, 1e-13);
  EXPECT_GE(box.largest_radius(), 1);
  EXPECT_LT(box.largest_radius(), 1.02);
  EXPECT_EQ(box.free_motions(), 0U);
  EXPECT_FALSE(box.is_periodic(0));
  EXPECT_EQ(box.size, (Vec3{2, 3, 4}));
  const Container ring = within(support::torus(60, 30, 2, 1, {5, -7, 1}), 3);
  EXPECT_NEAR(ring.volume(), 27 * 4 * std::numbers::pi * std::numbers::pi, 0.02 * ring.volume());
  EXPECT_NEAR(ring.volume(), accessible_volume(World(ring.box(), {}, ring.surfaces())),
              1e-14 * ring.volume());
  EXPECT_NEAR(ring.low.z, 3 * (1 - std::sin(2 * std::numbers::pi * 7 / 30)), 0.05);
  EXPECT_GE(ring.largest_radius(), 3 * std::cos(std::numbers::pi / 30));
  EXPECT_LT(ring.largest_radius(), 3 * 1.02);
  EXPECT_NEAR(ring.scaled(0.5).volume(), ring.volume() / 8, 1e-14 * ring.volume());
}

TEST(MeshContainer, IsRefusedWhereNothingIsEnclosed) {
  MeshParts open = box_mesh({1, 1, 1});
  open.triangles.pop_back();
  expect_refused([&] { within(made(open)); }, "not closed");
  MeshParts turned = box_mesh({1, 1, 1});
  std::swap(turned.triangles.front()[1], turned.triangles.front()[2]);
  expect_refused([&] { within(made(turned)); }, "inside out");
  expect_refused([&] { within(made(box_mesh({1, 1, 1})), -1); }, "scale");
  PackingRequest flat = support::jammed_request(10);
  flat.container = within(made(box_mesh({1, 1, 1})));
  flat.dimensions = 2;
  expect_refused([&] { plan(flat); }, "discs do not fit");
}

TEST(MeshContainer, KeepsItsSizeUnlessTheOthersSayHowLargeItIs) {
  PackingRequest request;
  request.container = within(box_from_origin({2, 2, 2}));
  request.is_container_size_free = true;
  request.count = 50;
  request.goal = 0.4;
  const PackingPlan sized = plan(request);
  EXPECT_EQ(sized.follows, PackingPlan::Follows::diameter);
  EXPECT_EQ(sized.container.scale, 1);
  request.diameter = 1;
  const PackingPlan scaled = plan(request);
  EXPECT_EQ(scaled.follows, PackingPlan::Follows::size);
  EXPECT_NEAR(scaled.container.volume(), 50 * std::numbers::pi / 6 / 0.4, 1e-12);
  request.is_container_size_free = false;
  expect_refused([&] { plan(request); }, "edges would have to be");
  request.count.reset();
  request.diameter = 0.3;
  EXPECT_EQ(plan(request).radii.size(), 226U);  // 0.4 * 8 / (pi / 6 * 0.027)
  request.diameter = 2.2;
  request.goal = PackingRequest::Densest{};
  expect_refused([&] { plan(request); }, "the largest diameter");
}

TEST(MeshContainer, IsReadFromATextWithOrWithoutAScale) {
  const support::ScratchFolder folder;
  const std::string file = (folder / "a,b.obj").string();
  std::ofstream(file) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const PackingRequest plain = parse_request({.container = "mesh:" + file}, "--");
  EXPECT_NEAR(plain.container->volume(), 8.0 / 6, 1e-15);
  EXPECT_TRUE(plain.is_container_size_free);
  const PackingRequest scaled = parse_request({.container = "mesh:" + file + ",0.5"}, "--");
  EXPECT_NEAR(scaled.container->volume(), 1.0 / 6, 1e-15);
  EXPECT_FALSE(scaled.is_container_size_free);
  expect_refused([&] { parse_request({.container = "mesh:" + (folder / "none.stl").string()}, "--"); },
                 "none.stl");
  expect_refused([&] { parse_request({.container = "mesh:"}, "--"); }, "mesh:FILE");
  std::ofstream(file) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  expect_refused([&] { parse_request({.container = "mesh:" + file}, "--"); }, "not closed");
}

// The walls of a box of triangles are the faces of a box: as many, as far, in the same direction.
TEST(MeshWalls, OfABoxAreItsFaces) {
  const Vec3 size{2, 3, 2.5};
  Container walled{.size = size, .has_walls = {true, true, true}};
  PackedSpheres by_walls{walled, {}, {}};
  Random random(3);
  constexpr int kSpheres = 300;
  for (int i = 0; i < kSpheres; ++i) {
    Vec3 center;
    // Often in corners, and above diagonals.
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      center[axis] = i % 3 == 0 ? 0.25 * size[axis] : size[axis] * (0.05 + 0.9 * random.uniform());
    by_walls.positions.push_back(center);
    by_walls.radii.push_back(0.5);
  }
  PackedSpheres by_mesh = by_walls;
  by_mesh.container = within(box_from_origin(size));
  const auto walls_of = [](const PackedSpheres& spheres) {
    std::vector<std::tuple<std::uint32_t, double, double, double, double>> walls;
    spheres.for_each_near(0.5, [&](const NearPair& pair) {
      if (!pair.bodies.is_wall) return;
      const Vec3& s = pair.separation;
      walls.emplace_back(pair.bodies.first, pair.gap, s.x, s.y, s.z);
    });
    std::ranges::sort(walls);
    return walls;
  };
  const auto expected = walls_of(by_walls);
  const auto found = walls_of(by_mesh);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_GT(found.size(), 300U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(std::get<0>(found[k]), std::get<0>(expected[k]));
    EXPECT_NEAR(std::get<1>(found[k]), std::get<1>(expected[k]), 1e-15);
    EXPECT_NEAR(std::get<2>(found[k]), std::get<2>(expected[k]), 1e-15);
    EXPECT_NEAR(std::get<3>(found[k]), std::get<3>(expected[k]), 1e-15);
    EXPECT_NEAR(std::get<4>(found[k]), std::get<4>(expected[k]), 1e-15);
  }
}

// The nearest of all walls is as far as the mesh, whatever the feature.
TEST(MeshWalls, ComeAsCloseAsTheMesh) {
  const std::shared_ptr<const Mesh> mesh = support::torus(11, 7, 2, 1);
  const MeshWalls walls(mesh);
  Random random(5);
  int edges = 0;
  for (int turn = 0; turn < 4000; ++turn) {
    const Vec3 center{6 * random.uniform() - 3, 6 * random.uniform() - 3, 2 * random.uniform() - 1};
    if (!mesh->contains(center)) continue;
    const double expected = length(mesh->nearest(center).point - center);
    double least = 10;
    walls.for_each_near(center, 1, [&](const NearWall& wall) {
      EXPECT_NEAR(length(wall.separation), wall.distance.high, 1e-14);
      if (wall.distance.high < least && wall.number >= kFaces + mesh->triangles().size()) ++edges;
      least = std::min(least, wall.distance.high);
    });
    EXPECT_NEAR(least, expected, 1e-14);
  }
  EXPECT_GT(edges, 100);
}

TEST(MeshContainer, IsFilledToTheDensityWanted) {
  PackingRequest request;
  request.container = within(support::torus(24, 12, 2, 1, {10, 20, -30}));
  request.count = 80;
  request.goal = 0.45;
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::reached) << packing.reason;
  EXPECT_NEAR(packing.packing_fraction(), 0.45, 1e-12);
  EXPECT_EQ(packing.largest_overlap, 0);
  EXPECT_GE(least_gap(packing.spheres), -1e-14);
  for (const Vec3& center : packing.spheres.positions) EXPECT_TRUE(request.container->mesh->contains(center));
}

TEST(MeshContainer, TakesTheSizeThatFollows) {
  PackingRequest request = support::jammed_request(20);
  request.rate = 0.1;
  request.container = within(support::torus(7, 5, 2, 1));
  request.is_container_size_free = true;
  request.diameter = 1;
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::jammed) << packing.reason;
  EXPECT_NEAR(packing.spheres.mean_diameter(), 1, 1e-12);
  EXPECT_NE(packing.spheres.container.scale, 1);
  EXPECT_GE(least_gap(packing.spheres), -1e-14);
  EXPECT_GT(packing.network.isostaticity, 0.9);
  EXPECT_LT(packing.network.isostaticity, 1.1);
}

// Forces are known for nearly all contacts with walls, which are those of the mesh as contacts are counted.
TEST(MeshContainer, IsLikeABoxWithWalls) {
  const Vec3 size{5, 4, 4.5};
  const auto mean_of = [&](const Container& container) {
    std::vector<double> sums(4);
    constexpr std::uint64_t kSeeds = 3;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      PackingRequest request = support::jammed_request(60, seed);
      request.rate = 0.1;
      request.container = container;
      const Packing packing = support::pack(request);
      EXPECT_EQ(packing.status, Packing::Status::jammed) << packing.reason;
      double at_walls = 0;
      double force = 0;
      for (const PackingContact& contact : packing.network.contacts) {
        if (!contact.bodies.is_wall) continue;
        ++at_walls;
        force += contact.force;
      }
      EXPECT_GT(force / at_walls, 0.5);
      const std::vector<double> values{packing.packing_fraction(), packing.network.isostaticity, at_walls,
                                       force / at_walls};
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += values[k] / kSeeds;
    }
    return sums;
  };
  const std::vector<double> walls = mean_of({.size = size, .has_walls = {true, true, true}});
  const std::vector<double> mesh = mean_of(within(box_from_origin(size)));
  EXPECT_NEAR(mesh[0], walls[0], 0.01);
  EXPECT_NEAR(mesh[1], walls[1], 0.02);
  EXPECT_NEAR(mesh[2], walls[2], 0.15 * walls[2]);
  EXPECT_NEAR(mesh[3], walls[3], 0.2);
}

TEST(MeshContainer, ResumesToTheSameBits) {
  PackingRequest request = support::jammed_request(10);
  request.container = within(support::torus(5, 4, 2, 1));
  request.rate = 0.2;
  const Packer whole = support::packed(request);
  Packer packer(plan(request));
  for (int k = 0; !packer.is_over(); ++k) {
    if (k % 3 == 2) packer = Packer::load(packer.save(), "a test");
    packer.advance();
  }
  EXPECT_EQ(packer.simulation().event_log_hash(), whole.simulation().event_log_hash());
  EXPECT_EQ(packer.impulses(), whole.impulses());
  const Packing packing = packing_of(packer);
  EXPECT_EQ(packing.spheres.container.volume(), request.container->volume());
  EXPECT_EQ(packing.network.contacts.size(), packing_of(whole).network.contacts.size());
}

// Files have the coordinates of the mesh; in GSD files the origin is the center of the box around it.
TEST(MeshContainer, IsTheOneThatFilesAreIn) {
  const support::ScratchFolder folder;
  PackingRequest request;
  request.container = within(support::torus(7, 5, 2, 1, {10, 20, -30}), 1.5);
  request.count = 40;
  request.goal = 0.35;
  const Packer packer = support::packed(request);
  for (const auto precision : {Precision::doubles, Precision::singles}) {
    const bool single = precision == Precision::singles;
    Packing packing = packing_of(packer);
    finish(packing, packer.plan(), precision);
    EXPECT_EQ(packing.largest_overlap, 0);
    EXPECT_NEAR(packing.packing_fraction(), 0.35, single ? 1e-5 : 1e-12);
    const std::filesystem::path file = folder / (single ? "packing.gsd" : "packing.xyz");
    {
      Trajectory trajectory(file);
      trajectory.append(snapshot_of(packing.spheres));
      trajectory.close();
    }
    const Snapshot written = read_snapshot(file);
    ASSERT_EQ(written.spheres.size(), 40U);
    PackedSpheres read = packing.spheres;
    for (std::size_t i = 0; i < read.size(); ++i) {
      read.positions[i] = written.spheres[i].position;
      read.radii[i] = written.spheres[i].radius;
    }
    EXPECT_GE(least_gap(read), -1e-15);
    EXPECT_EQ(read.largest_overlap(), 0);
  }
}

}  // namespace
}  // namespace hardball::mesh_container_test
