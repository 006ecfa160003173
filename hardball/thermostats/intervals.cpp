// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/intervals.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
void refuse_unresolved(double interval, double time) {
  constexpr double kMaxIntervals = 0x1p50;
  if (std::fabs(time) / interval < kMaxIntervals) return;
  throw Error("actions every " + to_text(interval) + " cannot be resolved at time " + to_text(time),
              "thermostat", "make it act less often");
}

Intervals::Intervals(double every) : every_(every) {
  check_positive(every, "every", "thermostat");
}

void Intervals::advance() {
  refuse_unresolved(every_, next());
  ++passed_;
}

}  // namespace hardball
