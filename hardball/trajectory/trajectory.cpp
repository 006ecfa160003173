// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/trajectory.hpp"

#include <system_error>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/gsd_trajectory.hpp"
#include "hardball/trajectory/npy_snapshot.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/text_formats.hpp"
#include "hardball/trajectory/text_trajectory.hpp"
#include "hardball/trajectory/vtp_trajectory.hpp"

namespace hardball {
namespace {

std::unique_ptr<FrameWriter> make_writer(const std::filesystem::path& path, SnapshotFormat format,
                                         const std::optional<TrajectoryPosition>& position) {
  const auto text = [&](const TextFrame& frame) {
    return std::make_unique<TextTrajectory>(path, frame, is_compressed(path), position);
  };
  switch (format) {
    case SnapshotFormat::extended_xyz:
    case SnapshotFormat::extended_xyz_zst:
      return text(extended_xyz_frame());
    case SnapshotFormat::gsd:
      return std::make_unique<GsdTrajectory>(path, position);
    case SnapshotFormat::lammps:
      return text(lammps_dump_frame());
    case SnapshotFormat::vtp:
      return std::make_unique<VtpTrajectory>(path, position);
    case SnapshotFormat::csv:
      return text(csv_frame());
    case SnapshotFormat::npy:
      return text(npy_frame());
    case SnapshotFormat::sph:
      return text(sph_frame());
    case SnapshotFormat::lammps_data:
      return text(lammps_data_frame());
  }
  return nullptr;
}

}  // namespace

Trajectory::Trajectory(const std::filesystem::path& path)
    : format_(format_of(path)), writer_(make_writer(path, format_, {})) {}

Trajectory::Trajectory(const std::filesystem::path& path, const TrajectoryPosition& position)
    : frames_(position.frames), format_(format_of(path)), writer_(make_writer(path, format_, position)) {}

Trajectory Trajectory::after_last_frame(const std::filesystem::path& path) {
  if (has_single_frame(format_of(path)))
    throw Error("files of this format have a single frame", path.string(),
                "write another file for each frame");
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(path);
  static_cast<void>(reader->read(reader->frames() - 1));
  return {path, {.frames = reader->frames(), .file = {.bytes = std::filesystem::file_size(path)}}};
}

void Trajectory::append(const World& world, const Time& moment) {
  append(snapshot_of(world, moment));
}

void Trajectory::append(const Snapshot& snapshot) {
  HARDBALL_CHECK(frames_ == 0 || !has_single_frame(format_));
  writer_->append(snapshot, frames_);
  ++frames_;
}

void Trajectory::append(const FrameParts& parts) {
  HARDBALL_CHECK(frames_ == 0 || !has_single_frame(format_));
  writer_->append(parts, frames_);
  ++frames_;
}

void Trajectory::flush() {
  writer_->flush();
}

void Trajectory::close() {
  writer_->close();
}

TrajectoryPosition Trajectory::position() {
  TrajectoryPosition position = writer_->position();
  position.frames = frames_;
  return position;
}

void Trajectory::remove(const std::filesystem::path& path) {
  std::error_code ignored;
  if (format_of(path) == SnapshotFormat::vtp) {
    VtpTrajectory::remove(path);
  } else {
    std::filesystem::remove(path, ignored);
  }
}

}  // namespace hardball
