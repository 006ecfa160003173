// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Walls of a scenario that are meshes.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/world/walls.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::scenario_mesh_walls_test {
namespace {

using namespace support;

const std::string kRest = R"([box]
boundary = ["open", "open", "open"]
[[spheres]]
positions = [[50.0, 50.0, 50.0]]
radius = 0.5
speed = 0.0
)";

// The scenario is as if in a folder.
World world_of(const ScratchFolder& folder, const std::string& wall) {
  return make_world(parse_scenario(kRest + "[[walls]]\n" + wall, (folder / "scenario.toml").string()));
}

std::string error_of(const ScratchFolder& folder, const std::string& wall) {
  return refusal_of([&] { world_of(folder, wall); });
}

const MeshShape& mesh_of(const World& world) {
  return *world.surfaces().front().mesh();
}

double distance(const World& world, const Vec3& point) {
  return distance_to_surfaces(world, point, Time(0));
}

TEST(MeshWalls, AreBoxesCapsulesAndPlates) {
  const ScratchFolder folder;
  const World box =
      world_of(folder, "shape = \"box\"\npoint = [1, 2, 3]\nsize = [2, 4, 6]\nspheres = \"inside\"");
  EXPECT_EQ(mesh_of(box).mesh().volume(), 48);
  EXPECT_EQ(distance(box, {1, 2, 3}), 1);
  EXPECT_LT(distance(box, {1, 2, 7}), 0);
  const World capsule =
      world_of(folder, "shape = \"capsule\"\npoint = [0, 0, 0]\nend = [0, 0, 3]\nradius = 0.5");
  EXPECT_EQ(distance(capsule, {2, 0, 1}), 1.5);
  EXPECT_EQ(distance(capsule, {0, 0, 5}), 1.5);
  const World plate = world_of(
      folder, "shape = \"plate\"\npoint = [0, 0, 1]\nedges = [[2, 0, 0], [0, 2, 0]]\nthickness = 0.25");
  EXPECT_EQ(distance(plate, {1, 1, 3}), 1.75);
  EXPECT_EQ(distance(plate, {5, 1, 1}), 2.75);
}

TEST(MeshWalls, AreHeightsOfAGrid) {
  const ScratchFolder folder;
  std::ofstream(folder / "ground.txt") << "# three rows along x\n0, 0\n\n1 1\n0\t0\n";
  const World world =
      world_of(folder, "shape = \"height_field\"\npoint = [10, 0, 0]\nfile = \"ground.txt\"\nspacing = 2");
  const Mesh& mesh = mesh_of(world).mesh();
  EXPECT_EQ(mesh.triangles().size(), 4U);
  EXPECT_EQ(mesh.extent().high, (Vec3{4, 2, 1}));
  EXPECT_EQ(distance(world, {12, 1, 4}), 3) << "above the ridge";
}

TEST(MeshWalls, SayWhatIsWrongWithHeights) {
  const ScratchFolder folder;
  const std::string wall = "shape = \"height_field\"\npoint = [0, 0, 0]\nfile = \"ground.txt\"\nspacing = 1";
  EXPECT_NE(error_of(folder, wall).find("ground.txt"), std::string::npos);
  const auto error_with = [&](const std::string& text) {
    std::ofstream(folder / "ground.txt") << text;
    return error_of(folder, wall);
  };
  EXPECT_NE(error_with("0 0\n1 2 3\n").find("ground.txt, line 2: a row has 3 heights, and the first 2"),
            std::string::npos);
  EXPECT_NE(error_with("0 0\n1 high\n").find("line 2: 'high' is not a number"), std::string::npos);
  EXPECT_NE(error_with("0 0\n").find("at least two full rows"), std::string::npos);
  EXPECT_NE(error_with("").find("at least two full rows"), std::string::npos);
}

TEST(MeshWalls, AreFilesWithGroups) {
  const ScratchFolder folder;
  std::ofstream(folder / "step.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl floor\nf 1 2 3\nusemtl side\nf 1 3 4\n";
  const std::string wall = R"(shape = "mesh"
point = [0, 0, 0]
file = "step.obj"
scale = 2
rotation = [0, 0, 90]
restitution = 0.9
[[walls.groups]]
name = "floor"
restitution = 0.5
)";
  const World world = world_of(folder, wall);
  const Surface& surface = world.surfaces().front();
  EXPECT_EQ(surface.mesh()->mesh().extent().low, (Vec3{-2, 0, 0}));
  EXPECT_EQ(surface.material_of(0).restitution, 0.5);
  EXPECT_EQ(surface.material_of(1).restitution, 0.9);
  EXPECT_NE(error_of(folder, wall + "[[walls.groups]]\nname = \"roof\"\n").find("its groups are floor, side"),
            std::string::npos);
  EXPECT_NE(error_of(folder, "spheres = \"inside\"\n" + wall).find("a mesh is not closed"),
            std::string::npos);
}

}  // namespace
}  // namespace hardball::scenario_mesh_walls_test
