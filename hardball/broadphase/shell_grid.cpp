// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/shell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/broadphase/wait_in_ball.hpp"
#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr std::int32_t kMostCellsPerAxis = 1 << 28;
constexpr double kMostCellsPerSphere = 1000;

// In boxes so small that larger spheres in the grid would have candidates too far apart, it keeps those that
// touch at most two cells along each axis.

constexpr double kLargestInCell = 0.4999;

// The least slack over the edge of a cell [1].
constexpr double kLeastSlack = 0.01;

// Candidates stay closer than this fraction of a periodic box along each axis.
constexpr double kLargestShare = 0.495;

// Shells overlap a little before they touch: far more than rounding.
constexpr double kShellMargin = 1e-9;

// The least and the greatest depth of a list, over the slack.
constexpr double kLeastDepth = 1e-4;
constexpr double kGreatestDepth = 0.25;
// Lists are deeper by this fraction of the farthest distance of candidates: far more than the errors of
// compact copies.
constexpr double kDepthMargin = 0x1p-19;
// A list must last for this fraction of the time, and its slack show in coordinates, so that rounding does
// not matter.
constexpr double kFewestDigits = 0x1p-38;

double smallest_edge(const Subdivision& cells) {
  return std::min({cells.edge(0), cells.edge(1), cells.edge(2)});
}

// More than the number of cells that the surface of a ball touches.
double cells_of_surface(double radius, double edge) {
  const double outer = radius + 2 * edge;
  const double inner = std::max(0.0, radius - 2 * edge);
  return 4 * std::numbers::pi / 3 * (outer * outer * outer - inner * inner * inner) / (edge * edge * edge);
}

std::int32_t round_down(double number) {
  return static_cast<std::int32_t>(std::floor(number));
}

}  // namespace

std::optional<ShellGrid::Sizes> ShellGrid::sizes_for(const World& world, const Subdivision& cells) {
  if (world.largest_radius() <= kLargestInGrid * smallest_edge(cells)) return std::nullopt;
  const std::optional<Sizes> sizes = sizes_for(world, cells, kLargestInGrid);
  return sizes ? sizes : sizes_for(world, cells, kLargestInCell);
}

std::optional<ShellGrid::Sizes> ShellGrid::sizes_for(const World& world, const Subdivision& cells,
                                                     double largest_in_edges) {
  const double edge = smallest_edge(cells);
  Sizes sizes;
  std::size_t balls = 0;
  double surfaces = 0;  // in cells
  double largest = 0;
  double second_largest = 0;
  for (const double radius : world.radii().each()) {
    if (radius <= largest_in_edges * edge) {
      sizes.largest_in_grid = std::max(sizes.largest_in_grid, radius);
      continue;
    }
    ++balls;
    surfaces += cells_of_surface(radius, edge);
    second_largest = std::max(second_largest, std::min(radius, largest));
    largest = std::max(largest, radius);
  }
  const auto spheres = static_cast<double>(world.size());
  if (balls == 0 || 2 * balls > world.size() || surfaces > kMostCellsPerSphere * spheres) return std::nullopt;
  sizes.slack = kSlack * edge;
  Vec3 extent;  // of a region of the grid; it shares one cell with a ball
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double touched = most_cells_touched(2 * cells.reach(axis, sizes.largest_in_grid), cells.edge(axis));
    extent[axis] = (touched + 1) * cells.edge(axis);
    if (!world.box().is_periodic(axis)) continue;
    if (!hardball::has_nearest_images(cells.period(axis), touched)) return std::nullopt;
    const double room = kLargestShare * world.box().size()[axis];
    if (balls > 1) sizes.slack = std::min(sizes.slack, (room - (largest + second_largest)) / 4);
    sizes.slack = std::min(sizes.slack, (room - (largest + extent[axis])) / 2);
  }
  if (sizes.slack < kLeastSlack * edge) return std::nullopt;
  sizes.farthest = std::max(2 * largest + 4 * sizes.slack, largest + 2 * sizes.slack + 2 * length(extent));
  return sizes;
}

bool ShellGrid::suits(const World& world, double edge) {
  if (world.radii().is_common()) return false;
  return sizes_for(world, Subdivision(world.box(), edge, kMostCellsPerAxis)).has_value();
}

