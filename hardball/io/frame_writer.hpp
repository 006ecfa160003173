// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/io/snapshot.hpp"

namespace hardball {

/// Writes the frames of a file, whatever its format.
class FrameWriter {
 public:
  virtual ~FrameWriter() = default;

  /// Appends frame number `frame`, so that readers find it. Error (RunFailure): it cannot be written; the
  /// file then ends with the previous frame.
  virtual void append(const Snapshot& snapshot, std::uint64_t frame) = 0;
  /// Makes what tells readers of the frames complete, where that is not done with every frame. Error: as
  /// above.
  virtual void flush() {}
  /// Waits until all frames are on the disk, and flushes. Error: as above.
  virtual void sync() = 0;
  /// Completes and closes the file; does nothing if it is closed. Error: as above.
  virtual void close() = 0;
  /// The length of the file, where frames follow each other in it; otherwise zero.
  virtual std::uint64_t bytes() const = 0;
};

}  // namespace hardball
