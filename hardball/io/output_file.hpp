// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace hardball {

/// A file being written, of which nothing half written remains when writing fails.
///
/// Its writer says whenever the file is whole. Once something cannot be written, as when the disk is full,
/// the file is cut back to where it was whole last, and closed.
class OutputFile {
 public:
  /// Creates the file, or empties it if there is one. Error: it cannot be opened for writing.
  explicit OutputFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  bool is_open() const { return file_ != nullptr; }

  /// Adds bytes at the end; they reach the file when many have gathered, or at the next flush.
  /// Error (RunFailure): they cannot be written.
  void append(std::string_view bytes);

  /// Replaces bytes at `offset`. Precondition: that part has been flushed. Error (RunFailure): as for append.
  void overwrite(std::uint64_t offset, std::string_view bytes);

  /// Hands all bytes to the operating system. Error (RunFailure): as for append.
  void flush();

  /// Says that the file is whole as it is now, after a flush. Error (RunFailure): as for append.
  void flush_whole();

  /// Flushes the file as whole and closes it; does nothing if it is closed. Error (RunFailure): as for
  /// append. Without it, destruction leaves the file whole as of the last flush_whole.
  void close();

  ~OutputFile();
  OutputFile(OutputFile&&) noexcept = default;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void write(std::string_view bytes);
  void cut_back() noexcept;
  [[noreturn]] void fail();

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string pending_;
  std::uint64_t written_ = 0;  // bytes handed to the operating system
  std::uint64_t whole_ = 0;    // bytes of the file when it was whole last
};

}  // namespace hardball
