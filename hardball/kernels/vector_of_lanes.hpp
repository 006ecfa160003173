// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball {

/// Several vectors, one per lane.
template <class Lanes>
struct VectorOfLanes {
  Lanes x, y, z;
};

}  // namespace hardball
