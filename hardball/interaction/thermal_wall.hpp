// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/interaction/contact.hpp"

namespace hardball {

/// The velocity with which a sphere leaves a thermal wall [L/T]: that of a gas at the wall's temperature that
/// effuses from it. Relative to the wall, components along it are normally distributed, and the one away from
/// it has a density proportional to u exp(-m u^2 / 2 k T).
///
/// The random numbers are a function of the material's seed, the sphere and the time of contact, so that they
/// do not depend on what else happens, or on the engine. Precondition: the material has a temperature.
/// Source: Tehver, Toigo, Koplik and Banavar, Phys. Rev. E 57 (1998) R17.
Vec3 rethermalized(const Contact& contact);

}  // namespace hardball
