// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/intervals.hpp"

#include "hardball/world/range.hpp"

namespace hardball {

Intervals::Intervals(double every, std::string_view where) : every_(every) {
  check_positive(every, "every", where);
}

}  // namespace hardball
