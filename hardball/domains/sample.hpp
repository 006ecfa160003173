// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/domains/sphere_transfer.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A small part of all `spheres` that has the whole range of radii, the same in all processes, each of which
/// brings some. `setting`: the world, with or without spheres. Cost: O(spheres here), and a message to each
/// process.
World sample_of(Processes& processes, const World& setting, const SphereTransfers& brought,
                std::uint64_t spheres);

}  // namespace hardball
