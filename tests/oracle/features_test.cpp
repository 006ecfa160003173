// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Every pair of features: either all engines agree on a small world or run that has both, or it is refused as
// the table says.
#include "hardball/world/features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/queries/queries.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/walls.hpp"
#include "support/history.hpp"
#include "support/refusal.hpp"
#include "support/thread_processes.hpp"

namespace hardball::feature_pairs_test {
namespace {

using namespace support;

constexpr double kSize = 8;
constexpr double kRadius = 0.4;

bool is_of_walls(Features features) {
  return features.has(Feature::moving_walls) || features.has(Feature::thermal_walls) ||
         features.has(Feature::oscillating_walls) || features.has(Feature::motions);
}

// Planes of their own instead of faces of the box.
bool has_planes(Features features) {
  return features.has(Feature::oscillating_walls) || features.has(Feature::motions);
}

// Periodic, but for an axis with the walls that are wanted.
Box make_box(Features features) {
  const bool is_flat = features.has(Feature::flat);
  const std::size_t across = is_flat ? 1 : 2;
  std::array<Boundary, kAxes> boundary{Boundary::periodic, Boundary::periodic, Boundary::periodic};
  if (is_flat) boundary[2] = Boundary::flat;
  if (is_of_walls(features)) boundary[across] = has_planes(features) ? Boundary::open : Boundary::wall;
  Box box(boundary, {kSize, kSize, kSize});
  if (features.has(Feature::shear)) box.set_shear({.rate = 0.3});
  FaceProperties properties;
  if (features.has(Feature::thermal_walls)) properties.material.temperature = 1;
  if (features.has(Feature::moving_walls)) properties.velocity = {0.5, 0, 0};
  if (box.is_wall(across)) box.set_face(face_of(across, false), properties);
  return box;
}

std::vector<Surface> make_surfaces(Features features) {
  const bool is_flat = features.has(Feature::flat);
  const Vec3 up = is_flat ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 center{kSize / 2, kSize / 2, is_flat ? 0 : kSize / 2};
  std::vector<Surface> surfaces;
  if (has_planes(features)) {
    // Where another of the walls is wanted, too, the one opposite has it.
    SurfaceMaterial material;
    if (features.has(Feature::thermal_walls)) material.temperature = 1;
    const Vec3 velocity = features.has(Feature::moving_walls) ? 0.1 * up : Vec3{};
    const bool oscillates = features.has(Feature::oscillating_walls);
    surfaces.emplace_back(oscillates ? Shape(OscillatingPlane(up, 0.1, 1)) : Plane(up), Vec3{});
    surfaces.emplace_back(Plane(-1 * up), kSize * up, velocity, material);
  }
  if (features.has(Feature::curved_walls)) surfaces.emplace_back(HollowSphere(kSize / 2 - 0.05), center);
  if (features.has(Feature::obstacle_images)) surfaces.emplace_back(Obstacle(0.5), center);
  return surfaces;
}

Interactions make_interactions(Features features) {
  BounceRules rules{.restitution = ConstantRestitution{0.95}, .elastic_below = 0.01};
  if (features.has(Feature::roughness)) rules.tangential_restitution = 0.5;
  const Bounce bounce(rules);
  ResponseTable table(bounce, bounce);
  if (features.has(Feature::passing)) table.set(0, 1, Passing());
  if (features.has(Feature::merging)) table.set(1, 1, Merging());
  Interactions interactions(table);
  if (features.has(Feature::custom_response)) interactions.set_function(CustomResponse(bounce));
  if (features.has(Feature::steps)) {
    StepTable steps;
    // Spheres that pass through each other have no core.
    steps.set(0, 0, StepPotential({.steps = {{1.3, -0.3}}, .core = 1}));
    interactions.set_steps(steps);
  }
  return interactions;
}

// Spheres near the points of a lattice, where there is room for them.
void add_spheres(Features features, World& world) {
  constexpr std::size_t kAlong = 4;
  constexpr double kSpacing = kSize / kAlong;
  Random random(7);
  const bool is_flat = world.box().is_flat();
  for (std::size_t i = 0; i < kAlong * kAlong * (is_flat ? 1 : kAlong); ++i) {
    Sphere sphere;
    sphere.radius = kRadius;
    sphere.species = static_cast<SpeciesId>(i % 2);
    for (std::size_t axis = 0, place = i; axis < world.box().dimensions(); ++axis, place /= kAlong) {
      const double along = static_cast<double>(place % kAlong) + 0.5;
      sphere.position[axis] = kSpacing * along + 0.4 * (random.uniform() - 0.5);
      sphere.velocity[axis] = random.normal();
    }
    const bool is_kinematic = features.has(Feature::kinematic) || features.has(Feature::undriven);
    if (is_kinematic && i == 5) sphere.mass = std::numeric_limits<double>::infinity();
    if (features.has(Feature::roughness)) sphere.spin = {0, 0, random.normal()};
    if (is_clear_of_surfaces(world, sphere.position, kRadius, Time(0))) world.add(sphere);
  }
}

World make_world(Features features) {
  Vec3 gravity;
  if (features.has(Feature::gravity)) gravity[features.has(Feature::flat) ? 1 : 2] = -0.5;
  World world(make_box(features), gravity, make_surfaces(features));
  world.set_interactions(make_interactions(features));
  add_spheres(features, world);
  return world;
}

// What simulations have that worlds do not.
void begin(Features features, Simulation& simulation) {
  if (features.has(Feature::growth)) simulation.grow({.rate = 0.02});
  if (features.has(Feature::thermostat)) simulation.set_thermostat(Thermostat(Andersen(1, 0.5), 3));
  const auto oscillation = [&](std::size_t axis) {
    Vec3 direction;
    direction[axis] = 1;
    return PrescribedMotion::oscillation(direction, 0.1, 1, 0.02);
  };
  if (features.has(Feature::motions)) {
    const std::uint32_t plane = kFaces + (features.has(Feature::oscillating_walls) ? 1 : 0);
    simulation.drive(DrivenMotion("plane", oscillation(features.has(Feature::flat) ? 1 : 2), {}, {plane}));
  }
  // Where there is gravity, kinematic spheres need motions.
  const bool needs_motion = features.has(Feature::gravity) && features.has(Feature::kinematic);
  if (needs_motion && !features.has(Feature::undriven))
    simulation.drive(DrivenMotion("sphere", oscillation(0), {5}));
}

void ask(Features features, const Simulation& simulation) {
  const World& world = simulation.world();
  const Time now = simulation.now();
  const Vec3 point{0.3, 0.2, world.box().is_flat() ? 0 : 0.1};
  if (features.has(Feature::ray)) static_cast<void>(ray(world, now, point, {1, 0, 0}, 10));
  if (!features.has(Feature::first_contact)) return;
  const SphereId id = world.id(0);
  static_cast<void>(first_contact(world, now, id, {1, 0, 0}, after(now, 5)));
}

History run(Features features, Simulation& simulation) {
  begin(features, simulation);
  std::optional<Measures> measures;
  if (features.has(Feature::measures)) measures.emplace(MeasureSettings{});
  const auto run_some = [&] {
    const RunLimits limits{.until = Time(simulation.time() + 8), .contacts = 100};
    measures ? simulation.run(limits, *measures) : simulation.run(limits);
  };
  if (features.has(Feature::births)) {
    if (!measures) run_some();
    std::optional<SphereId> first;
    simulation.world().for_each_by_id([&](Slot slot) {
      if (!first) first = simulation.world().id(slot);
    });
    simulation.remove(*first);
  }
  run_some();
  ask(features, simulation);
  simulation.validate();
  return run_on(simulation, {.until = simulation.now()});
}

// Throws what refuses these features, if anything does.
void try_out(Features features) {
  const World world = make_world(features);
  std::optional<History> expected;
  const auto compare = [&](const History& history, const std::string& name) {
    if (!expected) expected = history;
    EXPECT_EQ(difference(*expected, history), "") << name;
  };
  const auto run_by = [&](const EngineOptions& options, const std::string& name) {
    Simulation simulation(world, options);
    compare(run(features, simulation), name);
  };
  const bool is_any = !features.has(Feature::all_pairs) && !features.has(Feature::paper);
  const Features all = world.features() | features;
  if (is_any || features.has(Feature::all_pairs)) run_by({.engine = EngineKind::all_pairs}, "all pairs");
  if (features.has(Feature::paper) || (is_any && goes_with(Feature::paper, all)))
    run_by({.engine = EngineKind::paper}, "paper");
  if (is_any) {
    run_by({.engine = EngineKind::cells}, "cells");
    run_by({.engine = EngineKind::neighbors}, "neighbors");
  }
  if (features.has(Feature::threads)) {
    const EngineKind engine = is_any                         ? EngineKind::cells
                              : features.has(Feature::paper) ? EngineKind::paper
                                                             : EngineKind::all_pairs;
    run_by({.engine = engine, .threads = 2}, "threads");
  }
  if (features.has(Feature::processes)) {
    const EngineKind engine = is_any                         ? EngineKind::cells
                              : features.has(Feature::paper) ? EngineKind::paper
                                                             : EngineKind::all_pairs;
    in_processes(2, [&](Processes& processes) {
      const std::size_t threads = features.has(Feature::threads) ? 2 : 1;
      Simulation simulation(world, {.engine = engine, .threads = threads}, processes);
      const History history = run(features, simulation);
      if (processes.is_first()) compare(history, "processes");
    });
  }
  EXPECT_GT(expected.value_or(History()).contacts, 10U);
}

// In scenarios measures exclude more than in the library, where a run with them fails when it has to.
std::optional<Error> refusal_of_measures(Feature other) {
  std::string text =
      "[box]\nsize = [9, 9, 9]\nboundary = ['wall', 'wall', 'wall']\n[measures]\nnames = ['all']\n";
  text += "[[spheres]]\ncount = 2\nradius = 0.5\nplacement = 'random'\nspeed = 1\n";
  if (other == Feature::kinematic || other == Feature::undriven) text += "kinematic = true\n";
  if (other == Feature::merging) text += "[response]\nkind = 'merge'\n";
  if (other == Feature::growth) text += "[growth]\nrate = 0.1\n";
  try {
    parse_scenario(text, "features.toml");
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "features.toml:5:9");
    return error;
  }
  return std::nullopt;
}

std::optional<Error> refusal(Feature a, Feature b) {
  if (b == Feature::measures && (a == Feature::kinematic || a == Feature::undriven || a == Feature::merging))
    return refusal_of_measures(a);
  try {
    try_out(Features(a) | b);
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

const Exclusion* find_exclusion(Features features) {
  const auto it = std::ranges::find_if(exclusions(), [&](const Exclusion& pair) {
    return features.has(pair.first) && features.has(pair.second);
  });
  return it == exclusions().end() ? nullptr : &*it;
}

class EveryPairOfFeatures : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryPairOfFeatures, AgreesOrIsRefusedAsTheTableSays) {
  const auto a = static_cast<Feature>(GetParam());
  for (std::size_t number = GetParam() + 1; number < kFeatures; ++number) {
    const auto b = static_cast<Feature>(number);
    SCOPED_TRACE(std::string(description(a).name) + " and " + std::string(description(b).name));
    // A run has one engine.
    if (a == Feature::all_pairs && b == Feature::paper) continue;
    Features features = Features(a) | b;
    // Obstacles are no planes.
    features.add(Feature::curved_walls, features.has(Feature::obstacle_images));
    features.add(Feature::kinematic, features.has(Feature::undriven));
    const Exclusion* const pair = find_exclusion(features);
    const std::optional<Error> error = refusal(a, b);
    ASSERT_EQ(error.has_value(), pair != nullptr) << (error ? error->what() : "it was not refused");
    if (!error) continue;
    EXPECT_EQ(error->problem(), pair->what);
    EXPECT_EQ(error->remedy(), pair->remedy);
    EXPECT_NE(error->where(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryPairOfFeatures, testing::Range<std::size_t>(0, kFeatures - 1));

TEST(FeaturesOfAWorld, AreThoseItWasMadeWith) {
  for (std::size_t number = 0; number <= static_cast<std::size_t>(Feature::obstacle_images); ++number) {
    const auto feature = static_cast<Feature>(number);
    if (feature == Feature::growth) continue;
    Features expected = feature;
    expected.add(Feature::curved_walls, feature == Feature::obstacle_images);
    EXPECT_EQ(make_world(feature).features(), expected) << description(feature).name;
  }
  World growing = make_world({});
  growing.set_growth({.begin = Time(0), .end = Time(1), .scale = 1, .rate = 0.1});
  EXPECT_EQ(growing.features(), Feature::growth);
}

// Whatever comes later is refused, and changes nothing.
TEST(FeaturesOfAWorld, ExcludeEachOtherInWhateverOrderTheyCome) {
  for (const Feature feature : {Feature::merging, Feature::passing, Feature::steps, Feature::roughness}) {
    World world = make_world({});
    world.set_growth({.begin = Time(0), .end = Time(1), .scale = 1, .rate = 0.1});
    const Error error = error_of([&] { world.set_interactions(make_interactions(feature)); });
    const Exclusion* const pair = find_exclusion(Features(Feature::growth) | feature);
    ASSERT_NE(pair, nullptr);
    EXPECT_EQ(error.problem(), pair->what);
    EXPECT_EQ(error.where(), "growth");
    EXPECT_EQ(world.features(), Feature::growth);
  }
}

}  // namespace
}  // namespace hardball::feature_pairs_test
