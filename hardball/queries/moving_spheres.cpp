// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/queries/moving_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Small cells follow the surroundings of a body closely, large ones are looked at several spheres at a time.
constexpr double kSpheresPerCell = 6;

// More than single precision rounds sums of a few products by, over the largest of them.
constexpr double kRounding = 0x1p-19;

// How far an interval is from another.
double gap(double low, double high, double other_low, double other_high) {
  return std::max({0.0, other_low - high, low - other_high});
}

// The largest integer that is not above a number, which a 32-bit integer must hold.
std::int32_t floor_of(double number) {
  const auto towards_zero = static_cast<std::int32_t>(number);
  return towards_zero - (towards_zero > number ? 1 : 0);
}

// One over a size; zero for nothing.
double inverse_of(double size) {
  return size > 0 ? 1 / size : 0;
}

}  // namespace

void MovingSpheres::sort(const World& world, const Time& now) {
  const Box& box = world.box();
  states_.resize(world.size());
  low_ = high_ = {};
  for (Slot slot = 0; slot < world.size(); ++slot) {
    State& state = states_[slot];
    state = world.motion().state_at(world.path(slot), now);
    box.fold(state.position);
    if (slot == 0) low_ = high_ = state.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      low_[axis] = std::min(low_[axis], state.position[axis]);
      high_[axis] = std::max(high_[axis], state.position[axis]);
    }
  }
  assign_layers(world);
  choose_cells(box);
  sort_by_cells();
  copy_sorted(world);
}

void MovingSpheres::assign_layers(const World& world) {
  const std::size_t size = world.size();
  double squared_speeds = 0;
  double squared_radii = 0;
  for (Slot slot = 0; slot < size; ++slot) {
    const double radius = world.base_radius(slot);
    squared_speeds += dot(states_[slot].velocity, states_[slot].velocity);
    squared_radii += radius * radius;
  }
  const double count = std::max(1.0, static_cast<double>(size));
  const double mean_square = squared_speeds / count;
  const double large = kLarge * std::sqrt(squared_radii / count);
  std::array<double, kTopSpeeds.size()> tops;
  for (std::size_t i = 0; i < tops.size(); ++i) tops[i] = kTopSpeeds[i] * kTopSpeeds[i] * mean_square;

  layers_ = {};
  layer_numbers_.resize(size);
  for (Slot slot = 0; slot < size; ++slot) {
    const double square = dot(states_[slot].velocity, states_[slot].velocity);
    const double radius = world.base_radius(slot);
    std::size_t number = 0;
    for (const double top : tops) number += square > top ? 1 : 0;
    if (radius > large) number = kLayers - 1;
    layer_numbers_[slot] = static_cast<std::uint8_t>(number);
    Layer& layer = layers_[number];
    ++layer.size;
    layer.speed = std::max(layer.speed, square);
    layer.radius = std::max(layer.radius, radius);
  }
  fastest_ = 0;
  for (Layer& layer : layers_) {
    layer.speed = std::sqrt(layer.speed) * (1 + 0x1p-50);
    fastest_ = std::max(fastest_, layer.speed);
  }
  usual_speed_ = std::min(fastest_, kTopSpeeds.back() * std::sqrt(mean_square));
}

