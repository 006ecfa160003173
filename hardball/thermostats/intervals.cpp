// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/intervals.hpp"

#include "hardball/thermostats/resolution.hpp"
#include "hardball/world/range.hpp"

namespace hardball {

Intervals::Intervals(double every) : every_(every) {
  check_positive(every, "every", "thermostat");
}

void Intervals::advance() {
  refuse_unresolved(every_, next());
  ++passed_;
}

}  // namespace hardball
