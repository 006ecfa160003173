// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace hardball {

/// What takes the place of a number that does not exist or is not known: NaN.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace hardball
