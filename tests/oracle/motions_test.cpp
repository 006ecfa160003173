// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Worlds with prescribed motions: one history for all engines, domains and processes, however the run is
// split; and contacts with rotors against roots in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/pieces.hpp"
#include "support/thread_processes.hpp"

namespace hardball::motions_test {
namespace {

using namespace support;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct DrivenWorld {
  World world;
  std::vector<DrivenMotion> motions;
  double until = 0;
  std::string name;
};

PrescribedMotion random_motion(Random& random, const Vec3& center, bool is_flat) {
  const double tolerance = std::pow(10.0, -1.5 - 2 * random.uniform());
  const auto direction = [&] {
    Vec3 vector = random.normal_vector(kAxes);
    if (is_flat) vector.z = 0;
    return vector;
  };
  switch (random.bits() % 3) {
    case 0:
      return PrescribedMotion::rotation(center, is_flat ? Vec3{0, 0, 1} : direction(), random.normal(),
                                        tolerance);
    case 1:
      return PrescribedMotion::oscillation(direction(), 0.4, 2 * random.uniform() + 0.1, tolerance);
    default:
      std::vector<Keyframe> rows;
      const bool repeats = random.bits() % 2 == 0;
      double time = random.bits() % 2 == 0 ? 0 : 0.1;
      for (int row = 0; row < 5; ++row, time += 0.05 + random.uniform())
        rows.push_back({time, 0.5 * direction()});
      if (repeats) rows.back().position = rows.front().position;
      return PrescribedMotion::keyframes(rows, repeats, tolerance);
  }
}

// A periodic box, walls or a box with a floor and a lid that may move, with spheres on a lattice, of which
// some are driven.
DrivenWorld make_driven_world(std::uint64_t seed) {
  constexpr std::size_t kAlong = 4;
  constexpr double kSpacing = 2.5;
  constexpr double kSize = kAlong * kSpacing;
  Random random(seed);
  DrivenWorld made;
  const bool is_flat = random.bits() % 4 == 0;
  const bool falls = random.bits() % 2 == 0;
  const bool has_planes = random.bits() % 2 == 0;
  const std::size_t up = is_flat ? 1 : 2;
  std::array<Boundary, kAxes> boundary{Boundary::periodic, Boundary::periodic, Boundary::periodic};
  if (is_flat) boundary[2] = Boundary::flat;
  if (has_planes) boundary[up] = Boundary::open;
  Vec3 normal;
  normal[up] = 1;
  std::vector<Surface> surfaces;
  if (has_planes)
    surfaces = {Surface(Plane(normal), -1 * normal), Surface(Plane(-1 * normal), (kSize + 1) * normal)};
  Vec3 gravity;
  if (falls) gravity[up] = -1 - random.uniform();
  made.world = World(Box(boundary, {kSize, kSize, kSize}), gravity, surfaces);
  std::vector<SphereId> rotor;
  std::vector<SphereId> shaker;
  for (std::size_t i = 0; i < kAlong * kAlong * (is_flat ? 1 : kAlong); ++i) {
    Sphere sphere;
    sphere.radius = 0.3 + 0.3 * random.uniform();
    for (std::size_t axis = 0, place = i; axis < (is_flat ? 2 : kAxes); ++axis, place /= kAlong) {
      sphere.position[axis] = kSpacing * (static_cast<double>(place % kAlong) + 0.5);
      sphere.velocity[axis] = random.normal();
    }
    const bool is_low = has_planes && (sphere.position[up] < 2 || sphere.position[up] > kSize - 2);
    const bool is_rotor = i % 7 == 3 && !is_low;
    const bool is_shaker = i % 7 == 5 && !is_low;
    if (is_rotor || is_shaker) sphere.mass = kInfinity;
    const SphereId id = made.world.add(sphere);
    if (is_rotor) rotor.push_back(id);
    if (is_shaker) shaker.push_back(id);
  }
  // Planes reflect what rotates far.
  const Vec3 center{kSize / 2, kSize / 2, is_flat ? 0 : kSize / 2};
  PrescribedMotion turning = random_motion(random, center, is_flat);
  while (has_planes && turning.name() == "rotation") turning = random_motion(random, center, is_flat);
  if (!rotor.empty()) made.motions.emplace_back("rotor", turning, rotor);
  const auto shaking = PrescribedMotion::oscillation(normal, 0.3, 1.7, 0.02);
  if (!shaker.empty()) made.motions.emplace_back("shaker", shaking, shaker);
  if (has_planes) {
    made.motions.emplace_back("floor", PrescribedMotion::oscillation(normal, 0.2, 1.1, 0.02),
                              std::vector<SphereId>(), std::vector<std::uint32_t>{kFaces});
    const std::vector<Keyframe> rows{{0.25, {}}, {2, -1 * normal}, {4, {}}};
    if (random.bits() % 2 == 0)
      made.motions.emplace_back("lid", PrescribedMotion::keyframes(rows, true), std::vector<SphereId>(),
                                std::vector<std::uint32_t>{kFaces + 1});
  }
  made.until = 3;
  made.name = "world " + to_text(seed) + (falls ? ", gravity" : "") + (has_planes ? ", planes" : "") +
              (is_flat ? ", flat" : "");
  return made;
}

void drive(Simulation& simulation, const DrivenWorld& made) {
  for (const DrivenMotion& motion : made.motions) simulation.drive(motion);
}

History with_work(const Simulation& simulation, History history) {
  for (const DrivenMotion& motion : simulation.motions()) {
    history.more.push_back(simulation.work_of(motion));
    history.more.push_back(motion.next());
  }
  for (const Surface& surface : simulation.world().surfaces()) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      history.more.push_back(surface.point()[axis]);
      history.more.push_back(surface.velocity()[axis]);
    }
  }
  return history;
}

