// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/io/file_position.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/sphere_types.hpp"

namespace hardball {

/// How far a trajectory has been written: what is needed to truncate and continue it.
struct TrajectoryPosition {
  std::uint64_t frames = 0;
  FilePosition file = {};  ///< Without bytes, where frames are in files of their own.
  std::string head =
      {};  ///< The beginning of the file, where it is overwritten as the file grows; otherwise empty.

  friend bool operator==(const TrajectoryPosition&, const TrajectoryPosition&) = default;
  static void persist(auto& archive, auto& self) { archive(self.frames, self.file, self.head); }
};

/// A frame whose spheres come in parts, in the order of ids.
struct FrameParts {
  Snapshot head;                             ///< The snapshot without its spheres.
  std::size_t spheres = 0;                   ///< Number of spheres.
  SphereTypes types;                         ///< Types of all spheres.
  Function<std::optional<Snapshot>()> next;  ///< The next part; nothing at the end.
};

/// Writes the frames of a file, whatever its format. One that continues a file changes nothing in it
/// before the first call.
class HARDBALL_EXPORT FrameWriter {
 public:
  virtual ~FrameWriter() = default;

  /// Appends frame number `frame`, so that readers find it. Error (RunFailure): it cannot be written; the
  /// file then ends with the previous frame.
  virtual void append(const Snapshot& snapshot, std::uint64_t frame) = 0;
  /// Appends frame number `frame`, whose spheres come in parts. Error: the format needs all spheres at once.
  /// Error (RunFailure): it cannot be written.
  virtual void append(const FrameParts& /*parts*/, std::uint64_t /*frame*/) {
    throw Error("its format needs all spheres at once", "trajectory", "choose extended XYZ or a LAMMPS dump");
  }
  /// Completes what readers need to find the frames, where that is not done with every frame. Error
  /// (RunFailure): it cannot be written.
  virtual void flush() {}
  /// Waits until all frames are on the disk, flushes, and returns how to continue from here. Error
  /// (RunFailure): as for flush.
  virtual TrajectoryPosition position() = 0;
  /// Completes and closes the file; does nothing if it is closed. Error (RunFailure): as for flush.
  virtual void close() = 0;
};

}  // namespace hardball
