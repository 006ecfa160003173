// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What the engine requires of all broad phases, in worlds where spheres move and change their paths at
// random.
#include "hardball/broadphase/broad_phase.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "hardball/broadphase/all_pairs.hpp"
#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/broadphase/sheared_cells.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/engine/predictor.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "support/effort.hpp"
#include "support/random_world.hpp"
#include "support/sheared.hpp"

namespace hardball::broad_phase_test {
namespace {

using Partner = std::pair<Slot, std::array<std::int32_t, kAxes>>;

// A broad phase with the compact copies of paths that it reads, made as the engine makes them.
template <class Phase>
class Copying {
 public:
  explicit Copying(const PhaseSettings& settings = {}) : phase_(settings) {}

  void build(const World& world, const Time& now) { phase_.build(world, now, copies_); }
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
    phase_.refresh(world, slot, now, folded);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const {
    phase_.collect(world, slot, candidates);
  }
  double next_crossing(const World& world, Slot slot, const Time& now) {
    copies_.copy(world, slot, now);
    return phase_.next_crossing(world, slot, now, copies_);
  }
  void cross(const World& world, Slot slot, const Time& now, Candidates& candidates) {
    copies_.copy(world, slot, now);
    phase_.cross(world, slot, now, copies_, candidates);
  }
  void validate(const World& world, const Time& now) const { phase_.validate(world, now, copies_); }
  const Phase& phase() const { return phase_; }

 private:
  Phase phase_;
  CompactPaths copies_;
};

// A broad phase that is built at time zero.
template <class Phase>
Copying<Phase> built(const World& world, const PhaseSettings& settings = {}) {
  Copying<Phase> phase(settings);
  phase.build(world, Time(0));
  return phase;
}

// The candidates collected for a sphere at `now`, each with its image. Those with an image of their own may
// not be collected twice, nor include the sphere.
std::set<Partner> partners(const Candidates& candidates, const World& world, const Time& now) {
  std::set<Partner> found;
  const Slot slot = candidates.self();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Slot other = candidates.slot(i);
    const Image image =
        candidates.uses_minimum_image() ? nearest_image(world, slot, other, now) : candidates.image(i);
    if (candidates.uses_minimum_image() && other == slot) continue;
    EXPECT_NE(other, slot);
    const bool is_first = found.emplace(other, image.boxes).second;
    EXPECT_TRUE(is_first || candidates.uses_minimum_image()) << "collected twice";
  }
  return found;
}

template <class Phase>
std::set<Partner> candidates_of(const Copying<Phase>& phase, const World& world, Slot slot,
                                const Time& now = Time(0)) {
  Candidates candidates;
  phase.collect(world, slot, candidates);
  EXPECT_EQ(candidates.self(), slot);
  std::set<Partner> found = partners(candidates, world, now);
  // Where cells share lists, others are collected, too.
  std::erase_if(found,
                [&](const Partner& partner) { return !phase.phase().are_candidates(slot, partner.first); });
  return found;
}

// Whether all candidates are collected for a sphere: a large one may list those alone that can reach it.
template <class Phase>
bool are_all_collected(const Phase& phase, Slot slot) {
  if constexpr (requires { phase.has_approach_list(slot); }) return !phase.has_approach_list(slot);
  return true;
}

// All spheres and images whose surface touches that of the sphere now, found by searching several boxes in
// all directions; in these tests spheres pass through each other, and one may be inside another.
std::set<Partner> touching(const World& world, Slot slot, const Time& now) {
  std::set<Partner> found;
  for (Slot other = 0; other < world.size(); ++other) {
    if (other == slot) continue;
    const Vec3 apart = world.unfolded_position(other, now) - world.unfolded_position(slot, now);
    const double reach = world.base_radius(slot) + world.base_radius(other);
    const double inside = std::fabs(world.base_radius(slot) - world.base_radius(other));
    Image middle;
    Image span;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) continue;
      middle[axis] = static_cast<std::int32_t>(-std::round(apart[axis] / world.box().size()[axis]));
      span[axis] = 2;
    }
    for (std::int32_t y = -span[1]; y <= span[1]; ++y) {
      // Images above and below may have slid along x.
      const double slid = world.box().images().shift(0, middle[1] + y, now);
      const auto behind =
          static_cast<std::int32_t>(world.box().is_sheared() ? std::round(slid / world.box().size().x) : 0);
      for (std::int32_t x = -span[0]; x <= span[0]; ++x) {
        for (std::int32_t z = -span[2]; z <= span[2]; ++z) {
          const Image image = middle + Image{{x - behind, y, z}};
          const double distance = length(apart + world.box().shift(image, now));
          if (inside <= distance && distance <= reach) found.emplace(other, image.boxes);
        }
      }
    }
  }
  return found;
}

