// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/queries/moving_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hardball {
namespace {

// Small cells follow the surroundings of a body closely, large ones are looked at several spheres at a time.
constexpr double kSpheresPerCell = 4;

// More than single precision rounds sums of a few products by, over the largest of them.
constexpr double kRounding = 0x1p-19;

// How far an interval is from another.
double gap(double low, double high, double other_low, double other_high) {
  return std::max({0.0, other_low - high, low - other_high});
}

}  // namespace

MovingSpheres::MovingSpheres(const World& world, const Time& now) {
  const std::size_t size = world.size();
  std::vector<Vec3> centers(size);
  std::vector<Vec3> velocities(size);
  double squared_speeds = 0;
  double squared_radii = 0;
  double fastest_squared = 0;
  for (Slot slot = 0; slot < size; ++slot) {
    const State state = world.motion().state_at(world.path(slot), now);
    centers[slot] = state.position;
    world.box().fold(centers[slot]);
    velocities[slot] = state.velocity;
    const double square = dot(state.velocity, state.velocity);
    squared_speeds += square;
    squared_radii += world.base_radius(slot) * world.base_radius(slot);
    fastest_squared = std::max(fastest_squared, square);
  }
  fastest_ = std::sqrt(fastest_squared);
  const double count = std::max(1.0, static_cast<double>(size));
  usual_speed_ = std::min(fastest_, kUsual * std::sqrt(squared_speeds / count));
  const double usual_radius = kUsual * std::sqrt(squared_radii / count);
  choose_cells(centers, world.box());

  constexpr std::uint32_t kNoCell = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> cells(size, kNoCell);
  std::size_t usual = 0;
  for (Slot slot = 0; slot < size; ++slot) {
    const double speed_squared = dot(velocities[slot], velocities[slot]);
    const double radius = world.base_radius(slot);
    if (!(speed_squared <= usual_speed_ * usual_speed_ * (1 + 0x1p-40)) || radius > usual_radius) {
      unusual_.push_back(slot);
      continue;
    }
    largest_usual_radius_ = std::max(largest_usual_radius_, radius);
    cells[slot] = cell_of(centers[slot]);
    ++begins_[cells[slot] + 1];
    ++usual;
  }
  for (std::size_t cell = 1; cell < begins_.size(); ++cell) begins_[cell] += begins_[cell - 1];
  length_unit_ = std::max(std::numeric_limits<double>::min(), usual_radius);
  for (const Axis& axis : axes_)
    length_unit_ =
        std::max({length_unit_, std::fabs(axis.low), std::fabs(axis.low + axis.count * axis.edge)});
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    positions_[axis].resize(usual);
    velocities_[axis].resize(usual);
  }
  radii_.resize(usual);
  slots_.resize(usual);
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (Slot slot = 0; slot < size; ++slot) {
    if (cells[slot] == kNoCell) continue;
    const std::uint32_t at = next[cells[slot]]++;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      positions_[axis][at] = static_cast<float>(centers[slot][axis] / length_unit_);
      velocities_[axis][at] =
          usual_speed_ > 0 ? static_cast<float>(velocities[slot][axis] / usual_speed_) : 0;
    }
    radii_[at] = static_cast<float>(world.base_radius(slot) / length_unit_);
    slots_[at] = slot;
  }
}

void MovingSpheres::choose_cells(std::span<const Vec3> centers, const Box& box) {
  double volume = 1;
  double dimensions = 0;
  for (std::size_t number = 0; number < kAxes; ++number) {
    Axis& axis = axes_[number];
    double high = 0;
    if (box.is_periodic(number)) {
      axis.period = high = box.size()[number];
    } else if (!centers.empty()) {
      const auto along = [number](const Vec3& center) { return center[number]; };
      axis.low = std::ranges::min(centers, {}, along)[number];
      high = std::ranges::max(centers, {}, along)[number];
    }
    axis.edge = high - axis.low;
    if (!(axis.edge > 0)) continue;
    volume *= axis.edge;
    ++dimensions;
  }
  const double wanted = std::max(1.0, static_cast<double>(centers.size()) / kSpheresPerCell);
  const double edge = dimensions > 0 ? std::pow(volume / wanted, 1 / dimensions) : 0;
  cell_edge_ = edge;
  std::size_t cells = 1;
  for (Axis& axis : axes_) {
    if (!(axis.edge > 0) || !(edge > 0)) continue;
    axis.count = static_cast<std::int32_t>(std::clamp(std::floor(axis.edge / edge), 1.0, wanted));
    axis.edge /= axis.count;
    cells *= static_cast<std::size_t>(axis.count);
  }
  begins_.assign(cells + 1, 0);
}

