// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "hardball/errors/export.hpp"
#include "hardball/io/file_position.hpp"
#include "hardball/platform/files.hpp"

namespace hardball {

/// A file being written that keeps no partial record when writing fails.
///
/// Its writer marks when the file is complete. If something cannot be written, because the disk is full, say,
/// the file is truncated to the last complete state and closed.
class HARDBALL_EXPORT OutputFile {
 public:
  /// Creates the file, or empties it if there is one; one that has other names keeps its contents under
  /// these. Error: it cannot be opened for writing; it is a symbolic link.
  explicit OutputFile(std::filesystem::path path);

  /// Opens an existing file to continue from a position; the rest is cut off as soon as something is
  /// appended, and not before: so that several files can be opened, or none is changed. The first `head`
  /// bytes are those that are overwritten as the file grows. Error: it cannot be opened for writing, is
  /// shorter, or contains something else there.
  OutputFile(std::filesystem::path path, const FilePosition& position, std::uint64_t head = 0);

  const std::filesystem::path& path() const { return path_; }
  bool is_open() const { return file_.is_open(); }
  /// The bytes appended so far.
  std::uint64_t size() const { return written_ + pending_.size(); }

  /// Appends bytes; they are buffered until there are many, or until the next flush.
  /// Error (RunFailure): they cannot be written.
  void append(std::string_view bytes);

  /// Replaces bytes at `offset`. Precondition: that part has been flushed. Error (RunFailure): as for append.
  void overwrite(std::uint64_t offset, std::string_view bytes);

  /// Hands all bytes to the operating system. Error (RunFailure): as for append.
  void flush();

  /// Flushes, and marks the file as complete. Error (RunFailure): as for append.
  void flush_complete();

  /// Marks the file as complete, and waits until it is on the disk. Error (RunFailure): as for append.
  void sync();

  /// Marks the file as complete, waits until it is on the disk, and returns how to continue from here. Error
  /// (RunFailure): as for append.
  FilePosition position(std::uint64_t head = 0);

  /// Flushes the file as complete and closes it; does nothing if it is closed. Error (RunFailure): as for
  /// append. Without it, destruction leaves the file as of the last flush_complete.
  void close();

  ~OutputFile();
  OutputFile(OutputFile&&) noexcept;

 private:
  void require_open() const;
  void cut_off();
  void write(std::string_view bytes);
  void truncate() noexcept;
  [[noreturn]] void fail();

  std::filesystem::path path_;
  platform::File file_;
  std::string pending_;
  std::uint64_t written_ = 0;   // bytes handed to the operating system
  std::uint64_t complete_ = 0;  // bytes of the file when last complete
  bool is_too_long_ = false;    // the file has bytes that are to be cut off
};

}  // namespace hardball