// Lets spheres cross cells and change direction, passing through each other. Whenever two spheres touch, they
// must be candidates of each other, and crossings must have returned every new candidate.
template <class Phase>
void fly_about(Copying<Phase> phase, World world, double until, std::uint64_t seed) {
  Random random(seed);
  Time now(0);
  phase.build(world, now);
  std::vector<std::set<Partner>> known;
  std::vector<double> crossings;
  Candidates entered;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    known.push_back(candidates_of(phase, world, slot, now));
    crossings.push_back(phase.next_crossing(world, slot, now));
  }
  const auto mirror = [](Slot slot, const Partner& partner) {
    return Partner{slot, {-partner.second[0], -partner.second[1], -partner.second[2]}};
  };
  constexpr int kSteps = 60;
  for (int step = 0; step < kSteps && world.size() > 0; ++step) {
    // The next crossing, or a change of path before it.
    Slot slot = 0;
    for (Slot other = 1; other < world.size(); ++other) {
      if (crossings[other] < crossings[slot]) slot = other;
    }
    const Time turn = after(now, until * random.uniform() / kSteps);
    ASSERT_GE(crossings[slot], rounded_down(now));
    if (Time(crossings[slot]) <= turn) {
      now = later(now, Time(crossings[slot]));
      phase.cross(world, slot, now, entered);
      ASSERT_EQ(entered.self(), slot);
      const std::set<Partner> shown = partners(entered, world, now);
      for (const Partner& partner : candidates_of(phase, world, slot, now)) {
        ASSERT_TRUE(known[slot].contains(partner) || known[partner.first].contains(mirror(slot, partner)) ||
                    shown.contains(partner));
      }
    } else {
      now = turn;
      slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
      Vec3 velocity = world.path(slot).velocity;
      if (velocity == Vec3{}) velocity = {1, 0, 0};
      Vec3 direction = random.direction();
      if (world.box().is_flat()) direction.z = 0;
      const Image folded = world.change_velocity(slot, now, length(velocity) * direction);
      phase.refresh(world, slot, now, folded);
    }
    crossings[slot] = phase.next_crossing(world, slot, now);
    phase.validate(world, now);
    for (Slot each = 0; each < world.size(); ++each) known[each] = candidates_of(phase, world, each, now);
    for (Slot each = 0; each < world.size(); ++each) {
      for (const Partner& partner : known[each]) {
        ASSERT_TRUE(known[partner.first].contains(mirror(each, partner)) ||
                    !are_all_collected(phase.phase(), partner.first))
            << "only one is a candidate of the other";
      }
      for (const Partner& partner : touching(world, each, now)) {
        ASSERT_TRUE(known[each].contains(partner)) << "spheres " << each << " and " << partner.first;
      }
    }
  }
}

// A part of the box, where spheres begin; many leave it, and some begin elsewhere.
Extent random_part(const World& world, std::uint64_t seed) {
  Random random(seed + 1);
  Extent part;
  if (world.size() == 0) return part;
  const Vec3 middle = world.path(static_cast<Slot>(random.bits() % world.size())).position;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (random.uniform() < 0.2) continue;
    const double size = std::max(world.box().size()[axis], 4 * world.largest_radius());
    part.low[axis] = middle[axis] - 0.4 * size * random.uniform();
    part.high[axis] = middle[axis] + 0.4 * size * random.uniform();
  }
  return part;
}

// A mixture of spheres of radius one and others down to a hundredth of that, in a box of random boundaries;
// some are at rest.
support::RandomWorld make_mixture(std::uint64_t seed) {
  Random random(seed);
  const double size = 5 + static_cast<double>(seed % 3);
  const std::array all = {Boundary::periodic, Boundary::wall, Boundary::open};
  const std::array boundary = {all[random.bits() % 3], all[random.bits() % 3], all[random.bits() % 3]};
  World world(Box(boundary, {size, size * (1 + random.uniform()), size}));
  const std::size_t spheres = 20 + random.bits() % 40;
  for (std::size_t i = 0; i < spheres; ++i) {
    const double radius = i < 2        ? 1
                          : i % 5 == 0 ? std::exp2(-6.6 * random.uniform())
                                       : 0.01 + 0.1 * random.uniform();
    Vec3 place;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      place[axis] = radius + (size - 2 * radius) * random.uniform();
    }
    world.add(
        {place, random.uniform() < 0.1 ? Vec3{} : random.uniform() * 3 * random.direction(), radius, 1});
  }
  return {.world = std::move(world), .until = 3, .name = "mixture " + std::to_string(seed)};
}

// A length that depends on the seed, in radii of the largest sphere.
template <std::size_t kCount>
auto in_radii(const std::array<double, kCount>& lengths) {
  return [lengths](const World& world, std::uint64_t seed) {
    return lengths[seed % kCount] * (world.size() > 0 ? world.largest_radius() : 0.5);
  };
}
constexpr std::array kEdges = {1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0};
constexpr std::array kFineEdges = {1.0, 1.6, 2.2, 2.8, 3.4, 4.0, 4.6};
constexpr std::array kShearedEdges = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
constexpr std::array kShellEdges = {0.25, 0.4, 0.6};
// From the least to the most that boxes allow.
constexpr std::array kSkins = {0.01, 0.1, 0.5, 2.0, 20.0};

