// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/packing/protocol.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "support/packing.hpp"

namespace hardball::packer_test {
namespace {

using State = Packer::State;

TEST(Packer, ReachesTheDensityToRounding) {
  PackingRequest request;
  request.count = 200;
  request.goal = 0.6;
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::reached);
  EXPECT_NEAR(packing.packing_fraction(), 0.6, 1e-13);
  EXPECT_EQ(packing.largest_overlap, 0);
  EXPECT_LT(1 - packing.shrink, 1e-13);
  EXPECT_NEAR(packing.spheres.mean_diameter(), 1, 1e-13);
}

TEST(Packer, JamsWithTheContactsThatHoldIt) {
  const Packing packing = support::pack(support::jammed_request(60));
  EXPECT_EQ(packing.status, Packing::Status::jammed);
  EXPECT_GT(packing.pressure, 1e8);
  EXPECT_GE(packing.network.isostaticity, 0.95);
  EXPECT_LE(packing.network.isostaticity, 1.05);
  double mean = 0;
  for (const PackingContact& contact : packing.network.contacts) mean += contact.force;
  EXPECT_NEAR(mean / static_cast<double>(packing.network.contacts.size()), 1, 1e-12);
}

// The impulses on each sphere of a jammed packing cancel, up to how few they are.
TEST(Packer, ForcesAreBalanced) {
  const Packer packer = support::packed(support::jammed_request(60));
  const Packing packing = packing_of(packer);
  std::vector<Vec3> total(packing.spheres.size());
  std::vector<double> all(packing.spheres.size());
  std::size_t contact = 0;
  packing.spheres.for_each_near(packing.network.tolerance, [&](const NearPair& pair) {
    const double force = packing.network.contacts[contact++].force;
    const Vec3 push = (force / length(pair.separation)) * pair.separation;
    total[pair.bodies.first] -= push;
    total[pair.bodies.second] += push;
    all[pair.bodies.first] += force;
    all[pair.bodies.second] += force;
  });
  ASSERT_EQ(contact, packing.network.contacts.size());
  for (std::size_t sphere = 0; sphere < total.size(); ++sphere)
    if (!packing.network.rattles[sphere]) {
      EXPECT_LT(length(total[sphere]), 0.25 * all[sphere]);
    }
}

// Every state is saved while it lasts, and all that is loaded goes on to the same bits.
TEST(Packer, ResumesInEveryStateToTheSameBits) {
  const PackingRequest request = support::jammed_request(40, 3);
  const Packer whole = support::packed(request);
  Packer packer(plan(request));
  std::set<State> seen;
  while (!packer.is_over()) {
    if (seen.insert(packer.state()).second) {
      Packer resumed = Packer::load(packer.save(), "a test");
      while (!resumed.is_over()) resumed.advance();
      EXPECT_EQ(resumed.simulation().event_log_hash(), whole.simulation().event_log_hash())
          << name_of(packer.state());
      EXPECT_EQ(resumed.simulation().positions(), whole.simulation().positions());
      EXPECT_TRUE(packing_of(resumed).spheres.radii == packing_of(whole).spheres.radii);
      EXPECT_EQ(resumed.history(), whole.history());
      EXPECT_EQ(resumed.impulses(), whole.impulses());
    }
    packer.advance();
  }
  EXPECT_EQ(seen,
            (std::set{State::filling, State::growing, State::relaxing, State::stepping, State::weighing}));
  EXPECT_THROW(Packer::load("no packing", "a test"), Error);
}

TEST(Packer, AnyNumberOfThreadsAndAnyEngineGivesTheSameBits) {
  const PackingPlan planned = plan(support::jammed_request(40, 5));
  std::string first;
  for (const EngineOptions& options :
       {EngineOptions{}, EngineOptions{.engine = EngineKind::all_pairs},
        EngineOptions{.engine = EngineKind::cells}, EngineOptions{.threads = 2}}) {
    Packer packer(planned, options);
    while (!packer.is_over()) packer.advance();
    Packing packing = packing_of(packer);
    std::string bits = std::to_string(packer.simulation().event_log_hash());
    for (const PackingContact& contact : packing.network.contacts)
      bits += " " + to_text(contact.gap) + " " + to_text(contact.force);
    if (first.empty()) first = bits;
    EXPECT_EQ(bits, first);
  }
}

TEST(Packer, LowersTheRateWhereSpheresLock) {
  PackingRequest request;
  request.count = 64;
  request.goal = 0.65;
  request.rate = 0.3;
  const Packer given = support::packed(request);
  EXPECT_EQ(given.state(), State::locked);
  EXPECT_EQ(given.rate(), 0.3);
  const Packing packing = packing_of(given);
  EXPECT_EQ(packing.status, Packing::Status::not_reached);
  EXPECT_GT(packing.suggested_rate, 0);
  EXPECT_LT(packing.suggested_rate, 0.3);
  PackingPlan chosen = plan(request);
  chosen.is_rate_given = false;
  Packer lowered(chosen);
  while (!lowered.is_over()) lowered.advance();
  EXPECT_LT(lowered.rate(), 0.3);
  EXPECT_GT(lowered.collisions(), lowered.simulation().counters().contacts()) << "of all attempts";
}

TEST(Packer, FillsAContainerWithSpheresOfTheDiameterWanted) {
  PackingRequest request;
  request.diameter = 1;
  request.container = Container{.shape = Container::Shape::cylinder, .size = {3.5, 3.5, 6}};
  request.goal = PackingRequest::Densest{};
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::jammed) << packing.reason;
  EXPECT_NEAR(packing.spheres.mean_diameter(), 1, 1e-12);
  EXPECT_EQ(packing.largest_overlap, 0);
  EXPECT_GT(packing.shrink, 0.97);
}

