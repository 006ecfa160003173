// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The same motion in a different description.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "property/any_world.hpp"
#include "support/interacting.hpp"

namespace hardball::symmetry_test {
namespace {

using support::RandomWorld;

std::vector<Contact> first_contacts(const World& world, double restitution, std::uint64_t count,
                                    double until) {
  std::vector<Contact> contacts;
  Simulation simulation(support::interacting(world, Restitution(restitution)));
  simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
  simulation.run({.until = Time(until), .contacts = count});
  return contacts;
}

Sphere sphere_at(const World& world, Slot slot) {
  return {world.path(slot).position, world.path(slot).velocity, world.base_radius(slot), world.mass(slot)};
}

template <class Change>
World changed(const World& world, const Box& box, Change&& change) {
  World other(box);
  for (Slot slot = 0; slot < world.size(); ++slot) other.add(change(sphere_at(world, slot)));
  return other;
}

Box scaled(const Box& box, double factor) {
  Vec3 size;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    size[axis] = box.is_open(axis) ? 1 : factor * box.size()[axis];
  return {{box.boundary(0), box.boundary(1), box.boundary(2)}, size};
}

// ---- Changes that do not affect rounding: the same bits. ----

// Multiplying by a power of two is exact; so the whole history scales exactly.
RC_GTEST_PROP(UnitsOfPowersOfTwo, ChangeNoBit, ()) {
  const RandomWorld made = support::any_world();
  const double of_length = std::ldexp(1, *rc::gen::inRange(-40, 40));
  const double of_time = std::ldexp(1, *rc::gen::inRange(-40, 40));
  const double of_mass = std::ldexp(1, *rc::gen::inRange(-40, 40));
  const double of_speed = of_length / of_time;
  const World other = changed(made.world, scaled(made.world.box(), of_length), [&](const Sphere& sphere) {
    return Sphere{of_length * sphere.position, of_speed * sphere.velocity, of_length * sphere.radius,
                  of_mass * sphere.mass};
  });
  const auto contacts = first_contacts(made.world, made.restitution, 500, made.until);
  const auto others = first_contacts(other, made.restitution, 500, made.until * of_time);
  RC_ASSERT(contacts.size() == others.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    RC_ASSERT(others[i].kind == contacts[i].kind);
    RC_ASSERT(others[i].first == contacts[i].first);
    RC_ASSERT(others[i].second == contacts[i].second);
    RC_ASSERT(others[i].image == contacts[i].image);
    RC_ASSERT(others[i].time == Time(of_time * contacts[i].time.high, of_time * contacts[i].time.low));
    RC_ASSERT(others[i].position == of_length * contacts[i].position);
    RC_ASSERT(others[i].separation == of_length * contacts[i].separation);
    RC_ASSERT(others[i].after.first == of_speed * contacts[i].after.first);
    RC_ASSERT(others[i].after.second == of_speed * contacts[i].after.second);
  }
}

// Which sphere of a pair is first affects only signs, which do not round. Without ties the log is the same
// except for ids. Elastic spheres only: inelastic ones may come to rest midway between two periodic images of
// another, which they then touch at the same time.
RC_GTEST_PROP(OtherLabels, ChangeNothingButTheNames, ()) {
  const RandomWorld made = support::any_gas(support::any_boundary());
  const auto spheres = static_cast<SphereId>(made.world.size());
  std::vector<SphereId> old_name(spheres);
  std::iota(old_name.begin(), old_name.end(), SphereId{0});
  Random random(support::any_seed());
  for (SphereId i = spheres; i > 1; --i) {
    std::swap(old_name[i - 1], old_name[static_cast<std::size_t>(random.uniform() * i)]);
  }
  World other(made.world.box());
  for (const SphereId name : old_name) other.add(sphere_at(made.world, name));
  const auto contacts = first_contacts(made.world, 1, 500, made.until);
  const auto others = first_contacts(other, 1, 500, made.until);
  RC_ASSERT(contacts.size() == others.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const Contact& renamed = others[i];
    RC_ASSERT(renamed.time == contact.time);
    RC_ASSERT(renamed.kind == contact.kind);
    if (!contact.is_collision()) {
      RC_ASSERT(old_name[renamed.first] == contact.first);
      RC_ASSERT(renamed.second == contact.second);
      RC_ASSERT(renamed.after.first == contact.after.first);
      continue;
    }
    const bool swapped = old_name[renamed.first] == contact.second;
    RC_ASSERT(old_name[swapped ? renamed.second : renamed.first] == contact.first);
    RC_ASSERT(old_name[swapped ? renamed.first : renamed.second] == contact.second);
    RC_ASSERT((swapped ? renamed.after.second : renamed.after.first) == contact.after.first);
    RC_ASSERT((swapped ? renamed.after.first : renamed.after.second) == contact.after.second);
    RC_ASSERT(renamed.image == (swapped ? -contact.image : contact.image));
  }
}

// In open space the only origin is zero, which a mirror preserves.
RC_GTEST_PROP(AMirrorInOpenSpace, ChangesNoBit, ()) {
  constexpr Boundary kOpen = Boundary::open;
  const RandomWorld made = support::any_gas({kOpen, kOpen, kOpen});
  const std::size_t axis = *rc::gen::inRange<std::size_t>(0, kAxes);
  const auto mirror = [axis](Vec3 v) {
    v[axis] = -v[axis];
    return v;
  };
  const World other = changed(made.world, made.world.box(), [&](Sphere sphere) {
    sphere.position = mirror(sphere.position);
    sphere.velocity = mirror(sphere.velocity);
    return sphere;
  });
  const auto contacts = first_contacts(made.world, made.restitution, 500, made.until);
  const auto others = first_contacts(other, made.restitution, 500, made.until);
  RC_ASSERT(contacts.size() == others.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    RC_ASSERT(others[i].time == contacts[i].time);
    RC_ASSERT(others[i].first == contacts[i].first);
    RC_ASSERT(others[i].second == contacts[i].second);
    RC_ASSERT(others[i].position == mirror(contacts[i].position));
    RC_ASSERT(others[i].after.first == mirror(contacts[i].after.first));
  }
}

// ---- Changes that affect rounding: the same motion until rounding errors have grown. ----

// Each collision multiplies an error by the ratio of free path to radius, ten to fifty here, and more if it
// grazes. The comparison covers two collisions per sphere on average, up to six for some: 1e-16 * 50^6 =
// 2e-6. Observed in thousands of gases: 1e-9; a wrong image, wall or sign is off by a radius.
constexpr double kSame = 1e-6;

double largest_speed(const World& world) {
  double largest = 0;
  for (const Path& path : world.paths()) largest = std::max(largest, length(path.velocity));
  return largest;
}

// In a few mean free times; an open gas may have fewer contacts than requested.
constexpr double kLongTime = 10;

using Map = std::function<Vec3(const Vec3&, double time)>;

// Compares two runs: `map` maps positions of the first world to the second, `turn` velocities.
void expect_same_motion(const World& world, const World& other, const Map& map, const Map& turn) {
  const std::uint64_t count = world.size();
  const auto contacts = first_contacts(world, 1, count, kLongTime);
  const auto others = first_contacts(other, 1, count, kLongTime);
  RC_ASSERT(contacts.size() == others.size());
  const double speed = largest_speed(world);
  const Box& box = other.box();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const double time = contacts[i].time.value();
    const double radius = contacts[i].first_radius;
    RC_ASSERT(others[i].kind == contacts[i].kind);
    RC_ASSERT(others[i].first == contacts[i].first);
    RC_ASSERT(std::fabs(others[i].time.value() - time) * speed <= kSame * radius);
    Vec3 apart = others[i].position - map(contacts[i].position, time);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (box.is_periodic(axis)) apart[axis] -= box.size()[axis] * std::round(apart[axis] / box.size()[axis]);
    }
    RC_ASSERT(length(apart) <= kSame * radius);
    RC_ASSERT(length(others[i].after.first - turn(contacts[i].after.first, time)) <= kSame * speed);
    if (contacts[i].is_collision()) RC_ASSERT(others[i].second == contacts[i].second);
  }
}

