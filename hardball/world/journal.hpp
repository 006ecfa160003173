// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/world/pair_levels.hpp"
#include "hardball/world/sphere_state.hpp"

namespace hardball {

/// The changes of a world in their order, with what is needed to undo them.
///
/// Most are new paths, two for each contact: they are kept apart from the rest, each in a cache line.
class Journal {
 public:
  /// What has changed.
  enum class Kind : std::uint8_t {
    path,     ///< The path of a sphere.
    state,    ///< Anything about a sphere.
    birth,    ///< A sphere was added.
    death,    ///< A sphere was removed.
    passage,  ///< Two spheres began to pass through each other.
    level,    ///< The level of a pair.
  };
  struct Change {
    Time time;      ///< Time of the change [T].
    Slot slot = 0;  ///< The slot of the sphere at the time of the change.
    Kind kind = Kind::path;
  };

  bool empty() const { return changes_.empty(); }
  /// The last change. Precondition: there is one.
  const Change& back() const { return changes_.back(); }
  /// The path before the last change. Precondition: it is a path.
  const Path& path() const { return paths_.back(); }
  /// By how many boxes the center was folded back with the last change. Precondition: it is a path.
  Image folded() const { return has_folded() ? folds_.back().image : Image(); }
  /// The sphere before the last change, or after a birth. Precondition: it is a state, a birth
  /// or a death.
  const SphereState& state() const { return states_.back(); }
  /// The last passage before the last change. Precondition: it is a passage.
  const Event& passage() const { return passages_.back(); }
  /// The pair, for the sphere of the last change, as it was before. Precondition: it is a level.
  const PairLevel& level() const { return levels_.back(); }
  /// The path that a sphere had before the last change of its path. Precondition: there is one.
  const Path& path_before(Slot slot) const { return paths_[last_path(slot)]; }

  void note_path(const Time& moment, Slot slot, const Path& before) {
    append_ahead(changes_, Change{moment, slot, Kind::path});
    append_ahead(paths_, before);
  }
  /// The center was folded back with the last change of the path.
  void note_folded(Slot slot, const Image& folded) {
    const std::size_t path = last_path(slot);
    auto place = folds_.end();
    while (place != folds_.begin() && std::prev(place)->path > path) --place;
    if (place != folds_.begin() && std::prev(place)->path == path) {
      Image& all = std::prev(place)->image;
      all = all + folded;
    } else {
      folds_.insert(place, {path, folded});
    }
  }
  void record(Kind kind, const Time& moment, Slot slot, const SphereState& before) {
    changes_.push_back({moment, slot, kind});
    states_.push_back(before);
  }
  void note_passage(const Time& moment, const Event& before) {
    changes_.push_back({moment, 0, Kind::passage});
    passages_.push_back(before);
  }
  void note_level(const Time& moment, Slot slot, const PairLevel& before) {
    changes_.push_back({moment, slot, Kind::level});
    levels_.push_back(before);
  }
  /// Forgets the last change.
  void pop() {
    switch (back().kind) {
      case Kind::path:
        if (has_folded()) folds_.pop_back();
        paths_.pop_back();
        break;
      case Kind::passage:
        passages_.pop_back();
        break;
      case Kind::level:
        levels_.pop_back();
        break;
      case Kind::state:
      case Kind::birth:
      case Kind::death:
        states_.pop_back();
    }
    changes_.pop_back();
  }
  void clear() {
    changes_.clear();
    paths_.clear();
    folds_.clear();
    states_.clear();
    passages_.clear();
    levels_.clear();
  }

  std::size_t memory_bytes() const {
    return changes_.capacity() * sizeof(Change) + paths_.capacity() * sizeof(Path) +
           folds_.capacity() * sizeof(Fold) + states_.capacity() * sizeof(SphereState) +
           passages_.capacity() * sizeof(Event) + levels_.capacity() * sizeof(PairLevel);
  }

 private:
  // Most changes of a path fold nothing back.
  struct Fold {
    std::size_t path = 0;  // its number in the list
    Image image;
  };

  // Whether the last path, which is the last change, has been folded back.
  bool has_folded() const { return !folds_.empty() && folds_.back().path + 1 == paths_.size(); }

  // It is among the last few.
  std::size_t last_path(Slot slot) const {
    std::size_t path = paths_.size();
    for (std::size_t change = changes_.size();;) {
      --change;
      if (changes_[change].kind != Kind::path) continue;
      --path;
      if (changes_[change].slot == slot) return path;
    }
  }

  LargeVector<Change> changes_;
  LargeVector<Path> paths_;
  std::vector<Fold> folds_;
  std::vector<SphereState> states_;
  std::vector<Event> passages_;
  std::vector<PairLevel> levels_;
};

}  // namespace hardball