void MovingSpheres::choose_cells(const Box& box) {
  double volume = 1;
  double dimensions = 0;
  double radius = std::numeric_limits<double>::min();
  for (const Layer& layer : layers_) radius = std::max(radius, layer.radius);
  length_unit_ = radius;
  for (std::size_t number = 0; number < kAxes; ++number) {
    Axis& axis = extent_[number];
    axis = {};
    axis.low = box.is_periodic(number) ? 0 : low_[number];
    const double high = box.is_periodic(number) ? box.size()[number] : high_[number];
    axis.period = box.is_periodic(number) ? high : 0;
    length_unit_ = std::max({length_unit_, std::fabs(axis.low), std::fabs(high)});
    axis.edge = high - axis.low;
    if (!(axis.edge > 0)) continue;
    volume *= axis.edge;
    ++dimensions;
  }
  const auto edge_for = [&](double spheres) {
    const double cells = std::max(1.0, spheres / kSpheresPerCell);
    return dimensions > 0 ? std::pow(volume / cells, 1 / dimensions) : 0;
  };
  cell_edge_ = edge_for(static_cast<double>(states_.size()));
  std::uint32_t cells = 0;
  for (Layer& layer : layers_) {
    layer.first_cell = cells;
    layer.axes = extent_;
    if (layer.size == 0) continue;
    const double edge = edge_for(layer.size);
    std::uint32_t own = 1;
    for (Axis& axis : layer.axes) {
      if (!(axis.edge > 0) || !(edge > 0)) continue;
      axis.count =
          static_cast<std::int32_t>(std::clamp(axis.edge / edge, 1.0, static_cast<double>(layer.size)));
      axis.edge /= axis.count;
      own *= static_cast<std::uint32_t>(axis.count);
    }
    cells += own;
  }
  begins_.assign(cells + 1, 0);
}

void MovingSpheres::sort_by_cells() {
  cells_.resize(states_.size());
  for (Slot slot = 0; slot < states_.size(); ++slot) {
    cells_[slot] = cell_of(layers_[layer_numbers_[slot]], states_[slot].position);
    ++begins_[cells_[slot]];
  }
  std::uint32_t begin = 0;
  for (std::uint32_t& cell : begins_) begin = std::exchange(cell, begin) + begin;
  slots_.resize(states_.size());
  for (Slot slot = 0; slot < states_.size(); ++slot) slots_[begins_[cells_[slot]]++] = slot;
  // Each begins where the one before has ended.
  std::shift_right(begins_.begin(), begins_.end(), 1);
  begins_.front() = 0;
}

void MovingSpheres::copy_sorted(const World& world) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    positions_[axis].resize(slots_.size());
    velocities_[axis].resize(slots_.size());
  }
  radii_.resize(slots_.size());
  const double inverse_length = 1 / length_unit_;
  std::size_t at = 0;
  for (const Layer& layer : layers_) {
    const double inverse_speed = inverse_of(layer.speed);
    for (const std::size_t end = at + layer.size; at < end; ++at) {
      const State& state = states_[slots_[at]];
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        positions_[axis][at] = static_cast<float>(state.position[axis] * inverse_length);
        velocities_[axis][at] = static_cast<float>(state.velocity[axis] * inverse_speed);
      }
      radii_[at] = static_cast<float>(world.base_radius(slots_[at]) * inverse_length);
    }
  }
}

std::uint32_t MovingSpheres::cell_of(const Layer& layer, const Vec3& center) {
  std::uint32_t cell = 0;
  for (std::size_t number = 0; number < kAxes; ++number) {
    const Axis& axis = layer.axes[number];
    const double index = axis.edge > 0 ? (center[number] - axis.low) / axis.edge : 0;
    const auto last = static_cast<double>(axis.count - 1);
    cell = cell * static_cast<std::uint32_t>(axis.count) +
           static_cast<std::uint32_t>(std::clamp(index, 0.0, last));
  }
  return layer.first_cell + cell;
}

MovingSpheres::Span MovingSpheres::span_within(const Axis& axis, double low, double high) {
  if (!(axis.edge > 0)) return {0, 0};
  // Far beyond what any body can reach within half a box.
  constexpr double kMost = 1 << 28;
  const double most = axis.period > 0 ? kMost : axis.count - 1;
  const double least = axis.period > 0 ? -kMost : 0;
  const auto index_of = [&](double coordinate, double sign) {
    const double index = (coordinate - axis.low) / axis.edge;
    return floor_of(std::clamp(index + sign * kRounding * (std::fabs(index) + 1), least, most));
  };
  return {index_of(low, -1), index_of(high, 1)};
}

