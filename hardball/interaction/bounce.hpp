// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <tuple>

#include "hardball/describe/field.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/interaction/restitution.hpp"
#include "hardball/interaction/restitution_law.hpp"

namespace hardball {

/// The time within which contacts of spheres that settle are elastic, over sqrt(d / g) [1]; see
/// BounceRules::settle_under.
inline constexpr double kSettlingDuration = 0.01;

/// How bodies bounce off each other.
struct BounceRules {
  RestitutionLaw restitution = ConstantRestitution();
  /// Slower impacts are elastic, see Restitution [L/T].
  double elastic_below = 0;
  /// A contact is elastic if the motion of one of the bodies changed within this time before it [T]: the TC
  /// model. Zero if no contact is. Source: Luding and McNamara, Granular Matter 1 (1998) 113.
  double contact_duration = 0;
  /// The acceleration under which heaps are to come to rest [L/T^2]; zero if they need not. A contact is then
  /// elastic, too, if the motion of one of the bodies changed within a hundredth of sqrt(d / g) before it, d
  /// being the diameter of the smaller, and a sphere that is pressed against a wall leaves it for at least as
  /// long. Contacts that press spheres together follow each other faster than that, so that a heap bears its
  /// weight by a finite number of them.
  double settle_under = 0;
  /// The tangential velocity of the surfaces after a contact over that before, reversed [1]: from -1, smooth,
  /// over 0, sticking, to 1, perfectly rough; if absent, the bodies are smooth.
  std::optional<double> tangential_restitution = {};

  /// The rules that are numbers; the restitution may be a law.
  static constexpr auto fields() {
    return std::tuple{
        option(
            "elastic_below", &BounceRules::elastic_below, NumberRange::not_negative, "L/T",
            "impacts slower than this are elastic; under gravity a sphere pressed against a surface leaves "
            "it with at least a tenth of this speed",
            "0.01"),
        option("contact_duration", &BounceRules::contact_duration, NumberRange::not_negative, "T",
               "a contact is elastic if the motion of one of the spheres changed within this time before it: "
               "the TC model, which prevents inelastic collapse",
               "1e-5"),
        option("tangential_restitution", &BounceRules::tangential_restitution, NumberRange::signed_fraction,
               "",
               "for rough spheres, whose spins change at contacts: minus the ratio of the tangential "
               "velocities of the surfaces after and before a contact; 1 is perfectly rough, -1 smooth",
               "0.5")};
  }
  static void persist(auto& archive, auto& self) {
    archive(self.restitution, self.elastic_below, self.contact_duration, self.tangential_restitution,
            self.settle_under);
  }
};

/// Spheres and walls that bounce off each other, smooth or rough, with any law of restitution. An impact of
/// rough bodies changes their spins, too. Energy is conserved if the restitution is 1 and the tangential one
/// 1 or -1, momentum and angular momentum always. Source: Huthmann and Zippelius, Phys. Rev. E 56 (1997)
/// R6275, for spheres of equal size; here each sphere has a radius, mass and inertia factor of its own.
class HARDBALL_EXPORT Bounce {
 public:
  /// Error: a restitution is not between 0 and 1; the tangential one is not between -1 and 1; a speed, a
  /// duration or an acceleration is negative or not finite.
  explicit Bounce(const BounceRules& rules = {});
  /// Smooth, with a constant coefficient.
  explicit Bounce(const Restitution& restitution);

  const BounceRules& rules() const { return rules_; }
  /// The constant coefficient of smooth bodies, if that is all.
  const std::optional<Restitution>& restitution() const { return restitution_; }
  /// See Response.
  bool decide(Contact& contact) const {
    return restitution_ ? hardball::decide(*restitution_, contact) : decide_by_rules(contact);
  }
  Outcome operator()(const Contact& contact) const { return outcome_of(*this, contact); }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.rules_); }
  bool restored() {
    *this = Bounce(rules_);
    return true;
  }

  double contact_duration(const Contact& contact) const;
  double coefficient_at(const Contact& contact) const;
  double least_parting_speed(const Contact& contact) const;
  bool decide_by_rules(Contact& contact) const;

  BounceRules rules_;
  std::optional<Restitution> restitution_;
};

static_assert(Response<Bounce>);

}  // namespace hardball