// In worlds of which more than `least_suited` are those that the broad phase supports. Spheres may be
// expected only in a part of each.
template <class Phase, class Length>
void fly_about_in(support::RandomWorld (*make)(std::uint64_t), std::uint64_t worlds, const Length& length,
                  std::uint64_t least_suited = 0, bool in_part = false) {
  std::uint64_t suited = 0;
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    const support::RandomWorld made = make(seed);
    const double wanted = length(made.world, seed);
    if (!Phase::supports(made.world, wanted)) continue;
    ++suited;
    SCOPED_TRACE(made.name);
    const Extent expected = in_part ? random_part(made.world, seed) : Extent();
    fly_about(Copying<Phase>(PhaseSettings(wanted).within(expected)), made.world, made.until, seed);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(suited, least_suited);
}
constexpr bool kInPart = true;

TEST(AllPairs, KnowsWhoMayTouch) {
  fly_about_in<AllPairs>(support::make_random_world, support::cases(300), in_radii(kEdges));
}

TEST(CellGrid, KnowsWhoMayTouch) {
  fly_about_in<CellGrid>(support::make_random_world, support::cases(300), in_radii(kEdges));
}

TEST(CellGrid, KnowsWhoMayTouchWhereSpheresAreNotExpected) {
  fly_about_in<CellGrid>(support::make_random_world, support::cases(300), in_radii(kFineEdges), 0, kInPart);
}

TEST(NeighborList, KnowsWhoMayTouch) {
  const std::uint64_t worlds = support::cases(1000);
  fly_about_in<NeighborList>(support::make_random_world, worlds, in_radii(kSkins), worlds / 3);
}

TEST(NeighborList, KnowsWhoMayTouchWhereSpheresAreNotExpected) {
  const std::uint64_t worlds = support::cases(1000);
  fly_about_in<NeighborList>(support::make_random_world, worlds, in_radii(kSkins), worlds / 3, kInPart);
}

TEST(NeighborList, KnowsWhoMayTouchWhereImagesSlide) {
  const std::uint64_t worlds = support::cases(300);
  fly_about_in<NeighborList>(support::make_sheared_world, worlds, in_radii(kSkins), worlds / 3);
}

TEST(ShearedCells, KnowsWhoMayTouch) {
  const std::uint64_t worlds = support::cases(300);
  fly_about_in<ShearedCells>(support::make_sheared_world, worlds, in_radii(kShearedEdges), worlds / 3);
}

TEST(LargeSphereGrid, KnowsWhoMayTouch) {
  const std::uint64_t worlds = support::cases(300);
  fly_about_in<LargeSphereGrid>(make_mixture, worlds, in_radii(kShellEdges), worlds / 2);
}

TEST(LargeSphereGrid, KnowsWhoMayTouchWhereSpheresAreNotExpected) {
  const std::uint64_t worlds = support::cases(300);
  fly_about_in<LargeSphereGrid>(make_mixture, worlds, in_radii(kShellEdges), worlds / 2, kInPart);
}

TEST(LargeSphereGrid, SuitsOnlyMixturesInLargeBoxes) {
  const auto supports = [](double radius, double size, double edge) {
    World world(Box::periodic({size, size, size}));
    world.add({{1, 1, 1}, {}, radius, 1});
    world.add({{size / 2, size / 2, size / 2}, {}, 0.1, 1});
    world.add({{size / 2, size / 2 + 1, size / 2}, {}, 0.1, 1});
    return LargeSphereGrid::supports(world, edge);
  };
  EXPECT_TRUE(supports(1, 10, 0.5));
  EXPECT_FALSE(supports(0.1, 10, 0.5)) << "equal spheres";
  EXPECT_FALSE(supports(1, 10, 0.8)) << "not much larger than a cell";
  EXPECT_FALSE(supports(1, 10, 0.05)) << "most would be large";
  EXPECT_FALSE(supports(1, 5, 0.5)) << "candidates may be half a box apart";
  EXPECT_TRUE(supports(1, 5.2, 0.47)) << "small enough cells";
}

// A shell as thick as the rounding of coordinates along the longest axis would fill all memory.
TEST(LargeSphereGrid, DoesNotSuitABoxThatIsFarLongerAlongOneAxis) {
  const auto supports = [](double length) {
    World world(Box({Boundary::open, Boundary::wall, Boundary::open}, {0, length, 0}));
    world.add({{10, 20, 10}, {}, 8, 1});
    for (int i = 0; i < 9; ++i) world.add({{30, 20.0 + i, 10}, {}, 0.1, 1});
    return LargeSphereGrid::supports(world, 1);
  };
  EXPECT_TRUE(supports(50));
  EXPECT_TRUE(supports(1e9));
  EXPECT_FALSE(supports(1e19));
}

TEST(LargeSphereGrid, NoticesALargeSphereThatLeftItsCellsUnseen) {
  World world(Box::periodic({20, 20, 20}));
  world.add({{5, 5, 5}, {1, 0, 0}, 2, 1});
  world.add({{10, 10, 10}, {}, 0.1, 1});
  auto grid = built<LargeSphereGrid>(world, 1);
  EXPECT_NO_THROW(grid.validate(world, Time(0)));
  EXPECT_THROW(grid.validate(world, Time(1)), BrokenInvariant);
}

