// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/response/contact.hpp"

namespace hardball {

/// Spheres that become one when they touch, with the mass, momentum, angular momentum and volume of both.
struct Merging {
  Outcome operator()(const Contact& contact) const {
    Outcome outcome(contact, contact.before);
    outcome.merges = true;
    return outcome;
  }

  static void persist(auto& /*archive*/, auto& /*self*/) {}
};

static_assert(Response<Merging>);

}  // namespace hardball