std::uint32_t MovingSpheres::cell_of(const Vec3& center) const {
  std::uint32_t cell = 0;
  for (std::size_t number = 0; number < kAxes; ++number) {
    const Axis& axis = axes_[number];
    const double index = axis.edge > 0 ? (center[number] - axis.low) / axis.edge : 0;
    const auto last = static_cast<double>(axis.count - 1);
    cell = cell * static_cast<std::uint32_t>(axis.count) +
           static_cast<std::uint32_t>(std::clamp(std::floor(index), 0.0, last));
  }
  return cell;
}

MovingSpheres::Span MovingSpheres::span_within(std::size_t number, double low, double high) const {
  const Axis& axis = axes_[number];
  if (!(axis.edge > 0)) return {0, 0};
  // Far beyond what any body can reach within half a box.
  constexpr double kMost = 1 << 28;
  const auto index_of = [&axis](double coordinate, double sign) {
    const double index = (coordinate - axis.low) / axis.edge;
    return std::floor(index + sign * kRounding * (std::fabs(index) + 1));
  };
  const double first = index_of(low, -1);
  const double last = index_of(high, 1);
  const double most = axis.period > 0 ? kMost : axis.count - 1;
  const double least = axis.period > 0 ? -kMost : 0;
  return {static_cast<std::int32_t>(std::clamp(first, least, most)),
          static_cast<std::int32_t>(std::clamp(last, least, most))};
}

void MovingSpheres::for_each_near(const State& from, double radius, double begin, double end,
                                  const Function<void(Slot)>& visit) const {
  // Where the body itself comes along, from where spheres are at most so far away.
  Vec3 low = from.position;
  Vec3 high = from.position;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double velocity = from.velocity[axis];
    if (velocity == 0) continue;
    const double first = from.position[axis] + velocity * begin;
    const double last = from.position[axis] + velocity * end;
    low[axis] = std::min(first, last);
    high[axis] = std::max(first, last);
  }
  const double moved = usual_speed_ > 0 ? usual_speed_ * end : 0;
  const double reach = (radius + largest_usual_radius_ + moved) * (1 + kRounding);
  const double own_speed = length(from.velocity);
  const double speed_unit = usual_speed_ > 0 ? usual_speed_ : own_speed;
  const double speed = own_speed + usual_speed_;
  double size = length_unit_ + reach + (speed > 0 ? speed * end : 0);
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    size = std::max({size, std::fabs(low[axis]) + reach, std::fabs(high[axis]) + reach});
  const double end_in_units = speed_unit > 0 ? end * (speed_unit / length_unit_) : 0;
  Body body{.position = {},
            .velocity = {},
            .end = static_cast<float>(std::min(end_in_units * (1 + kRounding), 0x1p100)),
            .reach = static_cast<float>((radius + kRounding * size) / length_unit_)};
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    body.velocity[axis] = speed_unit > 0 ? static_cast<float>(from.velocity[axis] / speed_unit) : 0;

  const Axis& depth = axes_[2];
  const Span columns = span_within(0, low.x - reach, high.x + reach);
  const Span rows = span_within(1, low.y - reach, high.y + reach);
  const auto boxes_of = [](const Axis& axis, std::int32_t index) {
    if (axis.period == 0) return 0;
    return index >= 0 ? index / axis.count : -((axis.count - 1 - index) / axis.count);
  };
  const auto gap_along = [&](std::size_t number, std::int32_t index) {
    const Axis& axis = axes_[number];
    // The outermost cells may hold what rounding has put there.
    const double margin = kRounding * (axis.edge + length_unit_);
    const double face = axis.low + index * axis.edge;
    return gap(face - margin, face + axis.edge + margin, low[number], high[number]);
  };
  for (std::int32_t x = columns.first; x <= columns.last; ++x) {
    const double across = gap_along(0, x);
    const std::int32_t boxes_x = boxes_of(axes_[0], x);
    body.position[0] = static_cast<float>((from.position.x - boxes_x * axes_[0].period) / length_unit_);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) {
      const double along = gap_along(1, y);
      const double left = reach * reach - across * across - along * along;
      if (left < 0) continue;
      const std::int32_t boxes_y = boxes_of(axes_[1], y);
      body.position[1] = static_cast<float>((from.position.y - boxes_y * axes_[1].period) / length_unit_);
      // Not a number where squares overflow.
      const double half = left >= 0 ? std::sqrt(left) : reach;
      const Span cells = span_within(2, low.z - half, high.z + half);
      const auto row = static_cast<std::size_t>((x - boxes_x * axes_[0].count) * axes_[1].count +
                                                (y - boxes_y * axes_[1].count)) *
                       static_cast<std::size_t>(depth.count);
      for (std::int32_t z = cells.first; z <= cells.last;) {
        const std::int32_t boxes_z = boxes_of(depth, z);
        const std::int32_t first = z - boxes_z * depth.count;
        const std::int32_t last = std::min(depth.count - 1, first + (cells.last - z));
        body.position[2] = static_cast<float>((from.position.z - boxes_z * depth.period) / length_unit_);
        look_at(body, begins_[row + static_cast<std::size_t>(first)],
                begins_[row + static_cast<std::size_t>(last) + 1], visit);
        z += last - first + 1;
      }
    }
  }
}