double next_action(const Simulation& simulation) {
  double next = kInfinity;
  for (const DrivenMotion& motion : simulation.motions()) next = std::min(next, motion.next());
  return next;
}

class Motions : public testing::TestWithParam<std::uint64_t> {};

constexpr std::uint64_t kWorlds = 120;
constexpr std::uint64_t kParts = 4;

TEST_P(Motions, GiveOneHistory) {
  std::uint64_t contacts = 0;
  double work = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const DrivenWorld made = make_driven_world(seed);
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(made.until), .contacts = 100 + 100 * (seed % 5)};
    std::vector<EngineVariant> variants = engine_variants(made.world);
    const std::vector<EngineVariant> divided = divided_variants();
    variants.insert(variants.end(), divided.begin(), divided.end());
    const auto run = [&](Simulation& simulation, const EngineVariant&, bool) {
      drive(simulation, made);
      Simulation split(simulation);
      const History history = with_work(simulation, validated_run(simulation, limits));
      if (history.failure.empty()) {
        Random random(seed);
        const History pieces = with_work(split, run_in_pieces(split, limits, random, next_action));
        EXPECT_EQ(difference(history, pieces), "") << "in pieces";
      }
      return history;
    };
    const std::optional<History> history = one_history(made.world, variants, run, true);
    if (!history) return;
    EXPECT_EQ(history->failure, "");
    contacts += history->contacts;
    for (std::size_t k = 0; k < made.motions.size(); ++k) work += std::fabs(history->more[2 * k]);
  }
  EXPECT_GT(contacts, 30 * cases(kWorlds) / kParts);
  EXPECT_GT(work, 1);
}