void ShellGrid::build(const World& world, const Time& now, CompactPaths& copies) {
  const std::optional<Sizes> sizes =
      sizes_for(world, Subdivision(world.box(), wanted_edge_, kMostCellsPerAxis));
  HARDBALL_CHECK(sizes.has_value());
  grid_ = CellGrid(wanted_edge_, sizes->largest_in_grid, sizes->farthest);
  grid_.build(world, now, copies);
  HARDBALL_CHECK(grid_.has_nearest_images());
  slack_ = sizes->slack;
  margin_ = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    margin_ = std::max(margin_, grid_.cells().reach(axis, 0));
  }
  balls_.clear();
  are_balls_.assign(world.size() / 64 + 1, 0);
  ball_numbers_.assign(world.size(), 0);
  left_count_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (world.radius(slot) <= sizes->largest_in_grid) continue;
    are_balls_[slot / 64] |= std::uint64_t{1} << (slot % 64);
    ball_numbers_[slot] = static_cast<std::uint32_t>(balls_.size());
    Ball ball;
    ball.slot = slot;
    ball.radius = world.radius(slot);
    move_anchor(world, ball, now);
    for_each_cell(ball, [&](const CellIndex& cell) { grid_.store_to_edit().insert(cell, slot); });
    balls_.push_back(ball);
  }
  double squares = 0;
  for (const Path& path : world.paths()) squares += dot(path.velocity, path.velocity);
  usual_speed_ = kUsualSpeed * std::sqrt(squares / static_cast<double>(world.size()));
  for (Ball& ball : balls_) {
    collect_all(world, ball, found_);
    list_near(world, ball, now, copies, found_);
  }
}

void ShellGrid::move_anchor(const World& world, Ball& ball, const Time& now) const {
  ball.anchor = position_at(world.path(ball.slot), now);
  ball.boxes = -world.box().fold(ball.anchor);
}

// The centre, relative to the anchor.
Vec3 ShellGrid::place_of(const World& world, const Ball& ball, const Time& now) const {
  return position_at(world.path(ball.slot), now) + world.box().shift(ball.boxes) - ball.anchor;
}

double ShellGrid::next_crossing_of_ball(const World& world, Slot slot, const Time& now) const {
  const Ball& ball = ball_of(slot);
  const Vec3 place = place_of(world, ball, now);
  const Vec3& velocity = world.path(slot).velocity;
  const double error = coordinate_error(world, slot, now);
  const auto wait_within = [&](const Vec3& middle, double slack) {
    const Vec3 apart = place - middle;
    const double reach = std::max(slack / 2, slack - error);
    return wait_in_ball(apart, velocity, std::max(0.0, reach * reach - dot(apart, apart)));
  };
  const double begin = rounded_down(now);
  const double left = begin + wait_within({}, slack_);
  if (!ball.has_list) return left;
  return std::max(begin, std::min({left, begin + wait_within(ball.middle, ball.near_slack), ball.expiry}));
}

// Calls visit(cell) for each cell, folded into the box, that the surface of a ball may touch, in columns
// along the last axis. Cells at the ends of the box or of open space reach on for ever.
template <class Visit>
void ShellGrid::for_each_cell(const Ball& ball, Visit&& visit) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Subdivision& cells = grid_.cells();
  const double outer = ball.radius + slack_ + margin_;
  const double inner = std::max(0.0, ball.radius - slack_ - margin_);
  const auto index_at = [&](std::size_t axis, double coordinate) {
    return round_down(std::clamp<double>(coordinate / cells.edge(axis), cells.first(axis), cells.last(axis)));
  };
  const bool is_periodic[] = {cells.period(0) > 0, cells.period(1) > 0, cells.period(2) > 0};
  // The distances of the nearest and of the farthest point of a row of cells along an axis.
  struct Distances {
    double near;
    double far;
  };
  const auto distances = [&](std::size_t axis, std::int32_t index) {
    const bool has_below = is_periodic[axis] || index > cells.first(axis);
    const bool has_above = is_periodic[axis] || index < cells.last(axis);
    const double low = has_below ? cells.edge(axis) * index - ball.anchor[axis] : -kInfinity;
    const double high = has_above ? cells.edge(axis) * (index + 1) - ball.anchor[axis] : kInfinity;
    return Distances{std::max({low, -high, 0.0}), std::max(-low, high)};
  };
  const auto square = [](double number) { return number * number; };
  CellIndex low;
  CellIndex high;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    low[axis] = index_at(axis, ball.anchor[axis] - outer);
    high[axis] = index_at(axis, ball.anchor[axis] + outer);
  }
  for (std::int32_t x = low[0]; x <= high[0]; ++x) {
    const Distances in_x = distances(0, x);
    const std::int32_t folded_x = cells.folded(0, x);
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      const Distances in_y = distances(1, y);
      const double room = outer * outer - (square(in_x.near) + square(in_y.near));
      if (room < 0) continue;
      const double height = std::sqrt(room);
      const std::int32_t folded_y = cells.folded(1, y);
      const std::int32_t begin = index_at(2, ball.anchor.z - height);
      const std::int32_t end = index_at(2, ball.anchor.z + height) + 1;
      // Cells in which the ball leaves no room for others are left out.
      std::int32_t hole_begin = end;
      std::int32_t hole_end = end;
      const double hidden = inner * inner - (square(in_x.far) + square(in_y.far));
      if (hidden > 0) {
        const double half = std::sqrt(hidden);
        hole_begin = std::max(begin, index_at(2, ball.anchor.z - half) + 1);
        hole_end = std::min(end, index_at(2, ball.anchor.z + half));
        if (hole_begin >= hole_end) hole_begin = hole_end = end;
      }
      for (std::int32_t z = begin; z < hole_begin; ++z) {
        visit(CellIndex{folded_x, folded_y, cells.folded(2, z)});
      }
      for (std::int32_t z = hole_end; z < end; ++z) {
        visit(CellIndex{folded_x, folded_y, cells.folded(2, z)});
      }
    }
  }
}

