// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "hardball/io/output_file.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Appends a frame with all spheres of `world` at `moment` to an extended XYZ file, for OVITO, ASE and
/// read_snapshot. Error (RunFailure): the file cannot be written; it then ends with the previous frame.
///
/// Numbers have as many digits as needed to read back the same bits. Centres are folded into a periodic box;
/// `map_shift` counts the boxes. Along open axes the lattice spans the spheres, and the frame says
/// `unbounded=T`. Precondition: no contact lies between the stored paths and `moment`.
void append_snapshot(OutputFile& file, const World& world, const Time& moment);

/// A frame as read.
struct Snapshot {
  std::vector<Sphere> spheres;     ///< By ascending id if the file has ids, otherwise in file order.
  std::vector<std::size_t> lines;  ///< The line of each sphere in the file.
  std::optional<double> time;      ///< The frame's Time, if it has one [T].
};

/// Reads the last frame of an extended XYZ file, from which a run can start. Earlier frames are skipped.
///
/// The columns `pos:R:3`, `velo:R:3` and `radius:R:1` are required, in any order; `mass:R:1` (default 1) and
/// `id:I:1` are optional, and others are ignored. Error, located by file:line:column: the file cannot be
/// read, a column is missing, a line has too few values, a value is not a finite number, an id occurs twice,
/// the last frame is incomplete.
Snapshot read_snapshot(const std::filesystem::path& path);

/// The same from a seekable stream; `name` names it in messages.
Snapshot read_snapshot(std::istream& in, const std::string& name);

}  // namespace hardball