TEST(AllPairs, HasAllOthersAsCandidatesInABoxWithWalls) {
  World world(Box::walls({50, 50, 50}));
  for (int i = 0; i < 5; ++i) world.add({{5.0 + 9 * i, 25, 25}, {1, 0, 0}, 1, 1});
  auto phase = built<AllPairs>(world);
  for (Slot slot = 0; slot < 5; ++slot) {
    EXPECT_EQ(candidates_of(phase, world, slot).size(), 4U);
    EXPECT_EQ(phase.next_crossing(world, slot, Time(0)), kNever.high);
  }
}

TEST(CellGrid, HasOnlyNeighborsAsCandidates) {
  World world(Box::walls({50, 50, 50}));
  for (int i = 0; i < 5; ++i) world.add({{5.0 + 9 * i, 25, 25}, {1, 0, 0}, 1, 1});
  auto grid = built<CellGrid>(world, 3);
  for (Slot slot = 0; slot < 5; ++slot) EXPECT_EQ(candidates_of(grid, world, slot).size(), 0U);
  auto coarse = built<CellGrid>(world, 1000);
  for (Slot slot = 0; slot < 5; ++slot) EXPECT_EQ(candidates_of(coarse, world, slot).size(), 4U);
}

// Neighbors are at most this far apart [L].
double farthest_neighbors(double largest_radius, double skin) {
  return 2 * largest_radius + 4 * skin;
}

// How far a distance of anchors may be off: 2.5 units along each axis, at most 512 of which make a cell, here
// of at most 3/2 the wanted edge [L].
double packing_error(double largest_radius, double skin) {
  return std::sqrt(3.0) * 2.5 * 1.5 * (2 * largest_radius + 2 * skin) / 512;
}

// By how much a sphere crosses before it reaches the edge of its ball, at most [L]: the margin, and the
// errors of single precision.
double earliness(double farthest) {
  return farthest * (0x1p-21 + 0x1p-23);
}

TEST(NeighborList, HasThoseAsCandidatesWhoseShellsMeet) {
  const auto count_at = [](double distance, double radius, double skin) {
    World world(Box::walls({50, 50, 50}));
    world.add({{5, 25, 25}, {1, 0, 0}, 1, 1});
    world.add({{5 + distance, 25, 25}, {1, 0, 0}, radius, 1});
    auto list = built<NeighborList>(world, skin);
    EXPECT_EQ(list.phase().lengths().skin, skin);
    EXPECT_EQ(candidates_of(list, world, 0).size(), candidates_of(list, world, 1).size());
    return candidates_of(list, world, 0).size();
  };
  for (const double skin : {0.1, 0.5, 3.0}) {
    // Shells are a little larger than they need to be, and distances are known to some thousandths of a cell.
    const double margin = 0x1p-19 * farthest_neighbors(1, skin);
    const double beyond = margin + 2 * packing_error(1, skin);
    EXPECT_EQ(count_at(2 + 2 * skin + margin / 2, 1, skin), 1U);
    EXPECT_EQ(count_at(2 + 2 * skin + beyond, 1, skin), 0U);
    EXPECT_EQ(count_at(1.25 + 2 * skin + margin / 2, 0.25, skin), 1U);
    EXPECT_EQ(count_at(1.25 + 2 * skin + beyond, 0.25, skin), 0U);
  }
}

// Of two spheres whose shells just meet, as far as can be told, each finds the other if the other finds it.
// Returns in how many cases they do. Spheres may be expected only in a part of the box, which ends nearby.
std::uint64_t count_mutual_neighbors(bool in_part) {
  constexpr double kSkin = 0.25;
  const double error = packing_error(0.5, kSkin);
  Random random(7);
  std::uint64_t neighbors = 0;
  for (std::uint64_t i = 0; i < support::cases(20000); ++i) {
    World world(Box::walls({20, 20, 20}));
    const double first = 0.1 + 0.4 * random.uniform();
    const double second = 0.1 + 0.4 * random.uniform();
    const double distance = first + second + 2 * kSkin + 2 * error * random.uniform();
    const Vec3 place{5 + 10 * random.uniform(), 10, 10};
    world.add({place, {1, 0, 0}, first, 1});
    world.add({place + distance * random.direction(), {1, 0, 0}, second, 1});
    world.add({{2, 2, 2}, {}, 0.5, 1});
    Extent expected;
    if (in_part) expected.high = place + 3 * random.direction();
    auto list = built<NeighborList>(world, PhaseSettings(kSkin).within(expected));
    EXPECT_NO_THROW(list.validate(world, Time(0))) << "case " << i;
    if (testing::Test::HasFailure()) break;
    neighbors += candidates_of(list, world, 0).size();
  }
  return neighbors;
}

TEST(NeighborList, FindsTheSameNeighborsFromEitherSide) {
  const std::uint64_t neighbors = count_mutual_neighbors(false);
  EXPECT_GT(neighbors, support::cases(20000) / 5);
  EXPECT_LT(neighbors, support::cases(20000) * 4 / 5);
}

// Cells elsewhere share lists, and perhaps those around only one of the spheres do.
TEST(NeighborList, FindsTheSameNeighborsFromEitherSideWhereSpheresAreNotExpected) {
  EXPECT_GT(count_mutual_neighbors(true), support::cases(20000) / 50);
}

