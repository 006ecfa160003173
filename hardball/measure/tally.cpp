// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/tally.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "hardball/geometry/vec3.hpp"
#include "hardball/measure/angular_impulse.hpp"
#include "hardball/measure/energy_gain.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// The kinetic energy that both spheres gain.
double energy_gain_of(const Contact& contact) {
  return energy_gain(contact.first_mass, contact.before.first, contact.after.first) +
         energy_gain(contact.second_mass, contact.before.second, contact.after.second);
}

// The kinetic energy that spheres gain which merge to one.
double gain_of_merging(const Contact& contact) {
  const auto energy = [](double mass, const Vec3& velocity) { return energy_gain(mass, {}, velocity); };
  return energy(contact.first_mass + contact.second_mass, contact.after.first) -
         energy(contact.first_mass, contact.before.first) -
         energy(contact.second_mass, contact.before.second);
}

}  // namespace

void Tally::begin(const World& world, const Time& now) {
  begin(world, totals_of(world, now), now);
}

void Tally::begin(const World& world, const Totals& totals, const Time& now) {
  *this = Tally();
  for (const Surface& surface : world.surfaces())
    first_groups_.push_back(first_groups_.back() + group_count_of(surface));
  walls_.resize(first_groups_.back());
  begin_ = now;
  last_ = now;
  begin_energy_ = totals.kinetic_energy.value();
  keeps_energy_ = world.motion().is_straight() && !world.box().is_sheared();
  initial_energy_ = totals.energy.value();
  set_interactions(world.interactions());
}

void Tally::note_edit(double energy_change, const Time& now) {
  last_ = later(last_, now);
  note_gain(energy_change, now);
}

// One number for each contact, so that the sums do not depend on which gains are added together.
void Tally::note_gain(double energy, const Time& now) {
  if (energy == 0) return;
  gains_ += energy;
  delayed_gains_ += energy * duration(begin_, now);
}

void Tally::record(const Contact& contact) {
  if (last_ < contact.time) [[likely]]
    last_ = contact.time;
  if (!contact.is_collision()) return note_wall_contact(contact);
  ++collisions_;
  if (contact.outcome != ContactOutcome::bounce) [[unlikely]]
    return note_outcome(contact);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const bool is_known_to_conserve = is_elastic_ && contact.first_mass + contact.second_mass < kInfinity;
  if (!is_known_to_conserve) {
    note_gain(energy_gain_of(contact), contact.time);
    if (!(contact.first_mass + contact.second_mass < kInfinity)) note_kinematic(contact);
  }
  // As Contact has them, from one root.
  const double distance = length(contact.separation);
  const double virial = -dot(contact.impulse(), contact.separation);
  virial_ += virial;
  if (contact.step.happens()) [[unlikely]] {
    ++(contact.step.passes ? steps_passed_ : steps_refused_);
    return;
  }
  max_overlap_ = std::max(max_overlap_, 1 - distance / contact.reach);
  const double speed = std::max(
      0.0, dot(contact.before.first - contact.before.second, contact.separation) / distance + contact.growth);
  impact_speed_sum_ += speed;
  impact_speed_square_sum_ += speed * speed;
  if (contact.growth == 0) [[likely]]
    return;
  growth_work_ += virial / distance * contact.growth;
  if (is_known_to_conserve) note_gain(energy_gain_of(contact), contact.time);
}

void Tally::note_wall_contact(const Contact& contact) {
  ++wall_contacts_;
  const double gain = energy_gain(contact.first_mass, contact.before.first, contact.after.first);
  note_gain(gain, contact.time);
  max_overlap_ = std::max(max_overlap_, contact.overlap());
  WallSums& wall = walls_[first_groups_[contact.second] + contact.group];
  const Vec3 impulse = contact.impulse();
  const double work = dot(impulse, contact.before.second);
  ++wall.contacts;
  for (std::size_t axis = 0; axis < kAxes; ++axis) wall.impulse[axis] += -impulse[axis];
  if (contact.second >= kFaces) {
    const Vec3 angular_impulse = angular_impulse_on_wall(contact);
    for (std::size_t axis = 0; axis < kAxes; ++axis) wall.angular_impulse[axis] += angular_impulse[axis];
  }
  const double normal_impulse = -dot(impulse, contact.wall_normal);
  wall.normal_impulse += normal_impulse;
  const double of_growth = normal_impulse * contact.growth;
  if (of_growth != 0) growth_work_ += of_growth;
  wall.work += work;
  wall.heat += gain + rotational_energy_gain_of_first(contact) - work - of_growth;
}

void Tally::note_kinematic(const Contact& contact) {
  const bool is_first = std::isinf(contact.first_mass);
  const SphereId sphere = is_first ? contact.first : contact.second;
  const Vec3& velocity = is_first ? contact.before.first : contact.before.second;
  const double work = dot(contact.impulse(), velocity);
  if (work != 0) kinematic_work_[sphere] += is_first ? -work : work;
}

