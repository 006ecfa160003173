// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "hardball/errors/export.hpp"
#include "hardball/trajectory/frame_writer.hpp"
#include "hardball/trajectory/snapshot_format.hpp"

namespace hardball {

/// A trajectory being written: the spheres at a sequence of moments, in the format that its name says.
///
/// After every frame the file is complete; if a frame cannot be written, it ends with the one before. Writing
/// looks at the world and changes nothing.
class HARDBALL_EXPORT Trajectory {
 public:
  /// Creates the file, or replaces it if there is one. Error: it cannot be opened for writing; its name does
  /// not say what format it has.
  explicit Trajectory(const std::filesystem::path& path);
  /// Continues where the trajectory was at `position`; what follows is cut off as soon as anything is called,
  /// and not before. Error: it cannot be opened for writing; it is shorter, or contains something else there.
  Trajectory(const std::filesystem::path& path, const TrajectoryPosition& position);

  /// Continues a file after its last frame. Error: as above; its last frame is damaged; its format cannot be
  /// read, or has a single frame. Cost: that of counting its frames.
  static Trajectory after_last_frame(const std::filesystem::path& path);

  /// Appends a frame. Precondition: no contact lies between the stored paths and `moment`; a file with a
  /// single frame has none yet. Cost: O(n). Error (RunFailure): it cannot be written.
  void append(const World& world, const Time& moment);
  void append(const Snapshot& snapshot);
  /// Appends a frame whose spheres come in parts. Error: the format needs all spheres at once. Error
  /// (RunFailure): it cannot be written.
  void append(const FrameParts& parts);

  /// Hands to the operating system what readers need to find all frames. Error (RunFailure): it cannot be
  /// written.
  void flush();
  /// Completes the file for readers and closes it; does nothing if it is closed. Error (RunFailure): it
  /// cannot be written.
  void close();

  /// Waits until all frames are on the disk, and returns where they end. Error (RunFailure): as for flush.
  TrajectoryPosition position();

  /// Removes a trajectory and, of those that consist of several files, all of them. Errors are ignored.
  static void remove(const std::filesystem::path& path);

 private:
  std::uint64_t frames_ = 0;
  SnapshotFormat format_;
  std::unique_ptr<FrameWriter> writer_;
};

}  // namespace hardball
