// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hardball {

/// What domains have done to run windows of time.
struct WindowCounters {
  std::uint64_t windows = 0;  ///< Committed, single steps included.
  std::uint64_t failed = 0;   ///< Undone, as a domain was wrong.
  std::uint64_t steps = 0;    ///< Windows of at most one contact, where no window was short enough.

  friend WindowCounters operator+(const WindowCounters& a, const WindowCounters& b) {
    return {a.windows + b.windows, a.failed + b.failed, a.steps + b.steps};
  }
  friend bool operator==(const WindowCounters&, const WindowCounters&) = default;
};

}  // namespace hardball
