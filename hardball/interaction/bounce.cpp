// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/bounce.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/interaction/restitution.hpp"
#include "hardball/interaction/thermal_wall.hpp"

namespace hardball {
namespace {

void check_not_negative(double value, const char* name, const char* remedy) {
  if (value >= 0 && std::isfinite(value)) return;
  throw Error(std::string(name) + " is " + to_text(value), name, remedy);
}

// Adds the tangential impulse to what comes after a smooth impact.
void rub(double tangential_restitution, Contact& contact) {
  const Vec3 normal = contact.normal();
  const double first_radius = contact.first_radius;
  const double second_radius = contact.second_radius;
  const Vec3 turning =
      first_radius * contact.spins_before.first + second_radius * contact.spins_before.second;
  const Vec3 slip = (contact.before.first - contact.before.second) + cross(turning, normal);
  const Vec3 tangential = slip - dot(slip, normal) * normal;
  const double first_inverse = 1 / contact.first_mass;
  const double second_inverse = 1 / contact.second_mass;
  const double inverse = first_inverse * (1 + 1 / contact.first_inertia_factor) +
                         second_inverse * (1 + 1 / contact.second_inertia_factor);
  if (inverse == 0) return;  // a kinematic sphere at a wall
  const Vec3 impulse = (-(1 + tangential_restitution) / inverse) * tangential;
  const Vec3 torque = cross(normal, impulse);
  contact.after.first += first_inverse * impulse;
  contact.spins_after.first += (first_inverse / (contact.first_inertia_factor * first_radius)) * torque;
  if (!contact.is_collision()) return;
  contact.after.second -= second_inverse * impulse;
  contact.spins_after.second += (second_inverse / (contact.second_inertia_factor * second_radius)) * torque;
}

}  // namespace

Bounce::Bounce(const BounceRules& rules) : rules_(rules) {
  const auto* const constant = std::get_if<ConstantRestitution>(&rules.restitution);
  if (constant != nullptr) check_restitution(constant->value);
  check_not_negative(rules.elastic_below, "elastic_below", "give zero or a positive speed");
  check_not_negative(rules.contact_duration, "contact_duration", "give zero or a positive time");
  check_not_negative(rules.settle_under, "settle_under", "give zero or a positive acceleration");
  const double tangential = rules.tangential_restitution.value_or(-1);
  if (!(tangential >= -1 && tangential <= 1)) {
    throw Error("tangential_restitution is " + to_text(tangential), "tangential_restitution",
                "give a number between -1 and 1");
  }
  const bool is_instant = rules.contact_duration == 0 && rules.settle_under == 0;
  if (constant != nullptr && is_instant && !rules.tangential_restitution) {
    restitution_ = Restitution(constant->value, rules.elastic_below);
  }
}

Bounce::Bounce(const Restitution& restitution)
    : Bounce(BounceRules{.restitution = ConstantRestitution{restitution.coefficient()},
                         .elastic_below = restitution.elastic_below()}) {}

double Bounce::contact_duration(const Contact& contact) const {
  if (rules_.settle_under == 0) return rules_.contact_duration;
  const double radius =
      contact.is_collision() ? std::min(contact.first_radius, contact.second_radius) : contact.first_radius;
  return std::max(rules_.contact_duration, kSettlingDuration * std::sqrt(2 * radius / rules_.settle_under));
}

double Bounce::coefficient_at(const Contact& contact) const {
  const double speed = contact.impact_speed();
  if (speed < rules_.elastic_below || contact.flight() < contact_duration(contact)) return 1;
  if (contact.wall_material.restitution && !contact.is_collision()) return *contact.wall_material.restitution;
  return std::visit([speed](const auto& law) { return law.at(speed); }, rules_.restitution);
}

double Bounce::least_parting_speed(const Contact& contact) const {
  const double least = hardball::least_parting_speed(contact, rules_.elastic_below);
  if (rules_.settle_under == 0) return least;
  return std::max(least, contact.pressing * contact_duration(contact) / 2);
}

bool Bounce::decide_by_rules(Contact& contact) const {
  if (contact.is_collision()) {
    contact.after = velocities_after_impact(contact, coefficient_at(contact));
  } else if (contact.wall_material.temperature) {
    contact.after.first = rethermalized(contact);
    return false;
  } else {
    contact.after.first =
        velocity_after_bounce(contact, coefficient_at(contact), least_parting_speed(contact));
  }
  if (rules_.tangential_restitution) rub(*rules_.tangential_restitution, contact);
  return rules_.tangential_restitution.has_value();
}

}  // namespace hardball
