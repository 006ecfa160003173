// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/bounds/compact_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// The names of the constants are those of docs/bounds.md.

// Ticks per unit of time. A copy expires a little before its age in ticks exceeds a signed integer.
constexpr double kTicks = 0x1p24;
constexpr double kLongestAge = 0x1.cp30;

// The steps of the grid are at most this fraction of the greatest distance l of candidates.
constexpr double kGridStep = 0x1p-26;
constexpr double kRing = 0x1p32;
// Beyond, in units of l, coordinates in double precision are too coarse.
constexpr double kFarthestPosition = 0x1p24;
// The largest coordinate in steps of the grid that converts exactly.
constexpr double kMaxSteps = 0x1p50;

// The speed V up to which copies are good, over the root mean square of those copied.
constexpr double kSpeedMargin = 8;

// Units are chosen again after this many copies per sphere, or when this many copies have no bound.
constexpr std::uint64_t kCopiesPerSphere = 32;
constexpr std::uint64_t kUnboundedShare = 8;
constexpr std::uint64_t kFewCopies = 256;

// Makes up for rounding in single precision.
constexpr double kRoundedDown = 1 - 0x1p-10;

float rounded_up(double number) {
  const auto nearest = static_cast<float>(number);
  if (static_cast<double>(nearest) >= number) return nearest;
  return std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

// The least power of two that is greater than a positive number.
double unit_of(double number) {
  int exponent = 0;
  std::frexp(number, &exponent);
  return std::ldexp(1.0, exponent);
}

}  // namespace

void CompactPaths::reset(const World& world, double farthest, const Time& now) {
  reset(world, farthest, farthest, now);
}

void CompactPaths::reset(const World& world, double farthest, double most_moved, const Time& now) {
  if (paths_.size() < world.size()) {
    paths_.assign(world.size(), CompactPath{});
    squares_ = 0;
  }
  HARDBALL_CHECK(farthest >= least_farthest(world.box()) && farthest >= most_moved);
  epoch_ = now;
  farthest_ = farthest;
  most_moved_ = most_moved;
  choose_units(world);
  most_copies_ = kCopiesPerSphere * (world.size() + kFewCopies);
  most_unbounded_ = (world.size() + kFewCopies) / kUnboundedShare;
  for (Slot slot = 0; slot < world.size(); ++slot) copy(world, slot, now);
  copies_ = unbounded_ = 0;
  squares_ = 0;
}

double CompactPaths::least_farthest(const Box& box) {
  return box.is_sheared() ? box.size().y / (kGridStep * kRing) : 0;
}

// To the image that is in a sheared box, and is not rounded into the next.
void CompactPaths::fold(State& state, const Box& box, const Time& now) const {
  box.fold(state.position, state.velocity, now);
  state.position.y = std::clamp(state.position.y, lowest_in_box_, highest_in_box_);
}

void CompactPaths::choose_units(const World& world) {
  const double length_unit = length_unit_ = unit_of(farthest_);
  const double l = farthest_ / length_unit;
  if (!(squares_ > 0)) {
    copies_ = world.size();
    for (const Path& path : world.paths()) squares_ += dot(path.velocity, path.velocity);
  }
  // In falling by l, a sphere that is bounded does not come to exceed half of the greatest speed.
  const double fall = length(world.motion().gravity()) * farthest_;
  const double mean = copies_ > 0 ? std::sqrt(squares_ / static_cast<double>(copies_)) : 0;
  // Squares of slower speeds underflow; inelastic collapse leads to them. Then nothing is bounded.
  constexpr double kSlowest = 0x1p-400;
  constexpr double kFallMargin = 16;
  const double usual_speed = std::max(kSpeedMargin * mean, kSlowest);
  const double greatest_speed =
      fall > 0 ? std::sqrt(4 * usual_speed * usual_speed + kFallMargin * fall) : usual_speed;
  const double speed_unit = unit_of(greatest_speed);
  const double v = greatest_speed / speed_unit;
  greatest_speed_squared_ = greatest_speed > kSlowest ? usual_speed * usual_speed : -1;
  per_speed_ = 1 / speed_unit;
  time_unit_ = length_unit / speed_unit;
  ticks_per_time_ = kTicks / time_unit_;
  longest_age_ = kLongestAge / ticks_per_time_;

  const Box& box = world.box();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    double step = kGridStep * farthest_;
    if (box.is_periodic(axis)) {
      const double turns = std::ceil(box.size()[axis] / (kRing * step));
      step = box.size()[axis] / (turns * kRing);
    }
    step_[axis] = step;
    steps_per_length_[axis] = 1 / step;
    farthest_position_[axis] = std::min(kFarthestPosition * farthest_, kMaxSteps * step);
    scale_.grid[axis] = static_cast<float>(step / length_unit);
    scale_.gravity[axis] = static_cast<float>(world.motion().gravity()[axis] / speed_unit * time_unit_);
  }
  scale_.has_gravity = fall > 0;
  per_most_moved_ = 1 / (kRoundedDown * most_moved_ * per_speed_);
  longest_age_of_all_ = scale_.has_gravity ? 0 : longest_age_;
  if (box.is_sheared())
    longest_age_of_all_ = std::min(longest_age_, kRoundedDown * most_moved_ / greatest_speed);
  growth_ = world.motion().growth();
  per_scale_ = 1 / growth_.largest_scale();
  scale_.has_growth = world.motion().has_growth();
  const double growth = std::max(0.0, growth_.rate * per_scale_ * time_unit_);
  scale_.growth = rounded_up(growth);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  lowest_in_box_ = box.is_sheared() ? 0 : -kInfinite;
  highest_in_box_ = box.is_sheared() ? (kRing - 1) * step_.y : kInfinite;
  images_ = box.images();
  box_width_ = box.size().x;
  slid_at_epoch_ = box.is_sheared() ? images_.displacement_in_box(epoch_) : 0;
  scale_.has_shear = box.is_sheared();
  const double slide_speed = scale_.has_shear ? images_.speed() * per_speed_ : 0;
  scale_.slide_speed = static_cast<float>(slide_speed);
  // The greatest rate at which a gap may change; where images slide, twice that, as there is more to round.
  double w = 2 * v + growth * l;
  if (scale_.has_shear) w = 2 * (w + std::fabs(slide_speed));
  scale_.speed_error = rounded_up(0x1p-23 * w);
  scale_.tick = static_cast<float>(1 / kTicks);
  scale_.reach_allowance = rounded_up(0x1p-20 * l);
  scale_.square_allowance = rounded_up(0x1p-20 * l * l);
  scale_.approach_allowance = rounded_up(0x1p-19 * l * w);
  scale_.speed_allowance = rounded_up(0x1p-44 * w * w);
  scale_.excess_allowance = rounded_up(0x1p-19 * l * l);
  scale_.least_discriminant = rounded_up(0x1p-60 * l * l * w * w);
  copy_radii(world);
}

