// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball {

/// The random numbers of event `count` of a sphere: a function of these three, whatever else has happened.
Random event_random(std::uint64_t seed, SphereId sphere, std::uint64_t count);

}  // namespace hardball
