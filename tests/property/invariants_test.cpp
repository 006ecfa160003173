// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What holds at every contact and every time in every world.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hardball/world/audit.hpp"
#include "hardball/world/totals.hpp"
#include "property/any_world.hpp"

namespace hardball::invariants_test {
namespace {

using support::RandomWorld;

std::vector<Contact> contacts_of(Simulation& simulation, const RunLimits& limits) {
  std::vector<Contact> contacts;
  simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
  simulation.run(limits);
  return contacts;
}

std::vector<Contact> contacts_of(const RandomWorld& made) {
  Simulation simulation(made.world);
  return contacts_of(simulation, {.until = Time(made.until), .contacts = support::kMaxContacts});
}

double square(const Vec3& v) {
  return dot(v, v);
}

// Twice the kinetic energy of the spheres of a contact.
double twice_energy(const Contact& contact, const Velocities& v) {
  const double second = contact.is_collision() ? contact.second_mass * square(v.second) : 0;
  return contact.first_mass * square(v.first) + second;
}

// The rounding error of a contact, a few operations on numbers of the size of the sphere's energy or
// momentum.
constexpr double kRounding = 1e-14;

RC_GTEST_PROP(EveryCollision, KeepsTheMomentumOfItsPair, ()) {
  for (const Contact& contact : contacts_of(support::any_world())) {
    if (!contact.is_collision()) continue;
    const Vec3 change = contact.first_mass * (contact.after.first - contact.before.first) +
                        contact.second_mass * (contact.after.second - contact.before.second);
    const double size = contact.first_mass * (length(contact.before.first) + length(contact.after.first)) +
                        contact.second_mass * (length(contact.before.second) + length(contact.after.second));
    RC_ASSERT(length(change) <= kRounding * size);
  }
}

// A wall has infinite mass; for two spheres the reduced mass m1 m2 / (m1 + m2) counts.
RC_GTEST_PROP(EveryContact, TakesTheEnergyGivenByItsRestitutionAndNeverAddsAny, ()) {
  const RandomWorld made = support::any_world();
  const double loss_factor = 1 - made.restitution * made.restitution;
  for (const Contact& contact : contacts_of(made)) {
    const double reduced_mass = contact.is_collision() ? contact.first_mass * contact.second_mass /
                                                             (contact.first_mass + contact.second_mass)
                                                       : contact.first_mass;
    const double before = twice_energy(contact, contact.before);
    const double after = twice_energy(contact, contact.after);
    const double loss = loss_factor * reduced_mass * contact.impact_speed() * contact.impact_speed();
    RC_ASSERT(after <= before * (1 + kRounding));
    // In a collapse speeds may fall by 1e-150, until their squares vanish.
    constexpr double kVanishing = 1e-300;
    RC_ASSERT(std::fabs(before - after - loss) <= kRounding * before + kVanishing * contact.first_mass);
  }
}

RC_GTEST_PROP(EveryContact, SeparatesItsSpheres, ()) {
  for (const Contact& contact : contacts_of(support::any_world())) {
    // Bodies approach before and not after, by the same expressions that predict contacts.
    RC_ASSERT(dot(contact.separation, contact.before.second - contact.before.first) <= 0);
    RC_ASSERT(dot(contact.separation, contact.after.second - contact.after.first) >= 0);
  }
}

// Positions are rounded to 1e-16 of the largest coordinate, in worlds of up to 150 of the smallest radii and
// paths through up to a hundred of them: 1e-16 * 1.5e4. Clusters start with overlaps of up to 1e-13.
RC_GTEST_PROP(EveryContact, HappensWhenSurfacesTouch, ()) {
  for (const Contact& contact : contacts_of(support::any_world())) {
    RC_ASSERT(std::fabs(contact.overlap()) < 2e-12);
  }
}

RC_GTEST_PROP(Contacts, FollowEachOtherInTime, ()) {
  const RandomWorld made = support::any_world();
  Time last;
  for (const Contact& contact : contacts_of(made)) {
    RC_ASSERT(contact.time >= last);
    RC_ASSERT(contact.time <= Time(made.until));
    last = contact.time;
  }
}

RC_GTEST_PROP(TheClock, IsAtTheTimeAtWhichTheRunWasToStop, ()) {
  const RandomWorld made = support::any_world();
  Simulation simulation(made.world);
  double time = 0;
  for (int stop = 0; stop < 5; ++stop) {
    time += made.until / 50 * *rc::gen::inRange(0, 10);
    const RunStatus status = simulation.run({.until = Time(time), .contacts = support::kMaxContacts});
    RC_ASSERT(simulation.now() <= Time(time));
    // Touching spheres that lose energy may collide without end and without progress.
    if (status != RunStatus::time_reached) return;
    RC_ASSERT(simulation.now() == Time(time));
    const std::optional<NextContact> next = simulation.next_contact(2 * made.until);
    if (next) RC_ASSERT(next->time >= time);
  }
}

RC_GTEST_PROP(AtAnyTime, NothingOverlapsAndNoSphereHasEscaped, ()) {
  const RandomWorld made = support::any_world();
  Simulation simulation(made.world);
  for (int stop = 1; stop <= 5; ++stop) {
    const double fraction = (stop + 0.01 * *rc::gen::inRange(0, 100)) / 6;
    simulation.run({.until = Time(std::max(simulation.time(), made.until * fraction)),
                    .contacts = support::kMaxContacts / 5});
    const Audit found = audit(simulation.world(), simulation.now());
    RC_ASSERT(found.is_sound());
    // As at contacts.
    RC_ASSERT(found.max_overlap < 2e-12);
    RC_ASSERT(found.max_escape < 2e-12);
  }
}

RC_GTEST_PROP(AGasWithoutWalls, KeepsItsMomentumAndLosesOnlyWhatRestitutionTakes, ()) {
  std::array<Boundary, kAxes> boundary{};
  for (Boundary& each : boundary) each = *rc::gen::element(Boundary::periodic, Boundary::open);
  const RandomWorld made = support::any_gas(boundary);
  Simulation simulation(made.world);
  const std::vector<Contact> contacts =
      contacts_of(simulation, {.until = Time(made.until), .contacts = support::kMaxContacts});
  double momenta = 0;
  for (Slot slot = 0; slot < made.world.size(); ++slot) {
    momenta += made.world.mass(slot) * length(made.world.path(slot).velocity);
  }
  const auto events = static_cast<double>(contacts.size() + 1);
  RC_ASSERT(length(momentum(simulation.world(), simulation.now()) - momentum(made.world, Time(0))) <=
            kRounding * events * momenta);
  double loss = 0;
  for (const Contact& contact : contacts) {
    loss += (twice_energy(contact, contact.before) - twice_energy(contact, contact.after)) / 2;
  }
  const double start = kinetic_energy(made.world, Time(0));
  RC_ASSERT(std::fabs(start - loss - kinetic_energy(simulation.world(), simulation.now())) <=
            kRounding * events * start);
}

}  // namespace
}  // namespace hardball::invariants_test
