// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_snapshot_reader.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

/// Writes a table of comma-separated values (CSV), with a line for each sphere under the names of the columns
/// (see SphereColumns).
TextFrame csv_frame();

/// Tables of numbers under the names of columns (see known_columns), separated by commas, semicolons, tabs or
/// blanks. Lines that begin with # are ignored, unless the table has no other names: then the last such line
/// that names x, y and z does. Values may be in quotes, and numbers may have decimal commas where something
/// else separates them. Error, located by file:line:column: see SphereColumns.
TextFormat csv_format();

}  // namespace hardball
