// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/time.hpp"

namespace hardball {

/// Detects a run without end at one time: spheres that touch, locked among others, push each other for ever;
/// and events up to a time include all with the same nearest double, which are too many at a time some 10^20
/// times as large as the intervals between events.
class StandstillGuard {
 public:
  /// To be called before every crossing and contact, at `next`, when the event before was at `now`. Error
  /// (RunFailure): far more events at one time than this many spheres can have, collapsing ones included.
  void note_event(const Time& now, const Time& next, std::size_t spheres) {
    if (now.high < next.high) [[likely]] {
      events_ = 0;
      return;
    }
    constexpr std::uint64_t kMaxPerSphere = 20000;
    constexpr std::uint64_t kFewSpheres = 4;
    if (++events_ <= kMaxPerSphere * (spheres + kFewSpheres)) return;
    const std::string time = to_text(now.value());
    throw RunFailure(
        now.value() == 0
            ? "spheres collide without end at time 0: they touch at the start and are locked among "
              "others; make them smaller by a part in 1e9, or place them farther apart"
            : "events without end at time " + time +
                  ": spheres touch and are locked among others, walls or kinematic spheres squeeze them, or "
                  "the time is too large to resolve their motion; make them a little smaller, stop what "
                  "squeezes them, or start at an earlier time");
  }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.events_); }

  std::uint64_t events_ = 0;  // in a row at one time
};

}  // namespace hardball
