// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/text_snapshot_reader.hpp"

namespace hardball {

/// Extended XYZ, from which a run can start.
///
/// The columns `pos:R:3`, `velo:R:3` and `radius:R:1` are required, in any order; `mass:R:1` (default 1),
/// `id:I:1`, `type:I:1`, `map_shift:I:3`, `angular_velocity:R:3` and `moment:R:1` are optional, and others
/// are ignored. As ASE has it, `masses:R:1` may stand for `mass`, and `momenta:R:3` with either for `velo`.
/// Error, located by file:line:column: a column is missing, a line has too few values, a value is not a
/// finite number, an id occurs twice, the last frame is incomplete.
TextFormat extended_xyz_format();

}  // namespace hardball
