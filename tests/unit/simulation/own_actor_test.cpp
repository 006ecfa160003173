// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Actors of a program's own act at their times, in every copy of a simulation.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"

namespace hardball::own_actor_test {
namespace {

// Reverses all velocities at whole times.
class Reverser final : public Actor {
 public:
  std::unique_ptr<Actor> clone() const override { return std::make_unique<Reverser>(*this); }
  std::string_view deed() const override { return "velocities are reversed"; }
  Time next() const override { return Time(next_); }
  Action act(const World& world, const Tally&, const Time& moment) override {
    ++next_;
    changes_.clear();
    world.for_each_by_id([&](Slot slot) {
      const Vec3 velocity = world.velocity(slot, moment);
      changes_.push_back({slot, velocity, -velocity});
    });
    return {.changes = changes_};
  }

 private:
  double next_ = 1;
  std::vector<NewVelocity> changes_;
};

Simulation reversed(std::size_t count) {
  Simulation simulation(support::make_gas({.count = count, .packing_fraction = 0.05, .seed = 811}));
  simulation.add_actor(std::make_unique<Reverser>());
  return simulation;
}

TEST(OwnActor, ActsAtItsTimes) {
  Simulation simulation = reversed(50);
  const std::vector<Vec3> start = simulation.positions();
  simulation.run_until(1.5);
  EXPECT_GT(length(simulation.positions()[0] - start[0]), 1e-3);
  simulation.run_until(2);
  for (std::size_t i = 0; i < start.size(); ++i)
    EXPECT_LT(length(simulation.positions()[i] - start[i]), 1e-9) << "the history ran backwards";
}

TEST(OwnActor, IsCopiedWithTheSimulation) {
  Simulation simulation = reversed(50);
  simulation.run_until(0.5);
  Simulation copy = simulation;
  simulation.run_until(4.25);
  copy.run_until(4.25);
  EXPECT_EQ(copy.event_log_hash(), simulation.event_log_hash());
  EXPECT_EQ(copy.positions(), simulation.positions());
}

TEST(OwnActor, IsForeseenByALookAhead) {
  Simulation simulation = reversed(50);
  Simulation other = reversed(50);
  while (const auto next = simulation.next_contact(3)) {
    ASSERT_EQ(simulation.run_contacts(1, next->time), 1U);
    other.run_contacts(1);
    ASSERT_EQ(next->time, other.time());
  }
  EXPECT_GT(other.time(), 1);
}

TEST(OwnActor, CannotActInThePast) {
  Simulation simulation = reversed(10);
  EXPECT_THROW(simulation.add_actor(nullptr), Error);
  simulation.run_until(1.5);
  EXPECT_THROW(simulation.add_actor(std::make_unique<Reverser>()), Error);
}

}  // namespace
}  // namespace hardball::own_actor_test
