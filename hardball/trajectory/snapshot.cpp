// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/step_levels.hpp"

namespace hardball {
namespace {

// Widens the box along an axis to the spheres; to a unit length if there are none.
void span_spheres(const std::vector<Sphere>& spheres, std::size_t axis, SnapshotBox& box) {
  double low = spheres.empty() ? 0 : std::numeric_limits<double>::infinity();
  double high = spheres.empty() ? 1 : -std::numeric_limits<double>::infinity();
  for (const Sphere& sphere : spheres) {
    low = std::min(low, sphere.position[axis] - sphere.radius);
    high = std::max(high, sphere.position[axis] + sphere.radius);
  }
  box.low[axis] = low;
  box.size[axis] = high - low;
}

template <class Value>
void reorder(std::vector<Value>& values, const std::vector<std::size_t>& order) {
  if (values.empty()) return;
  std::vector<Value> sorted;
  sorted.reserve(values.size());
  for (const std::size_t index : order) sorted.push_back(values[index]);
  values = std::move(sorted);
}

// Tilts the box as images above are displaced at `moment`, and folds centers into the tilted cell: programs
// that know no images that slide show a cell like that.
void tilt_as_sheared(const Box& box, const Time& moment, Snapshot& snapshot) {
  const Vec3& size = box.size();
  const double displacement = box.images().displacement(moment).high;
  const double boxes = std::round(displacement / size.x);
  const double tilt = box.images().displacement_in_box(moment);
  snapshot.box->tilt = tilt > size.x / 2 ? tilt - size.x : tilt;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    Vec3& position = snapshot.spheres[i].position;
    const double beyond =
        std::floor((position.x - snapshot.box->tilt * (position.y / size.y - 0.5)) / size.x);
    position.x -= beyond * size.x;
    Image& image = snapshot.images[i];
    image[0] += static_cast<std::int32_t>(beyond + boxes * image[1]);
  }
}

// Error: an edge or the tilt is not finite, or negative; or zero where the box is periodic.
void check_box(const SnapshotBox& box, const std::string& name) {
  const auto refuse = [&](const std::string& problem) {
    throw Error(problem, name, "give a box with positive edges");
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double edge = box.size[axis];
    const std::string which = std::string("the edge of the box along ") + "xyz"[axis];
    if (!(edge >= 0) || !std::isfinite(edge)) refuse(which + " is " + to_text(edge));
    if (edge == 0 && box.is_periodic[axis]) refuse(which + " is zero, and the box is periodic there");
    if (!std::isfinite(box.low[axis])) refuse("the box begins at " + to_text(box.low[axis]));
  }
  if (!std::isfinite(box.tilt)) refuse("the tilt of the box is " + to_text(box.tilt));
}

bool is_finite(const Vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

}  // namespace

std::string Snapshot::location(const std::string& name, std::size_t sphere) const {
  return lines.empty() ? name + ": sphere " + to_text(sphere) : name + ":" + to_text(lines[sphere]);
}

std::size_t Snapshot::sphere_of(std::int64_t id) const {
  if (ids.empty() && id >= 0 && static_cast<std::size_t>(id) < spheres.size())
    return static_cast<std::size_t>(id);
  const auto found = ranges::lower_bound(ids, id);
  if (found == ids.end() || *found != id) {
    throw Error("a bond ties sphere " + to_text(id) + ", which the snapshot does not have", "bonds",
                "tie spheres of the snapshot");
  }
  return static_cast<std::size_t>(found - ids.begin());
}

Snapshot snapshot_of(const World& world, const Time& moment) {
  Snapshot snapshot;
  snapshot.time = moment.value();
  snapshot.has_spins = world.has_spins();
  snapshot.spheres.reserve(world.size());
  snapshot.ids.reserve(world.size());
  snapshot.images.reserve(world.size());
  world.for_each_by_id([&](Slot slot) {
    snapshot.spheres.push_back({.position = world.position(slot, moment),
                                .velocity = world.velocity(slot, moment),
                                .radius = world.radius(slot, moment),
                                .mass = world.mass(slot),
                                .spin = world.spin(slot),
                                .species = world.species(slot),
                                .inertia_factor = world.inertia_factor(slot)});
    snapshot.ids.push_back(world.id(slot));
    snapshot.images.push_back(image_of(world, slot, moment));
  });
  for (const Bond& bond : bonds_of(world)) snapshot.bonds.push_back({bond.first, bond.second});
  const Box& box = world.box();
  SnapshotBox& shown = snapshot.box.emplace();
  shown.is_unbounded = box.is_any(Boundary::open);
  shown.is_flat = box.is_flat();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    shown.is_periodic[axis] = box.is_periodic(axis);
    if (box.is_bounded(axis)) {
      shown.size[axis] = box.size()[axis];
    } else {
      span_spheres(snapshot.spheres, axis, shown);
    }
  }
  if (box.is_sheared()) tilt_as_sheared(box, moment, snapshot);
  return snapshot;
}