// Most spheres rattle among the large ones, and the median sphere with them.
TEST(Packer, JamsWhereMostSpheresRattle) {
  PackingRequest request;
  request.radii = std::vector<double>(60, 0.1);
  std::fill(request.radii.begin(), request.radii.begin() + 20, 1.0);
  request.goal = PackingRequest::Densest{};
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::jammed);
  EXPECT_GT(packing.pressure, 1e8);
  EXPECT_GT(packing.network.rattlers, 30U);
  EXPECT_GE(packing.network.isostaticity, 0.9);
}

TEST(Packer, EndsAtAPressure) {
  PackingRequest request;
  request.count = 100;
  for (const double pressure : {2.0, 5.0, 10.0, 50.0, 1e4, 1e8}) {
    request.goal = PackingRequest::Pressure{pressure};
    const Packer packer = support::packed(request);
    EXPECT_EQ(packer.state(), State::reached);
    EXPECT_GE(packer.pressure(), pressure);
    EXPECT_LE(packer.pressure(), protocol::kHighest * pressure);
  }
}

// The pressure printed is that at the diameter wanted.
TEST(Packer, ManySpheresOfTheirDiameterReachAPressure) {
  PackingRequest request;
  request.diameter = 1;
  request.container = Container::periodic({6, 6, 6});
  request.goal = PackingRequest::Pressure{8};
  const Packer packer = support::packed(request);
  Packing packing = packing_of(packer);
  EXPECT_EQ(packing.status, Packing::Status::reached) << packing.reason;
  EXPECT_GE(packing.pressure, 8);
  EXPECT_NEAR(packing.spheres.mean_diameter(), 1, 1e-12);
  request.container = Container{.shape = Container::Shape::cylinder, .size = {2, 2, 5}};
  request.goal = PackingRequest::Pressure{1e6};
  EXPECT_EQ(support::pack(request).status, Packing::Status::not_reached) << "no number has that";
}

