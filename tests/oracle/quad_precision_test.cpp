// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// An independent, naive simulation: all spheres are at the same time, the next contact is searched among all
// pairs, images and walls, and all spheres are moved there. It shares nothing with the library but the
// initial state, and computes with 113 bits, so that its history is the true one.
#include <gtest/gtest.h>
#include <algorithm>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/interacting.hpp"
#include "support/random_world.hpp"

namespace hardball::quad_precision_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Quads = std::array<Quad, kAxes>;

Quad dot(const Quads& a, const Quads& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Body {
  Quads x;
  Quads v;
  Quad radius;
  Quad mass;
};

struct Touch {
  Quad time;
  bool is_wall = false;
  std::size_t first = 0;
  std::size_t second = 0;  // the other body, or 2 * axis + upper
};

class PlainSimulation {
 public:
  // With `jostle`, rounding errors larger than a double's are added at every contact.
  PlainSimulation(const World& world, double restitution, bool jostle)
      : box_(world.box()), restitution_(restitution), jostle_(jostle), random_(2026) {
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const Path& path = world.path(slot);
      Body body;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        body.x[axis] = path.position[axis];
        body.v[axis] = path.velocity[axis];
      }
      body.radius = world.base_radius(slot);
      body.mass = world.mass(slot);
      bodies_.push_back(body);
    }
  }

  // Executes and returns the next contact; nothing if there is none up to `until`.
  std::optional<Touch> next(double until) {
    for (;;) {
      // In a time interval in which no sphere crosses half a box, only nearest images can be met.
      const Quad window = window_without_crossing();
      const std::optional<Found> found = least(window);
      if (found) {
        if (now_ + found->wait > until) return std::nullopt;
        move(found->wait);
        respond(*found);
        return found->touch;
      }
      if (now_ + window > until) return std::nullopt;
      move(window);
    }
  }

 private:
  struct Found {
    Quad wait;
    Touch touch;
    Quads apart;
  };

  Quad window_without_crossing() const {
    Quad window = 1e300;
    for (const Body& body : bodies_) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (box_.is_periodic(axis) && body.v[axis] != 0) {
          window = std::min<Quad>(window, box_.size()[axis] / (4 * abs(body.v[axis])));
        }
      }
    }
    return window;
  }

  std::optional<Found> least(const Quad& window) const {
    std::optional<Found> least;
    const auto offer = [&](const Quad& wait, const Touch& touch, const Quads& apart) {
      if (wait <= window && (!least || wait < least->wait)) {
        least = Found{wait, touch, apart};
        least->touch.time = now_ + wait;
      }
    };
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const Body& body = bodies_[i];
        if (!box_.is_wall(axis) || body.v[axis] == 0) continue;
        const bool upper = body.v[axis] > 0;
        const Quad gap =
            upper ? box_.size()[axis] - body.radius - body.x[axis] : Quad(body.x[axis] - body.radius);
        offer(std::max<Quad>(0, gap / abs(body.v[axis])), {0, true, i, 2 * axis + (upper ? 1 : 0)}, {});
      }
      for (std::size_t j = i + 1; j < bodies_.size(); ++j) offer_pair(i, j, offer);
    }
    return least;
  }

  template <class Offer>
  void offer_pair(std::size_t i, std::size_t j, const Offer& offer) const {
    const Body& first = bodies_[i];
    const Body& second = bodies_[j];
    const Quad reach = first.radius + second.radius;
    // Both are folded into the box: within the window, images at most two boxes away can be reached, and none
    // that is now farther than half a box beyond reach.
    std::array<std::vector<Quad>, kAxes> places;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Quad apart = second.x[axis] - first.x[axis];
      if (!box_.is_periodic(axis)) places[axis].push_back(apart);
      for (int boxes = -2; boxes <= 2 && box_.is_periodic(axis); ++boxes) {
        const Quad place = apart + boxes * Quad(box_.size()[axis]);
        if (abs(place) <= reach + box_.size()[axis] / 2) places[axis].push_back(place);
      }
    }
    Quads speed;
    for (std::size_t axis = 0; axis < kAxes; ++axis) speed[axis] = second.v[axis] - first.v[axis];
    for (const Quad& x : places[0]) {
      for (const Quad& y : places[1]) {
        for (const Quad& z : places[2]) {
          const Quads apart = {x, y, z};
          const Quad rv = dot(apart, speed);
          if (rv >= 0) continue;
          const Quad excess = dot(apart, apart) - reach * reach;
          const Quad discriminant = rv * rv - dot(speed, speed) * excess;
          if (discriminant <= 0) continue;
          offer(excess <= 0 ? Quad(0) : Quad(excess / (sqrt(discriminant) - rv)), {0, false, i, j}, apart);
        }
      }
    }
  }

  void move(const Quad& wait) {
    now_ += wait;
    for (Body& body : bodies_) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        body.x[axis] += wait * body.v[axis];
        if (box_.is_periodic(axis))
          body.x[axis] -= box_.size()[axis] * floor(body.x[axis] / box_.size()[axis]);
      }
    }
  }

  void respond(const Found& found) {
    Body& first = bodies_[found.touch.first];
    if (found.touch.is_wall) {
      first.v[found.touch.second / 2] *= -restitution_;
      if (jostle_) jostle(first);
      return;
    }
    Body& second = bodies_[found.touch.second];
    Quads apart = found.apart;
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      apart[axis] += found.wait * (second.v[axis] - first.v[axis]);
    Quad approach = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      approach += apart[axis] * (second.v[axis] - first.v[axis]);
    const Quad reduced = first.mass * second.mass / (first.mass + second.mass);
    const Quad impulse = (1 + restitution_) * reduced * approach / dot(apart, apart);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      first.v[axis] += impulse * apart[axis] / first.mass;
      second.v[axis] -= impulse * apart[axis] / second.mass;
    }
    if (jostle_) {
      jostle(first);
      jostle(second);
    }
  }

  void jostle(Body& body) {
    Quad extent = body.radius;
    Quad speed = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      extent = std::max<Quad>(extent, abs(body.x[axis]));
      speed = std::max<Quad>(speed, abs(body.v[axis]));
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      body.x[axis] += extent * (random_.uniform() - 0.5) * 0x1p-47;
      body.v[axis] += speed * (random_.uniform() - 0.5) * 0x1p-47;
    }
  }

  Box box_;
  Quad restitution_;
  bool jostle_;
  Random random_;
  std::vector<Body> bodies_;
  Quad now_ = 0;
};

