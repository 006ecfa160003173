// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/errors/error.hpp"

namespace hardball::support {

// What the build says of itself, so that a test is the same on every machine.
#if HARDBALL_VALIDATE || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    !defined(__OPTIMIZE__)
inline constexpr bool kIsSlowBuild = true;
#else
inline constexpr bool kIsSlowBuild = false;
#endif

/// How many cases to try: all in an optimised build, a tenth of them in one that is slowed down by checks.
constexpr std::uint64_t cases(std::uint64_t all) {
  return kIsSlowBuild ? all / 10 + 1 : all;
}

}  // namespace hardball::support
