// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "hardball/trajectory/frame_writer.hpp"

namespace hardball {

/// Writes frames for ParaView: each a file of VTK's PolyData in a folder, in the order of their numbers, and
/// a collection (PVD) that lists them with their times.
///
/// A VTP file has points and, for each, the arrays `radius`, `velocity`, `id`, `type`, `mass`, `image`, where
/// types are finer than species `species_id` and, where spheres spin, `angular_velocity` and `moment`, all
/// numbers in double precision; the field data `TimeValue`. The collection is replaced as a whole, so that it
/// is never incomplete: by every frame at first, later by every eighth part of them, and by flush().
class VtpTrajectory final : public FrameWriter {
 public:
  /// `path`: of the collection; the folder bears its name without extension. Creates both, or continues from
  /// a position. Error: they cannot be written; there are fewer frames, or others.
  explicit VtpTrajectory(std::filesystem::path path, const std::optional<TrajectoryPosition>& position = {});
  ~VtpTrajectory() override;

  void append(const Snapshot& snapshot, std::uint64_t frame) override;
  void flush() override;
  TrajectoryPosition position() override;
  void close() override { flush(); }

  /// The folder that goes with a collection.
  static std::filesystem::path folder_of(const std::filesystem::path& path);
  /// Removes the collection and its frames; other files stay, and the folder with them.
  static void remove(const std::filesystem::path& path);

 private:
  void find_first(const TrajectoryPosition& position);
  void cut_back();
  std::uint64_t checksum() const;

  std::filesystem::path path_;
  std::string entries_;  // of the collection
  std::uint64_t frames_ = 0;
  std::uint64_t listed_ = 0;  // in the file
  std::uint64_t synced_ = 0;  // of which it is known that they are on the disk
  bool is_too_long_ = false;  // there may be frames that are to be removed
};

}  // namespace hardball
