// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/section.hpp"

namespace hardball {

/// What the table [box.faces] of [box] describes. Error, with the location of the value: a key contradicts
/// another or is out of range.
std::vector<FaceDescription> read_faces(const Section& box, std::size_t dimensions);

/// What the tables [[walls]] of a scenario describe. Error, with the location of the value: a key is missing,
/// contradicts another or is out of range.
std::vector<WallDescription> read_walls(const Section& root, std::size_t dimensions);

/// What the tables [[obstacles]] describe, one for each position. Error: as for read_walls.
std::vector<ObstacleDescription> read_obstacles(const Section& root, std::size_t dimensions);

}  // namespace hardball
