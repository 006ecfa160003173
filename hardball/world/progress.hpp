// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hardball/memory/function.hpp"

namespace hardball {

/// Called from time to time during a long operation with the fraction done, which rises from 0 to 1. An
/// exception that it throws ends the operation, of which nothing remains.
using OnProgress = Function<void(double fraction)>;

/// Reports the progress of a loop, as part of a longer operation. Refers to the function that it calls.
class Progress {
 public:
  /// Reports nothing.
  Progress() = default;
  explicit Progress(const OnProgress& report) : report_(report ? &report : nullptr) {}

  /// The part of this one between two fractions of it.
  Progress part(double begin, double end) const {
    Progress part = *this;
    part.begin_ = begin_ + length_ * begin;
    part.length_ = length_ * (end - begin);
    return part;
  }

  /// `done` of `all` items are done. To be called for each; reports about a hundred of them at most.
  void record(std::size_t done, std::size_t all) const {
    constexpr std::size_t kReports = 128;
    if (report_ && (done % (all / kReports + 1) == 0 || done == all)) report(done, all);
  }

  /// Everything is done.
  void note_end() const { record(1, 1); }

 private:
  void report(std::size_t done, std::size_t all) const {
    const double fraction = all > 0 ? static_cast<double>(done) / static_cast<double>(all) : 1;
    (*report_)(begin_ + length_ * fraction);
  }

  const OnProgress* report_ = nullptr;
  double begin_ = 0;
  double length_ = 1;
};

}  // namespace hardball
