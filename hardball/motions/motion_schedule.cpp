// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/motions/motion_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

bool MotionSchedule::drives(SphereId sphere) const {
  return ranges::any_of(motions_, [&](const DrivenMotion& motion) { return motion.drives(sphere); });
}

bool MotionSchedule::drives_surface(std::uint32_t number) const {
  return ranges::any_of(
      motions_, [&](const DrivenMotion& motion) { return ranges::binary_search(motion.surfaces(), number); });
}

bool MotionSchedule::drives_surfaces() const {
  return ranges::any_of(motions_, [](const DrivenMotion& motion) { return !motion.surfaces().empty(); });
}

bool MotionSchedule::depends_on_pressure() const {
  return ranges::any_of(motions_, [](const DrivenMotion& motion) {
    return motion.depends_on_pressure() && std::isfinite(motion.next());
  });
}

void MotionSchedule::add(DrivenMotion motion, const World& world, const Time& now) {
  const auto refuse = [&](const std::string& what) {
    throw Error("two motions drive " + what, "motion " + motion.name(), "let one of them drive it");
  };
  for (const SphereId sphere : motion.spheres()) {
    if (drives(sphere)) refuse("sphere " + to_text(sphere));
  }
  for (const std::uint32_t number : motion.surfaces()) {
    if (drives_surface(number)) refuse("surface " + to_text(number));
  }
  motion.begin(world, now);
  motions_.push_back(std::move(motion));
}

double MotionSchedule::next() const {
  double next = std::numeric_limits<double>::infinity();
  for (const DrivenMotion& motion : motions_) next = std::min(next, motion.next());
  return next;
}

void MotionSchedule::act(const World& world, const DrivenMotion::ImpulseOn& impulse_on, const Time& moment) {
  places_.clear();
  surfaces_.clear();
  const double now = next();
  for (DrivenMotion& motion : motions_) {
    if (motion.next() == now) motion.act(world, impulse_on, moment, places_, surfaces_);
  }
  ranges::sort(places_, {}, &NewPlace::id);
}

bool MotionSchedule::fits(const Setting& setting, const Time& now) const {
  const auto exists = [&](std::uint32_t number) {
    return number >= kFaces && number - kFaces < setting.surfaces().size();
  };
  return next() >= now.value() && ranges::all_of(motions_, [&](const DrivenMotion& motion) {
           return ranges::all_of(motion.surfaces(), exists);
         });
}

void MotionSchedule::note_removed(SphereId sphere) {
  for (DrivenMotion& motion : motions_) motion.note_removed(sphere);
}

}  // namespace hardball