// Eleven zigzag in the tube: 1 + 10 sqrt(1 - 1/4) = 9.7 of its length, and twelve would take 10.5.
TEST(Packer, FillsATubeWithAsManyAsFit) {
  PackingRequest request;
  request.diameter = 1;
  request.container = Container{.shape = Container::Shape::cylinder, .size = {1.5, 1.5, 10}};
  request.goal = PackingRequest::Densest{};
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::jammed) << packing.reason;
  EXPECT_EQ(packing.spheres.size(), 11U);
  EXPECT_NEAR(packing.spheres.mean_diameter(), 1, 1e-12);
  EXPECT_EQ(packing.largest_overlap, 0);
}

// Three spheres that fill a tube from end to end, and one that fills a box: each has nowhere to go.
TEST(Packer, ReachesAnExactFit) {
  PackingRequest request;
  request.count = 3;
  request.diameter = 10;
  request.container = Container{.shape = Container::Shape::cylinder, .size = {10, 10, 30}};
  const Packing column = support::pack(request);
  EXPECT_EQ(column.status, Packing::Status::reached) << column.reason;
  EXPECT_NEAR(column.spheres.mean_diameter(), 10, 10 * protocol::kExact);
  EXPECT_EQ(column.largest_overlap, 0);
  request.count = 1;
  request.container = Container{.size = {10, 10, 10}, .has_walls = {true, true, true}};
  const Packing alone = support::pack(request);
  EXPECT_EQ(alone.status, Packing::Status::reached) << alone.reason;
  EXPECT_NEAR(alone.spheres.mean_diameter(), 10, 10 * protocol::kExact);
}

// Nearly half of them rattle, and growth by steps for the median sphere locks the others.
TEST(Packer, JamsMixturesOnlyWhereTheyBear) {
  PackingRequest request = support::jammed_request(60, 6);
  request.distribution = RadiusDistribution{
      .kind = RadiusDistribution::Kind::lognormal, .min = 1e-3, .max = 1e3, .mean = 1, .sigma = 0.5};
  request.rate = 0.1;
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::jammed);
  EXPECT_GT(packing.pressure, 1e6);
}

// Contacts, rattlers and gaps, counted again in the numbers that are written.
void expect_told_as_written(const Packing& packing) {
  const PackedSpheres& spheres = packing.spheres;
  const double tolerance = packing.network.tolerance;
  ASSERT_GT(tolerance, 0);
  double least = std::numeric_limits<double>::infinity();
  std::size_t contacts = 0;
  spheres.for_each_near(tolerance, [&](const NearPair& pair) {
    ++contacts;
    least = std::min(least, pair.gap / pair.reach);
  });
  EXPECT_EQ(packing.network.contacts.size(), contacts);
  EXPECT_GT(contacts, 0U);
  EXPECT_EQ(packing.smallest_gap, least);
  std::size_t with_force = 0;
  for (const PackingContact& contact : packing.network.contacts) {
    EXPECT_LE(contact.gap, tolerance * (2 * spheres.mean_diameter()));
    with_force += contact.force > 0 ? 1 : 0;
  }
  EXPECT_GT(with_force, contacts / 2) << "forces are those of the contacts";
}

TEST(Packing, TellsTheContactsOfItsNumbers) {
  PackingRequest request = support::jammed_request(50);
  expect_told_as_written(support::pack(request));
  expect_told_as_written(support::pack(request, Precision::singles));
  request.gap = 0.02;
  const Packing apart = support::pack(request);
  expect_told_as_written(apart);
  EXPECT_GE(apart.smallest_gap, 0.02);
  request.gap = 0;
  request.count.reset();
  request.diameter = 1;
  request.container = Container::periodic({3.4, 3.4, 3.4});
  const Packing reduced = support::pack(request);
  expect_told_as_written(reduced);
  EXPECT_LT(reduced.shrink, 1 - 1e-3);
  EXPECT_NE(reduced.reason.find("reduced to"), std::string::npos) << reduced.reason;
}