SnapshotBox box_of(const Snapshot& snapshot) {
  if (snapshot.box) return *snapshot.box;
  SnapshotBox box;
  box.is_unbounded = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) span_spheres(snapshot.spheres, axis, box);
  return box;
}

void sort_by_id(Snapshot& snapshot, const std::string& name) {
  const std::vector<std::int64_t>& ids = snapshot.ids;
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (ids[order[i]] != ids[order[i - 1]]) continue;
    const std::string before = snapshot.lines.empty() ? "that of sphere " + to_text(order[i - 1])
                                                      : "on line " + to_text(snapshot.lines[order[i - 1]]);
    throw Error("id " + to_text(ids[order[i]]) + " is already " + before, snapshot.location(name, order[i]),
                "give every sphere an id of its own");
  }
  reorder(snapshot.spheres, order);
  reorder(snapshot.images, order);
  reorder(snapshot.lines, order);
  reorder(snapshot.ids, order);
}

void fold_into_box(Snapshot& snapshot, const std::string& name) {
  if (!snapshot.box) return;
  const SnapshotBox& box = *snapshot.box;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    Vec3& position = snapshot.spheres[i].position;
    // Along x last: boxes above or below are displaced along it.
    for (std::size_t axis = kAxes; axis-- > 0;) {
      if (!box.is_periodic[axis] || !(box.size[axis] > 0)) continue;
      const double slant = axis == 0 ? box.tilt * ((position.y - box.low.y) / box.size.y - 0.5) : 0;
      const double boxes = std::floor((position[axis] - box.low[axis] - slant) / box.size[axis]);
      if (boxes == 0) continue;
      position[axis] -= boxes * box.size[axis];
      if (axis == 1) position.x -= boxes * box.tilt;
      if (snapshot.images.empty()) snapshot.images.resize(snapshot.spheres.size());
      std::int32_t& image = snapshot.images[i][axis];
      const double count = image + boxes;
      if (!(std::fabs(count) <= std::numeric_limits<std::int32_t>::max())) {
        throw Error("the center is " + to_text(count) + " boxes away along " + "xyz"[axis],
                    snapshot.location(name, i), "give a center nearer to the box");
      }
      image = static_cast<std::int32_t>(count);
    }
  }
}

std::string text_of(const SnapshotBox& box) {
  std::string size;
  std::string periodic;
  for (std::size_t axis = 0; axis < (box.is_flat ? kAxes - 1 : kAxes); ++axis) {
    size += (axis == 0 ? "" : " x ") + to_text(box.size[axis]);
    if (box.is_periodic[axis]) periodic += (periodic.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
  }
  if (!box.are_boundaries_known) {
    periodic = ", boundaries not given";
  } else {
    periodic = periodic.empty() ? ", not periodic" : ", periodic along " + periodic;
  }
  return size + periodic + (box.tilt == 0 ? "" : ", tilted by " + to_text(box.tilt)) +
         (box.is_unbounded ? ", unbounded: it spans the spheres" : "");
}

void check_numbers(const Snapshot& snapshot, const std::string& name) {
  if (snapshot.box) check_box(*snapshot.box, name);
  const auto is_proper = [](double number) { return number > 0 && std::isfinite(number); };
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    const bool has_mass = sphere.mass > 0;
    if (is_finite(sphere.position) && is_finite(sphere.velocity) && is_finite(sphere.spin) &&
        is_proper(sphere.radius) && is_proper(sphere.inertia_factor) && has_mass) {
      continue;
    }
    const std::string where = snapshot.location(name, i);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      check_finite(sphere.position[axis], "position", where);
      check_finite(sphere.velocity[axis], "velocity", where);
      check_finite(sphere.spin[axis], "spin", where);
    }
    check_positive(sphere.radius, "radius", where);
    if (!has_mass) check_positive(sphere.mass, "mass", where);
    check_positive(sphere.inertia_factor, "moment", where);
  }
}

}  // namespace hardball