void MovingSpheres::for_each_near(const State& from, double radius, double begin, double end,
                                  const Function<void(Slot)>& visit) const {
  Sweep sweep{from.position, from.position};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double velocity = from.velocity[axis];
    if (velocity == 0) continue;
    const double first = from.position[axis] + velocity * begin;
    const double last = from.position[axis] + velocity * end;
    sweep.low[axis] = std::min(first, last);
    sweep.high[axis] = std::max(first, last);
  }
  std::size_t at = 0;
  for (const Layer& layer : layers_) {
    const std::size_t behind = at + layer.size;
    // Later than that, too many images of each sphere may be in reach.
    const bool are_few_near = ranges::all_of(
        extent_, [&](const Axis& axis) { return axis.period == 0 || layer.speed * end <= axis.period; });
    if (are_few_near && layer.size > 0) {
      look_in(layer, from, sweep, radius, end, visit);
    } else {
      for (; at < behind; ++at) visit(slots_[at]);
    }
    at = behind;
  }
}

void MovingSpheres::look_in(const Layer& layer, const State& from, const Sweep& sweep, double radius,
                            double end, const Function<void(Slot)>& visit) const {
  const Vec3& low = sweep.low;
  const Vec3& high = sweep.high;
  // From where spheres come in time.
  const double moved = layer.speed > 0 ? layer.speed * end : 0;
  const double reach = (radius + layer.radius + moved) * (1 + kRounding);
  const double own_speed = length(from.velocity);
  const double speed_unit = layer.speed > 0 ? layer.speed : own_speed;
  const double speed = own_speed + layer.speed;
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

  const auto& [axis_x, axis_y, depth] = layer.axes;
  const Span columns = span_within(axis_x, low.x - reach, high.x + reach);
  const Span rows = span_within(axis_y, low.y - reach, high.y + reach);
  const auto boxes_of = [](const Axis& axis, std::int32_t index) {
    if (axis.period == 0) return 0;
    return index >= 0 ? index / axis.count : -((axis.count - 1 - index) / axis.count);
  };
  const auto gap_along = [&](std::size_t number, std::int32_t index) {
    const Axis& axis = layer.axes[number];
    // The outermost cells may hold what rounding has put there.
    const double margin = kRounding * (axis.edge + length_unit_);
    const double face = axis.low + index * axis.edge;
    return gap(face - margin, face + axis.edge + margin, low[number], high[number]);
  };
  for (std::int32_t x = columns.first; x <= columns.last; ++x) {
    const double across = gap_along(0, x);
    const std::int32_t boxes_x = boxes_of(axis_x, x);
    body.position[0] = static_cast<float>((from.position.x - boxes_x * axis_x.period) / length_unit_);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) {
      const double along = gap_along(1, y);
      const double left = reach * reach - across * across - along * along;
      if (left < 0) continue;
      const std::int32_t boxes_y = boxes_of(axis_y, y);
      body.position[1] = static_cast<float>((from.position.y - boxes_y * axis_y.period) / length_unit_);
      // Not a number where squares overflow.
      const double half = left >= 0 ? std::sqrt(left) : reach;
      const Span cells = span_within(depth, low.z - half, high.z + half);
      const auto row =
          layer.first_cell + static_cast<std::size_t>((x - boxes_x * axis_x.count) * axis_y.count +
                                                      (y - boxes_y * axis_y.count)) *
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
  if (asked_ == 0 || !(moment_ == now)) {
    moment_ = now;
    asked_ = 0;
    is_sorted_ = false;
  }
  const bool is_asked_again = ++asked_ > 1;
  const bool is_likely_to_be = is_asked_again || was_asked_again_;
  was_asked_again_ = is_asked_again;
  if (!is_likely_to_be) return nullptr;
  if (!is_sorted_) spheres_.sort(world, now);
  is_sorted_ = true;
  return &spheres_;
}

}  // namespace hardball
