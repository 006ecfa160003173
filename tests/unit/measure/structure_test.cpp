// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What all measures of structure have in common.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

#include "hardball/measure/neighbors.hpp"
#include "hardball/measure/profiles.hpp"
#include "hardball/measure/radial_distribution.hpp"
#include "hardball/measure/structure_factor.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/random_world.hpp"

namespace hardball::structure_test {
namespace {

template <class Measure>
class Structure : public ::testing::Test {};
using StructureMeasures = ::testing::Types<RadialDistribution, StructureFactor, DensityProfiles, Coordination,
                                           NearestNeighbor, BondOrder>;
TYPED_TEST_SUITE(Structure, StructureMeasures);

// Every bit of every number.
std::vector<std::uint64_t> bits_of(const Measurement& measurement) {
  std::vector<std::uint64_t> bits;
  const auto add = [&](double number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); };
  for (const Quantity& quantity : measurement.quantities) {
    add(quantity.value);
    add(quantity.error);
    add(quantity.theory);
  }
  for (const Column& column : measurement.columns) {
    for (const double number : column.values) add(number);
  }
  return bits;
}

struct Run {
  std::uint64_t hash = 0;
  std::vector<std::uint64_t> bits;
};

// Two sizes of spheres between two walls.
World slit_gas() {
  constexpr std::size_t kSpheres = 150;
  const Vec3 size{9, 8, 7};
  const Box box({Boundary::periodic, Boundary::wall, Boundary::periodic}, size);
  std::vector<double> radii(kSpheres / 2, 0.5);
  radii.resize(kSpheres, 0.4);
  Random random(57);
  const std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, random, "slit gas");
  World world(box);
  for (std::size_t i = 0; i < kSpheres; ++i) {
    world.add({.position = centers[i], .velocity = random.direction(), .radius = radii[i]});
  }
  return world;
}

template <class Measure>
Run run(const EngineOptions& options, std::uint64_t samples) {
  constexpr std::uint64_t kContacts = 2000;
  Simulation simulation(slit_gas(), options);
  Measure measure({simulation.world(), simulation.now()});
  for (std::uint64_t sample = 0; sample < samples; ++sample) {
    simulation.run_contacts(kContacts / samples);
    measure.sample({simulation.world(), simulation.now()});
  }
  EXPECT_EQ(simulation.counters().contacts(), kContacts);
  return {simulation.event_log_hash(), bits_of(result_of(measure, {simulation.world(), simulation.now()}))};
}

TYPED_TEST(Structure, IsTheSameForEveryEngineAndAltersNothing) {
  const Run cells = run<TypeParam>({.engine = EngineKind::cells}, 20);
  for (const EngineKind engine : {EngineKind::neighbors, EngineKind::all_pairs, EngineKind::paper}) {
    const Run other = run<TypeParam>({.engine = engine}, 20);
    EXPECT_EQ(other.hash, cells.hash);
    EXPECT_EQ(other.bits, cells.bits);
  }
  const Run unwatched = run<TypeParam>({.engine = EngineKind::cells}, 1);
  EXPECT_EQ(unwatched.hash, cells.hash);
  EXPECT_NE(unwatched.bits, cells.bits);
}

TYPED_TEST(Structure, DoesNotDependOnWhereSpheresAreStored) {
  World world = slit_gas();
  TypeParam measure({world, Time(0)});
  measure.sample({world, Time(0)});
  std::vector<Slot> order(world.size());
  for (Slot slot = 0; slot < order.size(); ++slot)
    order[slot] = static_cast<Slot>((slot * 7 + 3) % order.size());
  ASSERT_EQ(std::accumulate(order.begin(), order.end(), std::size_t{0}),
            order.size() * (order.size() - 1) / 2);
  world.reorder(order);
  TypeParam reordered({world, Time(0)});
  reordered.sample({world, Time(0)});
  EXPECT_EQ(bits_of(result_of(reordered, {world, Time(0)})), bits_of(result_of(measure, {world, Time(0)})));
}

TYPED_TEST(Structure, AcceptsSmallAndStrangeWorlds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    TypeParam measure({made.world, Time(0)});
    EXPECT_GE(measure.sample_cost(), 0);
    measure.sample({made.world, Time(0)});
    measure.sample({made.world, Time(made.until / 100)});
    const Measurement found = result_of(measure, {made.world, Time(0)});
    EXPECT_EQ(found.name, TypeParam::kName);
    for (const Column& column : found.columns) {
      EXPECT_EQ(column.values.size(), found.columns.front().values.size());
    }
    if (found.columns.empty()) continue;
    EXPECT_EQ(found.columns.front().role, ColumnRole::argument);
  }
  const World empty;
  TypeParam nothing({empty, Time(0)});
  nothing.sample({empty, Time(0)});
  const Measurement found = result_of(nothing, {empty, Time(0)});
  EXPECT_TRUE(found.columns.empty() || found.columns[0].name != "");
}

}  // namespace
}  // namespace hardball::structure_test