// The outermost cells of an open axis hold whatever lies beyond, where places in cells say nothing.
TEST(NeighborList, FindsNeighborsBeyondTheOutermostCells) {
  constexpr Boundary kOpen = Boundary::open;
  constexpr double kSkin = 0.5;
  constexpr double kDistance = 2.25;
  const double farthest = farthest_neighbors(1, kSkin);
  // The outermost cells begin here.
  const double end = 0x1p27 * (farthest - 2 * kSkin + 2 * 0x1p-19 * farthest);
  std::vector<double> places{1.01 * end, 3 * end, 1e3 * end};
  // More than the ring of the grid of compact paths.
  for (double beyond = -10; beyond < 70 * farthest; ++beyond) places.push_back(end + beyond);
  for (const double far : places) {
    for (const double sign : {-1, 1}) {
      SCOPED_TRACE(sign * far);
      World world(Box({kOpen, kOpen, kOpen}, {1, 1, 1}));
      world.add({{sign * far, 0, 0}, {}, 1, 1});
      world.add({{sign * (far + kDistance), 0, 0}, {}, 1, 1});
      world.add({{sign * far, 40, 0}, {}, 1, 1});
      auto list = built<NeighborList>(world, kSkin);
      ASSERT_TRUE(candidates_of(list, world, 0).contains({1, {0, 0, 0}}));
      ASSERT_TRUE(candidates_of(list, world, 1).contains({0, {0, 0, 0}}));
      ASSERT_TRUE(candidates_of(list, world, 2).empty());
    }
  }
}

// In a box of more cells than can be counted, cells are larger than the ring of the grid of compact paths.
TEST(NeighborList, FindsNeighborsInCellsOfAnySize) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    for (const double size : {1e9, 1e10, 3e11, 1e12, 1e14}) {
      for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(testing::Message() << size << ", " << i);
        World world(Box({boundary, boundary, boundary}, {size, 100, 100}));
        const double place = 0.3 * size + i;
        world.add({{place, 50, 50}, {}, 1, 1});
        world.add({{place + 2.25, 50, 50}, {}, 1, 1});
        world.add({{place, 50, 80}, {}, 1, 1});
        auto list = built<NeighborList>(world, 0.5);
        ASSERT_TRUE(candidates_of(list, world, 0).contains({1, {0, 0, 0}}));
        ASSERT_TRUE(candidates_of(list, world, 1).contains({0, {0, 0, 0}}));
        ASSERT_TRUE(candidates_of(list, world, 2).empty());
      }
    }
  }
}

TEST(NeighborList, ChangesBothListsWhenASphereCrosses) {
  World world(Box::periodic({20, 20, 20}));
  world.add({{15, 5, 5}, {1, 0, 0}, 0.5, 1});
  world.add({{16, 6, 5}, {}, 0.5, 1});
  world.add({{3, 5, 5}, {}, 0.5, 1});
  auto list = built<NeighborList>(world, 0.5);
  EXPECT_EQ(candidates_of(list, world, 1), (std::set<Partner>{{0, {0, 0, 0}}}));
  EXPECT_TRUE(candidates_of(list, world, 2).empty());
  Candidates entered;
  Time now(0);
  std::vector<Slot> met;
  while (now < Time(7.2)) {
    now = Time(list.next_crossing(world, 0, now));
    list.cross(world, 0, now, entered);
    list.validate(world, now);
    for (std::size_t i = 0; i < entered.size(); ++i) met.push_back(entered.slot(i));
  }
  // One ball of radius 0.5 after another: the anchor is at 15 + 7.5 = 2.5, beyond the edge of the box.
  EXPECT_NEAR(now.value(), 7.5, 15 * earliness(farthest_neighbors(0.5, 0.5)));
  EXPECT_EQ(met, std::vector<Slot>{2}) << "only new candidates are collected";
  EXPECT_TRUE(candidates_of(list, world, 1, now).empty());
  EXPECT_EQ(candidates_of(list, world, 2, now), (std::set<Partner>{{0, {-1, 0, 0}}}));
}

TEST(NeighborList, CrossesAtTheEdgeOfItsBall) {
  constexpr double kSkin = 0.4;
  const double early = earliness(farthest_neighbors(0.5, kSkin));
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    World world(Box::periodic({20, 20, 20}));
    const double speed = std::exp2(20 * random.uniform() - 10);
    world.add({{19.9, 5, 5}, speed * random.direction(), 0.5, 1});
    auto list = built<NeighborList>(world, kSkin);
    const double crossing = list.next_crossing(world, 0, Time(0));
    ASSERT_LE(crossing * speed, kSkin);
    ASSERT_GE(crossing * speed, kSkin - early);
    for (const double part : {0.3, 0.9}) {
      // From anywhere on the path, the crossing is at the same place.
      const double again = list.next_crossing(world, 0, Time(part * crossing));
      ASSERT_LE(again * speed, kSkin);
      ASSERT_GE(again * speed, kSkin - early);
    }
    // It turns within its ball: the path to the edge is a chord, which meets the edge at a cosine of more
    // than 0.7.
    const Time turn(0.7 * crossing);
    world.change_velocity(0, turn, speed * random.direction());
    const Time edge(list.next_crossing(world, 0, turn));
    ASSERT_NO_THROW(list.validate(world, edge));
    ASSERT_THROW(list.validate(world, after(edge, 2 * early / 0.7 / speed)), BrokenInvariant);
  }
}