Vec3 unchanged(const Vec3& v, double) {
  return v;
}

RC_GTEST_PROP(AnotherOriginOfAPeriodicBox, ChangesNothing, ()) {
  const World world = support::any_dense_gas(support::kAllPeriodic);
  const Vec3 size = world.box().size();
  Random random(support::any_seed());
  const Vec3 shift{size.x * random.uniform(), size.y * random.uniform(), size.z * random.uniform()};
  const World other = changed(world, world.box(), [&](Sphere sphere) {
    sphere.position += shift;
    return sphere;
  });
  expect_same_motion(
      world, other, [&](const Vec3& x, double) { return x + shift; }, unchanged);
}

RC_GTEST_PROP(AnObserverWhoMoves, SeesTheSameInAPeriodicBox, ()) {
  const World world = support::any_dense_gas(support::kAllPeriodic);
  Random random(support::any_seed());
  const Vec3 boost = largest_speed(world) * random.direction();
  const World other = changed(world, world.box(), [&](Sphere sphere) {
    sphere.velocity += boost;
    return sphere;
  });
  expect_same_motion(
      world, other, [&](const Vec3& x, double time) { return x + time * boost; },
      [&](const Vec3& v, double) { return v + boost; });
}

RC_GTEST_PROP(AMirrorInABox, ShowsTheSameMotion, ()) {
  const World world = support::any_dense_gas(support::any_boundary());
  const Box& box = world.box();
  const std::size_t axis = *rc::gen::inRange<std::size_t>(0, kAxes);
  const double size = box.is_open(axis) ? 0 : box.size()[axis];
  const auto place = [&](Vec3 x, double) {
    x[axis] = size - x[axis];
    return x;
  };
  const auto turn = [&](Vec3 v, double) {
    v[axis] = -v[axis];
    return v;
  };
  const World other = changed(world, box, [&](Sphere sphere) {
    sphere.position = place(sphere.position, 0);
    sphere.velocity = turn(sphere.velocity, 0);
    return sphere;
  });
  expect_same_motion(world, other, place, turn);
}

RC_GTEST_PROP(PermutedAxes, ShowTheSameMotion, ()) {
  const World world = support::any_dense_gas(support::any_boundary());
  const Box& box = world.box();
  const auto order =
      *rc::gen::element(std::array<std::size_t, kAxes>{1, 2, 0}, std::array<std::size_t, kAxes>{2, 0, 1},
                        std::array<std::size_t, kAxes>{1, 0, 2}, std::array<std::size_t, kAxes>{0, 2, 1},
                        std::array<std::size_t, kAxes>{2, 1, 0});
  const auto turn = [&](const Vec3& v, double) { return Vec3{v[order[0]], v[order[1]], v[order[2]]}; };
  const Vec3 size = turn(box.size(), 0);
  const Box turned({box.boundary(order[0]), box.boundary(order[1]), box.boundary(order[2])}, size);
  const World other = changed(world, turned, [&](Sphere sphere) {
    sphere.position = turn(sphere.position, 0);
    sphere.velocity = turn(sphere.velocity, 0);
    return sphere;
  });
  expect_same_motion(world, other, turn, turn);
}

}  // namespace
}  // namespace hardball::symmetry_test
