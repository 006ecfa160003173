// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/meshes/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/meshes/exact_sign.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "support/effort.hpp"
#include "support/torus.hpp"

namespace hardball::mesh_test {
namespace {

Vec3 random_point(Random& random, double scale) {
  return scale * Vec3{random.normal(), random.normal(), random.normal()};
}

// As a file of triangles has them, each with vertices of its own.
MeshParts separated(const MeshParts& parts) {
  MeshParts separate;
  for (const MeshParts::Triangle& corners : parts.triangles) {
    const auto first = static_cast<std::uint32_t>(separate.vertices.size());
    for (const std::uint32_t corner : corners) separate.vertices.push_back(parts.vertices[corner]);
    separate.triangles.push_back({first, first + 1, first + 2});
  }
  return separate;
}

TEST(Mesh, OfABoxHasItsFeaturesVolumeAndArea) {
  const Mesh box(separated(box_mesh({2, 3, 4})));
  EXPECT_EQ(box.vertices().size(), 8U);
  EXPECT_EQ(box.edges().size(), 18U);
  EXPECT_EQ(box.triangles().size(), 12U);
  EXPECT_EQ(box.feature_count(), 38U);
  EXPECT_EQ(box.report().welded_vertices, 28U);
  EXPECT_EQ(box.report().components, 1U);
  EXPECT_TRUE(box.is_closed());
  EXPECT_EQ(box.volume(), 24);
  EXPECT_EQ(box.area(), 2 * (6 + 8 + 12));
  const auto inner = static_cast<std::size_t>(
      std::count_if(box.edges().begin(), box.edges().end(),
                    [&, edge = 0U](const Mesh::Edge&) mutable { return box.is_inner(edge++); }));
  EXPECT_EQ(inner, 6U) << "the diagonals of the faces";
}

TEST(Mesh, OfATorusHasItsVolumeWhicheverWayItIsTurned) {
  MeshParts parts = support::torus_parts(90, 40, 2, 1);
  const Mesh outward(parts);
  EXPECT_NEAR(outward.volume(), 4 * std::numbers::pi * std::numbers::pi, 0.3);
  EXPECT_EQ(outward.feature_count(), 7200U + 10800U + 3600U);
  for (MeshParts::Triangle& corners : parts.triangles) std::swap(corners[1], corners[2]);
  EXPECT_EQ(Mesh(parts).volume(), outward.volume());
  std::swap(parts.triangles[7][1], parts.triangles[7][2]);
  const Mesh mixed(parts);
  EXPECT_EQ(mixed.report().flipped_edges, 3U);
  EXPECT_TRUE(std::isnan(mixed.volume()));
  EXPECT_TRUE(mixed.contains({2, 0, 0}));
  EXPECT_FALSE(mixed.contains({0, 0, 0}));
}

TEST(Mesh, KnowsWhatIsInsideEvenBelowItsVerticesAndEdges) {
  const Mesh mesh(support::torus_parts(24, 12, 2, 1));
  std::uint64_t inside = 0;
  Random random(1);
  const auto expect_right = [&](const Vec3& point) {
    const double winding = mesh.winding_number(point);
    // On the surface itself either answer will do.
    if (length(mesh.nearest(point).point - point) < 1e-12) return;
    EXPECT_EQ(mesh.contains(point), winding > 0.5) << point.x << ' ' << point.y << ' ' << point.z;
    EXPECT_NEAR(winding, std::round(winding), 1e-13);
    inside += winding > 0.5 ? 1U : 0U;
  };
  for (std::uint64_t i = 0; i < support::cases(2000); ++i) expect_right(random_point(random, 1.5));
  for (const Vec3& vertex : mesh.vertices()) expect_right({vertex.x, vertex.y, 0.3 * random.normal()});
  for (const Mesh::Edge& edge : mesh.edges()) {
    const Vec3 middle = 0.5 * (mesh.vertices()[edge.low] + mesh.vertices()[edge.high]);
    expect_right({middle.x, middle.y, 0.3 * random.normal()});
  }
  EXPECT_GT(inside, 300U);
}

TEST(Mesh, WithAHoleHasAWindingNumber) {
  MeshParts parts = support::torus_parts(24, 12, 2, 1);
  parts.triangles.erase(parts.triangles.begin() + 5, parts.triangles.begin() + 8);
  const Mesh mesh(parts);
  EXPECT_FALSE(mesh.is_closed());
  EXPECT_TRUE(std::isnan(mesh.volume()));
  EXPECT_GT(mesh.winding_number({0, 2, 0}), 0.9);
  EXPECT_LT(mesh.winding_number({0, 0, 0}), 0.1);
}

TEST(Mesh, FindsTheNearestPointAsAllTrianglesDo) {
  Random random(2);
  const Mesh mesh(support::torus_parts(30, 15, 2, 1));
  for (std::uint64_t i = 0; i < support::cases(1000); ++i) {
    const Vec3 point = random_point(random, 2);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
      MeshParts one;
      for (const std::uint32_t corner : mesh.triangles()[k]) one.vertices.push_back(mesh.vertices()[corner]);
      one.triangles = {{0, 1, 2}};
      if (k % 16 == i % 16) least = std::min(least, length(Mesh(one).nearest(point).point - point));
    }
    EXPECT_LE(length(mesh.nearest(point).point - point), least);
  }
}

TEST(Mesh, HasAClearanceThatIsNotMuchLessThanTheDistance) {
  Random random(4);
  const Mesh mesh(support::torus_parts(30, 15, 2, 1));
  for (std::uint64_t i = 0; i < support::cases(10000); ++i) {
    const Vec3 point = random_point(random, 2);
    const double distance = length(mesh.nearest(point).point - point);
    const double enough = 3 * random.uniform();
    EXPECT_LE(mesh.clearance(point, enough), std::min(distance, enough));
    EXPECT_GE(mesh.clearance(point, enough), std::min(0.75 * distance, enough));
  }
}

TEST(Mesh, IsWeldedAndSplitWhereVerticesLieOnEdges) {
  // Two triangles side by side, opposite to one that is as long as both.
  MeshParts parts{{{0, 0, 0},
                   {2, 0, 0},
                   {1, 2, 0},
                   {0, 0, 0},
                   {1, 0, 0},
                   {0.5, -2, 0},
                   {1, 1e-8, 0},
                   {2, 0, 0},
                   {1.5, -2, 0}},
                  {{0, 1, 2}, {3, 5, 4}, {6, 8, 7}},
                  {0, 1, 1},
                  {"large", "small"}};
  const Mesh exact(parts);
  EXPECT_EQ(exact.report().welded_vertices, 2U);
  EXPECT_EQ(exact.report().split_triangles, 1U);
  const Mesh welded(parts, 1e-6);
  EXPECT_EQ(welded.report().welded_vertices, 3U);
  EXPECT_EQ(welded.report().split_triangles, 1U);
  ASSERT_EQ(welded.triangles().size(), 4U);
  EXPECT_EQ(welded.group(1), 0U);
  EXPECT_EQ(welded.group(2), 1U);
  EXPECT_EQ(welded.report().boundary_edges, 6U);
  EXPECT_EQ(welded.report().flipped_edges, 0U);
}

TEST(Mesh, LeavesOutTrianglesThatAreThereTwice) {
  MeshParts parts{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {3, 0, 0}},
                  {{0, 1, 2}, {2, 0, 3}, {1, 1, 3}, {0, 1, 4}, {4, 0, 0}},
                  {},
                  {}};
  const Mesh mesh(parts);
  EXPECT_EQ(mesh.report().duplicate_triangles, 2U);
  EXPECT_EQ(mesh.report().flat_triangles, 2U);
  ASSERT_EQ(mesh.triangles().size(), 3U);
  // Of equal ones, the first stays.
  EXPECT_EQ(mesh.triangles()[0], (Mesh::Triangle{0, 1, 2}));
  EXPECT_FALSE(mesh.has_area(1));
}