TEST(NeighborList, LeavesItsBallHoweverSlowly) {
  constexpr double kSkin = 0.25;
  const double early = earliness(farthest_neighbors(0.5, kSkin));
  for (const double speed : {1e-100, 1e-130, 1e-162, 1e-200, 1e-297}) {
    World world(Box::walls({10, 10, 10}));
    world.add({{5, 5, 5}, {1, 0, 0}, 0.5, 1});
    world.rewrite_path(0, Time(0), {speed, 0, 0});
    auto list = built<NeighborList>(world, kSkin);
    const Time first(list.next_crossing(world, 0, Time(0)));
    EXPECT_NEAR(first.value() * speed, kSkin, early);
    Candidates candidates;
    list.cross(world, 0, first, candidates);
    EXPECT_NEAR(list.next_crossing(world, 0, first) * speed, 2 * kSkin, 2 * early);
  }
}

TEST(NeighborList, NeverLeavesItsBallAtRest) {
  World world;
  world.add({{1, 2, 3}, {}, 0.5, 1});
  auto list = built<NeighborList>(world, 0.1);
  for (const Time& now : {Time(0), Time(1e300)}) {
    EXPECT_EQ(list.next_crossing(world, 0, now), kNever.high);
  }
}

TEST(NeighborList, SuitsBoxesInWhichNoTwoImagesOfANeighborAreNear) {
  const auto supports = [](const Box& box, double radius) {
    World world(box);
    world.add({{1, 1, 1}, {}, radius, 1});
    return NeighborList::supports(world);
  };
  // Two diameters of 0.5 and four skins of a fiftieth of a radius: 1.04 within 0.33 of the box.
  EXPECT_TRUE(supports(Box::periodic({3.2, 3.2, 3.2}), 0.5));
  EXPECT_FALSE(supports(Box::periodic({3.1, 3.2, 3.2}), 0.5));
  EXPECT_FALSE(supports(Box::periodic({3.2, 3.2, 3.1}), 0.5));
  EXPECT_TRUE(supports(Box::walls({2.5, 2.5, 2.5}), 0.5)) << "no images";
  EXPECT_TRUE(supports(Box(), 0.5));
  EXPECT_TRUE(supports(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {2.5, 3.2, 0}), 0.5));
  EXPECT_FALSE(supports(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {2.5, 3.1, 0}), 0.5));
  World narrow(Box::periodic({3, 3, 3}));
  narrow.add({{1, 1, 1}, {}, 0.5, 1});
  Copying<NeighborList> list(0.1);
  EXPECT_THROW(list.build(narrow, Time(0)), BrokenInvariant);
}

TEST(NeighborList, TakesAsMuchSkinAsTheBoxHasRoomForAndNeverNone) {
  const auto skin_in = [](double size, double wanted) {
    World world(Box::periodic({size, 100, 100}));
    world.add({{1, 1, 1}, {}, 0.5, 1});
    auto list = built<NeighborList>(world, wanted);
    return list.phase().lengths().skin;
  };
  EXPECT_EQ(skin_in(10, 0.3), 0.3);
  EXPECT_DOUBLE_EQ(skin_in(10, 100), (3.3 - 1) / 4);
  EXPECT_DOUBLE_EQ(skin_in(10, 0), 0.01);
  EXPECT_DOUBLE_EQ(skin_in(10, -1), 0.01);
}

TEST(NeighborList, NoticesASphereThatLeftItsBallUnseen) {
  World world(Box::periodic({20, 20, 20}));
  world.add({{19.9, 5, 5}, {1, 0, 0}, 0.5, 1});
  auto list = built<NeighborList>(world, 0.5);
  EXPECT_NO_THROW(list.validate(world, Time(0.499)));
  EXPECT_THROW(list.validate(world, Time(0.501)), BrokenInvariant);
}

// By how much cells of edge 1 admit a sphere early [L].
double margin(const Box& box, std::size_t axis) {
  return Subdivision(box, 1, 1 << 28).reach(axis, 0);
}

TEST(CellGrid, CountsTheRowsOfCellsThatSpheresLeave) {
  World world;
  world.add({{0.5, 0.5, 0.5}, {1, 0, 0}, 0.25, 1});
  auto grid = built<CellGrid>(world, 1);
  constexpr int kCrossings = 10;
  Candidates entered;
  Time next(grid.next_crossing(world, 0, Time(0)));
  for (int i = 0; i < kCrossings; ++i) {
    grid.cross(world, 0, next, entered);
    next = Time(grid.next_crossing(world, 0, next));
  }
  // It enters cell 10 when its front reaches 10; by then it has left cells 0 to 8.
  EXPECT_NEAR(next.value(), 10.25 - margin(world.box(), 0), 1e-12);
  EXPECT_EQ(grid.phase().left_count(), 9U);
}

