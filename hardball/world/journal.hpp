// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/geometry/path.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/world/sphere.hpp"

namespace hardball {

/// All that a world knows of one sphere.
struct SphereState {
  SphereId id = 0;
  Path path;
  double radius = 0;          ///< [L]
  double mass = 0;            ///< [M]
  double inertia_factor = 0;  ///< [1]
  Image folded;               ///< By how many boxes its center has been folded back.
  Vec3 spin;                  ///< [1/T]
  SpeciesId species = 0;

  friend bool operator==(const SphereState&, const SphereState&) = default;
};

/// The changes of a world in their order, with what is needed to undo them.
///
/// Most are new paths, two for each contact: what only others need is kept apart.
class Journal {
 public:
  /// What has changed.
  enum class Kind : std::uint8_t {
    path,     ///< The path of a sphere.
    state,    ///< Anything about a sphere.
    birth,    ///< A sphere was added.
    death,    ///< A sphere was removed.
    passage,  ///< Two spheres began to pass through each other.
  };
  struct Change {
    Path path;      ///< Before, if that has changed.
    Time time;      ///< Of the change [T].
    Image folded;   ///< By how many boxes the center was folded back with it.
    Slot slot = 0;  ///< Where the sphere is stored, or was.
    Kind kind = Kind::path;
  };

  bool empty() const { return changes_.empty(); }
  /// The last change. Precondition: there is one.
  const Change& back() const { return changes_.back(); }
  /// The sphere before the last change, or after a birth. Precondition: it is a state, a birth
  /// or a death.
  const SphereState& state() const { return states_.back(); }
  /// The last passage before the last change. Precondition: it is a passage.
  const Event& passage() const { return passages_.back(); }
  /// The path that a sphere had before the last change of its path. Precondition: there is one.
  const Path& path_before(Slot slot) const { return changes_[last_path(slot)].path; }

  void note_path(const Time& moment, Slot slot, const Path& before) {
    changes_.push_back({before, moment, {}, slot, Kind::path});
  }
  /// The center was folded back with the last change of the path.
  void note_folded(Slot slot, const Image& folded) {
    Image& all = changes_[last_path(slot)].folded;
    all = all + folded;
  }
  void note(Kind kind, const Time& moment, Slot slot, const SphereState& before) {
    changes_.push_back({{}, moment, {}, slot, kind});
    states_.push_back(before);
  }
  void note_passage(const Time& moment, const Event& before) {
    changes_.push_back({{}, moment, {}, 0, Kind::passage});
    passages_.push_back(before);
  }
  /// Forgets the last change.
  void pop() {
    const Kind kind = back().kind;
    if (kind == Kind::passage) passages_.pop_back();
    if (kind == Kind::state || kind == Kind::birth || kind == Kind::death) states_.pop_back();
    changes_.pop_back();
  }
  void clear() {
    changes_.clear();
    states_.clear();
    passages_.clear();
  }

  std::size_t memory_bytes() const {
    return changes_.capacity() * sizeof(Change) + states_.capacity() * sizeof(SphereState) +
           passages_.capacity() * sizeof(Event);
  }

 private:
  // It is among the last few.
  std::size_t last_path(Slot slot) const {
    std::size_t last = changes_.size() - 1;
    while (changes_[last].kind != Kind::path || changes_[last].slot != slot) --last;
    return last;
  }

  LargeVector<Change> changes_;
  std::vector<SphereState> states_;
  std::vector<Event> passages_;
};

}  // namespace hardball