constexpr std::uint64_t kWorlds = 200;
constexpr std::size_t kMaxContacts = 40;

// How far the two histories have diverged by a contact: rounding errors grow exponentially from contact to
// contact. The library must stay within kTolerance as long as a naive simulation perturbed at every contact
// by as much as doubles round stays within a tenth of it and in the same order.
constexpr double kTolerance = 1e-10;
constexpr double kTrusted = kTolerance / 10;

double relative_difference(const Quad& a, const Quad& b) {
  return static_cast<double>(abs(a - b) / std::max<Quad>(abs(a), 1e-300));
}

bool same_bodies(const Touch& a, const Touch& b) {
  return a.is_wall == b.is_wall && a.first == b.first && a.second == b.second;
}

// Compares the histories of one world; returns how many contacts could be compared.
std::size_t compare(const World& world, double restitution, double until) {
  Simulation simulation(support::interacting(world, Restitution(restitution)));
  const std::vector<Contact> log =
      support::record(simulation, {.until = Time(until), .contacts = kMaxContacts});
  PlainSimulation plain(world, restitution, false);
  PlainSimulation jostled(world, restitution, true);
  std::size_t compared = 0;
  for (; compared < kMaxContacts; ++compared) {
    const std::optional<Touch> expected = plain.next(until);
    const std::optional<Touch> shaken = jostled.next(until);
    if (expected.has_value() != shaken.has_value()) break;
    if (!expected) {
      EXPECT_EQ(log.size(), compared) << "an extra contact";
      break;
    }
    const bool trusted =
        same_bodies(*expected, *shaken) && relative_difference(expected->time, shaken->time) < kTrusted;
    if (!trusted) break;
    if (compared >= log.size()) {
      ADD_FAILURE() << "contact " << compared << " is missing";
      break;
    }
    const Contact& contact = log[compared];
    const Quad time = Quad(contact.time.high) + Quad(contact.time.low);
    const Touch got{time, !contact.is_collision(), contact.first, contact.second};
    EXPECT_TRUE(same_bodies(*expected, got)) << "contact " << compared;
    EXPECT_LT(relative_difference(expected->time, time), kTolerance) << "contact " << compared;
    if (testing::Test::HasFailure()) break;
  }
  return compared;
}

class PlainSimulationInQuadPrecision : public testing::TestWithParam<std::array<Boundary, kAxes>> {};

TEST_P(PlainSimulationInQuadPrecision, HasTheSameHistory) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < support::cases(kWorlds); ++seed) {
    const support::RandomWorld made = support::make_random_gas(seed, GetParam(), 2 + seed % 5);
    SCOPED_TRACE(made.name);
    compared += compare(made.world, made.restitution, made.until);
    if (HasFailure()) return;
  }
  // In open space spheres soon separate for good; elsewhere some contacts can be compared in each world.
  const bool is_open = GetParam()[0] == Boundary::open;
  EXPECT_GT(compared, is_open ? support::cases(kWorlds) / 20 : 2 * support::cases(kWorlds));
}

constexpr Boundary kWall = Boundary::wall;
constexpr Boundary kPeriodic = Boundary::periodic;
constexpr Boundary kOpen = Boundary::open;
INSTANTIATE_TEST_SUITE_P(Boundaries, PlainSimulationInQuadPrecision,
                         testing::Values(std::array{kWall, kWall, kWall}, std::array{kOpen, kOpen, kOpen},
                                         std::array{kPeriodic, kPeriodic, kPeriodic},
                                         std::array{kWall, kPeriodic, kOpen}));

}  // namespace
}  // namespace hardball::quad_precision_test
