// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Worlds full of contacts at one moment, in numbers so simple that the moments are equal to the last bit: one
// history by every engine, queue and instruction set, whatever the ids and slots of the spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/instruction_sets.hpp"

namespace hardball::ties_test {
namespace {

using support::History;

constexpr double kEdge = 16;

std::size_t below(Random& random, std::size_t count) {
  return random.bits() % count;
}

// The spheres of diameter one that a test makes, added in any order and stored in another.
class Scene {
 public:
  explicit Scene(std::uint64_t seed) : random_(seed) {}

  Random& random() { return random_; }
  void add(const Vec3& place, const Vec3& velocity) { spheres_.push_back({place, velocity, 0.5, 1}); }

  World world(Boundary boundary) {
    World world(Box({boundary, boundary, boundary}, {kEdge, kEdge, kEdge}));
    for (const std::size_t i : any_order<std::size_t>()) world.add(spheres_[i]);
    world.reorder(any_order<Slot>());
    return world;
  }

 private:
  template <class Index>
  std::vector<Index> any_order() {
    std::vector<Index> order(spheres_.size());
    std::iota(order.begin(), order.end(), Index{0});
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[below(random_, i)]);
    return order;
  }

  Random random_;
  std::vector<Sphere> spheres_;
};

// Runs a world in every way, and returns how many contacts happened at the moment of the one before.
std::uint64_t ties_in_one_history(const World& world, const RunLimits& limits) {
  std::optional<History> expected;
  for (const support::EngineVariant& variant : support::engine_variants(world)) {
    const bool has_kernels = variant.options.engine != EngineKind::paper;
    for (const InstructionSet set : support::available_instruction_sets()) {
      if (!has_kernels && set != InstructionSet::portable) continue;
      SCOPED_TRACE(variant.name + ", instruction set " + std::to_string(static_cast<int>(set)));
      EngineOptions options = variant.options;
      options.instructions = set;
      Simulation simulation(world, options);
      const History history = support::run_on(simulation, limits);
      EXPECT_NO_THROW(simulation.validate());
      if (!expected) expected = history;
      EXPECT_EQ(support::difference(*expected, history), "");
      if (testing::Test::HasFailure()) return 0;
    }
  }
  Simulation simulation(world);
  const std::vector<Contact> log = support::record(simulation, limits);
  std::uint64_t ties = 0;
  for (std::size_t i = 1; i < log.size(); ++i) ties += log[i].time == log[i - 1].time ? 1U : 0U;
  return ties;
}

// A row of spheres along an axis, at integer places, some of which move.
void add_row(Scene& scene, std::size_t axis, double second, double third, bool is_closed) {
  Random& random = scene.random();
  const std::size_t moving = 1 + below(random, 2);
  const std::size_t places = static_cast<std::size_t>(kEdge) - (is_closed ? 1 : 0);
  std::vector<double> taken;
  for (std::size_t place = is_closed ? 1 : 0; place < places; ++place) {
    if (random.uniform() < 0.4) taken.push_back(static_cast<double>(place));
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    Vec3 place;
    place[axis] = taken[i];
    place[(axis + 1) % kAxes] = second;
    place[(axis + 2) % kAxes] = third;
    Vec3 velocity;
    if (i < moving) velocity[axis] = random.uniform() < 0.5 ? -1 : 1;
    scene.add(place, velocity);
  }
}

TEST(Ties, OfNewtonsCradlesSideBySide) {
  std::uint64_t ties = 0;
  for (std::uint64_t seed = 0; seed < support::cases(60); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene(seed);
    const bool is_closed = seed % 2 == 0;
    for (const double second : {2.0, 4.0, 6.0, 9.0}) {
      add_row(scene, seed % kAxes, second, seed % 4 < 2 ? 5 : second + 1, is_closed);
    }
    ties += ties_in_one_history(scene.world(is_closed ? Boundary::wall : Boundary::periodic),
                                {.until = Time(40), .contacts = 400});
    if (HasFailure()) return;
  }
  EXPECT_GT(ties, 50 * support::cases(60));
}

// Rows that cross in the middle of the box.
TEST(Ties, OfRowsThatCross) {
  std::uint64_t ties = 0;
  for (std::uint64_t seed = 0; seed < support::cases(60); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene(seed);
    const bool is_closed = seed % 2 == 0;
    // One sphere in the middle; the rows begin two places from it on.
    scene.add({8, 8, 8}, {});
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        for (double distance = 2; distance < 7; distance += 1) {
          if (scene.random().uniform() < 0.5) continue;
          Vec3 place{8, 8, 8};
          place[axis] += side * distance;
          Vec3 velocity;
          velocity[axis] = -side;
          scene.add(place, velocity);
        }
      }
    }
    ties += ties_in_one_history(scene.world(is_closed ? Boundary::wall : Boundary::periodic),
                                {.until = Time(20), .contacts = 200});
    if (HasFailure()) return;
  }
  EXPECT_GT(ties, 5 * support::cases(60));
}

// Pairs that meet on a plane in the middle, return to the walls, and reach both at one moment.
TEST(Ties, OfMirroredPairsAndWalls) {
  std::uint64_t ties = 0;
  for (std::uint64_t seed = 0; seed < support::cases(60); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene(seed);
    for (const double y : {2.0, 5.0, 8.0, 11.0}) {
      for (const double z : {3.0, 6.0}) {
        const double distance = 1 + static_cast<double>(below(scene.random(), 4));
        const double speed = static_cast<double>(1 + below(scene.random(), 2));
        scene.add({8 - distance, y, z}, {speed, 0, 0});
        scene.add({8 + distance, y, z}, {-speed, 0, 0});
      }
    }
    // One that meets nothing but walls, when the pairs do.
    scene.add({8, 8, 12}, {1, 0, 0});
    ties += ties_in_one_history(scene.world(Boundary::wall), {.until = Time(64), .contacts = 400});
    if (HasFailure()) return;
  }
  EXPECT_GT(ties, 50 * support::cases(60));
}

// Spheres that touch from the start, three and more at once, up to whole layers.
TEST(Ties, OfThreeSpheresAndMore) {
  std::uint64_t ties = 0;
  for (std::uint64_t seed = 0; seed < support::cases(100); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene(seed);
    Random& random = scene.random();
    for (double x = 4; x < 8; x += 1) {
      for (double y = 4; y < 8; y += 1) {
        for (double z = 4; z < 6; z += 1) {
          if (random.uniform() < 0.3) continue;
          Vec3 velocity;
          if (random.uniform() < 0.7) velocity[below(random, kAxes)] = random.uniform() < 0.5 ? -1 : 1;
          scene.add({x, y, z}, velocity);
        }
      }
    }
    ties += ties_in_one_history(scene.world(seed % 2 == 0 ? Boundary::wall : Boundary::periodic),
                                {.until = Time(30), .contacts = 300});
    if (HasFailure()) return;
  }
  EXPECT_GT(ties, 20 * support::cases(100));
}

}  // namespace
}  // namespace hardball::ties_test