TEST(Packing, KeepsTheLabelsOfItsStart) {
  PackingRequest request;
  request.start.emplace();
  request.start->spheres = {{.position = {-1.5, 0.25, 0.8}, .radius = 0.5, .mass = 2, .species = 1},
                            {.position = {3, 4, 1.3}, .radius = 0.25, .mass = 3}};
  request.start->ids = {5, 9};
  request.start->box = SnapshotBox{{-2.1, -0.3, 0.1}, {7.7, 6.1, 5.3}, {true, true, false}};
  request.goal = PackingRequest::Densest{};
  const Packing packing = support::pack(request);
  const Snapshot written = snapshot_of(packing.spheres);
  EXPECT_EQ(written.ids, request.start->ids);
  EXPECT_EQ(written.spheres[0].species, 1);
  EXPECT_EQ(written.spheres[0].mass, 2);
  EXPECT_EQ(written.spheres[1].mass, 3);
  EXPECT_EQ(written.box->low, request.start->box->low);
  // In the numbers of the file, too, nothing overlaps.
  PackedSpheres read = packing.spheres;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const Vec3& position = written.spheres[i].position;
    for (std::size_t axis = 0; axis < 2; ++axis)
      EXPECT_EQ(position[axis] - (written.spheres[1 - i].position[axis]),
                read.positions[i][axis] - read.positions[1 - i][axis]);
    EXPECT_GE(position.z - written.box->low.z, read.radii[i]);
    EXPECT_GE(written.box->low.z + written.box->size.z - position.z, read.radii[i]);
  }
}

TEST(Packer, GrowsSpheresWhereTheyStart) {
  PackingRequest request;
  request.start.emplace();
  for (double x = 0; x < 4; ++x) {
    for (double y = 0; y < 4; ++y) {
      for (double z = 0; z < 4; ++z)
        request.start->spheres.push_back({.position = {x + 0.5, y + 0.5, z + 0.5}, .radius = 0.3});
    }
  }
  request.start->box = SnapshotBox{{}, {4, 4, 4}, {true, true, false}};
  request.goal = 0.5;
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::reached);
  EXPECT_NEAR(packing.packing_fraction(), 0.5, 1e-12);
  EXPECT_TRUE(packing.spheres.container.has_walls[2]);
  for (double& radius : std::vector<double>(packing.spheres.radii))
    EXPECT_EQ(radius, packing.spheres.radii[0]);
  request.start->spheres[1].position = request.start->spheres[0].position;
  EXPECT_THROW(support::pack(request), Error) << "they overlap";
}

TEST(Packer, LeavesTheGapThatIsWanted) {
  PackingRequest request = support::jammed_request(50);
  request.gap = 1e-3;
  const Packing packing = support::pack(request);
  EXPECT_NEAR(packing.shrink, 1 - 1e-3, 1e-12);
  double least = 1;
  packing.spheres.for_each_near(
      0.01, [&](const NearPair& pair) { least = std::min(least, pair.gap / pair.reach); });
  EXPECT_NEAR(least, 1e-3, 2e-6);
}

TEST(Packer, OneSphereFillsItsContainer) {
  PackingRequest request = support::jammed_request(1);
  request.container = Container{.shape = Container::Shape::cone, .size = {6, 6, 4}};
  request.is_container_size_free = false;
  const Packing packing = support::pack(request);
  EXPECT_EQ(packing.status, Packing::Status::jammed);
  EXPECT_NEAR(packing.spheres.radii[0], 1.5, 1e-6);
}

