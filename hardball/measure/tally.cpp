// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/measure/energy_gain.hpp"

namespace hardball {
namespace {

// The kinetic energy that spheres gain which merge to one.
double gain_of_merging(const Contact& contact) {
  const auto energy = [](double mass, const Vec3& velocity) { return energy_gain(mass, {}, velocity); };
  return energy(contact.first_mass + contact.second_mass, contact.after.first) -
         energy(contact.first_mass, contact.before.first) -
         energy(contact.second_mass, contact.before.second);
}

}  // namespace

void Tally::begin(const World& world, const Time& now) {
  *this = Tally();
  walls_.resize(kFaces + world.surfaces().size());
  begin_ = now;
  last_ = now;
  energy_ = world.kinetic_energy(now);
  is_straight_ = world.motion().is_straight();
  initial_energy_ = world.energy(now);
}

void Tally::note_edit(double energy_change, const Time& now) {
  energy_integral_ = energy_integral(now);
  last_ = now;
  energy_ += energy_change;
}

void Tally::note(const Contact& contact) {
  energy_integral_ = energy_integral(contact.time);
  last_ = contact.time;
  if (contact.is_collision()) {
    ++collisions_;
    if (contact.outcome != ContactOutcome::bounce) [[unlikely]]
      return note_outcome(contact);
    energy_ += energy_gain(contact.first_mass, contact.before.first, contact.after.first) +
               energy_gain(contact.second_mass, contact.before.second, contact.after.second);
    max_overlap_ = std::max(max_overlap_, contact.overlap());
    virial_ -= dot(contact.impulse(), contact.separation);
    const double speed = contact.impact_speed();
    impact_speed_sum_ += speed;
    impact_speed_square_sum_ += speed * speed;
  } else {
    ++wall_contacts_;
    energy_ += energy_gain(contact.first_mass, contact.before.first, contact.after.first);
    max_overlap_ = std::max(max_overlap_, contact.overlap());
    WallTally& wall = walls_[contact.second];
    const Vec3 impulse = contact.impulse();
    const double work = dot(impulse, contact.before.second);
    ++wall.contacts;
    wall.impulse -= impulse;
    wall.normal_impulse -= dot(impulse, contact.wall_normal);
    wall.work += work;
    wall.heat += energy_gain_of_first(contact) - work;
  }
}

void Tally::note_outcome(const Contact& contact) {
  ++(contact.outcome == ContactOutcome::merge ? mergers_ : passes_);
  if (contact.outcome == ContactOutcome::merge) energy_ += gain_of_merging(contact);
}

double Tally::energy_integral(const Time& now) const {
  return energy_integral_ + energy_ * duration(last_, now);
}

double Tally::compressibility(const Time& now) const {
  if (!is_straight_) return std::numeric_limits<double>::quiet_NaN();
  return 1 + virial_ / (2 * energy_integral(now));
}

double Tally::wall_pressure(const Box& box, const Time& now) const {
  double impulse = 0;
  double area = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_wall(axis)) continue;
    impulse += wall_impulse(face_of(axis, false)) + wall_impulse(face_of(axis, true));
    area += 2 * box.face_area(axis);
  }
  return area > 0 ? impulse / (area * duration(begin_, now)) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hardball
