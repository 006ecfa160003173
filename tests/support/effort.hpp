// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/errors/error.hpp"

namespace hardball::support {

// Depends on the build alone, so that a test is the same on every machine.
#if HARDBALL_VALIDATE || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    !defined(__OPTIMIZE__)
inline constexpr bool kIsSlowBuild = true;
#else
inline constexpr bool kIsSlowBuild = false;
#endif

/// The number of cases to try: all in an optimized build, a tenth in one slowed down by checks.
constexpr std::uint64_t cases(std::uint64_t all) {
  return kIsSlowBuild ? all / 10 + 1 : all;
}

}  // namespace hardball::support
