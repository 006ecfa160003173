// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/world.hpp"

/// Gases made in code, in the units of the literature: the diameter, the mass and kT are one.
namespace hardball::support {

enum class Start {
  random,        ///< Random sequential addition, up to a packing fraction of 0.36.
  fcc,           ///< A face-centered cubic crystal, stable from a packing fraction of about 0.5 on.
  simple_cubic,  ///< A lattice that thermal motion destroys at every density below its own 0.52. Needs k^3
                 ///< spheres.
};

struct Gas {
  std::size_t count = 1000;
  double packing_fraction = 0.1;
  std::uint64_t seed = 1;
  Boundary boundary = Boundary::periodic;  ///< Along all axes; an open gas starts in a cube.
  Start start = Start::random;
};

inline constexpr double kDiameter = 1;

/// The edge of the cube in which `count` spheres of diameter one have this packing fraction.
inline double cube_edge(std::size_t count, double packing_fraction) {
  return std::cbrt(static_cast<double>(count) * std::numbers::pi / 6 / packing_fraction);
}

/// Maxwell velocities with zero total momentum, scaled so that the mean of m v^2 is 3 up to rounding.
inline std::vector<Vec3> thermal_velocities(std::span<const double> masses, Random& random) {
  std::vector<Vec3> velocities;
  Vec3 momentum;
  double mass = 0;
  for (const double m : masses) {
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    velocities.push_back((1 / std::sqrt(m)) * Vec3{x, y, z});
    momentum += m * velocities.back();
    mass += m;
  }
  double twice_energy = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    velocities[i] -= (1 / mass) * momentum;
    twice_energy += masses[i] * dot(velocities[i], velocities[i]);
  }
  const double scale = std::sqrt(3 * static_cast<double>(masses.size()) / twice_energy);
  for (Vec3& velocity : velocities) velocity = scale * velocity;
  return velocities;
}

inline std::vector<Vec3> simple_cubic_centers(std::size_t count, double edge) {
  const auto per_axis = static_cast<std::size_t>(std::lround(std::cbrt(static_cast<double>(count))));
  const double spacing = edge / static_cast<double>(per_axis);
  std::vector<Vec3> centers;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t x = i % per_axis;
    const std::size_t y = i / per_axis % per_axis;
    const std::size_t z = i / per_axis / per_axis;
    centers.push_back(spacing * Vec3{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5,
                                     static_cast<double>(z) + 0.5});
  }
  return centers;
}

inline World make_gas(const Gas& gas) {
  const double edge = cube_edge(gas.count, gas.packing_fraction);
  const Vec3 size{edge, edge, edge};
  const Box box({gas.boundary, gas.boundary, gas.boundary}, size);
  const Region region{{}, size};
  Random random(gas.seed);
  std::vector<Vec3> centers;
  switch (gas.start) {
    case Start::random:
      centers = place_randomly(box, region, std::vector<double>(gas.count, kDiameter / 2), random, "gas");
      break;
    case Start::fcc:
      centers = place_on_lattice(box, region, gas.count, kDiameter / 2, "gas");
      break;
    case Start::simple_cubic:
      centers = simple_cubic_centers(gas.count, edge);
      break;
  }
  const std::vector<Vec3> velocities = thermal_velocities(std::vector<double>(gas.count, 1), random);
  World world(box);
  for (std::size_t i = 0; i < gas.count; ++i) {
    world.add({.position = centers[i], .velocity = velocities[i], .radius = kDiameter / 2});
  }
  return world;
}

/// The spheres of a simulation at its current time, in a world at time zero.
inline World restarted(const Simulation& simulation) {
  World world(simulation.world().box());
  for (Slot slot = 0; slot < simulation.size(); ++slot) {
    world.add({.position = simulation.world().position(slot, simulation.now()),
               .velocity = simulation.world().path(slot).velocity,
               .radius = simulation.world().base_radius(slot),
               .mass = simulation.world().mass(slot)});
  }
  return world;
}

/// The world after this many collisions per sphere on average, equilibrated.
inline World settled(World world, double collisions_per_sphere) {
  const double collisions = collisions_per_sphere * static_cast<double>(world.size()) / 2;
  Simulation simulation(std::move(world));
  while (static_cast<double>(simulation.tally().collisions()) < collisions) {
    simulation.run_contacts(simulation.size());
  }
  return restarted(simulation);
}

}  // namespace hardball::support
