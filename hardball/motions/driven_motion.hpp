// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/motions/prescribed_motion.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/new_place.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A surface as it moves from some moment on.
struct NewSurface {
  std::uint32_t number = 0;
  Surface surface;
};

/// A prescribed motion and what it drives: kinematic spheres and surfaces. They move on chords, from where
/// they were when the motion began.
class HARDBALL_EXPORT DrivenMotion {
 public:
  /// `name` is for messages and results; `spheres` are the ids of kinematic spheres, `surfaces` the numbers
  /// of surfaces, from kFaces on.
  DrivenMotion(std::string name, PrescribedMotion motion, std::vector<SphereId> spheres,
               std::vector<std::uint32_t> surfaces = {});

  const std::string& name() const { return name_; }
  const PrescribedMotion& motion() const { return motion_; }
  /// The spheres that it drives, in the order of ids.
  std::span<const SphereId> spheres() const { return spheres_; }
  /// Those that it has driven, and that have been removed or have become part of others.
  std::span<const SphereId> removed_spheres() const { return removed_; }
  std::span<const std::uint32_t> surfaces() const { return surfaces_; }
  bool drives(SphereId sphere) const;

  /// Begins at `now` with the bodies where they are. Cost: O(bodies). Error: it drives nothing; there is no
  /// such sphere or surface, it is given twice, or is not kinematic; a surface rotates or oscillates by
  /// itself, or must not move as the motion does; the motion leaves the plane of a flat box; see Knots.
  void begin(const World& world, const Time& now);
  /// When the next chords begin [T]; infinity for never. Precondition: it has begun.
  double next() const { return next_; }
  /// Appends the chords that begin at `moment`: the first ones when it has just begun, otherwise those of
  /// next(), to which the moment rounds. Cost: O(bodies). Error (RunFailure): a sphere is not where the
  /// motion has led it; times do not resolve the chords.
  void act(const World& world, const Time& moment, std::vector<NewPlace>& places,
           std::vector<NewSurface>& surfaces);
  /// How long the present chord lasts [T]; infinity for a body at rest.
  double chord() const { return next_ - time_of(knot_); }

  void note_removed(SphereId sphere);

 private:
  friend class Persistence;
  DrivenMotion() : motion_(PrescribedMotion::keyframes(std::vector<Keyframe>(1))), knots_(motion_, 0) {}
  static void persist(auto& archive, auto& self) {
    archive(self.name_, self.motion_, self.spheres_, self.removed_, self.places_, self.surfaces_,
            self.points_, self.begin_, self.acceleration_, self.knot_, self.has_acted_);
  }
  bool restored();

  void check_bodies(const World& world) const;
  void check_surface(const World& world, std::uint32_t number) const;
  double time_of(const Knots::Number& knot) const;
  Vec3 displacement(const Knots::Number& knot, const Vec3& from) const;
  void note_next();

  std::string name_;
  PrescribedMotion motion_;
  std::vector<SphereId> spheres_;
  std::vector<SphereId> removed_;
  std::vector<Vec3> places_;  // of the spheres at the begin, not folded into the box
  std::vector<std::uint32_t> surfaces_;
  std::vector<Vec3> points_;  // of the surfaces at the begin
  Time begin_;
  double acceleration_ = 0;  // the greatest, that of gravity included
  Knots::Number knot_;       // the last one
  bool has_acted_ = false;
  Knots knots_;
  double next_ = 0;
};

}  // namespace hardball
