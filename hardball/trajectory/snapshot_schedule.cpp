// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/snapshot_schedule.hpp"

#include <limits>

namespace hardball {
namespace {

// By multiplication: the C library's powers may differ in the last bit from one platform to the next.
double power(double base, std::uint64_t exponent) {
  double product = 1;
  for (; exponent > 0 && product < std::numeric_limits<double>::infinity(); --exponent) product *= base;
  return product;
}

// The number whose `exponent`-th power is ten, by bisection.
double root_of_ten(std::uint64_t exponent) {
  double low = 1;
  double high = 10;
  for (;;) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) return middle;
    (power(middle, exponent) < 10 ? low : high) = middle;
  }
}

}  // namespace

SnapshotSchedule SnapshotSchedule::every(double interval) {
  SnapshotSchedule schedule;
  schedule.kind_ = Kind::linear;
  schedule.interval_ = interval;
  return schedule;
}

SnapshotSchedule SnapshotSchedule::logarithmic(double first, std::uint64_t per_decade) {
  SnapshotSchedule schedule;
  schedule.kind_ = Kind::logarithmic;
  schedule.interval_ = first;
  schedule.ratio_ = root_of_ten(per_decade);
  schedule.count_ = per_decade;
  return schedule;
}

SnapshotSchedule SnapshotSchedule::every_contacts(std::uint64_t count) {
  SnapshotSchedule schedule;
  schedule.kind_ = Kind::contacts;
  schedule.count_ = count;
  return schedule;
}

double SnapshotSchedule::time(std::uint64_t index, double until) const {
  constexpr double kRounding = 1e-14;
  double time = kNoTime;
  if (kind_ == Kind::linear) {
    time = static_cast<double>(index) * interval_;
  } else if (kind_ == Kind::logarithmic) {
    // Decades are exact up to one rounding.
    time = index == 0 ? 0 : interval_ * power(10, (index - 1) / count_) * power(ratio_, (index - 1) % count_);
  }
  return time > until && time <= until * (1 + kRounding) ? until : time;
}

std::uint64_t SnapshotSchedule::contacts(std::uint64_t index) const {
  if (kind_ != Kind::contacts || index > kNoContacts / count_) return kNoContacts;
  return index * count_;
}

}  // namespace hardball