// Within each of the containers whose walls are several surfaces, which nothing reaches beyond.
TEST(Packer, FillsShellsAndTruncatedCones) {
  using Shape = Container::Shape;
  for (const Container& container :
       {Container{.shape = Shape::shell, .size = {6, 6, 6}, .inner = 2},
        Container{.shape = Shape::annulus, .size = {6, 6, 3}, .inner = 2},
        Container{.shape = Shape::truncated_cone, .size = {5, 5, 4}, .inner = 3},
        Container{.shape = Shape::shell, .dimensions = 2, .size = {6, 6, 0}, .inner = 2}}) {
    for (const bool jams : {false, true}) {
      PackingRequest request = support::jammed_request(40);
      request.dimensions = container.dimensions;
      request.container = container;
      request.rate = 0.1;
      if (!jams) request.goal = 0.4;
      const Packing packing = support::pack(request);
      EXPECT_EQ(packing.status, jams ? Packing::Status::jammed : Packing::Status::reached) << packing.reason;
      if (!jams) {
        EXPECT_NEAR(packing.packing_fraction(), 0.4, 1e-12);
      }
      EXPECT_EQ(packing.largest_overlap, 0);
      const World world(container.box(), {}, container.surfaces());
      std::set<std::uint32_t> touched;
      for (std::size_t i = 0; i < packing.spheres.size(); ++i) {
        const Vec3& center = packing.spheres.positions[i];
        const double radius = packing.spheres.radii[i];
        EXPECT_GE(distance_to_surfaces(world, center, Time(0)), radius * (1 - 1e-14));
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          if (!world.box().is_wall(axis)) continue;
          EXPECT_GE(center[axis], radius * (1 - 1e-14));
          EXPECT_LE(center[axis], container.size[axis] - radius * (1 - 1e-14));
        }
      }
      for (const PackingContact& contact : packing.network.contacts) {
        if (!contact.bodies.is_wall) continue;
        touched.insert(contact.bodies.second);
        if (contact.bodies.second >= kFaces) {
          EXPECT_NEAR(length(contact.separation), packing.spheres.radii[contact.bodies.first], 1e-5);
        }
      }
      if (jams) {
        EXPECT_EQ(touched.size(), container.surfaces().size() + (world.box().is_wall(2) ? 2 : 0));
        EXPECT_NEAR(packing.network.isostaticity, 1, 0.15);
      }
    }
  }
}

void expect_end_without_room(const PackingRequest& request, Packing::Status status) {
  Packer packer(plan(request));
  constexpr int kMany = 40;
  for (int k = 0; k < kMany && !packer.is_over(); ++k) packer.advance();
  ASSERT_TRUE(packer.is_over()) << name_of(packer.state());
  const Packing packing = packing_of(packer);
  EXPECT_EQ(packing.status, status);
  EXPECT_EQ(packing.reason, "the largest sphere fills the container");
}

// Four spheres that touch their own images along the shortest edge have pressures of about 200 and 9.
TEST(Packer, EndsBelowThePressureWantedWhereTheLargestSphereFillsTheContainer) {
  PackingRequest request;
  request.count = 4;
  request.goal = PackingRequest::Pressure{1e4};
  for (const double edge : {1.5, 2.0}) {
    request.container = Container::periodic({2, edge, 1});
    expect_end_without_room(request, Packing::Status::not_reached);
  }
}

TEST(Packer, EndsAtOnceWhereTheLargestSphereFillsTheContainerAtTheStart) {
  PackingRequest request;
  request.start.emplace();
  request.start->spheres.push_back({.position = {0.5, 0.5, 0.5}, .radius = 0.5});
  for (double x = 1.5; x < 12; x += 0.25)
    request.start->spheres.push_back({.position = {x, 0.5, 0.3}, .radius = 0.1});
  request.start->box = SnapshotBox{{}, {12, 12, 1}, {true, true, true}};
  request.goal = PackingRequest::Densest{};
  expect_end_without_room(request, Packing::Status::jammed);
}

TEST(Packing, GoesOnAsAGas) {
  PackingRequest request;
  request.count = 100;
  request.goal = 0.55;
  const Packing packing = support::pack(request);
  Simulation simulation(world_of(packing.spheres, 2, 7));
  EXPECT_NEAR(kinetic_energy(simulation.world(), simulation.now()) / 100, 3, 0.8);
  simulation.run_contacts(1000);
  simulation.validate();
}

}  // namespace
}  // namespace hardball::packer_test
