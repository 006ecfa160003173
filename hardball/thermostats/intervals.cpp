// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/intervals.hpp"

#include "hardball/geometry/range.hpp"
#include "hardball/thermostats/resolution.hpp"

namespace hardball {

Intervals::Intervals(double every) : every_(every) {
  check_positive(every, "every", "thermostat");
}

void Intervals::advance() {
  refuse_unresolved(every_, next());
  ++passed_;
}

}  // namespace hardball
