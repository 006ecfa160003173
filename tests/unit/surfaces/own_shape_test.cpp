// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A shape of a program's own behaves as one of the library.
#include "hardball/surfaces/own_shape.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "hardball/recording/recording_header.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"

namespace hardball::own_shape_test {
namespace {

// A sphere, with no more than what a program must give.
class Cavity final : public ShapeInterface {
 public:
  explicit Cavity(double radius) : sphere_(radius) {}

  std::string_view name() const override { return "cavity"; }
  Time contact_time(const Passage& passage) const override {
    return after(passage.start, earliest_descent(sphere_.gap(passage)));
  }
  DoubleDouble<> opening_speed(const Passage& passage) const override {
    return sphere_.gap(passage).coefficients[1];
  }
  double distance(const Vec3& position) const override { return sphere_.distance(position); }
  Vec3 towards(const Vec3& position) const override { return sphere_.towards(position); }

 private:
  HollowSphere sphere_;
};

World gas_in(const Shape& shape) {
  const World gas =
      support::make_gas({.count = 100, .packing_fraction = 0.1, .seed = 801, .boundary = Boundary::open});
  const double edge = support::cube_edge(100, 0.1);
  World world(Box::open(), {}, {Surface(shape, {edge / 2, edge / 2, edge / 2})});
  for (Slot slot = 0; slot < gas.size(); ++slot) {
    world.add(
        {gas.position(slot, Time(0)), gas.velocity(slot, Time(0)), gas.base_radius(slot), gas.mass(slot)});
  }
  return world;
}

Shape cavity(double radius) {
  return OwnShape(std::make_shared<Cavity>(radius));
}

TEST(OwnShape, IsMetAsOneOfTheLibrary) {
  for (const EngineKind engine : {EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs}) {
    Simulation own(gas_in(cavity(8)), {.engine = engine});
    Simulation known(gas_in(HollowSphere(8)), {.engine = engine});
    own.run_contacts(2000);
    known.run_contacts(2000);
    EXPECT_GT(own.counters().wall, 100U);
    EXPECT_EQ(own.event_log_hash(), known.event_log_hash());
  }
}

TEST(OwnShape, HasItsNameInMessages) {
  const Surface surface(cavity(8), {});
  EXPECT_EQ(surface.name(), "cavity");
  try {
    static_cast<void>(World(Box::periodic({20, 20, 20}), {}, {surface}));
    FAIL() << "it has no images";
  } catch (const Error& error) {
    EXPECT_EQ(error.problem(), "the cavity is not periodic along x");
    EXPECT_EQ(error.remedy(), "make the axis a wall, or open");
  }
}

TEST(OwnShape, CannotBeSavedNorRecorded) {
  const Simulation simulation(gas_in(cavity(8)));
  EXPECT_THROW(static_cast<void>(simulation.save()), Error);
  EXPECT_THROW(static_cast<void>(recording_header(simulation)), Error);
}

}  // namespace
}  // namespace hardball::own_shape_test