// The nearest that a sphere comes, against the distance at which it would touch; whatever is not a number may
// touch.
void MovingSpheres::look_at(const Body& body, std::size_t begin, std::size_t end,
                            const Function<void(Slot)>& visit) const {
  constexpr std::size_t kBlock = 32;
  // So that what is at rest relative to the body divides by something.
  constexpr float kTiny = 1e-30F;
  std::array<float, kBlock> excess;
  for (std::size_t from = begin; from < end; from += kBlock) {
    const std::size_t count = std::min(kBlock, end - from);
    const float* const x = positions_[0].data() + from;
    const float* const y = positions_[1].data() + from;
    const float* const z = positions_[2].data() + from;
    const float* const u = velocities_[0].data() + from;
    const float* const v = velocities_[1].data() + from;
    const float* const w = velocities_[2].data() + from;
    const float* const radii = radii_.data() + from;
    for (std::size_t i = 0; i < count; ++i) {
      const float dx = x[i] - body.position[0];
      const float dy = y[i] - body.position[1];
      const float dz = z[i] - body.position[2];
      const float du = u[i] - body.velocity[0];
      const float dv = v[i] - body.velocity[1];
      const float dw = w[i] - body.velocity[2];
      const float nearest = -(dx * du + dy * dv + dz * dw) / (du * du + dv * dv + dw * dw + kTiny);
      const float later = nearest > 0 ? nearest : 0;
      const float time = later < body.end ? later : body.end;
      const float px = dx + du * time;
      const float py = dy + dv * time;
      const float pz = dz + dw * time;
      const float reach = radii[i] + body.reach;
      excess[i] = (px * px + py * py + pz * pz) - reach * reach;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!(excess[i] > 0)) visit(slots_[from + i]);
    }
  }
}

const MovingSpheres* LazyMovingSpheres::at(const World& world, const Time& now) const {
  const std::lock_guard lock(mutex_);
  if (!is_asked_ || !(moment_ == now)) {
    spheres_.reset();
    moment_ = now;
    is_asked_ = true;
    return nullptr;
  }
  if (!spheres_) spheres_.emplace(world, now);
  return &*spheres_;
}

}  // namespace hardball