TEST_P(Motions, GiveOneHistoryInProcesses) {
  for (std::uint64_t seed = GetParam(); seed < std::max<std::uint64_t>(cases(kWorlds) / 10, kParts);
       seed += kParts) {
    const DrivenWorld made = make_driven_world(seed);
    SCOPED_TRACE(made.name);
    Simulation whole(made.world);
    drive(whole, made);
    const History expected = with_work(whole, run_on(whole, {.until = Time(made.until)}));
    in_processes(2, [&](Processes& processes) {
      Simulation simulation(made.world, {.engine = EngineKind::cells}, processes);
      drive(simulation, made);
      const History history = with_work(simulation, run_on(simulation, {.until = Time(made.until)}));
      EXPECT_EQ(difference(expected, history), "");
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Part, Motions, testing::Range<std::uint64_t>(0, kParts));

// Contacts of elastic spheres change the energy only through the work of motions and walls.
TEST(WorkOfMotions, IsTheEnergyThatSpheresGain) {
  for (std::uint64_t seed = 0; seed < cases(40); ++seed) {
    const DrivenWorld made = make_driven_world(seed);
    SCOPED_TRACE(made.name);
    Simulation simulation(made.world);
    const double before = simulation.totals().energy.value();
    drive(simulation, made);
    simulation.run_until(made.until);
    double work = 0;
    for (const DrivenMotion& motion : simulation.motions()) work += simulation.work_of(motion);
    const double after = simulation.totals().energy.value();
    EXPECT_NEAR(after - before, work, 1e-11 * (std::fabs(before) + std::fabs(after) + std::fabs(work)));
  }
}

// A sphere on a rotor and one beside it, by the exact curve.
struct Rotor {
  using Real = long double;

  Vec3 axis;
  Vec3 from;
  double frequency = 0;
  Vec3 position;  // of the other sphere
  Vec3 velocity;
  double reach = 0;

  Real gap(Real time) const {
    const Real angle = 2 * std::numbers::pi_v<Real> * frequency * time;
    const std::array<Real, 3> n{axis.x, axis.y, axis.z};
    const std::array<Real, 3> p{from.x, from.y, from.z};
    const std::array<Real, 3> across{n[1] * p[2] - n[2] * p[1], n[2] * p[0] - n[0] * p[2],
                                     n[0] * p[1] - n[1] * p[0]};
    const Real along = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
    Real square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real place = along * n[i] + std::cos(angle) * (p[i] - along * n[i]) + std::sin(angle) * across[i];
      const Real apart = place - position[i] - time * static_cast<Real>(velocity[i]);
      square += apart * apart;
    }
    return std::sqrt(square) - reach;
  }
  // The first root, from samples so dense that the gap cannot close and open between them by more than
  // `depth`; infinity if there is none.
  Real first_root(Real until, Real step) const {
    Real before = 0;
    for (Real time = 0; time <= until; time += step) {
      if (gap(time) > 0) {
        before = time;
        continue;
      }
      Real after = time;
      for (int k = 0; k < 100; ++k) {
        const Real middle = (before + after) / 2;
        (gap(middle) > 0 ? before : after) = middle;
      }
      return after;
    }
    return std::numeric_limits<Real>::infinity();
  }
};

// With its radius raised by the tolerance, no contact is missed, and none is early by more than it takes to
// close twice the tolerance.
TEST(Rotors, TriggerNoLaterThanOnTheirCurve) {
  std::size_t hits = 0;
  std::size_t misses = 0;
  for (std::uint64_t seed = 0; seed < cases(400); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Vec3 axis = random.normal_vector(kAxes);
    axis = (1 / length(axis)) * axis;
    const double tolerance = std::pow(10.0, -2 - 3 * random.uniform());
    const double radius = 0.1 + 0.2 * random.uniform();
    Rotor rotor{axis, random.normal_vector(kAxes),       0.3 + random.uniform(),
                {},   0.2 * random.normal_vector(kAxes), 2 * radius};
    // Near where the sphere on the rotor will be at some time.
    const double passage = 0.2 + 1.5 * random.uniform();
    const PrescribedMotion turning = PrescribedMotion::rotation({}, axis, rotor.frequency, tolerance);
    const Vec3 there =
        rotor.from + std::get<Rotation>(turning.kind()).displacement(rotor.from, Time(passage));
    rotor.position = there + radius * random.normal_vector(kAxes) - passage * rotor.velocity;
    if (rotor.gap(0) < 3 * tolerance) continue;
    constexpr double kUntil = 2;
    World world(Box::open());
    world.add({.position = rotor.from, .radius = radius + tolerance, .mass = kInfinity});
    world.add({.position = rotor.position, .velocity = rotor.velocity, .radius = radius});
    Simulation simulation(world);
    simulation.drive(DrivenMotion("rotor", turning, {0}));
    const double found = simulation.run_contacts(1, kUntil) > 0 ? simulation.time() : kInfinity;
    const auto exact = static_cast<double>(rotor.first_root(kUntil, 1e-4L));
    if (found < kInfinity) {
      // The chord touches at the raised distance, and the curve is within the tolerance of it.
      EXPECT_LE(rotor.gap(found), 2 * tolerance * (1 + 1e-9));
      EXPECT_GE(rotor.gap(found), -1e-12L);
    }
    if (exact < kInfinity) {
      ++hits;
      ASSERT_LE(found, exact + 1e-12);
      // The least speed at which the gap closes meanwhile.
      double least = kInfinity;
      constexpr int kSteps = 200;
      const double step = (exact - found) / kSteps;
      for (int k = 0; k < kSteps && step > 0; ++k) {
        const double time = found + k * step;
        least = std::min(least, static_cast<double>((rotor.gap(time) - rotor.gap(time + step)) / step));
      }
      if (least > 0) {
        EXPECT_LE(exact - found, 2 * tolerance / least * (1 + 1e-6));
      }
    } else if (found == kInfinity) {
      ++misses;
    }
  }
  EXPECT_GT(hits, cases(400) / 5);
  EXPECT_GT(misses, cases(400) / 20);
}

}  // namespace
}  // namespace hardball::motions_test
