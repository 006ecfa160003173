// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hardball/memory/function.hpp"

namespace hardball {

/// Calls work(k) for each k below a count, perhaps for several at once, and returns when all have returned.
using ForEach = Function<void(std::size_t count, const Function<void(std::size_t)>& work)>;

/// One after the other.
inline void one_by_one(std::size_t count, const Function<void(std::size_t)>& work) {
  for (std::size_t k = 0; k < count; ++k) work(k);
}

}  // namespace hardball
