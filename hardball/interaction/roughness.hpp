// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/interaction/contact.hpp"

namespace hardball {

/// Adds the impulse along rough surfaces to what comes after a smooth impact: it reverses this share of their
/// tangential velocity [1], from -1, smooth, over 0, sticking, to 1, perfectly rough, and changes spins.
/// Source: Huthmann and Zippelius, Phys. Rev. E 56 (1997) R6275.
void rub(double tangential_restitution, Contact& contact);

}  // namespace hardball
