// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/all_pairs.hpp"
#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/broadphase/sheared_cells.hpp"

namespace hardball {
namespace {

ValuePointer<BroadPhase> make_cells(const PhaseSettings& settings, const World& world) {
  if (world.box().is_sheared()) return std::make_unique<ShearedCells>(settings);
  if (LargeSphereGrid::supports(world, settings.length)) return std::make_unique<LargeSphereGrid>(settings);
  return std::make_unique<CellGrid>(settings);
}

}  // namespace

ValuePointer<BroadPhase> make_broad_phase(const PhaseSettings& settings, const World& world) {
  switch (settings.kind) {
    case PhaseKind::neighbors:
      return std::make_unique<NeighborList>(settings);
    case PhaseKind::all_pairs:
      return std::make_unique<AllPairs>(settings);
    case PhaseKind::cells:
      break;
  }
  return make_cells(settings, world);
}

}  // namespace hardball
