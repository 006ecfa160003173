// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/sphere_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::sphere_file_test {
namespace {

constexpr const char* kText = R"(# Spheres.
robot_cfg:
  kinematics:
    collision_spheres:
      base_link:
        - "center": [0.0, -0.05, 1e-1]   # a comment
          "radius": 0.08
        - center: [1, 2,
                   3]
          radius: +0.5
      arm:
      - {center: [0.1, 0.2, 0.3], radius: 0.25}
      - radius: 0.125
        center:
        - 4
        - 5
        - 6
      attached_object:
        - center: [0.0, 0.0, 0.0]
          radius: -10.0
      'tool # 1': [{center: [0, 0, 0], radius: 1}]
      camera:
    self_collision_ignore: {
      base_link: ["arm", "camera"], arm: [camera, "tool # 1"]}
    cspace: [a, {b: c}]
)";

TEST(SphereFile, IsReadInAllItsForms) {
  const SphereFile file = parse_spheres(kText, "robot.yml");
  ASSERT_EQ(file.links.size(), 3);
  EXPECT_EQ(file.links[0].name, "base_link");
  ASSERT_EQ(file.links[0].spheres.size(), 2);
  EXPECT_EQ(file.links[0].spheres[0].center, (Vec3{0, -0.05, 0.1}));
  EXPECT_EQ(file.links[0].spheres[0].radius, 0.08);
  EXPECT_EQ(file.links[0].spheres[1].center, (Vec3{1, 2, 3}));
  EXPECT_EQ(file.links[0].spheres[1].radius, 0.5);
  ASSERT_EQ(file.links[1].spheres.size(), 2);
  EXPECT_EQ(file.links[1].spheres[0].center, (Vec3{0.1, 0.2, 0.3}));
  EXPECT_EQ(file.links[1].spheres[1].center, (Vec3{4, 5, 6}));
  EXPECT_EQ(file.links[2].name, "tool # 1") << "the others have no spheres, or placeholders";
  const std::vector<std::pair<std::string, std::string>> ignored{{"base_link", "arm"}, {"arm", "tool # 1"}};
  EXPECT_EQ(file.ignored, ignored);
}

TEST(SphereFile, ComesFromAFile) {
  const support::ScratchFolder folder;
  const auto path = folder / "robot.yml";
  std::ofstream(path) << kText;
  EXPECT_EQ(read_spheres(path).links.size(), 3);
}

TEST(SphereFile, ErrorsNameTheLine) {
  const auto message = [](const std::string& text) {
    const Error error = support::error_of([&] { parse_spheres(text, "robot.yml"); });
    return error.where() + ": " + error.problem();
  };
  EXPECT_EQ(message(""), "robot.yml: there is no table 'collision_spheres'");
  EXPECT_EQ(message("collision_spheres: spheres/a.yml\n"),
            "robot.yml:1: the spheres are in the file 'spheres/a.yml'");
  const std::string head = "collision_spheres:\n  a:\n";
  EXPECT_EQ(message(head + "    - center: [1, 2]\n      radius: 1\n"),
            "robot.yml:3: a sphere has no center of three numbers");
  EXPECT_EQ(message(head + "    - center: [1, 2, 3]\n"), "robot.yml:3: a sphere has no radius");
  EXPECT_EQ(message(head + "    - center: [1, 2, x]\n      radius: 1\n"), "robot.yml:3: 'x' is no number");
  EXPECT_EQ(message(head + "    - center: [1, 2, inf]\n      radius: 1\n"),
            "robot.yml:3: 'inf' is no number");
  EXPECT_EQ(message(head + "    - center: [1, 2, 3\n"), "robot.yml:3: a bracket is not closed");
  EXPECT_EQ(message(head + "    - center: [1, 2, 3]\n     radius: 1\n"),
            "robot.yml:4: a line is indented otherwise than those above");
  EXPECT_EQ(message(head + "\t- center: 1\n"), "robot.yml:3: a tab indents a line");
  EXPECT_EQ(message("collision_spheres: &a\n"), "robot.yml:1: '&a' is a part of YAML that is not understood");
  EXPECT_EQ(message(head + "    center: 1\n"), "robot.yml:3: the spheres of a link are no list");
  EXPECT_EQ(message("collision_spheres:\n"), "robot.yml:1: 'collision_spheres' has no spheres");
  EXPECT_EQ(message("a\n"), "robot.yml:1: there is no key, as in 'radius: 0.1'");
  EXPECT_EQ(message("a: 'b\n"), "robot.yml:1: a quote is not closed");
  EXPECT_EQ(message("a: " + std::string(100, '[') + std::string(100, ']')),
            "robot.yml:1: brackets are nested too deeply");
}

TEST(SphereFile, DamagedTextIsRefusedOrRead) {
  const std::string whole = kText;
  for (std::size_t place = 0; place < whole.size(); ++place) {
    for (const char other : {' ', '[', '}', ':', '-', '"', '\n', ','}) {
      std::string text = whole;
      text[place] = other;
      try {
        parse_spheres(text, "robot.yml");
      } catch (const Error&) {
      }
    }
    try {
      parse_spheres(whole.substr(0, place), "robot.yml");
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace hardball::sphere_file_test
