// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/motions/driven_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Below the operating range a component is zero.
Vec3 flushed(Vec3 velocity) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (std::fabs(velocity[axis]) < kSmallestMagnitude) velocity[axis] = 0;
  }
  return velocity;
}

Vec3 place_of(const World& world, Slot slot, const Time& moment) {
  return world.unfolded_position(slot, moment) + world.box().shift(world.folded(slot), moment);
}

double magnitude(const Vec3& vector) {
  return std::max({std::fabs(vector.x), std::fabs(vector.y), std::fabs(vector.z)});
}

// NaN of what is no plane, and of a plane that the box does not bound.
double area_of_plane(const World& world, std::uint32_t number) {
  const auto* const plane = std::get_if<Plane>(&world.surface(number).shape());
  const double area = plane ? plane->area(world.box()) : std::numeric_limits<double>::quiet_NaN();
  return std::isfinite(area) ? area : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

DrivenMotion::DrivenMotion(std::string name, PrescribedMotion motion, std::vector<SphereId> spheres,
                           std::vector<std::uint32_t> surfaces)
    : name_(std::move(name)),
      motion_(std::move(motion)),
      spheres_(std::move(spheres)),
      surfaces_(std::move(surfaces)),
      knots_(motion_, 0) {
  ranges::sort(spheres_);
  ranges::sort(surfaces_);
}

void DrivenMotion::stop_at_pressure(double pressure, double interval) {
  const std::string where = "motion " + name_;
  check_positive(pressure, "pressure", where);
  check_positive(interval, "interval", where);
  pressure_ = pressure;
  interval_ = interval;
}

bool DrivenMotion::drives(SphereId sphere) const {
  return ranges::binary_search(spheres_, sphere);
}

void DrivenMotion::check_bodies(const World& world) const {
  const std::string where = "motion " + name_;
  if (spheres_.empty() && surfaces_.empty())
    throw Error("the motion drives nothing", where, "name kinematic spheres or surfaces");
  const auto twice = ranges::adjacent_find(spheres_);
  if (twice != spheres_.end())
    throw Error("sphere " + to_text(*twice) + " is given twice", where, "give each sphere once");
  const auto surface_twice = ranges::adjacent_find(surfaces_);
  if (surface_twice != surfaces_.end())
    throw Error("surface " + to_text(*surface_twice) + " is given twice", where, "give each surface once");
  for (const SphereId id : spheres_) {
    if (world.is_kinematic(world.slot_of(id))) continue;
    throw Error("sphere " + to_text(id) + " is not kinematic", where, "give it an infinite mass");
  }
  for (const std::uint32_t number : surfaces_) check_surface(world, number);
  const auto is_piston = [&](std::uint32_t number) { return area_of_plane(world, number) > 0; };
  if (depends_on_pressure() && !(spheres_.empty() && ranges::all_of(surfaces_, is_piston))) {
    throw Error("the motion stops at a pressure, and drives other than planes across axes of the box", where,
                "let it drive such planes alone, or run in pieces and stop it by yourself");
  }
  if (world.box().is_flat()) refuse_out_of_plane(motion_.span(), "the motion", where);
}

void DrivenMotion::check_surface(const World& world, std::uint32_t number) const {
  const std::string where = "motion " + name_;
  const auto surfaces = world.surfaces();
  if (number < kFaces || number - kFaces >= surfaces.size()) {
    throw Error("there is no surface " + to_text(number), where,
                "give the number of a surface: faces of the box, 0 to 5, do not move");
  }
  const Surface& surface = surfaces[number - kFaces];
  if (std::holds_alternative<Rotation>(motion_.kind())) {
    throw Error("a " + std::string(surface.name()) + " does not rotate", where,
                "let kinematic spheres rotate, or give it another motion");
  }
  if (std::holds_alternative<OscillatingPlane>(surface.shape())) {
    throw Error("the plane oscillates by itself", where, "give it a motion, or amplitude and frequency");
  }
  // As if it moved evenly: toward the spheres, because it may be behind them now.
  Vec3 velocity = motion_.span();
  const Vec3* const normal = surface.normal();
  if (normal && dot(*normal, velocity) <= 0) velocity += *normal;
  if (motion_.span() == Vec3{}) return;
  const Vec3 point = surface.at_rest(Time(0)).point();
  try {
    static_cast<void>(World(world.box(), {}, {Surface(surface.shape(), point, velocity)}));
  } catch (const Error& error) {
    throw Error(error.problem(), where, error.remedy());
  }
}

void DrivenMotion::begin(const World& world, const Time& now) {
  check_bodies(world);
  begin_ = now;
  places_.clear();
  points_.clear();
  double curved = 0;
  for (const SphereId id : spheres_) {
    places_.push_back(place_of(world, world.slot_of(id), now));
    curved = std::max(curved, motion_.acceleration(places_.back()));
  }
  for (const std::uint32_t number : surfaces_) {
    const Surface& surface = world.surface(number);
    points_.push_back(surface.point() + duration(surface.since(), now) * surface.velocity());
    curved = std::max(curved, motion_.acceleration(points_.back()));
  }
  acceleration_ = curved + (spheres_.empty() ? 0 : length(world.motion().gravity()));
  knots_ = Knots(motion_, acceleration_);
  knot_ = knots_.first(motion_);
  has_acted_ = false;
  looks_ = 0;
  stopped_at_.reset();
  next_ = now.value();
}

// Since a motion begins at some moment, only the times of its knots are rounded, and bodies are where the
// curve is at the rounded time.
double DrivenMotion::time_of(const Knots::Number& knot) const {
  return after(begin_, knots_.time(motion_, knot)).high;
}

Vec3 DrivenMotion::displacement(const Knots::Number& knot, const Vec3& from) const {
  if (knot == knots_.first(motion_)) return {};
  const DoubleDouble<> elapsed = DoubleDouble<>{time_of(knot), 0} - DoubleDouble<>{begin_.high, begin_.low};
  return knots_.displacement(motion_, knot, from, {elapsed.high, elapsed.low});
}

double DrivenMotion::end_of_chord() const {
  if (stopped_at_ || knots_.is_last(motion_, knot_)) return std::numeric_limits<double>::infinity();
  return time_of(knots_.after(motion_, knot_));
}

double DrivenMotion::next_look() const {
  if (!depends_on_pressure()) return std::numeric_limits<double>::infinity();
  return after(begin_, static_cast<double>(looks_ + 1) * interval_).high;
}

// What has come to rest looks no more.
void DrivenMotion::note_next() {
  next_ = end_of_chord();
  if (std::isfinite(next_)) next_ = std::min(next_, next_look());
}

double DrivenMotion::impulse(const ImpulseOn& impulse_on) const {
  double sum = 0;
  for (const std::uint32_t number : surfaces_) sum += impulse_on(number);
  return sum;
}

bool DrivenMotion::is_pressed(const World& world, double impulse) const {
  double area = 0;
  for (const std::uint32_t number : surfaces_) area += area_of_plane(world, number);
  return impulse >= pressure_ * area * interval_;
}

void DrivenMotion::act(const World& world, const ImpulseOn& impulse_on, const Time& moment,
                       std::vector<NewPlace>& places, std::vector<NewSurface>& surfaces) {
  if (has_acted_ && next_ == next_look()) {
    const double before = std::exchange(impulse_, impulse(impulse_on));
    ++looks_;
    if (is_pressed(world, impulse_ - before)) {
      stopped_at_ = next_;
      for (const std::uint32_t number : surfaces_) {
        const Surface& surface = world.surface(number);
        const Vec3 point = surface.point() + duration(surface.since(), moment) * surface.velocity();
        surfaces.push_back({number, surface.moved(moment, point, Vec3{})});
      }
      return note_next();
    }
    if (next_ < end_of_chord()) return note_next();
  }
  if (has_acted_) {
    knot_ = knots_.after(motion_, knot_);
  } else {
    impulse_ = impulse(impulse_on);
  }
  note_next();
  const double now = has_acted_ ? time_of(knot_) : begin_.value();
  const double chord = end_of_chord() - now;
  if (!(chord > 0)) {
    throw RunFailure("the chords of the motion " + name_ + " are not resolved at time " + to_text(now) +
                     "; give it a larger tolerance");
  }
  const bool rests = !std::isfinite(chord);
  const Knots::Number end = rests ? knot_ : knots_.after(motion_, knot_);
  const auto velocity_of = [&](const Vec3& from, const Vec3& moved) {
    return rests ? Vec3{} : (1 / chord) * (displacement(end, from) - moved);
  };
  const Vec3 arc = rests ? Vec3{} : (chord / 2) * world.motion().gravity();
  for (std::size_t k = 0; k < spheres_.size(); ++k) {
    constexpr double kRounding = 1e-9;
    const Slot slot = world.slot_of(spheres_[k]);
    const Vec3 moved = displacement(knot_, places_[k]);
    const Vec3 place = places_[k] + moved;
    const Vec3 before = world.velocity(slot, moment);
    const Vec3 gap = place_of(world, slot, moment) - place;
    const double scale = magnitude(place) + magnitude(moved) + (rests ? 0 : chord * magnitude(before)) +
                         world.base_radius(slot);
    if (magnitude(gap) > kRounding * scale) {
      throw RunFailure("sphere " + to_text(spheres_[k]) + " is not where the motion " + name_ +
                       " has led it at time " + to_text(now) +
                       ": a wall has reflected it, or it was given another velocity");
    }
    places.push_back({slot, spheres_[k], place, before, flushed(velocity_of(places_[k], moved) - arc)});
  }
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const Vec3 moved = displacement(knot_, points_[k]);
    surfaces.push_back(
        {surfaces_[k], world.surface(surfaces_[k])
                           .moved(moment, points_[k] + moved, flushed(velocity_of(points_[k], moved)))});
  }
  has_acted_ = true;
}

void DrivenMotion::note_removed(SphereId sphere) {
  const auto found = ranges::lower_bound(spheres_, sphere);
  if (found == spheres_.end() || *found != sphere) return;
  places_.erase(places_.begin() + (found - spheres_.begin()));
  spheres_.erase(found);
  removed_.push_back(sphere);
}

bool DrivenMotion::restored() {
  if (spheres_.size() != places_.size() || surfaces_.size() != points_.size()) return false;
  if (!ranges::is_sorted(spheres_) || !ranges::is_sorted(surfaces_)) return false;
  check_moment(begin_, "motion");
  if (!(acceleration_ >= 0) || !(pressure_ >= 0) || !(interval_ >= 0)) return false;
  for (const Vec3& place : places_) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(place[axis], "place", "motion");
  }
  for (const Vec3& point : points_) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(point[axis], "point", "motion");
  }
  knots_ = Knots(motion_, acceleration_);
  next_ = begin_.value();
  if (has_acted_) note_next();
  return true;
}

}  // namespace hardball
