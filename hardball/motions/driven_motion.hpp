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
#include "hardball/memory/function.hpp"
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
  /// The normal impulse that spheres have given to a surface since the start of the simulation [M L/T].
  using ImpulseOn = Function<double(std::uint32_t)>;

  /// `name` is for messages and results; `spheres` are the ids of kinematic spheres, `surfaces` the numbers
  /// of surfaces, from kFaces on.
  DrivenMotion(std::string name, PrescribedMotion motion, std::vector<SphereId> spheres,
               std::vector<std::uint32_t> surfaces = {});

  /// Lets the motion stop where the spheres press on the planes that it drives: at multiples of `interval`
  /// [T] after its begin it looks at the mean pressure since the last look, and ends if that is `pressure` [M
  /// L^-1 T^-2] or more; the planes then rest. Precondition: it has not begun. Error: a number that is not
  /// positive or out of range.
  void stop_at_pressure(double pressure, double interval);
  /// Whether it looks at the pressure.
  bool depends_on_pressure() const { return interval_ > 0; }
  /// When the pressure has stopped it [T].
  const std::optional<double>& stopped_at() const { return stopped_at_; }

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
  /// itself, or must not move as the motion does; the motion leaves the plane of a flat box; it looks at the
  /// pressure on other than planes of known areas; see Knots.
  void begin(const World& world, const Time& now);
  /// When the next chords begin, or it looks at the pressure [T]; infinity for never. Precondition: it has
  /// begun.
  double next() const { return next_; }
  /// Appends the chords that begin at `moment`: the first ones when it has just begun, otherwise those of
  /// next(), to which the moment rounds. Cost: O(bodies). Error (RunFailure): a sphere is not where the
  /// motion has led it; times do not resolve the chords.
  void act(const World& world, const ImpulseOn& impulse_on, const Time& moment, std::vector<NewPlace>& places,
           std::vector<NewSurface>& surfaces);
  /// How long the present chord lasts [T]; infinity for a body at rest.
  double chord() const { return end_of_chord() - time_of(knot_); }

  void note_removed(SphereId sphere);

 private:
  friend class Persistence;
  DrivenMotion() : motion_(PrescribedMotion::keyframes(std::vector<Keyframe>(1))), knots_(motion_, 0) {}
  static void persist(auto& archive, auto& self) {
    archive(self.name_, self.motion_, self.spheres_, self.removed_, self.places_, self.surfaces_,
            self.points_, self.begin_, self.acceleration_, self.knot_, self.has_acted_, self.pressure_,
            self.interval_, self.looks_, self.impulse_, self.stopped_at_);
  }
  bool restored();

  void check_bodies(const World& world) const;
  void check_surface(const World& world, std::uint32_t number) const;
  double time_of(const Knots::Number& knot) const;
  Vec3 displacement(const Knots::Number& knot, const Vec3& from) const;
  double end_of_chord() const;
  double next_look() const;
  void note_next();
  double impulse(const ImpulseOn& impulse_on) const;
  bool is_pressed(const World& world, double impulse) const;

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
  double pressure_ = 0;      // at which it stops
  double interval_ = 0;      // between looks; zero if it does not look
  std::uint64_t looks_ = 0;  // so far
  double impulse_ = 0;       // on the surfaces, at the last look
  std::optional<double> stopped_at_;
  Knots knots_;
  double next_ = 0;
};

}  // namespace hardball
