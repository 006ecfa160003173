// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/time.hpp"

namespace hardball {

/// Detects a run without end at one time. Events up to a time include all with the same nearest double; at a
/// time some 10^20 times as large as the intervals between events these are too many.
class StandstillGuard {
 public:
  /// To be called before every crossing and contact, at `next`, when the event before was at `now`. Error
  /// (RunFailure): far more events at one time than so many spheres can have, collapsing ones included.
  void note_event(const Time& now, const Time& next, std::size_t spheres) {
    if (now.high < next.high) [[likely]] {
      events_ = 0;
      return;
    }
    constexpr std::uint64_t kMaxPerSphere = 20000;
    constexpr std::uint64_t kFewSpheres = 4;
    if (++events_ <= kMaxPerSphere * (spheres + kFewSpheres)) return;
    throw RunFailure("the time " + to_text(now.value()) +
                     " is too large to resolve the motion of the spheres; start at an earlier time");
  }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.events_); }

  std::uint64_t events_ = 0;  // in a row at one time
};

}  // namespace hardball
