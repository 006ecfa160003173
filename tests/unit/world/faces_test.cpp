// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Faces of the box with properties of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/interacting.hpp"
#include "support/refusal.hpp"

namespace hardball::faces_test {
namespace {

constexpr Face kFloor = face_of(2, false);
constexpr Face kCeiling = face_of(2, true);
const Box kSlab({Boundary::periodic, Boundary::periodic, Boundary::wall}, {10, 10, 8});

std::string refusal(Box box, Face face, const FaceProperties& properties) {
  return support::refusal_of([&] { box.set_face(face, properties); });
}

TEST(Faces, AreRefusedWithTheirName) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Box walls = Box::walls({1, 2, 3});
  EXPECT_NE(refusal(kSlab, face_of(1, true), {}).find("face y_max"), std::string::npos);
  EXPECT_NE(refusal(Box::open(), 0, {}), "");
  EXPECT_NE(refusal(walls, kFaces, {}), "");
  EXPECT_NE(refusal(Box::flat_walls(3, 4), kFloor, {}), "") << "there is no such face";
  EXPECT_NE(refusal(Box::flat_walls(3, 4), 0, {.velocity = {0, 1, 1}}).find("two dimensions"),
            std::string::npos);
  EXPECT_NE(refusal(walls, kFloor, {.velocity = {1, 0, 1e-3}}).find("moves only along itself"),
            std::string::npos);
  EXPECT_NE(refusal(walls, kFloor, {.velocity = {infinity, 0, 0}}), "");
  EXPECT_NE(refusal(walls, kFloor, {.velocity = {1e-70, 0, 0}}), "");
  EXPECT_NE(refusal(walls, kFloor, {.material = {.restitution = 1.5}}), "");
  EXPECT_NE(refusal(walls, kFloor, {.material = {.temperature = -1}}), "");
  EXPECT_EQ(refusal(walls, kFloor, {.material = {.temperature = 0}, .velocity = {1, -1, 0}}), "");
}

TEST(Faces, ArePlainUnlessSaidOtherwise) {
  Box box = kSlab;
  EXPECT_TRUE(box.has_plain_faces());
  box.set_face(kFloor, {});
  EXPECT_TRUE(box.has_plain_faces());
  box.set_face(kFloor, {.velocity = {1, 0, 0}});
  EXPECT_FALSE(box.has_plain_faces());
  EXPECT_TRUE(box.has_own_properties(kFloor));
  EXPECT_FALSE(box.has_own_properties(kCeiling));
  EXPECT_NE(box, kSlab);
}

// The state after one contact with the floor: at a face, and at a plane in its place.
Simulation after_a_bounce(bool at_face, const FaceProperties& floor, const Interactions& interactions = {}) {
  Box box = kSlab;
  std::vector<Surface> planes;
  if (at_face) {
    box.set_face(kFloor, floor);
  } else {
    box = Box({Boundary::periodic, Boundary::periodic, Boundary::open}, {10, 10, 0});
    planes = {Surface(Plane({0, 0, 1}), {}, floor.velocity, floor.material)};
  }
  World world(box, {}, planes);
  world.add({.position = {5, 5, 2}, .velocity = {0.5, 0, -1}, .radius = 0.5, .spin = {0.25, 1, 0}});
  Simulation simulation(support::interacting(world, interactions));
  EXPECT_EQ(simulation.run_contacts(1, 3), 1U);
  return simulation;
}

TEST(Faces, DoWhatPlanesDo) {
  const ResponseTable rough(Bounce({.tangential_restitution = 0.5}), Bounce({.tangential_restitution = 0.5}));
  for (const FaceProperties& floor :
       {FaceProperties{}, FaceProperties{.material = {.restitution = 0.25}},
        FaceProperties{.material = {.restitution = 0.25}, .velocity = {2, 1, 0}}}) {
    for (const Interactions& interactions : {Interactions(Restitution(0.5)), Interactions(rough)}) {
      const Simulation face = after_a_bounce(true, floor, interactions);
      const Simulation plane = after_a_bounce(false, floor, interactions);
      EXPECT_NEAR(face.time(), plane.time(), 1e-15);
      EXPECT_LE(length(face.velocity(0) - plane.velocity(0)), 1e-15);
      EXPECT_LE(length(face.world().spin(0) - plane.world().spin(0)), 1e-15);
      EXPECT_NEAR(face.tally().wall(kFloor).heat, plane.tally().wall(kFaces).heat, 1e-15);
      EXPECT_NEAR(face.tally().wall(kFloor).work, plane.tally().wall(kFaces).work, 1e-15);
    }
  }
  const FaceProperties hot{.material = {.temperature = 4, .seed = 3}, .velocity = {100, 0, 0}};
  const Vec3 velocity = after_a_bounce(true, hot).velocity(0);
  EXPECT_NEAR(velocity.x, 100, 20) << "with the face";
  EXPECT_GT(velocity.z, 0);
}

TEST(Faces, DragRoughSpheresAndNoSmoothOnes) {
  const FaceProperties belt{.velocity = {2, 0, 0}};
  EXPECT_EQ(after_a_bounce(true, belt).velocity(0).x, 0.5);
  const Bounce rough({.tangential_restitution = 0});
  EXPECT_GT(after_a_bounce(true, belt, ResponseTable(rough, rough)).velocity(0).x, 0.5);
}

// A disc leaves a thermal wall within its plane.
TEST(Faces, KeepDiscsInTheirPlane) {
  Box box = Box::flat_walls(6, 6);
  for (Face face = 0; face < 4; ++face) {
    box.set_face(face,
                 {.material = {.temperature = 1}, .velocity = face < 2 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}});
  }
  World world(box);
  world.add({.position = {2, 2, 0}, .velocity = {1, 0.5, 0}, .radius = 0.5});
  world.add({.position = {4, 4, 0}, .velocity = {-1, 0.25, 0}, .radius = 0.5});
  Simulation simulation(world);
  simulation.run_contacts(200);
  EXPECT_EQ(simulation.velocity(0).z, 0);
  simulation.validate();
}

