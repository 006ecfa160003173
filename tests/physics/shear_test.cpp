// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What must hold in a sheared box: momentum, the work of the shear, no preferred height, each contact once,
// and Grad's theory of a dilute granular gas.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "hardball/interaction/bounce.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/totals.hpp"
#include "support/effort.hpp"
#include "support/measurement.hpp"

namespace hardball::shear_physics_test {
namespace {

struct Fluid {
  std::size_t cells = 5;  // of an fcc lattice, along each axis
  double packing_fraction = 0.3;
  double rate = 0.5;
  double restitution = 1;
  double offset = 0;
};

World make_world(const Fluid& fluid) {
  const auto count = static_cast<double>(4 * fluid.cells * fluid.cells * fluid.cells);
  const double size = std::cbrt(count * 3.14159265358979 / 6 / fluid.packing_fraction);
  Box box = Box::periodic({size, size, size});
  box.set_shear({.rate = fluid.rate, .offset = fluid.offset});
  World world(box);
  Random random(7);
  // Pairs of opposite velocities: a fluid that drifts along y lags behind the flow more and more.
  Vec3 last;
  const double edge = size / static_cast<double>(fluid.cells);
  for (std::size_t k = 0; k < 4 * fluid.cells * fluid.cells * fluid.cells; ++k) {
    const std::size_t cell = k / 4;
    const Vec3 corner{static_cast<double>(cell % fluid.cells),
                      static_cast<double>(cell / fluid.cells % fluid.cells),
                      static_cast<double>(cell / fluid.cells / fluid.cells)};
    constexpr Vec3 kBasis[] = {
        {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
    const Vec3 position = edge * (corner + kBasis[k % 4]);
    Vec3 velocity = k % 2 == 1 ? -last : Vec3{random.normal(), random.normal(), random.normal()};
    last = velocity;
    velocity.x += box.flow_speed(position.y);
    world.add({.position = position, .velocity = velocity, .radius = 0.5});
  }
  ResponseTable table;
  BounceRules rules{.restitution = ConstantRestitution(fluid.restitution)};
  table.set(0, 0, Bounce(rules));
  world.set_interactions(table);
  return world;
}

TEST(Shear, WithRateZeroIsThePeriodicBox) {
  const auto hash_of = [](World world) {
    Simulation simulation(std::move(world));
    simulation.run({.contacts = 5000});
    return simulation.event_log_hash();
  };
  const Fluid fluid{.rate = 0};
  const World sheared = make_world(fluid);
  World periodic(Box::periodic(sheared.box().size()));
  for (Slot slot = 0; slot < sheared.size(); ++slot) {
    const Path& path = sheared.path(slot);
    periodic.add({.position = path.position, .velocity = path.velocity, .radius = 0.5});
  }
  periodic.set_interactions(sheared.interactions());
  EXPECT_FALSE(sheared.box().is_sheared());
  EXPECT_EQ(hash_of(sheared), hash_of(periodic));
}

TEST(Shear, KeepsMomentumAcrossTheFlow) {
  Simulation simulation(make_world({}));
  const Vec3 before = momentum(simulation.world(), simulation.now());
  simulation.run({.contacts = support::cases(100000)});
  const Vec3 after = momentum(simulation.world(), simulation.now());
  EXPECT_NEAR(after.y, before.y, 1e-10);
  EXPECT_NEAR(after.z, before.z, 1e-10);
  EXPECT_NEAR(after.x, before.x, 1e-9);
}

TEST(Shear, LeavesAFluidBehindThatRises) {
  World world = make_world({});
  for (Slot slot = 0; slot < world.size(); ++slot)
    world.change_velocity(slot, Time(0), world.velocity(slot, Time(0)) + Vec3{0, 0.25, 0});
  Simulation simulation(std::move(world));
  const Vec3 before = momentum(simulation.world(), simulation.now());
  simulation.run({.contacts = support::cases(20000)});
  const Vec3 after = momentum(simulation.world(), simulation.now());
  EXPECT_NEAR(after.y, before.y, 1e-10);
  EXPECT_NEAR(after.x, before.x - 0.5 * before.y * simulation.time(), 1e-8);
}

// The energy relative to the flow changes by -g sum of m v'_x v_y between contacts, and at each by -g r_y
// dp_x.
TEST(Shear, DoesTheWorkThatTheStressSays) {
  for (const double rate : {0.5, -3.0}) {
    Fluid fluid{.rate = rate, .offset = 1.5};
    Simulation simulation(make_world(fluid));
    const World& world = simulation.world();
    double carried = 0;
    double transferred = 0;
    const auto carry = [&](const Vec3& peculiar, double elapsed) {
      carried += peculiar.y * (peculiar.x * elapsed - rate * peculiar.y * elapsed * elapsed / 2);
    };
    // The peculiar velocity of each sphere at its last contact.
    std::vector<Vec3> velocities;
    std::vector<Time> since(world.size(), Time(0));
    for (Slot slot = 0; slot < world.size(); ++slot)
      velocities.push_back(peculiar_velocity(world, world.slot_of(slot), Time(0)));
    const auto renew = [&](SphereId id, const Time& now, const Vec3& velocity) {
      carry(velocities[id], duration(since[id], now));
      since[id] = now;
      velocities[id] = velocity;
    };
    simulation.on_contact([&](const Contact& contact) {
      transferred += contact.separation.y * -contact.impulse().x;
      const double height = contact.position.y;
      Vec3 first = contact.after.first;
      first.x -= world.box().flow_speed(height);
      Vec3 second = contact.after.second;
      second.x -= world.box().flow_speed(height + contact.separation.y);
      renew(contact.first, contact.time, first);
      renew(contact.second, contact.time, second);
    });
    const double before = kinetic_energy(world, Time(0));
    simulation.run({.contacts = support::cases(50000)});
    for (SphereId id = 0; id < world.size(); ++id) renew(id, simulation.now(), {});
    const double gained = kinetic_energy(world, simulation.now()) - before;
    EXPECT_GT(gained, before / 100);
    EXPECT_NEAR(gained, -rate * (carried + transferred), 1e-9 * (before + gained));
    EXPECT_NEAR(simulation.tally().shear_work(kinetic_energy(world, simulation.now())), gained,
                1e-9 * gained);
  }
}

TEST(Shear, IsMeasuredExactly) {
  Simulation simulation(make_world({.rate = 0.4, .restitution = 0.9}));
  simulation.run({.contacts = 60000});  // then it is steady
  const World& world = simulation.world();
  Measures measures(MeasureSettings{.names = {"pressure"}});
  const double before = kinetic_energy(world, simulation.now());
  const double work = simulation.tally().shear_work(before);
  const double begin = simulation.time();
  simulation.run({.until = Time(begin + 20)}, measures);
  const double energy = kinetic_energy(world, simulation.now());
  const std::vector<Measurement> results = measures.results(world, simulation.now());
  const double done = simulation.tally().shear_work(energy) - work;
  const double volume = world.box().volume();
  const double viscosity = support::quantity(results.front(), "viscosity").value;
  EXPECT_NEAR(viscosity * 0.4 * 0.4 * volume * 20, done, 0.02 * done);
}

// Moving the origin along y, each sphere that leaves above coming in below with the velocity of its image.
TEST(Shear, PrefersNoHeight) {
  const World world = make_world({.cells = 3, .packing_fraction = 0.2});
  const double height = world.box().size().y;
  for (const double moved : {0.37 * height, 0.8 * height}) {
    World other(world.box());
    for (Slot slot = 0; slot < world.size(); ++slot) {
      Path path = world.path(slot);
      path.position.y += moved;
      // The flow has its zero in the middle.
      other.add({.position = path.position, .velocity = path.velocity, .radius = 0.5});
    }
    other.set_interactions(world.interactions());
    using Pair = std::tuple<double, SphereId, std::uint32_t>;
    const auto contacts_of = [](World start) {
      std::vector<Pair> contacts;
      Simulation simulation(std::move(start));
      simulation.on_contact([&](const Contact& contact) {
        contacts.emplace_back(contact.time.value(), contact.first, contact.second);
      });
      simulation.run({.contacts = 300});
      return contacts;
    };
    const std::vector<Pair> expected = contacts_of(world);
    const std::vector<Pair> found = contacts_of(other);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      ASSERT_NEAR(std::get<0>(found[k]), std::get<0>(expected[k]), 1e-6) << k;
      ASSERT_EQ(std::get<1>(found[k]), std::get<1>(expected[k])) << k;
      ASSERT_EQ(std::get<2>(found[k]), std::get<2>(expected[k])) << k;
    }
  }
}

// The earliest contact of all pairs in all images, by a search that knows nothing of broad phases; and none
// happens twice.
TEST(Shear, FindsEveryPairAcrossTheFaceOnce) {
  Simulation simulation(make_world({.cells = 4, .packing_fraction = 0.35, .rate = 1.5}));
  const World& world = simulation.world();
  const Vec3& size = world.box().size();
  std::size_t across = 0;
  std::optional<Contact> last;
  simulation.on_contact([&](const Contact& contact) {
    across += contact.image[1] != 0 ? 1U : 0U;
    if (last) {
      const bool is_same = last->first == contact.first && last->second == contact.second;
      EXPECT_FALSE(is_same && !(last->time < contact.time));
    }
    last = contact;
  });
  for (std::size_t k = 0; k < support::cases(200); ++k) {
    const Time now = simulation.now();
    double earliest = 1e300;
    for (Slot a = 0; a < world.size(); ++a) {
      for (Slot b = a + 1; b < world.size(); ++b) {
        const Vec3 r = world.position(b, now) - world.position(a, now);
        const Vec3 v = world.velocity(b, now) - world.velocity(a, now);
        for (int above = -1; above <= 1; ++above) {
          const double slid = above * world.box().images().displacement(now).high;
          const Vec3 relative{v.x + above * world.box().images().speed(), v.y, v.z};
          const double first = std::floor(-(r.x + slid) / size.x - 1.5);
          for (double along = first; along <= first + 4; ++along) {
            for (int beside = -1; beside <= 1; ++beside) {
              const Vec3 apart{r.x + slid + along * size.x, r.y + above * size.y, r.z + beside * size.z};
              const double b_half = dot(apart, relative);
              const double c = dot(apart, apart) - 1;
              const double d = b_half * b_half - dot(relative, relative) * c;
              if (b_half >= -1e-9 || d < 0) continue;
              earliest = std::min(earliest, c / (std::sqrt(d) - b_half));
            }
          }
        }
      }
    }
    simulation.run({.contacts = 1});
    ASSERT_NEAR(duration(now, last->time), earliest, 1e-9) << k;
    simulation.run({.contacts = 97});
  }
  EXPECT_GT(across, 98 * support::cases(200) / 50);
}

// Source: Jenkins and Richman, Phys. Fluids 31 (1988) 3485: Grad's moments, to second order.
TEST(Shear, OfADiluteGranularGasIsAsGradHasIt) {
  const double restitution = 0.8;
  const double rate = 0.05;
  const Fluid fluid{.cells = 6, .packing_fraction = 0.01, .rate = rate, .restitution = restitution};
  World world = make_world(fluid);
  Simulation simulation(std::move(world));
  simulation.run({.contacts = support::cases(200000)});
  Measures measures(MeasureSettings{.names = {"pressure", "temperature"}});
  const double begin = simulation.time();
  simulation.run({.contacts = support::cases(1500000)}, measures);
  const std::vector<Measurement> results = measures.results(simulation.world(), simulation.now());
  const double zeta = 5.0 / 12 * (1 - restitution * restitution);
  const double beta = (1 + restitution) * (2 + restitution) / 6;
  const double a = std::sqrt(3 * zeta / (2 * beta)) * (beta + zeta);
  const double phi = 0.01;
  const double contact_value = (1 - phi / 2) / std::pow(1 - phi, 3);
  const double density = phi * 6 / 3.14159265358979;
  const double root = rate / (a * 16 / 5 * std::sqrt(3.14159265358979) * density * contact_value);
  const double expected = root * root;
  const double temperature = support::quantity(results[1], "temperature").value;
  EXPECT_NEAR(temperature / expected, 1, 0.06);
  const double pressure = density * temperature;
  const double yy = beta / (beta + zeta);
  const double xy = -a * beta / ((beta + zeta) * (beta + zeta));
  // The collisional part, which Grad's theory of a dilute gas leaves out, is a few percent.
  EXPECT_NEAR(support::quantity(results[0], "pressure_xy").value / pressure, xy, 0.05);
  EXPECT_NEAR(support::quantity(results[0], "pressure_yy").value / pressure, yy, 0.06);
  EXPECT_NEAR(support::quantity(results[0], "pressure_xx").value / pressure, 3 - 2 * yy, 0.08);
  EXPECT_GT(simulation.time(), begin);
}

}  // namespace
}  // namespace hardball::shear_physics_test
