// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "hardball/io/output_file.hpp"
#include "hardball/response/contact.hpp"

namespace hardball {

/// Writes every collision and wall contact to a NumPy file: one structured array, for numpy.load.
///
/// The fields, packed and little-endian:
/// - `t` f8: when [T];
/// - `i` u4: the sphere; for a collision, the one with the lower id;
/// - `j` i4: the other sphere, or -(number + 1) for a wall (see Face);
/// - `kind` u1: 0 a collision, 1 a wall;
/// - `impulse` 3 f8: the momentum that `i` gained [M L/T];
/// - `normal_speed` f8: the speed at which the surfaces met [L/T].
///
/// The file can be read while it grows, and after a run that failed: every flush updates the record count in
/// the header, which has 256 bytes. Source: NumPy enhancement proposal 1, format version 1.0.
class NpyEventLog {
 public:
  /// Creates the file. Error: it cannot be opened for writing.
  explicit NpyEventLog(std::filesystem::path path);
  /// Opens a file written before to go on after its first `size` records; the rest is cut off as soon as
  /// one follows. Error: it cannot be opened for writing, or is shorter.
  NpyEventLog(std::filesystem::path path, std::uint64_t size);

  /// Precondition: ids are below 2^31. Error (RunFailure): the file cannot be written.
  void append(const Contact& contact);

  /// Completes the file for readers, as happens automatically every few megabytes; a caller with a clock does
  /// it more often. Error (RunFailure): as for append.
  void flush();

  /// The same, and waits until all is on the disk. Error (RunFailure): as for append.
  void sync();

  /// Completes and closes the file; does nothing if it is closed. Error (RunFailure): as for append.
  void close();

  /// Closes the file as far as possible; errors are ignored.
  ~NpyEventLog();
  NpyEventLog(NpyEventLog&&) noexcept = default;

  std::uint64_t size() const { return size_; }

 private:
  OutputFile file_;
  std::uint64_t size_ = 0;
  std::uint64_t counted_ = 0;  // by the header
};

}  // namespace hardball