bool ShellGrid::do_shells_meet(const World& world, const Ball& a, const Ball& b) const {
  const Vec3 apart = b.anchor - a.anchor;
  const double reach = (a.radius + b.radius + 2 * slack_) * (1 + kShellMargin);
  return length(apart + world.box().shift(world.box().nearest_image(-apart))) <= reach;
}

// Of balls, a cell may hold the same as many others.
void ShellGrid::collect_cell(const World& world, const Ball& ball, const CellIndex& cell,
                             Candidates& candidates) const {
  grid_.store().lists().for_each_line(grid_.store().list(cell),
                                      [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
                                        const auto is_small = [&](Slot other) {
                                          const bool is_other_ball = is_ball(other) & (other != ball.slot);
                                          if (is_other_ball) [[unlikely]] {
                                            if (candidates.is_new(other)) {
                                              candidates.mark(other);
                                              return do_shells_meet(world, ball, ball_of(other));
                                            }
                                          }
                                          return !is_ball(other);
                                        };
                                        candidates.add_if(slots, count, is_small);
                                      });
}

void ShellGrid::collect_of_ball(const World& world, Slot slot, Candidates& candidates) const {
  const Ball& ball = ball_of(slot);
  candidates.begin(slot, true);
  if (ball.has_list) return candidates.refer_to(ball.near.data(), ball.near_count);
  collect_all(world, ball, candidates);
}

void ShellGrid::collect_all(const World& world, const Ball& ball, Candidates& candidates) const {
  candidates.begin(ball.slot, true);
  candidates.start_round(balls_.size());
  for_each_cell(ball, [&](const CellIndex& cell) { collect_cell(world, ball, cell, candidates); });
  candidates.end();
}

void ShellGrid::cross_ball(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                           Candidates& candidates) {
  Ball& ball = ball_of(slot);
  // A list reaches no farther than the slack.
  const double most = ball.has_list ? (1 - 2 * kGreatestDepth) * slack_ : 0;
  const bool moves = !(length(place_of(world, ball, now)) < most);
  if (moves) {
    for_each_cell(ball, [&](const CellIndex& cell) { grid_.store_to_edit().erase(cell, slot); });
    ++left_count_;
    move_anchor(world, ball, now);
    for_each_cell(ball, [&](const CellIndex& cell) { grid_.store_to_edit().insert(cell, slot); });
  }
  collect_all(world, ball, candidates);
  if (moves) list_at_balls(slot, candidates);
  list_near(world, ball, now, copies, candidates);
  if (ball.has_list) candidates.refer_to(ball.near.data(), ball.near_count);
}

void ShellGrid::Ball::append(Slot other) {
  near.resize(near_count + 1 + Candidates::kPadding);
  near[near_count++] = other;
  std::fill_n(near.begin() + static_cast<std::ptrdiff_t>(near_count), Candidates::kPadding, slot);
}

// Adds a sphere to the lists of the balls among its candidates.
void ShellGrid::list_at_balls(Slot slot, const Candidates& candidates) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Slot other = candidates.slot(i);
    if (is_ball(other) && other != slot && ball_of(other).has_list) ball_of(other).append(slot);
  }
}

void ShellGrid::list_fast(const World& world, Slot slot) {
  grid_.collect(world, slot, found_);
  list_at_balls(slot, found_);
}

