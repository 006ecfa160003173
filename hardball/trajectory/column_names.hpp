// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/trajectory/text_lines.hpp"

namespace hardball {

/// The names of a table's columns, those that mean a quantity of a sphere as SphereColumns calls it.
///
/// Case, blanks, punctuation and units in brackets do not matter. Components of vectors may be numbered from
/// zero, as ParaView writes them. `X [m]`, `Points:0`, `pos_x` and `X Position` become `x`; `velocity:1` and
/// `VelY` become `vy`. If several columns mean the same, the one with the plainest name counts, and the
/// others keep their names. The text of new names is static. Error, at `where`: two names are equal in this
/// sense.
std::vector<Token> known_columns(std::vector<Token> names, const TextLocation& where);

}  // namespace hardball
