// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The errors of the heat at thermal walls, against the scatter among runs. The energy that the spheres take
// up they give back, so that the heat of a long run varies far less than that of its parts suggests.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/walls.hpp"
#include "support/measurement.hpp"
#include "support/record.hpp"

namespace hardball::heat_errors_test {
namespace {

constexpr std::size_t kRuns = 60;

void fill(World& world, std::uint64_t seed, std::size_t spheres, double edge) {
  constexpr double kRadius = 0.5;
  Random random(seed);
  while (world.size() < spheres) {
    const auto coordinate = [&] { return kRadius + (edge - 2 * kRadius) * random.uniform(); };
    const double x = coordinate();
    const double y = coordinate();
    const Vec3 place{x, y, coordinate()};
    bool is_free = distance_to_surfaces(world, place, Time(0)) > kRadius;
    for (Slot slot = 0; is_free && slot < world.size(); ++slot) {
      is_free = length(world.path(slot).position - place) > 2 * kRadius;
    }
    if (is_free) world.add({place, random.direction(), kRadius, 1});
  }
}

World cavity(std::uint64_t seed) {
  World world(Box::open(), {}, {Surface(HollowSphere(4), {4, 4, 4}, {}, {.temperature = 1, .seed = seed})});
  fill(world, seed, 20, 8);
  return world;
}

World between_plates(std::uint64_t seed) {
  World world(Box({Boundary::periodic, Boundary::periodic, Boundary::open}, {8, 8, 0}), {},
              {Surface(Plane({0, 0, 1}), {}, {}, {.temperature = 1, .seed = seed}),
               Surface(Plane({0, 0, -1}), {0, 0, 8}, {}, {.temperature = 2, .seed = seed})});
  fill(world, seed, 20, 8);
  return world;
}

// The stated error of a quantity over its scatter among runs, in the root of the mean square. By chance the
// temperature of so few spheres seems to change throughout one run of a hundred, which then has no error.
double error_over_scatter(const std::function<World(std::uint64_t)>& start, double length,
                          const std::string& name) {
  double sum = 0;
  double squares = 0;
  double errors = 0;
  double known = 0;
  for (std::size_t run = 0; run < kRuns; ++run) {
    Simulation simulation(start(100 + run));
    simulation.run_until(50);
    Measures measures({.names = {"wall_forces"}, .from = 50});
    simulation.run_until(50 + length, measures);
    const Quantity heat =
        support::quantity(measures.results(simulation.world(), simulation.now()).front(), name);
    sum += heat.value;
    squares += heat.value * heat.value;
    if (std::isnan(heat.error)) continue;
    errors += heat.error * heat.error;
    ++known;
  }
  constexpr double kCount = kRuns;
  EXPECT_GE(known, kCount - 4) << name;
  return std::sqrt(errors / known / ((squares - sum * sum / kCount) / (kCount - 1)));
}

// The scatter is known to 1 / sqrt(2 * 60), 9%, and each error to 10 or 20%.
void expect_honest(const std::string& name, double ratio) {
  support::record(name, ratio);
  EXPECT_GT(ratio, 0.7) << name;
  EXPECT_LT(ratio, 1.4) << name;
}

TEST(HeatErrors, AreTheScatterAtACavity) {
  expect_honest("cavity", error_over_scatter(cavity, 200, "sphere_0_heat"));
}

TEST(HeatErrors, AreTheScatterBetweenPlates) {
  expect_honest("plates", error_over_scatter(between_plates, 100, "plane_1_heat"));
}

}  // namespace
}  // namespace hardball::heat_errors_test
