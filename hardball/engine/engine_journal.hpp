// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hardball/engine/run.hpp"
#include "hardball/execution/merged_spheres.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A sphere, and where it was stored.
struct StoredSphere {
  SphereId id = 0;
  Slot slot = 0;
};

/// What an engine has done since a moment, besides the changes that the world's own journal holds: enough to
/// go back.
class EngineJournal {
 public:
  /// What an event was.
  enum class Kind : std::uint8_t { collision, wall, no_contact };

  /// Forgets what was before, and begins at `now`.
  void begin(const Time& now) {
    end();
    is_kept_ = true;
    begin_ = now;
  }
  void end() {
    is_kept_ = false;
    last_rebuild_ = kLongAgo;
    events_.clear();
    merged_.clear();
  }
  /// Whether the journal reaches back to `moment`.
  bool reaches(const Time& moment) const { return is_kept_ && begin_ <= moment && !(last_rebuild_ > moment); }
  /// Whether all of the journal can be undone so.
  bool reaches_begin() const { return is_kept_ && last_rebuild_ == kLongAgo; }
  const Time& begin_time() const { return begin_; }

  /// An event of one sphere or of two has been handled.
  void note_event(Kind kind, const Time& moment, StoredSphere first, StoredSphere second) {
    if (is_kept_) [[unlikely]]
      append(kind, moment, first, second);
  }
  /// The list of spheres that have merged is about to change.
  void note_merged(const Time& moment, const MergedSpheres& before) {
    if (is_kept_) merged_.push_back({moment, before});
  }
  /// Regions, predictions or compact copies of all spheres have been made anew.
  void note_rebuild(const Time& moment) {
    if (is_kept_) last_rebuild_ = moment;
  }

  /// Earlier than any event.
  static constexpr Time kLongAgo{-kNever.high, 0};

  /// Takes the events after `moment` back from the counters and from the list of spheres that have merged,
  /// and returns the spheres whose events they were.
  std::vector<StoredSphere> undo_events(const Time& moment, Counters& counters, MergedSpheres& merged) {
    std::vector<StoredSphere> spheres;
    spheres.reserve(2 * events_.size());
    for (; !events_.empty() && events_.back().time > moment; events_.pop_back()) {
      const Done& done = events_.back();
      if (done.kind == Kind::collision) --counters.collision;
      if (done.kind == Kind::wall) --counters.wall;
      spheres.push_back(done.first);
      spheres.push_back(done.second);
    }
    for (; !merged_.empty() && merged_.back().time > moment; merged_.pop_back()) {
      merged = merged_.back().before;
    }
    return spheres;
  }

 private:
  // Apart, so that it takes no room in the hot loop.
  HARDBALL_NEVER_INLINE void append(Kind kind, Time moment, StoredSphere first, StoredSphere second) {
    append_ahead(events_, Done{kind, moment, first, second});
  }

  struct Done {
    Kind kind;
    Time time;
    StoredSphere first;
    StoredSphere second;
  };
  struct MergedBefore {
    Time time;
    MergedSpheres before;
  };

  bool is_kept_ = false;
  Time begin_;
  Time last_rebuild_ = kLongAgo;
  std::vector<Done> events_;
  std::vector<MergedBefore> merged_;
};

}  // namespace hardball
