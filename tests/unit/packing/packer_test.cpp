// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "hardball/errors/error.hpp"
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
        EngineOptions{.engine = EngineKind::cells}, EngineOptions{.queue = QueueKind::ordered},
        EngineOptions{.threads = 2}}) {
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
  for (const double pressure : {5.0, 50.0, 1e4}) {
    request.goal = PackingRequest::Pressure{pressure};
    const Packer packer = support::packed(request);
    EXPECT_EQ(packer.state(), State::reached);
    EXPECT_GT(packer.pressure(), 0.7 * pressure);
    EXPECT_LT(packer.pressure(), 3 * pressure);
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

TEST(Packing, GoesOnAsAGas) {
  PackingRequest request;
  request.count = 100;
  request.goal = 0.55;
  const Packing packing = support::pack(request);
  Simulation simulation(world_of(packing.spheres, 2, 7));
  EXPECT_NEAR(simulation.world().kinetic_energy(simulation.now()) / 100, 3, 0.8);
  simulation.run_contacts(1000);
  simulation.validate();
}

}  // namespace
}  // namespace hardball::packer_test
