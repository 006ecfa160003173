// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/extended_xyz.hpp"

#include <sstream>
#include <string>

#include "fuzz/target.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  const Snapshot snapshot = read_snapshot(in, "start.xyz");
  if (snapshot.spheres.size() > kMostSpheres) return;
  World world(Box::open());
  for (const Sphere& sphere : snapshot.spheres) world.add(sphere);
  Simulation simulation(std::move(world));
  run_a_little(simulation);
}
