// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/request_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hardball/errors/error.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::request_text_test {
namespace {

using Kind = RadiusDistribution::Kind;

std::string place_of_error(const PackingText& text) {
  return support::refusal_of([&] { parse_request(text, "--"); },
                             [](const Error& error) { return error.where(); });
}

TEST(RequestText, ReadsSizes) {
  const auto sizes = [](const std::string& text) { return *parse_request({.sizes = text}, "").distribution; };
  EXPECT_EQ(sizes("lognormal:0.3").kind, Kind::lognormal);
  EXPECT_EQ(sizes("lognormal:0.3").sigma, 0.3);
  EXPECT_EQ(sizes("uniform:1,2").max, 2);
  EXPECT_EQ(sizes("powerlaw:-3,1,10").exponent, -3);
  EXPECT_EQ(sizes("discrete:1=0.25,2=0.75").values, (std::vector<double>{1, 2}));
  EXPECT_EQ(sizes("discrete:1=0.25,2=0.75").weights, (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(sizes("discrete:1,1.4").weights, (std::vector<double>{1, 1}));
}

TEST(RequestText, ReadsRadiiFromAFile) {
  const support::ScratchFolder folder;
  support::write_text(folder / "radii.txt", "1\n0.5\n2.5\n");
  EXPECT_EQ(parse_request({.sizes = "file:" + (folder / "radii.txt").string()}, "").radii,
            (std::vector<double>{1, 0.5, 2.5}));
  EXPECT_EQ(place_of_error({.sizes = "file:" + (folder / "none.txt").string()}), "--sizes");
}

TEST(RequestText, ReadsContainers) {
  const auto container = [](const std::string& text) {
    return *parse_request({.container = text}, "").container;
  };
  EXPECT_EQ(container("cylinder:7,50").shape, Container::Shape::cylinder);
  EXPECT_EQ(container("cylinder:7,50").size, (Vec3{7, 7, 50}));
  EXPECT_EQ(container("cone:3,4").shape, Container::Shape::cone);
  EXPECT_EQ(container("truncated_cone:2,3,4").shape, Container::Shape::truncated_cone);
  EXPECT_EQ(container("truncated_cone:2,3,4").size, (Vec3{3, 3, 4}));
  EXPECT_EQ(container("shell:2,3").shape, Container::Shape::shell);
  EXPECT_EQ(container("shell:2,3").inner, 2);
  EXPECT_TRUE(parse_request({.container = "shell:2:3"}, "").is_container_size_free);
  EXPECT_EQ(container("sphere:9").size, (Vec3{9, 9, 9}));
  EXPECT_EQ(container("slab:3,4,5").has_walls, (std::array<bool, kAxes>{false, false, true}));
  EXPECT_FALSE(parse_request({.container = "cylinder:7,50"}, "").is_container_size_free);
  EXPECT_TRUE(parse_request({.container = "cylinder:1:3"}, "").is_container_size_free);
  EXPECT_TRUE(parse_request({.container = "sphere"}, "").is_container_size_free);
}

TEST(RequestText, ReadsBoxes) {
  EXPECT_EQ(parse_request({.box = "10"}, "").container->size, (Vec3{10, 10, 10}));
  EXPECT_EQ(parse_request({.box = "1,2", .dimensions = "2"}, "").container->size, (Vec3{1, 2, 0}));
  EXPECT_TRUE(parse_request({.box = "1:2:3"}, "").is_container_size_free);
  EXPECT_EQ(parse_request({.walls = "zx"}, "").container->has_walls,
            (std::array<bool, kAxes>{true, false, true}));
}

TEST(RequestText, NamesThePartThatIsWrong) {
  EXPECT_EQ(place_of_error({.count = "many"}), "--count");
  EXPECT_EQ(place_of_error({.count = "0"}), "--count");
  EXPECT_EQ(place_of_error({.diameter = "-1"}), "--diameter");
  EXPECT_EQ(place_of_error({.diameter = "nan"}), "--diameter");
  EXPECT_EQ(place_of_error({.box = "1,2"}), "--box");
  EXPECT_EQ(place_of_error({.box = "1,2,x"}), "--box");
  EXPECT_EQ(place_of_error({.walls = "w"}), "--walls");
  EXPECT_EQ(place_of_error({.walls = "z", .dimensions = "2"}), "--walls");
  EXPECT_EQ(place_of_error({.container = "cylinder"}), "--container");
  EXPECT_EQ(place_of_error({.container = "cube:1,2,3"}), "--container");
  EXPECT_EQ(place_of_error({.container = "shell:1"}), "--container");
  EXPECT_EQ(place_of_error({.container = "truncated_cone:1,2"}), "--container");
  EXPECT_EQ(place_of_error({.box = "3", .container = "sphere"}), "--container");
  EXPECT_EQ(place_of_error({.phi = "dense"}), "--phi");
  EXPECT_EQ(place_of_error({.phi = "0.6", .pressure = "10"}), "--pressure");
  EXPECT_EQ(place_of_error({.rate = "0"}), "--rate");
  EXPECT_EQ(place_of_error({.dimensions = "4"}), "--dimensions");
  EXPECT_EQ(place_of_error({.seed = "-1"}), "--seed");
  for (const std::string sizes : {"lognormal", "lognormal:-1", "uniform:2,1", "uniform:1", "powerlaw:1,0,2",
                                  "discrete:", "discrete:1=0", "normal:1", "uniform:1,inf"})
    EXPECT_EQ(place_of_error({.sizes = sizes}), "--sizes") << sizes;
}

}  // namespace
}  // namespace hardball::request_text_test
