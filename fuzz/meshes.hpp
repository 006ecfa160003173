// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "fuzz/target.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/surfaces/surface.hpp"

namespace hardball::fuzz {

/// Makes a mesh of what a file has, asks about a point, and lets a sphere bounce off it.
inline void use(MeshParts parts) {
  if (parts.triangles.size() > 1000) return;
  const auto mesh = std::make_shared<const Mesh>(std::move(parts), 1e-6);
  const Vec3 middle = 0.5 * (mesh->extent().low + mesh->extent().high);
  const Vec3 size = mesh->extent().high - mesh->extent().low;
  static_cast<void>(mesh->nearest(middle));
  static_cast<void>(mesh->winding_number(middle));
  if (mesh->is_closed()) static_cast<void>(mesh->contains(middle));
  World world(Box::open(), {}, {Surface(MeshShape(mesh), {})});
  const double radius = 0.05 * length(size);
  const Vec3 start = middle + length(size) * Vec3{0.3, 0.7, 1};
  world.add({.position = start, .velocity = middle - start, .radius = radius, .mass = 1});
  Simulation simulation(std::move(world));
  run_a_little(simulation);
}

}  // namespace hardball::fuzz
