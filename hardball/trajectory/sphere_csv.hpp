// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_snapshot_reader.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

/// Writes a table of comma-separated values (CSV), with a line for each sphere under the names of the columns
/// (see SphereColumns).
void append_csv(const Snapshot& snapshot, std::uint64_t frame, const AppendText& append);

/// Such a table; lines that begin with # are ignored. Error, located by file:line:column: see SphereColumns.
TextFormat csv_format();

}  // namespace hardball
