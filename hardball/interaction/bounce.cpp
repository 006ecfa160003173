// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/bounce.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/interaction/restitution.hpp"
#include "hardball/interaction/roughness.hpp"
#include "hardball/interaction/thermal_wall.hpp"

namespace hardball {
namespace {

void check_not_negative(double value, const char* name, const char* remedy) {
  if (value >= 0 && std::isfinite(value)) return;
  throw Error(std::string(name) + " is " + to_text(value), name, remedy);
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
  std::optional<double> tangential = rules_.tangential_restitution;
  if (!contact.is_collision() && contact.wall_material.tangential_restitution)
    tangential = contact.wall_material.tangential_restitution;
  if (tangential) rub(*tangential, contact);
  return tangential.has_value();
}

}  // namespace hardball
