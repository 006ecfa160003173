// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Sensors: when an overlap begins and ends, and who is inside.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/refusal.hpp"

namespace hardball::sensors_test {
namespace {

constexpr SpeciesId kSensor = 1;

Interactions sensing() {
  StepTable table;
  table.set(0, kSensor, StepPotential::sensor());
  Interactions interactions;
  interactions.set_steps(table);
  return interactions;
}

struct Seen {
  double time;
  bool is_end;
};

TEST(Sensor, TellsWhenAnOverlapBeginsAndEnds) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {5, 0.6, 0}, .radius = 0.5, .species = kSensor});
  world.set_interactions(sensing());
  Simulation simulation(std::move(world));
  std::vector<Seen> seen;
  simulation.on_contact([&](const Contact& contact) {
    ASSERT_TRUE(contact.step.passes);
    EXPECT_EQ(contact.before, contact.after);
    EXPECT_EQ(contact.impulse(), Vec3{});
    seen.push_back({contact.time.value(), contact.step.is_outward});
  });
  EXPECT_TRUE(simulation.partners(0).empty());
  simulation.run({.until = Time(5)});
  EXPECT_EQ(simulation.partners(0), std::vector<SphereId>{1});
  EXPECT_EQ(simulation.partners(1), std::vector<SphereId>{0});
  simulation.run({.until = Time(10)});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_FALSE(seen[0].is_end);
  EXPECT_NEAR(seen[0].time, 5 - 0.8, 1e-14);
  EXPECT_TRUE(seen[1].is_end);
  EXPECT_NEAR(seen[1].time, 5 + 0.8, 1e-14);
  EXPECT_TRUE(simulation.partners(1).empty());
  EXPECT_EQ(simulation.velocity(0), (Vec3{1, 0, 0}));
  EXPECT_EQ(simulation.velocity(1), Vec3{});
}

TEST(Sensor, KnowsWhoStartsInside) {
  World world(Box::open());
  world.add({.position = {0.25, 0, 0}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {0, 0, 0}, .radius = 0.5, .species = kSensor});
  world.set_interactions(sensing());
  Simulation simulation(std::move(world));
  EXPECT_EQ(simulation.partners(1), std::vector<SphereId>{0});
  std::vector<Seen> seen;
  simulation.on_contact([&](const Contact& contact) {
    seen.push_back({contact.time.value(), contact.step.is_outward});
  });
  simulation.run({.until = Time(10)});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_TRUE(seen[0].is_end);
  EXPECT_EQ(seen[0].time, 0.75);
}

TEST(Sensor, NamesTheSphereThatDoesNotExist) {
  World world(Box::open());
  world.add({.position = {}, .radius = 0.5});
  const Simulation simulation(std::move(world));
  EXPECT_TRUE(simulation.partners(0).empty());
  EXPECT_NE(support::refusal_of([&] { simulation.partners(7); }).find("7"), std::string::npos);
}

// Who overlaps a sensor, by looking at all; what is closer to the edge than rounding may be either.
void compare_with_all(const Simulation& simulation, SphereId sensor, double size) {
  const std::vector<SphereId> partners = simulation.partners(sensor);
  const std::set<SphereId> inside(partners.begin(), partners.end());
  ASSERT_EQ(inside.size(), partners.size());
  const World& world = simulation.world();
  for (SphereId id = 0; id < world.size(); ++id) {
    if (world.species(world.slot_of(id)) == kSensor) continue;
    Vec3 apart = simulation.position(id) - simulation.position(sensor);
    for (std::size_t axis = 0; axis < kAxes; ++axis) apart[axis] -= size * std::round(apart[axis] / size);
    const double gap =
        length(apart) - world.base_radius(world.slot_of(id)) - world.base_radius(world.slot_of(sensor));
    if (std::fabs(gap) < 1e-9) continue;
    EXPECT_EQ(inside.contains(id), gap < 0) << "sphere " << id << ", gap " << gap;
  }
}

TEST(Sensor, SeesInAGasWhatALookAtAllSees) {
  constexpr double kSize = 12;
  Random random(7);
  World world(Box::periodic({kSize, kSize, kSize}));
  world.set_interactions(sensing());
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      for (int z = 0; z < 6; ++z) {
        world.add({.position = {2.0 * x + 1, 2.0 * y + 1, 2.0 * z + 1},
                   .velocity = random.direction(),
                   .radius = 0.3 + 0.4 * random.uniform()});
      }
    }
  }
  std::vector<SphereId> sensors;
  for (int k = 0; k < 6; ++k) {
    sensors.push_back(
        world.add({.position = {kSize * random.uniform(), kSize * random.uniform(), kSize * random.uniform()},
                   .velocity = k % 2 == 0 ? Vec3{} : 0.5 * random.direction(),
                   .radius = 0.2 + 2 * random.uniform(),
                   .mass = k < 3 ? std::numeric_limits<double>::infinity() : 1,
                   .species = kSensor}));
  }
  // Sensors do not see each other, nor bounce.
  StepTable table = world.interactions().steps();
  table.set(kSensor, kSensor, StepPotential::sensor());
  Interactions interactions;
  interactions.set_steps(table);
  world.set_interactions(interactions);
  Simulation simulation(std::move(world));
  std::size_t begun = 0;
  std::size_t ended = 0;
  simulation.on_contact([&](const Contact& contact) {
    if (!contact.step.happens()) return;
    EXPECT_TRUE(contact.step.passes);
    EXPECT_EQ(contact.before, contact.after);
    ++(contact.step.is_outward ? ended : begun);
  });
  for (int look = 1; look <= 40; ++look) {
    simulation.run({.until = Time(0.5 * look)});
    for (const SphereId sensor : sensors) compare_with_all(simulation, sensor, kSize);
  }
  EXPECT_GT(begun, 100U);
  EXPECT_GT(ended, 100U);
}

}  // namespace
}  // namespace hardball::sensors_test
