// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/subdivision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/contact_time.hpp"

namespace hardball {
namespace {

// By how much cells admit early and release late, as a fraction of their edge and of the greatest distance
// from the origin, where coordinates are rounded most coarsely.
constexpr double kEdgeMargin = 0x1p-18;
constexpr double kDistanceMargin = 1e-14;

// Without SSE4.1, std::floor is a function call.
std::int32_t round_down(double number) {
  const auto whole = static_cast<std::int32_t>(number);
  return whole - (whole > number ? 1 : 0);
}

[[noreturn]] void throw_far_from_box() {
  throw RunFailure("a sphere has crossed 2^29 cells of a periodic box without a collision; use larger cells");
}

}  // namespace

Subdivision::Subdivision(const Box& box, double edge, std::int32_t most_cells) {
  if (!(edge > 0) || !std::isfinite(edge)) {
    throw Error("the cell edge is " + to_text(edge), "cell edge", "give a positive length");
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    Axis& cells = axes_[axis];
    if (box.boundary(axis) == Boundary::flat) {
      // A single layer, from which no sphere reaches out.
      cells.edge = edge;
      cells.count = 1;
      continue;
    }
    if (box.is_open(axis)) {
      cells = {edge, 1 / edge, 0, -most_cells / 2, most_cells / 2 - 1, 0, 0};
      continue;
    }
    const double count = std::clamp<double>(std::floor(box.size()[axis] / edge), 1, most_cells);
    const auto whole = static_cast<std::int32_t>(count);
    cells.edge = box.size()[axis] / count;
    cells.inverse_edge = 1 / cells.edge;
    cells.last = whole - 1;
    cells.count = whole;
    if (!box.is_periodic(axis)) continue;
    cells.period = whole;
    cells.first = std::numeric_limits<std::int32_t>::min() / 4;
    cells.last = std::numeric_limits<std::int32_t>::max() / 4;
  }
  for (Axis& cells : axes_) {
    const double farthest = cells.edge * (std::max(-cells.first, cells.last) + 1.0);
    cells.margin = kEdgeMargin * cells.edge + kDistanceMargin * farthest;
  }
}

std::int32_t Subdivision::index_of(const Axis& cells, double coordinate) {
  double index = coordinate * cells.inverse_edge;
  if (!(index > cells.first && index < cells.last)) [[unlikely]] {
    if (cells.period > 0) throw_far_from_box();
    index = std::clamp<double>(index, cells.first, cells.last);
  }
  return round_down(index);
}

CellSpans Subdivision::spans_of(const Extent& extent) const {
  CellSpans spans;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double margin = axes_[axis].margin;
    spans[axis] = span_of(axes_[axis], extent.low[axis] - margin, extent.high[axis] + margin);
  }
  return spans;
}

CellSpan Subdivision::span_of(const Axis& cells, double low, double high) {
  const CellSpan all{0, cells.count};
  if (cells.count <= 1) return all;
  double first = std::floor(low * cells.inverse_edge);
  double last = std::floor(high * cells.inverse_edge);
  if (cells.period == 0) {
    first = std::max<double>(first, cells.first);
    last = std::min<double>(last, cells.last);
  }
  const double count = last - first + 1;
  if (!(count < cells.count)) return all;
  if (!(count > 0)) return {0, 1};  // it meets none: any will do
  // By whole boxes, so that the middle is inside: most spheres are stored with these indices.
  if (cells.period > 0) first -= cells.count * std::floor((first + last + 1) / 2 / cells.count);
  return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(count)};
}

CellRange Subdivision::range_at(const Vec3& position, double radius) const {
  CellRange range;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    std::tie(range.low[axis], range.high[axis]) = range_along(axis, position[axis], radius);
  return range;
}

std::pair<std::int32_t, std::int32_t> Subdivision::range_along(std::size_t axis, double coordinate,
                                                               double radius) const {
  const Axis& cells = axes_[axis];
  return {index_of(cells, coordinate - reach(axis, radius)),
          index_of(cells, coordinate + reach(axis, radius))};
}

std::int32_t Subdivision::folded_from_beyond(const Axis& cells, std::int32_t index) {
  if (index < cells.first || index > cells.last) throw_far_from_box();
  const std::int32_t rest = index % cells.period;
  return rest < 0 ? rest + cells.period : rest;
}

CellRange Subdivision::clipped(const CellRange& range) const {
  CellRange clipped;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Axis& cells = axes_[axis];
    clipped.low[axis] = std::clamp(range.low[axis], cells.first, cells.last);
    clipped.high[axis] = std::clamp(range.high[axis], cells.first, cells.last);
    if (cells.period > 0)
      clipped.high[axis] = std::min(clipped.high[axis], clipped.low[axis] + cells.period - 1);
  }
  return clipped;
}

CellIndex Subdivision::cell_of(const Vec3& point) const {
  CellIndex cell;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Axis& cells = axes_[axis];
    const std::int32_t first = cells.period > 0 ? 0 : cells.first;
    const std::int32_t last = cells.period > 0 ? cells.period - 1 : cells.last;
    cell[axis] = round_down(std::clamp<double>(point[axis] * cells.inverse_edge, first, last));
  }
  return cell;
}

CellCrossing Subdivision::next_enter(const Vec3& position, const Vec3& velocity, const Vec3& gravity,
                                     double radius, const CellRange& range) const {
  CellCrossing next;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const bool up : {false, true}) {
      const std::int32_t plane = up ? range.high[axis] + 1 : range.low[axis];
      if (plane == (up ? axes_[axis].last + 1 : axes_[axis].first)) continue;
      const double sign = up ? 1 : -1;
      const double ahead = sign * -beyond_face(axis, plane, position[axis]) - reach(axis, radius);
      const double wait = time_to_pass(std::max(0.0, ahead), sign * velocity[axis], sign * gravity[axis]);
      if (wait < next.wait) next = {wait, static_cast<std::uint8_t>(axis), up};
    }
  }
  return next;
}

CellCrossing Subdivision::next_leave(const Path& path, double radius, const CellRange& range) const {
  CellCrossing next;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (range.low[axis] == range.high[axis]) continue;
    const bool up = path.velocity[axis] > 0;
    const std::int32_t plane = up ? range.low[axis] + 1 : range.high[axis];
    const double beyond = beyond_face(axis, plane, path.position[axis]);
    const double distance = (up ? -beyond : beyond) + reach(axis, radius);
    const double wait = time_to_plane(distance, std::fabs(path.velocity[axis]));
    if (wait < next.wait) next = {wait, static_cast<std::uint8_t>(axis), up};
  }
  return next;
}

}  // namespace hardball
