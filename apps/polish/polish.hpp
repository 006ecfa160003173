// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hardball/memory/function.hpp"
#include "hardball/packing/packing.hpp"

namespace hardball::polish {

/// Removes the last gaps between the spheres of a packing that has jammed: moves and enlarges them by a
/// sequence of linear programs, until those that bear force touch to 1e-12 of a diameter, as many as hold a
/// packing with one state of stress. Contacts and forces of the network become those of the last program;
/// forces are its multipliers. No program makes the packing less dense; if they do not end with spheres that
/// touch, the packing stays as it was, with a warning. Calls `on_round(rounds so far)` before each program;
/// if it throws, the packing is as it was. Error: the packing has not jammed. Cost: that of some ten linear
/// programs, O(n^2) or more each. Source: Torquato and Jiao, Phys. Rev. E 82 (2010) 061302; Donev, Torquato,
/// Stillinger and Connelly, J. Comput. Phys. 197 (2004) 139.
void polish(Packing& packing, const Function<void(int)>& on_round = {});

}  // namespace hardball::polish
