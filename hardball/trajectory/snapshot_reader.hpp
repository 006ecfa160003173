// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "hardball/errors/export.hpp"
#include "hardball/trajectory/snapshot.hpp"

namespace hardball {

/// Reads the frames of a file, whatever its format.
///
/// Whatever the file contains, no more memory is allocated than its length justifies.
class HARDBALL_EXPORT SnapshotReader {
 public:
  virtual ~SnapshotReader() = default;

  /// The number of frames, at least one.
  virtual std::size_t frames() const = 0;
  /// A frame; reading them in order is fastest. Precondition: there is one of this number. Error, with its
  /// place in the file: it is not what the format prescribes, or a number cannot be read.
  virtual Snapshot read(std::size_t frame) = 0;
};

/// Opens a file to read its frames, in the format that its name says. Error: it cannot be read; it is not
/// what its name says; it contains no frame; its format cannot be read.
HARDBALL_EXPORT std::unique_ptr<SnapshotReader> open_snapshots(const std::filesystem::path& path);

/// The last frame of a file, from which a run can start. Error: as for open_snapshots and reading.
HARDBALL_EXPORT Snapshot read_snapshot(const std::filesystem::path& path);

}  // namespace hardball
