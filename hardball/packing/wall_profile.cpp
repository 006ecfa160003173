// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/wall_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hardball {
namespace {

constexpr double kStepsPerDiameter = 25;

bool is_round(const Container& container) {
  return container.shape == Container::Shape::sphere || container.shape == Container::Shape::shell;
}
bool is_conical(const Container& container) {
  return container.shape == Container::Shape::cone || container.shape == Container::Shape::truncated_cone;
}

// The wall of a cone that may be truncated.
struct Mantle {
  explicit Mantle(const Container& container)
      : bottom(container.inner / 2),
        slope((container.size.x - container.inner) / 2 / container.size.z),
        secant(std::hypot(1, slope)) {}

  double bottom;  // its radius there
  double slope;   // by which that grows with the height
  double secant;  // the distance of two points on it over that along the axis
};

// A circle about the axis of a container.
struct Ring {
  double radius;
  double height;
};

// What is at one distance from a curved wall, as rings, evenly spaced and from the lowest up.
class Shell {
 public:
  Shell(const Container& container, double distance, double spacing)
      : container_(&container), distance_(distance), radius_(container.size.x / 2) {
    if (container.dimensions == 2) return;
    const double length = is_sphere() ? std::numbers::pi * (radius_ - distance) : container.size.z - lowest();
    rings_ = static_cast<std::size_t>(std::max(1.0, std::ceil(length / spacing)));
  }

  std::size_t rings() const { return rings_; }

  Ring ring(std::size_t number) const {
    const double inner = radius_ - distance_;
    if (container_->dimensions == 2) return {inner, 0};
    const double share = (static_cast<double>(number) + 0.5) / static_cast<double>(rings_);
    if (is_sphere()) {
      const double angle = share * std::numbers::pi;
      return {inner * std::sin(angle), radius_ - inner * std::cos(angle)};
    }
    const double height = lowest() + share * (container_->size.z - lowest());
    if (!is_conical(*container_)) return {inner, height};
    const Mantle mantle(*container_);
    return {mantle.bottom + mantle.slope * height - distance_ * mantle.secant, height};
  }

  // The first ring that is not below a height.
  std::size_t from(double height) const {
    std::size_t low = 0;
    std::size_t high = rings_;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (ring(middle).height < height) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

 private:
  bool is_sphere() const { return is_round(*container_); }
  // Where the surface begins: within a cone, at an apex of its own.
  double lowest() const {
    if (!is_conical(*container_)) return 0;
    const Mantle mantle(*container_);
    return std::max(0.0, (distance_ * mantle.secant - mantle.bottom) / mantle.slope);
  }

  const Container* container_;
  double distance_;
  double radius_;
  std::size_t rings_ = 1;
};

// The share of a ring that is within a sphere whose center is at this distance from the axis.
double share_within(const Ring& ring, double from_axis, double height, double radius) {
  const double above = ring.height - height;
  const double square = radius * radius - above * above;
  if (square <= 0) return 0;
  const double twice = 2 * ring.radius * from_axis;
  const double excess = ring.radius * ring.radius + from_axis * from_axis - square;
  if (excess >= twice) return 0;
  if (excess <= -twice) return 1;
  return std::acos(excess / twice) / std::numbers::pi;
}

// From the curved wall, of a shell or an annulus from the outer one [L].
double depth(const Container& container, double from_axis, double height) {
  const double radius = container.size.x / 2;
  if (is_conical(container)) {
    const Mantle mantle(container);
    return (mantle.bottom + mantle.slope * height - from_axis) / mantle.secant;
  }
  const bool is_ball = is_round(container) && container.dimensions == 3;
  return radius - (is_ball ? std::hypot(from_axis, height - radius) : from_axis);
}

// The largest distance from the curved wall [L].
double deepest(const Container& container) {
  if (!is_conical(container) && container.inner > 0) return (container.size.x - container.inner) / 2;
  return depth(container, 0, is_conical(container) ? container.size.z : container.size.x / 2);
}

}  // namespace

WallProfile wall_profile(const PackedSpheres& spheres) {
  const Container& container = spheres.container;
  WallProfile profile;
  using enum Container::Shape;
  if (container.shape == box || container.shape == mesh || spheres.size() == 0) return profile;
  const double end = deepest(container);
  const auto steps = static_cast<std::size_t>(std::ceil(end * kStepsPerDiameter / spheres.mean_diameter()));
  profile.width = end / static_cast<double>(steps);
  std::vector<Shell> shells;
  for (std::size_t k = 0; k < steps; ++k) shells.emplace_back(container, profile.distance(k), profile.width);
  profile.packing_fraction.assign(steps, 0);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Vec3& center = spheres.positions[i];
    const double radius = spheres.radii[i];
    const double from_axis = std::hypot(center.x - container.size.x / 2, center.y - container.size.y / 2);
    const double middle = depth(container, from_axis, center.z);
    const auto step_of = [&](double distance) {
      return static_cast<std::size_t>(std::max(0.0, distance / profile.width));
    };
    const std::size_t last = std::min(steps, step_of(middle + radius) + 1);
    for (std::size_t k = step_of(middle - radius); k < last; ++k) {
      const Shell& shell = shells[k];
      const std::size_t end_ring = shell.from(center.z + radius);
      for (std::size_t number = shell.from(center.z - radius); number < end_ring; ++number) {
        const Ring ring = shell.ring(number);
        profile.packing_fraction[k] += ring.radius * share_within(ring, from_axis, center.z, radius);
      }
    }
  }
  for (std::size_t k = 0; k < steps; ++k) {
    double whole = 0;
    for (std::size_t number = 0; number < shells[k].rings(); ++number) whole += shells[k].ring(number).radius;
    profile.packing_fraction[k] /= whole;
  }
  return profile;
}

}  // namespace hardball
