// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/meshes/read_mesh.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "hardball/errors/error.hpp"

namespace hardball::read_mesh_test {
namespace {

std::string problem_of(const auto& read) {
  try {
    static_cast<void>(read());
  } catch (const Error& error) {
    return error.where() + ": " + error.problem();
  }
  return "";
}

// The bytes of a number, least significant first, or last.
template <class Number>
void append(std::string& bytes, Number number, bool is_big = false) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  const bool is_reversed = is_big == (std::endian::native == std::endian::little);
  for (std::size_t i = 0; i < sizeof(Number); ++i) bytes += raw[is_reversed ? sizeof(Number) - 1 - i : i];
}

constexpr const char* kText = R"(solid floor of the hopper
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1.5e0 0 0
   vertex 0 +1 -2
  endloop
 endfacet
endsolid floor of the hopper
solid wall
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 0 1 0
   vertex 0 0 1
  endloop
 endfacet
endsolid wall
)";

TEST(ReadStl, ReadsTextWithItsSolids) {
  const MeshParts parts = mesh_from_stl(kText, "a.stl");
  EXPECT_EQ(parts.triangles.size(), 2U);
  EXPECT_EQ(parts.vertices.size(), 6U);
  EXPECT_EQ(parts.vertices[2], (Vec3{0, 1, -2}));
  EXPECT_EQ(parts.group_names, (std::vector<std::string>{"floor of the hopper", "wall"}));
  EXPECT_EQ(parts.groups, (std::vector<std::uint32_t>{0, 1}));
}

TEST(ReadStl, ReadsBinaryThatBeginsLikeText) {
  std::string bytes = "solid but binary";
  bytes.resize(80, ' ');
  append(bytes, std::uint32_t{1});
  for (const float number : {0.F, 0.F, 1.F, 0.1F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 7.F})
    append(bytes, number);
  append(bytes, std::uint16_t{0});
  const MeshParts parts = mesh_from_stl(bytes, "a.stl");
  ASSERT_EQ(parts.triangles.size(), 1U);
  EXPECT_EQ(parts.vertices[0].x, double{0.1F});
  EXPECT_EQ(parts.vertices[2], (Vec3{0, 1, 7}));
  bytes.pop_back();
  bytes[0] = 'S';
  EXPECT_EQ(problem_of([&] { return mesh_from_stl(bytes, "a.stl"); }),
            "a.stl: this is no STL file: as a binary one it would have 134 bytes, and it has 133");
}

TEST(ReadStl, SaysWhatIsWrongAndWhere) {
  const auto problem = [](const std::string& text) {
    return problem_of([&] { return mesh_from_stl(text, "a.stl"); });
  };
  EXPECT_EQ(problem("solid\nfacet\nvertex 1 2 x\n"), "a.stl, line 3: 'x' is not a number");
  EXPECT_EQ(problem("solid\nendfacet\n"), "a.stl, line 2: a facet has 0 vertices");
  EXPECT_EQ(problem("solid\nvertex 1 2 3\n"), "a.stl, line 2: the file ends within a facet");
  EXPECT_EQ(problem("solid\nendsolid\n"), "a.stl: there are no triangles");
  EXPECT_EQ(problem("solid\nfoo\n"), "a.stl, line 2: 'foo' is no word of an STL file");
}

TEST(ReadObj, ReadsPolygonsLinesAndGroups) {
  const MeshParts parts = mesh_from_obj(
      "# a comment\r\nv 0 0 0\r\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\ng floor\nf 1//1 2//1 3//1 "
      "-1//1\nusemtl belt\nl 1 2 3\n",
      "a.obj");
  EXPECT_EQ(parts.vertices.size(), 4U);
  EXPECT_EQ(parts.triangles, (std::vector<MeshParts::Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 1}, {1, 2, 2}}));
  EXPECT_EQ(parts.group_names, (std::vector<std::string>{"", "floor", "belt"}));
  EXPECT_EQ(parts.groups, (std::vector<std::uint32_t>{1, 1, 2, 2}));
}

