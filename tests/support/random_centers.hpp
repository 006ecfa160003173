// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "hardball/geometry/vec3.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::support {

/// Points anywhere in a box of this size, always the same.
inline std::vector<Vec3> random_centers(std::size_t count, const Vec3& size) {
  Random random(7);
  std::vector<Vec3> centers;
  for (std::size_t i = 0; i < count; ++i)
    centers.push_back({size.x * random.uniform(), size.y * random.uniform(), size.z * random.uniform()});
  return centers;
}

}  // namespace hardball::support