void Tally::note_outcome(const Contact& contact) {
  ++(contact.outcome == ContactOutcome::merge ? mergers_ : passes_);
  if (contact.outcome == ContactOutcome::merge) note_gain(gain_of_merging(contact), contact.time);
}

void Tally::WallSums::add(const WallSums& other) {
  contacts += other.contacts;
  for (std::size_t axis = 0; axis < kAxes; ++axis) impulse[axis].add(other.impulse[axis]);
  for (std::size_t axis = 0; axis < kAxes; ++axis) angular_impulse[axis].add(other.angular_impulse[axis]);
  normal_impulse.add(other.normal_impulse);
  work.add(other.work);
  heat.add(other.heat);
}

Tally Tally::part() const {
  Tally part;
  part.walls_.resize(walls_.size());
  part.first_groups_ = first_groups_;
  part.begin_ = begin_;
  part.last_ = begin_;
  part.keeps_energy_ = keeps_energy_;
  part.is_elastic_ = is_elastic_;
  return part;
}

void Tally::add(const Tally& other) {
  last_ = later(last_, other.last_);
  gains_.add(other.gains_);
  delayed_gains_.add(other.delayed_gains_);
  collisions_ += other.collisions_;
  mergers_ += other.mergers_;
  passes_ += other.passes_;
  steps_passed_ += other.steps_passed_;
  steps_refused_ += other.steps_refused_;
  wall_contacts_ += other.wall_contacts_;
  max_overlap_ = std::max(max_overlap_, other.max_overlap_);
  virial_.add(other.virial_);
  growth_work_.add(other.growth_work_);
  impact_speed_sum_.add(other.impact_speed_sum_);
  impact_speed_square_sum_.add(other.impact_speed_square_sum_);
  for (std::size_t group = 0; group < walls_.size(); ++group) walls_[group].add(other.walls_[group]);
  for (const auto& [sphere, work] : other.kinematic_work_) kinematic_work_[sphere].add(work);
}

double Tally::kinematic_work(SphereId sphere) const {
  return kinematic_work({&sphere, 1});
}

double Tally::kinematic_work(std::span<const SphereId> spheres) const {
  ExactSum work;
  for (const SphereId sphere : spheres) {
    const auto found = kinematic_work_.find(sphere);
    if (found != kinematic_work_.end()) work.add(found->second);
  }
  return work.value();
}

WallTally Tally::WallSums::tally() const {
  WallTally tally;
  tally.contacts = contacts;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    tally.impulse[axis] = impulse[axis].value();
    tally.angular_impulse[axis] = angular_impulse[axis].value();
  }
  tally.normal_impulse = normal_impulse.value();
  tally.work = work.value();
  tally.heat = heat.value();
  return tally;
}

WallTally Tally::wall(std::size_t number) const {
  WallSums sums = walls_[first_groups_[number]];
  for (std::size_t group = 1; group < group_count(number); ++group)
    sums.add(walls_[first_groups_[number] + group]);
  return sums.tally();
}

WallTally Tally::wall(std::size_t number, std::size_t group) const {
  return walls_[first_groups_[number] + group].tally();
}

std::vector<std::size_t> Tally::one_group_each(std::size_t walls) {
  std::vector<std::size_t> begins(walls + 1);
  std::iota(begins.begin(), begins.end(), std::size_t{0});
  return begins;
}

bool Tally::restored() {
  // Of an archive that is older than groups and angular impulses, which are not known of its contacts.
  if (first_groups_ == one_group_each(kFaces)) {
    first_groups_ = one_group_each(walls_.size());
    for (std::size_t wall = kFaces; wall < walls_.size(); ++wall)
      walls_[wall].angular_impulse.fill(ExactSum(std::numeric_limits<double>::quiet_NaN()));
  }
  return first_groups_.size() > kFaces && first_groups_.front() == 0 &&
         first_groups_.back() == walls_.size() && ranges::is_sorted(first_groups_, std::less_equal());
}

bool Tally::matches(const World& world) const {
  const std::span<const Surface> surfaces = world.surfaces();
  if (wall_count() != kFaces + surfaces.size()) return false;
  for (std::size_t wall = 0; wall < wall_count(); ++wall) {
    const std::size_t groups = wall < kFaces ? 1 : group_count_of(surfaces[wall - kFaces]);
    if (group_count(wall) != groups) return false;
  }
  return true;
}

double Tally::energy_integral(const Time& now) const {
  ExactSum energy = gains_;
  energy += begin_energy_;
  return energy.value() * duration(begin_, now) - delayed_gains_.value();
}

double Tally::shear_work(double kinetic_energy) const {
  ExactSum work = gains_;
  work += begin_energy_;
  return kinetic_energy - work.value();
}

double Tally::compressibility(const Time& now) const {
  if (!keeps_energy_) return std::numeric_limits<double>::quiet_NaN();
  return 1 + virial() / (2 * energy_integral(now));
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