TEST(CellGrid, CountsTheRowsThatSpheresLeaveInEveryDirection) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const double speed : {1.0, -1.0}) {
      World world(Box::periodic({10, 10, 10}));
      Vec3 velocity;
      velocity[axis] = speed;
      world.add({{0.5, 0.5, 0.5}, velocity, 0.25, 1});
      auto grid = built<CellGrid>(world, 1);
      Candidates entered;
      Time next(grid.next_crossing(world, 0, Time(0)));
      for (std::uint64_t i = 0; i < 25; ++i) {
        EXPECT_NEAR(next.value(), 0.25 + static_cast<double>(i) - margin(world.box(), axis), 1e-12);
        grid.cross(world, 0, next, entered);
        // It has just entered a cell and not yet left the previous one.
        EXPECT_EQ(grid.phase().left_count(), i);
        grid.validate(world, next);
        next = Time(grid.next_crossing(world, 0, next));
      }
      // At rest in between it keeps the cells it touches, and never crosses again.
      const Time now(24.8);
      grid.refresh(world, 0, now, world.change_velocity(0, now, {}));
      EXPECT_EQ(grid.phase().left_count(), 25U);
      grid.validate(world, now);
      EXPECT_EQ(grid.next_crossing(world, 0, now), kNever.high);
    }
  }
}

TEST(CellGrid, CountsNoMoreRowsAsLeftBecauseAPathIsFolded) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{9.5, 5.5, 5.5}, {1, 0, 0}, 0.25, 1});
  auto grid = built<CellGrid>(world, 1);
  Candidates entered;
  for (Time next(grid.next_crossing(world, 0, Time(0))); next < Time(2);) {
    grid.cross(world, 0, next, entered);
    next = Time(grid.next_crossing(world, 0, next));
  }
  // At time 2 it is at 11.5: in cell 11, having left cell 9 and, once refreshed, 10.
  const Image folded = world.change_velocity(0, Time(2), {0, 1, 0});
  ASSERT_EQ(folded, (Image{{1, 0, 0}}));
  const std::uint64_t left = grid.phase().left_count();
  grid.refresh(world, 0, Time(2), folded);
  EXPECT_EQ(grid.phase().left_count(), left + 1);
  grid.validate(world, Time(2));
}

TEST(BroadPhase, NextCrossingIsNeverBeforeNow) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{5, 5, 5}, {1, 0, 0}, 0.25, 1});
  auto grid = built<CellGrid>(world, 1);
  auto pairs = built<AllPairs>(world);
  auto list = built<NeighborList>(world, 0.5);
  for (const Time& now : {Time(0), Time(9), Time(9, 1e-20), Time(9, -1e-20)}) {
    EXPECT_GE(list.next_crossing(world, 0, now), rounded_down(now));
    EXPECT_GE(grid.next_crossing(world, 0, now), rounded_down(now));
    EXPECT_GE(pairs.next_crossing(world, 0, now), rounded_down(now));
  }
}

// Crossings come from copies in single precision: against the exact path, they are off by less than half the
// margin by which cells admit spheres early.
TEST(CellGrid, CrossesWithinHalfTheMargin) {
  constexpr double kScales[] = {1e-10, 1, 1e20};
  std::uint64_t early = 0;
  std::uint64_t late = 0;
  for (std::uint64_t seed = 0; seed < support::cases(300); ++seed) {
    Random random(seed);
    const double scale = kScales[seed % 3];
    const double radius = scale * std::exp2(3 * random.uniform() - 1);  // up to four edges
    const double size = 40 * scale;
    const std::array all = {Boundary::periodic, Boundary::wall, Boundary::open};
    const std::array boundary = {all[random.bits() % 3], all[random.bits() % 3], all[random.bits() % 3]};
    World world(Box(boundary, {size, size, size}));
    const double start = seed % 2 == 0 ? 0 : 1000 * random.uniform();
    for (int i = 0; i < 30; ++i) {
      Vec3 place;
      Vec3 velocity;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        place[axis] = radius + (size - 2 * radius) * random.uniform();
        velocity[axis] = scale * random.normal() * (random.uniform() < 0.2 ? 1e-9 : 1);
        if (random.uniform() < 0.1) velocity[axis] = random.uniform() < 0.5 ? 0 : 1e-40 * scale;
      }
      world.add({place, velocity, radius, 1}, Time(start));
    }
    const double edge = scale * (1 + random.uniform());
    Copying<CellGrid> grid(edge);
    const Time now(start);
    grid.build(world, now);
    const Subdivision cells(world.box(), edge, 1 << 28);
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const Path& path = world.path(slot);
      const CellRange range = cells.range_at(path.position, radius);
      const CellCrossing next = cells.next_enter(path.position, path.velocity, {}, radius, range);
      const double expected = next.wait;
      const double found = grid.next_crossing(world, slot, now);
      if (!(expected < kNever.high)) {
        ASSERT_EQ(found, kNever.high) << "seed " << seed;
        continue;
      }
      const double speed = std::fabs(path.velocity[next.axis]);
      const double margin = cells.reach(next.axis, radius) - radius;
      const double rounding = 0x1p-50 * (start + expected) * speed;
      const double way = (found - (start + expected)) * speed;
      ASSERT_LT(std::fabs(way), margin / 2 + rounding) << "seed " << seed << " slot " << slot;
      early += way < -rounding ? 1U : 0U;
      late += way > rounding ? 1U : 0U;
    }
  }
  EXPECT_GT(early, support::cases(300) * 5) << "single precision is in use";
  EXPECT_GT(late, support::cases(300) * 5);
}