// Lists those of all candidates that can reach a ball before the list expires, each once.
void ShellGrid::list_near(const World& world, Ball& ball, const Time& now, const CompactPaths& copies,
                          const Candidates& all) const {
  const Slot slot = ball.slot;
  const bool pays = all.size() >= kFewestToList && copies.is_bounded(slot);
  if (pays) choose_depth(ball, all.size());
  const double begin = rounded_down(now);
  // A ball at rest may be hit and move.
  constexpr double kAtRest = 0.01;
  constexpr double kChange = 3;
  const double speed = length(world.path(slot).velocity);
  ball.near_slack = ball.depth * std::min(1.0, kAtRest + kChange * speed / usual_speed_);
  ball.expiry = begin + ball.depth / usual_speed_;
  ball.has_list = pays && usual_speed_ > 0 && ball.expiry > begin + kFewestDigits * std::fabs(begin) &&
                  0x1p-12 * ball.near_slack > coordinate_error(world, slot, now);
  if (!ball.has_list) return;
  ball.middle = place_of(world, ball, now);
  ball.contacts = 0;
  const double unit = copies.length_unit();
  const CompactPath& own = copies.paths()[ball.slot];
  const auto usual = static_cast<float>(ball.depth / unit);
  const float reach =
      copies.radius(ball.slot) +
      static_cast<float>((ball.near_slack + ball.depth + kDepthMargin * copies.farthest()) / unit);
  const auto wait = static_cast<float>((ball.expiry - begin) / copies.time_unit() * (1 + 0x1p-20));
  ball.near.resize(all.size() + Candidates::kPadding);
  std::size_t count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Slot other = all.slot(i);
    const CompactPath& path = copies.paths()[other];
    const float age = static_cast<float>(static_cast<std::int32_t>(static_cast<std::uint32_t>(own.tick) -
                                                                   static_cast<std::uint32_t>(path.tick))) *
                      copies.scale().tick;
    float distance_squared = 0;
    float speed_squared = 0;
    for_each_axis([&](auto axis) {
      const auto steps =
          static_cast<std::uint32_t>(path.place[axis]) - static_cast<std::uint32_t>(own.place[axis]);
      const float place = static_cast<float>(static_cast<std::int32_t>(steps)) * copies.scale().grid[axis] +
                          path.velocity[axis] * age;
      distance_squared += place * place;
      speed_squared += path.velocity[axis] * path.velocity[axis];
    });
    const float way = std::sqrt(speed_squared) * wait;
    const float sum = reach + copies.radius(other) + std::max(0.0F, way - usual);
    ball.near[count] = other;
    // Of a sphere too fast to be copied, nothing is known.
    count += !(distance_squared > sum * sum) || is_ball(other) ? 1U : 0U;
  }
  const auto end = ball.near.begin() + static_cast<std::ptrdiff_t>(count);
  std::sort(ball.near.begin(), end);
  count = static_cast<std::size_t>(std::unique(ball.near.begin(), end) - ball.near.begin());
  ball.near_count = count;
  ball.near.resize(count + Candidates::kPadding);
  std::fill_n(ball.near.begin() + static_cast<std::ptrdiff_t>(count), Candidates::kPadding, ball.slot);
}

// The search for a list is shared by the contacts of its time; each of these goes through the list: the depth
// at which both cost the same costs least.
void ShellGrid::choose_depth(Ball& ball, std::size_t searched) const {
  constexpr double kFactor = 1.5;
  if (!ball.has_list) {
    ball.depth = slack_ / 64;
  } else {
    const double search = static_cast<double>(searched) / (1 + ball.contacts);
    ball.depth *= search > static_cast<double>(ball.near_count) ? kFactor : 1 / kFactor;
  }
  ball.depth = std::clamp(ball.depth, kLeastDepth * slack_, kGreatestDepth * slack_);
}

std::size_t ShellGrid::memory_bytes() const {
  return grid_.memory_bytes() + balls_.capacity() * sizeof(Ball) +
         are_balls_.capacity() * sizeof(std::uint64_t) + ball_numbers_.capacity() * sizeof(std::uint32_t);
}

void ShellGrid::validate(const World& world, const Time& now, const CompactPaths& copies) const {
  HARDBALL_CHECK(ball_numbers_.size() == world.size());
  grid_.validate(world, now, copies);
  for (const Ball& ball : balls_) {
    HARDBALL_CHECK(is_ball(ball.slot) && ball.radius == world.radius(ball.slot));
    HARDBALL_CHECK(length(place_of(world, ball, now)) <= slack_ + coordinate_error(world, ball.slot, now));
    for_each_cell(ball, [&](const CellIndex& cell) {
      std::size_t found = 0;
      grid_.store().lists().for_each(grid_.store().list(cell),
                                     [&](Slot occupant) { found += occupant == ball.slot ? 1U : 0U; });
      HARDBALL_CHECK(found == 1);
    });
  }
}

}  // namespace hardball
