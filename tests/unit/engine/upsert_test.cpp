// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/engine/upsert.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "support/gas.hpp"

namespace hardball::put_test {
namespace {

using PlainEngine = Engine<CalendarQueue>;

// In open space contacts end, and crossings do not.
std::vector<Contact> next_contacts(auto& engine, std::uint64_t count) {
  std::vector<Contact> contacts;
  engine.run({.until = Time(50), .contacts = count},
             [&](const Contact& contact) { contacts.push_back(contact); });
  return contacts;
}

// Puts all spheres of an engine where they are in a copy that has run on for `wait`, without letting that
// time pass.
void put_where_they_will_be(PlainEngine& engine, double wait) {
  PlainEngine ahead = engine;
  const Time now = engine.now();
  const Time then(now.high + wait);
  ahead.run({.until = then}, [](const Contact&) {});
  std::vector<NewPath> paths;
  for (Slot slot = 0; slot < engine.world().size(); ++slot) {
    const World& world = ahead.world();
    paths.push_back({slot, {world.position(slot, then), world.velocity(slot, then), now}, {}});
  }
  engine.replace_paths(paths, now);
}

// Spheres that stay in their regions, and others that do not: the contacts are those of an engine made anew.
void expect_contacts_of_a_new_engine(const PhaseSettings& phase, Boundary boundary, double packing_fraction) {
  const World gas = support::make_gas(
      {.count = 100, .packing_fraction = packing_fraction, .seed = 3, .boundary = boundary});
  PlainEngine engine(gas, phase, Time(0));
  for (const double wait : {1e-3, 0.03, 0.3, 4.0}) {
    SCOPED_TRACE(wait);
    next_contacts(engine, 100);
    put_where_they_will_be(engine, wait);
    ASSERT_FALSE(engine.needs_rebuild());
    ASSERT_NO_THROW(engine.validate());
    PlainEngine made_anew(engine.world(), {PhaseKind::all_pairs, 1}, engine.now());
    const std::vector<Contact> expected = next_contacts(made_anew, 200);
    const std::vector<Contact> found = next_contacts(engine, 200);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_EQ(found[k].time, expected[k].time) << k;
      ASSERT_EQ(found[k].first, expected[k].first) << k;
      ASSERT_EQ(found[k].second, expected[k].second) << k;
    }
  }
}

TEST(PutOnPaths, GivesTheContactsOfANewEngine) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall, Boundary::open}) {
    for (const double packing_fraction : {0.02, 0.3}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(boundary) << " " << packing_fraction);
      expect_contacts_of_a_new_engine({PhaseKind::all_pairs, 1}, boundary, packing_fraction);
      expect_contacts_of_a_new_engine({PhaseKind::cells, 1.3}, boundary, packing_fraction);
      expect_contacts_of_a_new_engine({PhaseKind::cells, 0.7}, boundary, packing_fraction);
      expect_contacts_of_a_new_engine({PhaseKind::neighbors, 0.3}, boundary, packing_fraction);
    }
  }
}

// A center keeps its region as long as it is in the ball around the anchor.
TEST(PutOnPaths, KeepsTheRegionsOfSpheresThatHaveHardlyMoved) {
  const World gas = support::make_gas({.count = 200, .packing_fraction = 0.3, .seed = 3});
  NeighborList phase(0.3);
  CompactPaths copies;
  phase.build(gas, Time(0), copies);
  World world = gas;
  const auto keeps = [&](double x) {
    Path path = gas.path(0);
    path.position.x += x;
    SphereEdit(world, Time(0), 0).store_path(0, path, Image());
    copies.copy(world, 0, Time(0));
    return phase.keeps(world, 0, Time(0), copies);
  };
  EXPECT_TRUE(keeps(0));
  EXPECT_TRUE(keeps(0.29));
  EXPECT_TRUE(keeps(-0.29));
  EXPECT_FALSE(keeps(0.31));
  EXPECT_FALSE(keeps(3));
  EXPECT_TRUE(keeps(gas.box().size().x)) << "the same place, a period away";
}

}  // namespace
}  // namespace hardball::put_test
