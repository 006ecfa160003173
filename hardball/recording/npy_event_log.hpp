// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/io/npy_header.hpp"
#include "hardball/io/output_file.hpp"

namespace hardball {

/// The field that holds the times, if the array of a NumPy file is an event log; otherwise null.
HARDBALL_EXPORT const NpyField* time_in_event_log(const NpyHeader& header);

/// How far an event log has been written: what is needed to truncate and continue it.
struct EventLogPosition {
  std::uint64_t records = 0;
  std::optional<std::uint64_t> checksum = {};  ///< Checksum of the last records; unknown for devices.

  friend bool operator==(const EventLogPosition&, const EventLogPosition&) = default;
  static void persist(auto& archive, auto& self) { archive(self.records, self.checksum); }
};

/// Writes every collision and wall contact to a NumPy file: one structured array, for numpy.load.
///
/// The fields, packed and little-endian, have the names and values that they have in Contact:
/// - `time` f8: when [T];
/// - `first` u4: the sphere; for a collision, the one with the lower id;
/// - `second` u4: the other sphere or, for a wall, its number (see Face);
/// - `kind` u1: 0 a collision, 1 a wall;
/// - `impulse` 3 f8: the momentum that `first` gained [M L/T];
/// - `normal_speed` f8: the speed at which the surfaces met [L/T].
///
/// The file can be read while it grows, and after a run that failed: every flush updates the record count in
/// the header, which has 256 bytes. Source: NumPy enhancement proposal 1, format version 1.0.
class HARDBALL_EXPORT NpyEventLog {
 public:
  /// Creates the file. Error: it cannot be opened for writing.
  explicit NpyEventLog(std::filesystem::path path);
  /// Opens an existing file to continue from a position; the rest is cut off as soon as anything is called,
  /// and not before. Error: it cannot be opened for writing, is shorter, contains something else there, or is
  /// no NumPy file.
  NpyEventLog(const std::filesystem::path& path, const EventLogPosition& position);

  /// Precondition: ids are below 2^31. Error (RunFailure): the file cannot be written.
  void append(const Contact& contact);

  /// Completes the file for readers, as happens automatically every few megabytes; a caller with a clock does
  /// it more often. Error (RunFailure): as for append.
  void flush();

  /// Completes the file for readers, waits until all is on the disk, and returns how to continue from here.
  /// Error (RunFailure): as for append.
  EventLogPosition position();

  /// Completes and closes the file; does nothing if it is closed. Error (RunFailure): as for append.
  void close();

  /// Closes the file as far as possible; errors are ignored.
  ~NpyEventLog();
  NpyEventLog(NpyEventLog&&) noexcept = default;

  std::uint64_t size() const { return size_; }

 private:
  OutputFile file_;
  std::uint64_t size_ = 0;
  std::uint64_t counted_ = 0;        // by the header
  bool may_count_too_many_ = false;  // the header, if the file continues beyond the position
};

}  // namespace hardball
