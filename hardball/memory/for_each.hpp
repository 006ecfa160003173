// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <vector>

#include "hardball/memory/function.hpp"

namespace hardball {

/// Calls work(k) for each k below a count, perhaps for several at once, and returns when all have returned.
using ForEach = Function<void(std::size_t count, const Function<void(std::size_t)>& work)>;

/// Calls work(k) for each k below `count`, where work may throw, and returns when all have returned. Error:
/// that of the least k whose call has thrown.
inline void for_each_or_throw(const ForEach& for_each, std::size_t count,
                              const Function<void(std::size_t)>& work) {
  std::vector<std::exception_ptr> failures(count);
  for_each(count, [&](std::size_t k) {
    try {
      work(k);
    } catch (...) {
      failures[k] = std::current_exception();
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

/// One after the other.
inline void one_by_one(std::size_t count, const Function<void(std::size_t)>& work) {
  for (std::size_t k = 0; k < count; ++k) work(k);
}

}  // namespace hardball
