// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/large_sphere_grid.hpp"

#include <cmath>
#include <optional>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/wait_in_ball.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

// Shells overlap a little before they touch: far more than rounding.
constexpr double kShellMargin = 1e-9;

}  // namespace

bool LargeSphereGrid::supports(const World& world, double edge) {
  return LargeSizes::in(world, Subdivision(world.box(), edge)).has_value();
}

void LargeSphereGrid::build(const World& world, const Time& now, CompactPaths& copies) {
  const auto sizes = LargeSizes::in_part(world, Subdivision(world.box(), settings_.length));
  HARDBALL_CHECK(sizes.has_value());
  // Large spheres touch cells around those in which centers are expected.
  const Extent touched = settings_.expected.grown(world.largest_bounding_radius() + sizes->skin);
  CellGrid::operator=(CellGrid(settings_.within(touched), sizes->largest_in_grid, sizes->farthest));
  CellGrid::build(world, now, copies);
  HARDBALL_CHECK(CellGrid::uses_minimum_image());
  sizes_ = *sizes;
  skin_ = sizes->skin;
  margin_ = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    margin_ = std::max(margin_, cells().reach(axis, 0));
  }
  large_.clear();
  are_large_.reset(world.size());
  large_numbers_.assign(world.size(), 0);
  moved_anchors_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (world.bounding_radius(slot) > sizes->largest_in_grid) insert_large(world, slot, now);
  }
  double squares = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 velocity = world.velocity(slot, now);
    squares += dot(velocity, velocity);
  }
  usual_speed_ = kUsualSpeed * std::sqrt(squares / static_cast<double>(world.size()));
  for (LargeSphere& large : large_) {
    collect_all(world, large, found_);
    make_list(world, large, now, copies, found_);
  }
}

void LargeSphereGrid::mark_large(Slot slot, bool is_large, std::uint32_t number) {
  if (slot >= large_numbers_.size()) large_numbers_.resize(slot + 1);
  are_large_.set(slot, is_large);
  large_numbers_[slot] = number;
}

void LargeSphereGrid::insert_large(const World& world, Slot slot, const Time& now) {
  mark_large(slot, true, static_cast<std::uint32_t>(large_.size()));
  LargeSphere& large = large_.emplace_back();
  large.slot = slot;
  large.radius = world.bounding_radius(slot);
  move_anchor(world, large, now);
  insert_guest(large);
}

bool LargeSphereGrid::admits(const World& world, Slot slot) const {
  const double radius = world.bounding_radius(slot);
  if (radius <= std::max(sizes_.largest_in_grid, sizes_.second_largest)) return true;
  return radius <= sizes_.largest && ranges::all_of(large_, [&](const LargeSphere& other) {
           return other.radius <= sizes_.second_largest || other.slot == slot;
         });
}

void LargeSphereGrid::insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  mark_large(slot, false, 0);
  CellGrid::insert(world, slot, now, copies);
  if (world.bounding_radius(slot) > sizes_.largest_in_grid) insert_large(world, slot, now);
  collect(world, slot, found_);
  list_at_large(slot, found_);
}

void LargeSphereGrid::erase(Slot slot) {
  for (LargeSphere& large : large_) large.list.replace(slot, large.slot);
  if (!is_large(slot)) return CellGrid::erase(slot);
  const std::uint32_t number = large_numbers_[slot];
  erase_guest(large_[number]);
  mark_large(large_.back().slot, true, number);
  large_[number] = std::move(large_.back());
  large_.pop_back();
  mark_large(slot, false, 0);
}

void LargeSphereGrid::move(Slot from, Slot to) {
  for (LargeSphere& large : large_) large.list.replace(from, to);
  if (!is_large(from)) {
    mark_large(to, false, 0);
    return CellGrid::move(from, to);
  }
  lines_[to] = lines_[from];
  LargeSphere& large = large_of(from);
  erase_guest(large);
  large.slot = to;
  insert_guest(large);
  mark_large(to, true, large_numbers_[from]);
  mark_large(from, false, 0);
}

// No cell knows which spheres lie deep inside a large sphere.
void LargeSphereGrid::collect_overlapping(const World& world, Slot slot, Candidates& candidates) const {
  if (is_large(slot)) {
    candidates.begin(slot, true);
    const LargeSphere& large = large_of(slot);
    for_each_cell_of_shell(cells(), large.anchor, 0, large.radius + skin_ + margin_,
                           [&](const CellIndex& cell) {
                             for_each_line(cell, [&](const SlotLists::LineOfSlots& slots,
                                                     std::uint32_t count) { candidates.add(slots, count); });
                           });
  } else {
    CellGrid::collect(world, slot, candidates);
  }
  for (const LargeSphere& large : large_) candidates.add(large.slot);
  candidates.end();
}

void LargeSphereGrid::move_anchor(const World& world, LargeSphere& large, const Time& now) const {
  large.anchor = world.unfolded_position(large.slot, now);
  large.boxes = -world.box().fold(large.anchor);
}

// The center, relative to the anchor.
Vec3 LargeSphereGrid::position_of(const World& world, const LargeSphere& large, const Time& now) const {
  return world.unfolded_position(large.slot, now) + world.box().shift(large.boxes) - large.anchor;
}

