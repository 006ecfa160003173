// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "hardball/geometry/time.hpp"
#include "hardball/statistics/moment_lags.hpp"

namespace hardball {

/// A moment, as of all spheres together, that changes evenly between events and jumps at them. It is exact at
/// every time, and so are its increments over equal times.
class CollectiveMoment {
 public:
  static constexpr std::size_t kComponents = 6;  // of those that have fewer the last are zero
  using Sums = std::array<double, kComponents>;

  CollectiveMoment() = default;
  /// Starts at `begin`; `lags` has as many components and no increments yet.
  CollectiveMoment(const Time& begin, MomentLags lags)
      : begin_(begin), last_(begin), lags_(std::move(lags)) {}

  /// At which the components change at present.
  Sums rates{};

  /// Advances to `now`, with these rates. Cost: O(1), and O(components) for each increment that ends.
  void advance(const Time& now) {
    for (Time end = next_end(); !(now < end); end = next_end()) {
      carry(duration(last_, end));
      last_ = end;
      lags_.add(increment_, duration(begin_, end));
      increment_ = {};
      ++ended_;
    }
    carry(duration(last_, now));
    last_ = now;
  }
  /// Adds what jumps at the time reached.
  void jump(const Sums& amounts) {
    for (std::size_t k = 0; k < kComponents; ++k) increment_[k] += amounts[k];
  }

  const MomentLags& lags() const { return lags_; }
  /// The lags of a copy that has advanced to `now`.
  MomentLags lags_at(const Time& now) const {
    CollectiveMoment later = *this;
    later.advance(now);
    return later.lags_;
  }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.begin_, self.last_, self.lags_, self.rates, self.increment_, self.ended_);
  }
  bool restored() const {
    const bool is_in_order = (ended_ == 0 || !(last_ < end_of(ended_))) && last_ < next_end();
    return lags_.components() == kComponents && is_in_order;
  }

  Time end_of(std::uint64_t increments) const {
    return Time(begin_.value() + static_cast<double>(increments) * lags_.base());
  }
  Time next_end() const { return end_of(ended_ + 1); }
  void carry(double elapsed) {
    for (std::size_t k = 0; k < kComponents; ++k) increment_[k] += rates[k] * elapsed;
  }

  Time begin_;
  Time last_;
  MomentLags lags_;
  Sums increment_{};
  std::uint64_t ended_ = 0;  // increments
};

}  // namespace hardball
