// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/subdivision.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/contact_time.hpp"

namespace hardball {
namespace {

// How early cells admit and how late they release, as a fraction of their edge and of the distance from the
// origin, where coordinates are rounded more coarsely.
constexpr double kEdgeMargin = 1e-9;
constexpr double kDistanceMargin = 1e-14;

double margin(double edge, double place) {
  return kEdgeMargin * edge + kDistanceMargin * std::fabs(place);
}

// Without SSE4.1, std::floor is the call of a function.
std::int32_t round_down(double number) {
  const auto whole = static_cast<std::int32_t>(number);
  return whole - (whole > number ? 1 : 0);
}

}  // namespace

Subdivision::Subdivision(const Box& box, double edge, std::int32_t most_cells) {
  if (!(edge > 0) || !std::isfinite(edge)) {
    throw Error("the cell edge is " + to_text(edge), "cell edge", "give a positive length");
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    Axis& cells = axes_[axis];
    if (box.is_open(axis)) {
      cells = {edge, 1 / edge, -most_cells / 2, most_cells / 2 - 1, 0, 0};
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
}

std::int32_t Subdivision::place_of(const Axis& cells, double coordinate) {
  double place = coordinate * cells.inverse_edge;
  if (!(place > cells.first && place < cells.last)) [[unlikely]] {
    if (cells.period > 0) {
      throw RunFailure(
          "a sphere has crossed 2^29 cells of a periodic box without a collision; use larger cells");
    }
    place = std::clamp<double>(place, cells.first, cells.last);
  }
  return round_down(place);
}

CellRange Subdivision::range_at(const Vec3& position, double radius) const {
  CellRange range;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Axis& cells = axes_[axis];
    const double reach = radius + margin(cells.edge, position[axis]);
    range.low[axis] = place_of(cells, position[axis] - reach);
    range.high[axis] = place_of(cells, position[axis] + reach);
  }
  return range;
}

std::int32_t Subdivision::hindmost(std::size_t axis, double position, double radius, double velocity) const {
  const Axis& cells = axes_[axis];
  const double reach = radius + margin(cells.edge, position);
  return place_of(cells, position - std::copysign(reach, velocity));
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

// Nothing here branches on which way a sphere flies: nobody can foresee it.
CellCrossing Subdivision::next_enter(const Path& path, double radius, const CellRange& range) const {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  static constexpr std::array<double, 2> kUnless{0, kForever};
  double least = kForever;
  Face face = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Axis& cells = axes_[axis];
    const double velocity = path.velocity[axis];
    const bool up = velocity > 0;
    const std::int32_t upwards = up ? -1 : 0;  // all bits
    const std::int32_t front = range.low[axis] + ((range.high[axis] - range.low[axis]) & upwards);
    const std::int32_t last = cells.first + ((cells.last - cells.first) & upwards);
    const double plane = cells.edge * (front - upwards);
    const double reach = radius + margin(cells.edge, plane);
    const double distance = std::copysign(1.0, velocity) * (plane - path.position[axis]) - reach;
    // At rest the wait is infinite or not a number.
    const double wait = std::max(distance, 0.0) / std::fabs(velocity) + kUnless[front == last ? 1 : 0];
    const bool sooner = wait < least;
    least = sooner ? wait : least;
    face ^= (face ^ face_of(axis, up)) & (0U - static_cast<Face>(sooner));
  }
  return {least, static_cast<std::uint8_t>(axis_of(face)), is_upper(face)};
}

CellCrossing Subdivision::next_leave(const Path& path, double radius, const CellRange& range) const {
  CellCrossing next;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (range.low[axis] == range.high[axis]) continue;
    const bool up = path.velocity[axis] > 0;
    const double edge = axes_[axis].edge;
    const double face = edge * (up ? range.low[axis] + 1 : range.high[axis]);
    const double reach = radius + margin(edge, face);
    const double distance = up ? (face + reach) - path.position[axis] : path.position[axis] - (face - reach);
    const double wait = time_to_plane(distance, std::fabs(path.velocity[axis]));
    if (wait < next.wait) next = {wait, static_cast<std::uint8_t>(axis), up};
  }
  return next;
}

}  // namespace hardball
