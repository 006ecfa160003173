// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The table [box.faces] of a scenario.
#include <gtest/gtest.h>

#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/recording/recording.hpp"
#include "hardball/scenario/make_world.hpp"

namespace hardball::box_faces_test {
namespace {

constexpr Face kFloor = face_of(2, false);
constexpr Face kCeiling = face_of(2, true);

std::string text_with(const std::string& more) {
  return R"([box]
boundary = ["wall", "periodic", "wall"]
size = [10, 10, 10]
[run]
seed = 7
[[spheres]]
count = 3
radius = 0.5
placement = "random"
temperature = 1
)" + more;
}

Box box_of(const std::string& more) {
  return make_world(parse_scenario(text_with(more), "slab.toml")).box();
}

std::string refusal(const std::string& more) {
  try {
    box_of(more);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(BoxFaces, AreReadFromATableOrOneByOne) {
  for (const char* text :
       {"[box.faces]\nz_min = { temperature = 2.0, velocity = [1, 0, 0] }\nz_max = { restitution = 0.5 }",
        "[box.faces.z_min]\ntemperature = 2.0\nvelocity = [1, 0, 0]\n[box.faces.z_max]\nrestitution = 0.5"}) {
    const Box box = box_of(text);
    EXPECT_EQ(box.face(kFloor), (FaceProperties{{.temperature = 2, .seed = 7}, {1, 0, 0}}))
        << "the seed is that of the run";
    EXPECT_EQ(box.face(kCeiling).material.restitution, 0.5);
    EXPECT_FALSE(box.has_own_properties(face_of(0, false)));
  }
  EXPECT_TRUE(box_of("").has_plain_faces());
}

TEST(BoxFaces, AreRefusedWithTheirPlace) {
  const auto expect = [](const std::string& text, const std::string& where, const std::string& what) {
    const std::string found = refusal(text);
    EXPECT_EQ(found.find(where), 0U) << found;
    EXPECT_NE(found.find(what), std::string::npos) << found;
  };
  expect("[box.faces]\ny_min = { temperature = 2.0 }", "slab.toml:12:9", "along y a wall");
  expect("[box.faces]\nz_min = { velocity = [0, 0, 1] }", "slab.toml:12:9", "[[walls]]");
  expect("[box.faces]\nz_min = { temperature = 1, restitution = 1 }", "slab.toml:12:25",
         "remove one of the two");
  expect("[box.faces]\nz_min = { temprature = 1 }", "slab.toml:12:11", "did you mean 'temperature'?");
  expect("[box.faces]\nz_lower = { temperature = 1 }", "slab.toml:12:1", "z_m");
  expect("[box.faces]\nz_min = { restitution = 2 }", "slab.toml:12:25", "restitution is 2");
}

TEST(BoxFaces, AreNamedWhereAPlaneIsHiddenByThem) {
  const std::string found =
      refusal("[[walls]]\nshape = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ntemperature = 2");
  EXPECT_EQ(found.find("slab.toml:11:1"), 0U) << found;
  EXPECT_NE(found.find("[box.faces]"), std::string::npos) << found;
}

TEST(BoxFaces, AreRecorded) {
  const RecordingHeader header{
      .spheres = 1,
      .box = box_of("[box.faces]\nx_max = { restitution = 0.25, velocity = [0, 1, 2] }\n"
                    "z_min = { temperature = 2 }")};
  const Box read = parse_recording_header(to_json(header), "test").box;
  EXPECT_EQ(read.face(face_of(0, true)), (FaceProperties{{.restitution = 0.25}, {0, 1, 2}}));
  EXPECT_EQ(read.face(kFloor).material.temperature, 2);
  EXPECT_FALSE(read.has_own_properties(kCeiling));
  const std::string damaged =
      R"({"spheres": 1, "box": {"size": [1, 1, 1], "boundary": ["wall", "wall", "open"],
    "faces": {"z_min": {"temperature": 2}}}})";
  EXPECT_THROW(parse_recording_header(damaged, "test"), Error);
}

}  // namespace
}  // namespace hardball::box_faces_test
