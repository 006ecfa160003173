// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/motions/driven_motion.hpp"
#include "hardball/world/new_place.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// All prescribed motions of a run: when the next chords begin, and what they are.
class HARDBALL_EXPORT MotionSchedule {
 public:
  bool is_empty() const { return motions_.empty(); }
  std::span<const DrivenMotion> motions() const { return motions_; }
  /// Whether one of them drives this sphere.
  bool drives(SphereId sphere) const;
  /// Whether one of them drives this surface.
  bool drives_surface(std::uint32_t number) const;
  /// Whether one of them drives a surface.
  bool drives_surfaces() const;

  /// Adds a motion that begins at `now`, when it acts for the first time. Error, and nothing has changed: two
  /// motions drive the same body; see DrivenMotion::begin.
  void add(DrivenMotion motion, const World& world, const Time& now);

  /// Whether one of them looks at the pressure on what it drives.
  bool depends_on_pressure() const;

  /// When one of them acts next [T]; infinity for never.
  double next() const;
  /// Begins the chords of next(), to which `moment` rounds. Cost: O(bodies). Error: see DrivenMotion::act.
  void act(const World& world, const DrivenMotion::ImpulseOn& impulse_on, const Time& moment);
  /// The new paths of spheres, in the order of ids, and the surfaces that have changed, since the last call
  /// of `act`; valid until the next one.
  std::span<const NewPlace> places() const { return places_; }
  std::span<const NewSurface> surfaces() const { return surfaces_; }

  void note_removed(SphereId sphere);

  /// Whether the motions may go on at `now` in a setting, as far as surfaces and times are concerned.
  bool fits(const Setting& setting, const Time& now) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    if (archive.version() >= kSinceVersion) archive(self.motions_);
  }
  static constexpr std::uint32_t kSinceVersion = 15;  // of archives that have motions

  std::vector<DrivenMotion> motions_;
  std::vector<NewPlace> places_;
  std::vector<NewSurface> surfaces_;
};

}  // namespace hardball