TEST(Mesh, IsRestoredFromAnArchiveAndSharedThere) {
  const Mesh mesh(support::torus_parts(6, 5, 2, 1));
  const auto shared = std::make_shared<const Mesh>(mesh);
  const std::string bytes = archived(shared, shared);
  EXPECT_LT(bytes.size(), archived(shared).size() + 20);
  std::shared_ptr<const Mesh> first;
  std::shared_ptr<const Mesh> second;
  restore(bytes, "test", first, second);
  EXPECT_EQ(first, second);
  EXPECT_EQ(first->volume(), mesh.volume());
  EXPECT_EQ(first->edges().size(), mesh.edges().size());
}

TEST(Mesh, RefusesWhatItCannotBe) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(Mesh(MeshParts{corners, {}, {}, {}}), Error);
  EXPECT_THROW(Mesh(MeshParts{corners, {{0, 1, 3}}, {}, {}}), Error);
  EXPECT_THROW(Mesh(MeshParts{corners, {{1, 1, 1}}, {}, {}}), Error);
  EXPECT_THROW(Mesh(MeshParts{corners, {{0, 1, 2}}, {1}, {}}), Error);
  EXPECT_THROW(Mesh(MeshParts{corners, {{0, 1, 2}}, {0, 0}, {}}), Error);
  EXPECT_THROW(Mesh(MeshParts{corners, {{0, 1, 2}}, {}, {}}, 0.6), Error);
  EXPECT_THROW(Mesh(MeshParts{{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}}, {}, {}}), Error);
}

TEST(ExactSign, IsThatOfTheDeterminantHoweverSmall) {
  const double tiny = 0x1p-52;
  const Vec3 a{0.5, 0.5, 0};
  const Vec3 b{12, 12, 0};
  EXPECT_EQ(orientation_along_z(a, b, {24, 24, 0}), 0);
  EXPECT_EQ(orientation_along_z(a, b, {24, 24 + 32 * tiny, 0}), 1);
  EXPECT_EQ(orientation_along_z(a, b, {24, 24 - 32 * tiny, 0}), -1);
  EXPECT_EQ(orientation_along_z(a, {12, 12 + 8 * tiny, 0}, {24, 24, 0}), -1);
  const Vec3 p{1 + tiny, 1, 1};
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 5, -tiny * tiny}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 5, 0}), 0);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 1, 1}, p, 2 * p), 0);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 1, 1}, {1, 2, 3}, {4, 6, 8}), 0);
  EXPECT_NE(orientation({0, 0, 0}, {1, 1, 1}, {1, 2, 3}, {4 + 4 * tiny, 6, 8}), 0);
}

}  // namespace
}  // namespace hardball::mesh_test
