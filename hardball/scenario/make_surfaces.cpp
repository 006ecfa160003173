// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_surfaces.hpp"

#include <algorithm>

#include "hardball/errors/error.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

std::vector<Surface> make_surfaces(const Scenario& scenario, const Box& box) {
  std::vector<Surface> surfaces;
  for (const auto& [described, where, motion, torque_offset] : scenario.surfaces) {
    SurfaceMaterial material = described.material();
    material.seed = scenario.run.seed;
    Shape shape = described.shape();
    if (auto* const mesh = std::get_if<MeshShape>(&shape)) mesh->set_seed(scenario.run.seed);
    const Surface surface(shape, described.point(), described.velocity(), material);
    try {
      static_cast<void>(World(box, {}, {surface}));
    } catch (const Error& error) {
      throw Error(error.problem(), where, error.remedy());
    }
    surfaces.push_back(surface);
  }
  return surfaces;
}

Extent room_between(std::span<const Surface> surfaces) {
  Extent room;
  for (const Surface& surface : surfaces) {
    const Extent each = surface.room();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      room.low[axis] = std::max(room.low[axis], each.low[axis]);
      room.high[axis] = std::min(room.high[axis], each.high[axis]);
    }
  }
  return room;
}

}  // namespace hardball
