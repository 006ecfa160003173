// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packing_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/packing/jamming.hpp"
#include "hardball/packing/request_text.hpp"
#include "hardball/world/walls.hpp"
#include "support/refusal.hpp"

namespace hardball::packing_plan_test {
namespace {

PackingPlan plan_of(const PackingText& text) {
  return plan(parse_request(text, "--"));
}

double fraction_of(const PackingPlan& plan) {
  double volume = 0;
  for (const double radius : plan.radii) volume += plan.container.box().sphere_volume(radius);
  return volume / plan.container.volume();
}

double mean_diameter(const PackingPlan& plan) {
  return 2 * statistics_of(plan.radii, plan.container.dimensions).mean;
}

std::string refusal_of(const PackingText& text) {
  return support::refusal_of([&] { plan_of(text); });
}

void expect_refused(const PackingText& text, const std::string& part) {
  const std::string refusal = refusal_of(text);
  EXPECT_NE(refusal.find(part), std::string::npos) << refusal;
}

bool has_warning(const PackingPlan& plan, const std::string& part) {
  return std::ranges::any_of(
      plan.warnings, [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

TEST(PackingPlan, TheEdgeFollowsFromCountDiameterAndDensity) {
  const PackingPlan found = plan_of({.count = "1000", .phi = "0.6"});
  EXPECT_EQ(found.radii.size(), 1000U);
  EXPECT_NEAR(mean_diameter(found), 1, 1e-14);
  EXPECT_NEAR(fraction_of(found), 0.6, 1e-12);
  EXPECT_EQ(found.container.size.x, found.container.size.y);
}

TEST(PackingPlan, ProportionsOfTheBoxStay) {
  const PackingPlan found = plan_of({.count = "100", .diameter = "2", .box = "1:2:4", .phi = "0.5"});
  EXPECT_NEAR(found.container.size.z / found.container.size.x, 4, 1e-14);
  EXPECT_NEAR(fraction_of(found), 0.5, 1e-12);
  EXPECT_NEAR(mean_diameter(found), 2, 1e-14);
}

TEST(PackingPlan, TheDiameterFollowsFromCountBoxAndDensity) {
  const PackingPlan found =
      plan_of({.count = "200", .sizes = "lognormal:0.4", .box = "3,4,5", .phi = "0.55"});
  EXPECT_NEAR(fraction_of(found), 0.55, 1e-12);
  EXPECT_EQ(found.container.size, (Vec3{3, 4, 5}));
}

TEST(PackingPlan, TheCountFollowsFromDiameterBoxAndDensity) {
  for (const std::string sizes :
       {"lognormal:0.3", "uniform:1,3", "discrete:1=0.9,4=0.1", "powerlaw:-2,1,5"}) {
    const PackingPlan found = plan_of({.diameter = "2.5", .sizes = sizes, .box = "40", .phi = "0.6"});
    EXPECT_NEAR(mean_diameter(found), 2.5, 1e-12);
    EXPECT_NEAR(fraction_of(found), 0.6, 0.03) << sizes;
    EXPECT_NEAR(std::get<double>(found.goal), fraction_of(found), 1e-12) << "of as many as there are";
  }
}

TEST(PackingPlan, TheDensityFollowsFromTheOthers) {
  const PackingPlan found = plan_of({.count = "500", .diameter = "1", .box = "10"});
  EXPECT_NEAR(std::get<double>(found.goal), 500 * 0.5235987755982988 / 1000, 1e-12);
}

TEST(PackingPlan, ListedRadiiAreAbsolute) {
  PackingRequest request;
  request.radii = {1, 2, 3};
  request.goal = 0.2;
  const PackingPlan found = plan(request);
  EXPECT_EQ(found.radii, request.radii);
  EXPECT_NEAR(fraction_of(found), 0.2, 1e-12);
}

TEST(PackingPlan, DiscsHaveAnArea) {
  const PackingPlan found = plan_of({.count = "100", .phi = "0.7", .dimensions = "2"});
  EXPECT_EQ(found.container.size.z, 0);
  EXPECT_NEAR(100 * 0.7853981633974483 / (found.container.size.x * found.container.size.y), 0.7, 1e-12);
}

TEST(PackingPlan, TheRateFallsAsTheDensityRises) {
  double last = 1;
  for (const std::string phi : {"0.55", "0.61", "0.635", "0.645", "0.648"}) {
    const double rate = plan_of({.count = "1000", .phi = phi}).rate;
    EXPECT_LT(rate, last) << phi;
    last = rate;
  }
  EXPECT_EQ(plan_of({.count = "1000", .phi = "0.64", .rate = "0.2"}).rate, 0.2);
  EXPECT_EQ(plan_of({.count = "1000", .phi = "max"}).rate, 0.01);
}

TEST(PackingPlan, MoreCollisionsAreExpectedOfDenserAndSlowerPackings) {
  const auto collisions = [](const std::string& phi, const std::string& rate) {
    return plan_of({.count = "1000", .phi = phi, .rate = rate}).expected_collisions();
  };
  // Source of the three: Carnahan and Starling's equation of state, integrated.
  EXPECT_NEAR(collisions("0.5", "0.1"), (2.8 - 1.07) / 0.1, 1);
  EXPECT_GT(collisions("0.6", "0.1"), collisions("0.5", "0.1"));
  EXPECT_GT(collisions("0.6", "0.01"), 3 * collisions("0.6", "0.1"));
  EXPECT_GT(collisions("max", "0.01"), 3000);
}

TEST(PackingPlan, RefusesWhatDoesNotDetermineThePacking) {
  expect_refused({.count = "10", .diameter = "1", .box = "9", .phi = "0.1"}, "leave one of the four out");
  expect_refused({.count = "10"}, "give a packing fraction");
  expect_refused({.phi = "0.5"}, "give a count");
  expect_refused({.box = "10", .phi = "0.5"}, "give a count");
}

TEST(PackingPlan, RefusesWhatCannotExist) {
  expect_refused({.count = "100", .phi = "0.75"}, "no equal spheres fill 0.75");
  expect_refused({.count = "100", .phi = "0.91", .dimensions = "2"}, "no equal discs fill 0.91");
  expect_refused({.count = "100", .sizes = "uniform:1,2", .phi = "1.1"}, "no spheres fill 1.1");
  expect_refused({.count = "2", .box = "1,1,9", .phi = "0.6"}, "the largest diameter would be");
  expect_refused({.count = "1", .phi = "max"}, "one sphere in a periodic box");
  expect_refused({.count = "100", .pressure = "1e14"}, "coordinates resolve");
  expect_refused({.count = "100", .pressure = "0.5"}, "give a number above one");
  expect_refused({.count = "100", .phi = "0.5", .gap = "1"}, "from 0 to below 1");
}

TEST(PackingPlan, RefusesAStartThatDoesNotFit) {
  PackingRequest request;
  request.start.emplace();
  request.start->spheres = {{.position = {1, 1, 1}}, {.position = {4, 4, 4}}};
  request.start->box = SnapshotBox{{}, {6, 6, 6}, {true, true, true}};
  request.goal = 0.01;
  EXPECT_THROW(plan(request), Error) << "less dense than it is";
  request.goal = 0.3;
  EXPECT_NO_THROW(plan(request));
  request.count = 3;
  EXPECT_THROW(plan(request), Error) << "the file says how many";
  request.count.reset();
  request.start->box->is_unbounded = true;
  EXPECT_THROW(plan(request), Error);
  request.start->box.reset();
  EXPECT_THROW(plan(request), Error);
}

TEST(PackingPlan, WarnsOfDensitiesBeyondThePlausible) {
  EXPECT_TRUE(has_warning(plan_of({.count = "1000", .phi = "0.66"}), "only crystals"));
  EXPECT_FALSE(has_warning(plan_of({.count = "1000", .phi = "0.64"}), "only crystals"));
  EXPECT_TRUE(has_warning(plan_of({.count = "1000", .box = "12,12,12", .walls = "xyz", .phi = "0.64"}),
                          "layers next to walls"));
}

TEST(PackingPlan, WarnsWhereAFewSpheresDecide) {
  const PackingText text{.count = "5000", .sizes = "discrete:1=0.9996,20=0.0004", .phi = "0.7"};
  EXPECT_TRUE(has_warning(plan_of(text), "make up half of the volume"));
  EXPECT_FALSE(has_warning(plan_of({.count = "5000", .phi = "0.6"}), "half of the volume"));
}

TEST(PackingPlan, WarnsOfNarrowContainers) {
  EXPECT_TRUE(has_warning(plan_of({.diameter = "1", .container = "cylinder:3,20", .phi = "max"}),
                          "diameters of the largest sphere wide"));
  EXPECT_FALSE(has_warning(plan_of({.diameter = "1", .container = "cylinder:12,20", .phi = "max"}), "wide"));
}

// 200 sizes drawn at random have a mean of some 34.6, and scaled to a mean of 35 some would be 50.6.
TEST(PackingPlan, SizesStayWithinTheirRange) {
  const PackingPlan found =
      plan_of({.count = "200", .diameter = "35", .sizes = "uniform:20,50", .phi = "0.3"});
  EXPECT_NEAR(mean_diameter(found), 35, 1e-12);
  EXPECT_GE(2 * std::ranges::min(found.radii), 20);
  EXPECT_LE(2 * std::ranges::max(found.radii), 50);
}

TEST(PackingPlan, SaysByHowMuchCountDiameterContainerAndDensityDisagree) {
  const PackingText four{.count = "1000", .diameter = "1", .box = "10", .phi = "0.6"};
  for (const std::string part :
       {"1000 spheres of mean diameter 1 fill 0.523599", "not 0.6", "0.955614 times", "1.04645"})
    expect_refused(four, part);
  expect_refused({.count = "1000", .diameter = "1", .box = "10", .phi = "max"}, "fill 0.523599");
  const PackingPlan agreeing =
      plan_of({.count = "1000", .diameter = "1", .box = "10", .phi = "0.5235987755982988"});
  EXPECT_EQ(agreeing.radii.size(), 1000U);
}

TEST(PackingPlan, SpheresWithGapsAreAsDenseAndAsLargeAsWanted) {
  const PackingPlan found = plan_of({.count = "100", .diameter = "2", .phi = "0.5", .gap = "0.1"});
  EXPECT_NEAR(mean_diameter(found), 2 / 0.9, 1e-12);
  EXPECT_NEAR(fraction_of(found), 0.5 / (0.9 * 0.9 * 0.9), 1e-12);
  EXPECT_NEAR(found.final_fraction(), 0.5, 1e-12);
  expect_refused({.count = "100", .phi = "0.6", .gap = "0.6"}, "fill 0.6 of the volume with gaps of 0.6");
  expect_refused({.count = "100", .phi = "0.6", .gap = "0.6"}, "below 0.04739");
}

// Measured: 0.638, 500 spheres. The others: Farr and Groot, and Farr, Powder Technology 245 (2013) 28.
TEST(PackingPlan, KnowsWhereMixturesJam) {
  const auto plausible = [](const std::string& sizes) {
    return plan_of({.count = "5000", .sizes = sizes, .phi = "max"}).plausible;
  };
  EXPECT_EQ(plan_of({.count = "100", .phi = "max"}).plausible, 0.644);
  EXPECT_NEAR(plausible("discrete:1=0.5,20=0.5"), 0.639, 0.01);
  EXPECT_NEAR(plausible("lognormal:0.1"), 0.647, 0.005);
  EXPECT_NEAR(plausible("lognormal:0.3"), 0.671, 0.005);
  EXPECT_NEAR(plausible("lognormal:0.5"), 0.707, 0.01);
}

TEST(PackingPlan, SpheresMayFillTheWidthOfTheirContainer) {
  const PackingPlan found = plan_of({.count = "3", .diameter = "10", .container = "cylinder:10,30"});
  EXPECT_NEAR(fraction_of(found), 2.0 / 3, 1e-12);
  expect_refused({.count = "10", .container = "shell:3,2", .phi = "0.3"}, "give the smaller one first");
  expect_refused({.count = "10", .container = "truncated_cone:3,3,4", .phi = "0.3"}, "turned over");
  expect_refused({.count = "3", .diameter = "10.1", .container = "cylinder:10,31"},
                 "the largest diameter would be 10.1 in a container 10 wide");
  expect_refused({.diameter = "10.1", .container = "cylinder:10,31", .phi = "max"}, "in a container 10 wide");
}

TEST(PackingPlan, FewSpheresThatFollowAreAsDenseAsAWholeNumberAllows) {
  for (const std::string seed : {"1", "2", "3", "4", "5"}) {
    const PackingPlan found =
        plan_of({.diameter = "1", .sizes = "lognormal:0.5", .box = "4", .phi = "0.4", .seed = seed});
    const double off = std::fabs(fraction_of(found) - 0.4);
    for (std::size_t count = 1; count < 60; ++count)
      EXPECT_LE(off, std::fabs(fraction_of(with_count(found, count)) - 0.4) + 1e-12) << seed << " " << count;
  }
}

TEST(PackingPlan, ReadsDiscsWhereTheyLieInAPlane) {
  PackingRequest request;
  request.start.emplace();
  request.start->spheres = {{.position = {1, 1, 0}, .radius = 0.25}, {.position = {4, 4, 0}, .radius = 0.25}};
  request.start->box = SnapshotBox{{0, 0, -0.5}, {6, 6, 1}, {true, true, true}};
  request.goal = 0.1;
  EXPECT_EQ(plan(request).container.dimensions, 3U) << "spheres have room across the plane";
  request.dimensions = 2;
  EXPECT_EQ(plan(request).container.dimensions, 2U);
  EXPECT_EQ(plan(request).container.size.z, 0);
  request.dimensions = 3;
  request.start->spheres[0].radius = 0.5;
  EXPECT_EQ(plan(request).container.dimensions, 2U) << "they have none";
  request.dimensions = 2;
  request.start->spheres[1].position.z = 0.1;
  EXPECT_THROW(plan(request), Error) << "not in one plane";
}

TEST(PackingPlan, RefusesTiltedBoxes) {
  PackingRequest request;
  request.start.emplace();
  request.start->spheres = {{.position = {1, 1, 1}, .radius = 0.5}, {.position = {4, 4, 4}, .radius = 0.5}};
  request.start->box = SnapshotBox{{}, {6, 6, 6}, {true, true, true}};
  request.goal = 0.3;
  EXPECT_NO_THROW(plan(request));
  request.start->box->tilt = 2;
  EXPECT_THROW(plan(request), Error);
}

TEST(Container, HasItsVolumeAreaAndFreeMotions) {
  constexpr double kPi = 3.14159265358979323846;
  const Container cylinder{.shape = Container::Shape::cylinder, .size = {2, 2, 5}};
  EXPECT_NEAR(cylinder.volume(), 5 * kPi, 1e-12);
  EXPECT_NEAR(cylinder.wall_area(), 12 * kPi, 1e-12);
  EXPECT_EQ(cylinder.largest_radius(), 1);
  EXPECT_EQ(cylinder.free_motions(), 1U);
  const Container sphere{.shape = Container::Shape::sphere, .size = {2, 2, 2}};
  EXPECT_NEAR(sphere.volume(), 4 * kPi / 3, 1e-12);
  EXPECT_EQ(sphere.free_motions(), 3U);
  const Container cone{.shape = Container::Shape::cone, .size = {6, 6, 4}};
  EXPECT_NEAR(cone.volume(), 12 * kPi, 1e-12);
  EXPECT_NEAR(cone.wall_area(), 24 * kPi, 1e-12);
  EXPECT_NEAR(cone.largest_radius(), 1.5, 1e-12);
  const Container funnel{.shape = Container::Shape::truncated_cone, .size = {6, 6, 4}, .inner = 2};
  EXPECT_NEAR(funnel.volume(), kPi * 4 / 3 * (9 + 3 + 1), 1e-13);
  EXPECT_NEAR(accessible_volume(World(funnel.box(), {}, funnel.surfaces())), funnel.volume(), 1e-13);
  EXPECT_NEAR(funnel.wall_area(), kPi * (9 + 1 + 4 * std::sqrt(20.0)), 1e-13);
  EXPECT_NEAR(funnel.largest_radius(), 12 / (2 + std::sqrt(20.0)), 1e-14);
  EXPECT_EQ(funnel.free_motions(), 1U);
  EXPECT_NEAR(funnel.scaled(2).volume(), 8 * funnel.volume(), 1e-11);
  const Container shell{.shape = Container::Shape::shell, .size = {6, 6, 6}, .inner = 2};
  EXPECT_NEAR(shell.volume(), kPi * 4 / 3 * (27 - 1), 1e-13);
  EXPECT_NEAR(shell.wall_area(), 4 * kPi * (9 + 1), 1e-13);
  EXPECT_EQ(shell.largest_radius(), 1);
  EXPECT_EQ(shell.free_motions(), 3U);
  const Container annulus{.shape = Container::Shape::annulus, .size = {6, 6, 5}, .inner = 2};
  EXPECT_NEAR(annulus.volume(), kPi * 5 * (9 - 1), 1e-13);
  EXPECT_NEAR(annulus.wall_area(), 2 * kPi * ((9 - 1) + 5 * (3 + 1)), 1e-13);
  EXPECT_EQ(annulus.largest_radius(), 1);
  EXPECT_EQ(annulus.free_motions(), 1U);
  const Container ring{.shape = Container::Shape::shell, .dimensions = 2, .size = {6, 6, 0}, .inner = 2};
  EXPECT_NEAR(ring.volume(), kPi * 8, 1e-13);
  EXPECT_NEAR(ring.wall_area(), 2 * kPi * 4, 1e-13);
  EXPECT_EQ(ring.free_motions(), 1U);
  Container slab = Container::periodic({2, 3, 4});
  slab.has_walls[2] = true;
  EXPECT_EQ(slab.wall_area(), 12);
  EXPECT_EQ(slab.free_motions(), 2U);
}

}  // namespace
}  // namespace hardball::packing_plan_test
