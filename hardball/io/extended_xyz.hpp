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

/// Adds a frame that shows all spheres of `world` at `moment` to an extended XYZ file, for OVITO, ASE and
/// read_snapshot. Error (RunFailure): the file cannot be written; it then ends with the frame before.
///
/// Numbers are written with as many digits as it takes to read back the same bits. Centres are folded into a
/// periodic box; `map_shift` counts the boxes folded away. Along open axes the lattice spans the spheres, and
/// the frame says `unbounded=T`.
/// Precondition: no contact lies between the stored paths and `moment`.
void append_snapshot(OutputFile& file, const World& world, const Time& moment);

/// A frame as it was read.
struct Snapshot {
  std::vector<Sphere> spheres;     ///< By rising id if the file has ids, otherwise as they stand.
  std::vector<std::size_t> lines;  ///< Of each sphere, the line of the file.
  std::optional<double> time;      ///< The frame's Time, if it has one [T].
};

/// Reads the last frame of an extended XYZ file, the one from which a run goes on. Frames before it are
/// skipped.
///
/// The columns `pos:R:3`, `velo:R:3` and `radius:R:1` are needed, in any order; `mass:R:1` (otherwise 1) and
/// `id:I:1` are used if they are there, and others are passed over.
/// Error, with file:line:column as its place: the file cannot be read, a column is missing, a line has too
/// few values, a value is no finite number, an id occurs twice, the last frame is not complete.
Snapshot read_snapshot(const std::filesystem::path& path);

/// The same from a stream that can be rewound; `name` stands for the file in messages.
Snapshot read_snapshot(std::istream& in, const std::string& name);

}  // namespace hardball