TEST(ReadObj, SaysWhatIsWrongAndWhere) {
  const auto problem = [](const std::string& text) {
    return problem_of([&] { return mesh_from_obj(text, "a.obj"); });
  };
  EXPECT_EQ(problem("v 0 0\n"), "a.obj, line 1: '' is not a number");
  EXPECT_EQ(problem("v 0 0 0\nf 1 2 3\n"), "a.obj, line 2: vertex 2 is named, and 1 stand before it");
  EXPECT_EQ(problem("v 0 0 0\nf 1 1\n"), "a.obj, line 2: a face or a line has 2 vertices");
  EXPECT_EQ(problem("v 0 0 0\n"), "a.obj: there are no faces");
}

constexpr const char* kPlyHeader = R"(element vertex 3
property float x
property float y
property float z
property uchar red
element face 2
property list uchar int vertex_indices
property int material
end_header
)";

TEST(ReadPly, ReadsTextAndBothOrdersOfBytesAlike) {
  const std::string text = "ply\nformat ascii 1.0\ncomment none\n" + std::string(kPlyHeader) +
                           "0 0 0 255\n1 0 0 0\n0 1 0.5 9\n\n3 0 1 2 7\n3 2 1 0 4\n";
  const MeshParts expected = mesh_from_ply(text, "a.ply");
  EXPECT_EQ(expected.triangles, (std::vector<MeshParts::Triangle>{{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(expected.vertices[2], (Vec3{0, 1, 0.5}));
  EXPECT_EQ(expected.group_names, (std::vector<std::string>{"4", "7"}));
  EXPECT_EQ(expected.groups, (std::vector<std::uint32_t>{1, 0}));
  for (const bool is_big : {false, true}) {
    std::string bytes =
        std::string("ply\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\n" + kPlyHeader;
    for (const Vec3& vertex : expected.vertices) {
      for (std::size_t axis = 0; axis < kAxes; ++axis)
        append(bytes, static_cast<float>(vertex[axis]), is_big);
      append(bytes, std::uint8_t{3});
    }
    std::int32_t material = 7;
    for (const MeshParts::Triangle& corners : expected.triangles) {
      append(bytes, std::uint8_t{3});
      for (const std::uint32_t corner : corners) append(bytes, static_cast<std::int32_t>(corner), is_big);
      append(bytes, material, is_big);
      material -= 3;
    }
    const MeshParts parts = mesh_from_ply(bytes, "a.ply");
    EXPECT_EQ(parts.triangles, expected.triangles);
    EXPECT_EQ(parts.vertices, expected.vertices);
    EXPECT_EQ(parts.groups, expected.groups);
    bytes.pop_back();
    EXPECT_EQ(problem_of([&] { return mesh_from_ply(bytes, "a.ply"); }),
              "a.ply: the file ends before its last element");
  }
}

TEST(ReadPly, SaysWhatIsWrongAndWhere) {
  const auto problem = [](const std::string& text) {
    return problem_of([&] { return mesh_from_ply("ply\nformat ascii 1.0\n" + text, "a.ply"); });
  };
  EXPECT_EQ(problem("element vertex x\n"), "a.ply, line 3: 'x' is not a number");
  EXPECT_EQ(problem("property float x\n"), "a.ply, line 3: a property stands before all elements");
  EXPECT_EQ(problem("element vertex 1\nproperty real x\n"), "a.ply, line 4: 'real' is no type of a number");
  EXPECT_EQ(problem("element vertex 1\nproperty float x\n"), "a.ply, line 4: the header does not end");
  EXPECT_EQ(problem("element face 1\nproperty list uchar int vertex_index\nend_header\n3 0 1 2\n"),
            "a.ply, line 6: a face names the vertex 0 of 0");
  EXPECT_EQ(problem("element vertex 9\nend_header\n\n"),
            "a.ply, line 5: the file ends before its last element");
}

TEST(ReadMesh, RefusesOtherFiles) {
  EXPECT_EQ(problem_of([] { return read_mesh("a.step"); }), "a.step: the name of a mesh ends in '.step'");
}

}  // namespace
}  // namespace hardball::read_mesh_test