void CompactPaths::copy_radii(const World& world) {
  radii_.clear();
  if (!world.base_radii().is_common()) radii_.resize(paths_.size());
  scale_.radii.fill(world.size() > 0 ? rounded_up(world.bounding_radius(0) / length_unit_) : 0);
  scale_.are_radii_alike = radii_.empty();
  scale_.common_reach = scale_.radii[0] + scale_.radii[0] + scale_.reach_allowance;
  kinds_ = 1;
  are_radii_few_ = true;
  for (Slot slot = 0; slot < world.size(); ++slot) copy_radius(slot, world.bounding_radius(slot));
}

void CompactPaths::copy_radius(Slot slot, double radius) {
  std::size_t kind = 0;
  if (!radii_.empty()) {
    const float copied = radii_[slot] = rounded_up(radius / length_unit_);
    while (kind < kinds_ && scale_.radii[kind] != copied) ++kind;
    are_radii_few_ &= kind < CompactPath::kRadii;
    if (kind == kinds_ && are_radii_few_) scale_.radii[kinds_++] = copied;
  }
  paths_[slot].revision = revision(slot) + static_cast<std::uint32_t>(kind % CompactPath::kRadii);
}

void CompactPaths::insert(const World& world, Slot slot, const Time& now) {
  if (slot == paths_.size()) append_sparingly(paths_, CompactPath{});
  if (scale_.are_radii_alike != world.base_radii().is_common() || world.size() == 1) {
    copy_radii(world);
  } else {
    if (!radii_.empty() && slot >= radii_.size()) radii_.resize(slot + 1);
    copy_radius(slot, world.bounding_radius(slot));
  }
  copy(world, slot, now);
}

void CompactPaths::move(Slot from, Slot to) {
  const std::uint32_t revision_of_slot = revision(to);
  paths_[to] = paths_[from];
  paths_[to].revision = revision_of_slot + paths_[from].revision % kRevision;
  if (!radii_.empty()) radii_[to] = radii_[from];
}

// Until then the sphere moves no farther than it may, counting its rise and its fall apart.
double CompactPaths::longest_age_of(Slot slot) const {
  if (!is_bounded(slot)) return longest_age_;
  const auto square = [](const std::array<float, 3>& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; };
  const auto farthest = static_cast<float>(most_moved_ / length_unit_);
  const float speed_squared = square(paths_[slot].velocity);
  const float gravity = std::sqrt(square(scale_.gravity));
  const float root = std::sqrt(speed_squared + 2 * gravity * farthest);
  const float age = static_cast<float>(kRoundedDown) * 2 * farthest / (std::sqrt(speed_squared) + root);
  return std::min(longest_age_, time_unit_ * static_cast<double>(age));
}

// A position may be too far away for the fast conversion to an integer.
void CompactPaths::note_unbounded(CompactPath& copy, const Vec3& position) {
  ++unbounded_;
  copy.velocity.fill(std::numeric_limits<float>::quiet_NaN());
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    copy.position[axis] =
        to_integer(std::remainder(position[axis], kRing * step_[axis]) * steps_per_length_[axis]);
  }
}

}  // namespace hardball