TEST(CellGrid, UsesNearestImagesOnlyWhereTheBoxIsManyCellsWide) {
  // A sphere of diameter 1 touches at most two cells of edge 1.5 along an axis: two that share one lie less
  // than three cells apart, which is less than half a box of seven.
  const auto nearest_in = [](const Vec3& size, const std::array<Boundary, kAxes>& boundary) {
    World world(Box(boundary, size));
    world.add({{1, 1, 1}, {1, 0, 0}, 0.5, 1});
    auto grid = built<CellGrid>(world, 1.5);
    return grid.phase().uses_minimum_image();
  };
  constexpr std::array kPeriodic = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  EXPECT_TRUE(nearest_in({10.5, 10.5, 10.5}, kPeriodic));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const double size : {1.5, 3.0, 4.5, 9.0, 10.4}) {
      Vec3 small{10.5, 10.5, 10.5};
      small[axis] = size;
      EXPECT_FALSE(nearest_in(small, kPeriodic)) << size;
      std::array<Boundary, kAxes> walled = kPeriodic;
      walled[axis] = Boundary::wall;
      EXPECT_TRUE(nearest_in(small, walled)) << "no images along this axis";
      walled[axis] = Boundary::open;
      EXPECT_TRUE(nearest_in(small, walled));
    }
  }
}

// In a box only a few cells wide a sphere may meet several images of another, or one that is not the nearest:
// each contact that all pairs find before one of the two crosses must be found by the grid.
TEST(CellGrid, FindsEveryImageInASmallBox) {
  std::uint64_t contacts = 0;
  std::uint64_t with_far_copies = 0;
  std::uint64_t with_several_copies = 0;
  for (std::uint64_t seed = 0; seed < support::cases(2000); ++seed) {
    const support::RandomWorld made =
        support::make_random_gas(seed, {Boundary::periodic, Boundary::periodic, Boundary::periodic}, 5);
    const World& world = made.world;
    if (world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    Copying<CellGrid> grid(2 * world.largest_radius() * (0.4 + 0.3 * static_cast<double>(seed % 7)));
    Copying<AllPairs> pairs;
    grid.build(world, Time(0));
    pairs.build(world, Time(0));
    if (grid.phase().uses_minimum_image()) continue;
    std::vector<double> crossings;
    for (Slot slot = 0; slot < world.size(); ++slot) {
      crossings.push_back(
          std::min(grid.next_crossing(world, slot, Time(0)), pairs.next_crossing(world, slot, Time(0))));
    }
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const std::set<Partner> known = candidates_of(grid, world, slot);
      for (const auto& [other, boxes] : known)
        with_several_copies += known.count({other, {boxes[0] + 1, boxes[1], boxes[2]}});
      Candidates all;
      pairs.collect(world, slot, all);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Slot other = all.slot(i);
        const Time contact = contact_time(world, slot, other, all.image(i));
        if (contact == kNever || contact.high > std::min(crossings[slot], crossings[other])) continue;
        ++contacts;
        with_far_copies += all.image(i) == nearest_image(world, slot, other, Time(0)) ? 0U : 1U;
        ASSERT_TRUE(known.contains({other, all.image(i).boxes})) << "spheres " << slot << " and " << other;
      }
    }
  }
  // All these cases occur.
  EXPECT_GT(contacts, support::cases(2000) / 4);
  EXPECT_GT(with_far_copies, support::cases(2000) / 100);
  EXPECT_GT(with_several_copies, support::cases(2000));
}

TEST(CellGrid, RefusesCellsThatAreTooSmall) {
  World world(Box::walls({10, 10, 10}));
  world.add({{5, 5, 5}, {}, 1, 1});
  for (const double edge : {0.0, -1.0, 0.01, std::numeric_limits<double>::quiet_NaN()}) {
    Copying<CellGrid> grid(edge);
    EXPECT_THROW(grid.build(world, Time(0)), Error);
  }
  Copying<CellGrid> grid(0.4);  // the remedy named by the message
  EXPECT_NO_THROW(grid.build(world, Time(0)));
}

TEST(CellGrid, NoticesASphereThatLeftItsCellsUnseen) {
  World world(Box::periodic({20, 20, 20}));
  world.add({{5, 5, 5}, {1, 0, 0}, 0.5, 1});
  auto grid = built<CellGrid>(world, 1);
  EXPECT_NO_THROW(grid.validate(world, Time(0)));
  EXPECT_THROW(grid.validate(world, Time(3)), BrokenInvariant);
}

}  // namespace
}  // namespace hardball::broad_phase_test