double LargeSphereGrid::next_crossing_of_large(const World& world, Slot slot, const Time& now) const {
  const LargeSphere& large = large_of(slot);
  const Vec3 position = position_of(world, large, now);
  const Vec3 velocity = world.velocity(slot, now);
  const double error = coordinate_error(world, slot, now);
  const double begin = rounded_down(now);
  const auto time_within = [&](const Vec3& middle, double skin) {
    const double reach = std::max(skin / 2, skin - error);
    return begin + wait_in_ball(world.motion(), position - middle, velocity, reach);
  };
  const double left = time_within({}, skin_);
  const ApproachList& list = large.list;
  if (!list.exists()) return left;
  return std::max(begin, std::min({left, time_within(list.middle(), list.skin()), list.expiry()}));
}

bool LargeSphereGrid::do_shells_meet(const World& world, const LargeSphere& a, const LargeSphere& b) const {
  const Vec3 apart = b.anchor - a.anchor;
  const double reach = (a.radius + b.radius + 2 * skin_) * (1 + kShellMargin);
  return length(apart + world.box().shift(world.box().nearest_image(-apart))) <= reach;
}

bool LargeSphereGrid::are_candidates(Slot a, Slot b) const {
  if (is_large(a) == is_large(b)) return is_large(a) || CellGrid::are_candidates(a, b);
  bool share_cell = false;
  for_each_cell(large_of(is_large(a) ? a : b),
                [&](const CellIndex& cell) { share_cell |= is_in(is_large(a) ? b : a, cell); });
  return share_cell;
}

// Large spheres are found in many cells, and added once.
void LargeSphereGrid::collect_cell(const World& world, const LargeSphere& large, const CellIndex& cell,
                                   Candidates& candidates) const {
  for_each_line(cell, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
    const auto is_small = [&](Slot other) {
      const bool is_other_large = is_large(other) & (other != large.slot);
      if (is_other_large) [[unlikely]] {
        if (candidates.is_new(other)) {
          candidates.mark(other);
          return do_shells_meet(world, large, large_of(other));
        }
      }
      return !is_large(other);
    };
    candidates.add_if(slots, count, is_small);
  });
}

void LargeSphereGrid::collect_of_large(const World& world, Slot slot, Candidates& candidates) const {
  const LargeSphere& large = large_of(slot);
  candidates.begin(slot, true);
  if (large.list.exists()) return candidates.refer_to(large.list.slots());
  collect_all(world, large, candidates);
}

void LargeSphereGrid::collect_all(const World& world, const LargeSphere& large,
                                  Candidates& candidates) const {
  candidates.begin(large.slot, true);
  candidates.start_round(large_.size());
  for_each_cell(large, [&](const CellIndex& cell) { collect_cell(world, large, cell, candidates); });
  candidates.end();
}

void LargeSphereGrid::cross_large(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                                  Candidates& candidates) {
  LargeSphere& large = large_of(slot);
  const double most = large.list.exists() ? (1 - 2 * ApproachList::kGreatestDepth) * skin_ : 0;
  const bool moves = !(length(position_of(world, large, now)) < most);
  if (moves) {
    erase_guest(large);
    ++moved_anchors_;
    move_anchor(world, large, now);
    insert_guest(large);
  }
  collect_all(world, large, candidates);
  if (moves) list_at_large(slot, candidates);
  make_list(world, large, now, copies, candidates);
  if (large.list.exists()) candidates.refer_to(large.list.slots());
}

// Adds a sphere to the lists of the large ones among its candidates.
void LargeSphereGrid::list_at_large(Slot slot, const Candidates& candidates) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Slot other = candidates.slot(i);
    if (is_large(other) && other != slot) large_of(other).list.add(slot);
  }
}

// From elsewhere none arrives in time at less than this speed, as a list reaches no farther than the skin.
void LargeSphereGrid::list_fast(const World& world, Slot slot) {
  CellGrid::collect(world, slot, found_);
  list_at_large(slot, found_);
}

void LargeSphereGrid::make_list(const World& world, LargeSphere& large, const Time& now,
                                const CompactPaths& copies, const Candidates& all) const {
  large.list.make({world, copies, are_large_, usual_speed_, skin_}, large.slot,
                  position_of(world, large, now), now, all);
}

std::size_t LargeSphereGrid::memory_bytes() const {
  return CellGrid::memory_bytes() + large_.capacity() * sizeof(LargeSphere) + are_large_.memory_bytes() +
         large_numbers_.capacity() * sizeof(std::uint32_t);
}

void LargeSphereGrid::validate(const World& world, const Time& now, const CompactPaths& copies) const {
  HARDBALL_CHECK(large_numbers_.size() >= world.size());
  CellGrid::validate(world, now, copies);
  for (const LargeSphere& large : large_) {
    HARDBALL_CHECK(is_large(large.slot) && large.radius == world.bounding_radius(large.slot));
    HARDBALL_CHECK(length(position_of(world, large, now)) <=
                   skin_ + coordinate_error(world, large.slot, now));
    for_each_cell(large, [&](const CellIndex& cell) {
      std::size_t found = 0;
      for_each_line(cell, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
        found += static_cast<std::size_t>(std::count(slots.begin(), slots.begin() + count, large.slot));
      });
      HARDBALL_CHECK(found == 1 || (found > 1 && shares_lists()));
    });
  }
}

}  // namespace hardball