TEST(Faces, AreSaved) {
  Box box = kSlab;
  box.set_face(kFloor, {.material = {.temperature = 2, .seed = 9}, .velocity = {1, 0, 0}});
  box.set_face(kCeiling, {.material = {.restitution = 0.5}});
  World world(box);
  world.add({.position = {5, 5, 2}, .velocity = {0.5, 0, -1}, .radius = 0.5});
  Simulation simulation(world);
  simulation.run_until(20);
  Simulation loaded = Simulation::load(simulation.save());
  EXPECT_EQ(loaded.world().box(), box);
  simulation.run_until(60);
  loaded.run_until(60);
  EXPECT_EQ(loaded.event_log_hash(), simulation.event_log_hash());
  EXPECT_GT(simulation.counters().wall, 5U);
}

// Planes that faces hide are refused: they would do nothing.
TEST(Planes, ThatNoSphereCanReachAreRefused) {
  const Box walls = Box::walls({10, 10, 10});
  const double diagonal = std::sqrt(0.5);
  const auto is_refused = [](const Box& box, const Surface& surface) {
    try {
      World(box, {}, {surface});
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("[box.faces]"), std::string::npos);
      return true;
    }
    return false;
  };
  EXPECT_TRUE(is_refused(walls, Surface(Plane({0, 0, 1}), {})));
  EXPECT_TRUE(is_refused(walls, Surface(Plane({0, 0, 1}), {5, 5, 1e-14})));
  EXPECT_TRUE(is_refused(walls, Surface(Plane({0, 0, 1}), {0, 0, -3})));
  EXPECT_TRUE(is_refused(walls, Surface(Plane({0, 0, -1}), {0, 0, 10})));
  EXPECT_TRUE(is_refused(walls, Surface(Plane({0, 0, -1}), {0, 0, 11}, {1, 0, 0}))) << "it slides";
  EXPECT_TRUE(is_refused(walls, Surface(Plane({0, 0, 1}), {}, {0, 0, -1}))) << "it recedes";
  EXPECT_TRUE(is_refused(walls, Surface(Plane({diagonal, 0, diagonal}), {}))) << "it touches an edge";
  EXPECT_TRUE(is_refused(walls, Surface(OscillatingPlane({0, 0, 1}, 0.5, 1), {0, 0, -0.5})));
  EXPECT_FALSE(is_refused(walls, Surface(OscillatingPlane({0, 0, 1}, 0.5, 1), {0, 0, -0.25})));
  EXPECT_FALSE(is_refused(walls, Surface(Plane({0, 0, 1}), {0, 0, 1e-3})));
  EXPECT_FALSE(is_refused(walls, Surface(Plane({0, 0, 1}), {0, 0, 1}, {0, 0, -1}))) << "met at first";
  EXPECT_FALSE(is_refused(walls, Surface(Plane({0, 0, 1}), {0, 0, -5}, {0, 0, 1}))) << "it comes";
  EXPECT_FALSE(is_refused(walls, Surface(Plane({diagonal, 0, diagonal}), {1, 0, 0})));
  EXPECT_FALSE(is_refused(walls, Surface(Plane({0, 0, -1}), {0, 0, 0}))) << "it keeps spheres out of the box";
  const Box open({Boundary::wall, Boundary::wall, Boundary::open}, {10, 10, 0});
  EXPECT_FALSE(is_refused(open, Surface(Plane({0, 0, 1}), {})));
  EXPECT_FALSE(is_refused(open, Surface(Plane({diagonal, 0, diagonal}), {})));
  EXPECT_TRUE(is_refused(Box::flat_walls(10, 10), Surface(Plane({0, 1, 0}), {})));
}

}  // namespace
}  // namespace hardball::faces_test
// x
