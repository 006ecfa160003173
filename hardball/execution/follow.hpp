// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/interaction/contact.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Lets a contact that was executed in another world happen to the same spheres in this one. Precondition:
/// all contacts before it have happened here; no spheres merge in it. Cost: that of World::slot_of.
void follow(World& world, const Contact& contact);

}  // namespace hardball
