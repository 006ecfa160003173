// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/errors/export.hpp"

namespace hardball {

/// Error: at `time` [T] doubles do not resolve intervals of this length [T].
void refuse_unresolved(double interval, double time);

/// Times at equal intervals: start + k * every, for k = 1, 2, ...
class HARDBALL_EXPORT Intervals {
 public:
  /// Error: `every` [T] is not positive.
  explicit Intervals(double every);

  double every() const { return every_; }
  /// Starts at a time [T].
  void begin(double start) {
    start_ = start;
    passed_ = 0;
  }
  /// The next time [T].
  double next() const { return start_ + static_cast<double>(passed_ + 1) * every_; }
  /// How many have passed.
  std::uint64_t passed() const { return passed_; }
  /// Error: doubles do not resolve the interval at the next time.
  void advance();

 private:
  friend class Persistence;
  Intervals() = default;
  static void persist(auto& archive, auto& self) { archive(self.every_, self.start_, self.passed_); }
  bool restored() const { return every_ > 0; }

  double every_;
  double start_ = 0;
  std::uint64_t passed_ = 0;
};

}  // namespace hardball
