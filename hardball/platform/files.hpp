// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace hardball::platform {

/// How a file is opened.
enum class Access {
  read,        ///< One that exists, to be read.
  write,       ///< One that exists, to be written.
  create,      ///< To be written; created if there is none. A symbolic link is not followed.
  create_new,  ///< To be written, if there is none yet. A symbolic link is not followed.
};

/// An open file of the operating system: bytes as they are, without a buffer, in no other process that this
/// one starts. Where a function returns false, errno says why.
class File {
 public:
  /// No file.
  File() = default;
  /// Opens a file; if that is impossible, it is not open, and errno says why.
  File(const std::filesystem::path& path, Access access);
  /// Closes the file, and keeps errno.
  ~File();
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;

  bool is_open() const { return descriptor_ >= 0; }
  /// The number of names of a regular file; 0 of a device or a pipe.
  std::uint64_t names() const;
  /// Reads at most `most` bytes from `offset` on, in any thread, and returns their number; negative, with
  /// errno, if that is impossible.
  std::ptrdiff_t read_at(std::uint64_t offset, char* bytes, std::size_t most) const;
  /// Writes all bytes at its place, which moves behind them.
  bool write(std::string_view bytes);
  /// Moves its place to `offset` bytes from the begin.
  bool seek(std::uint64_t offset);
  /// Cuts it off, or fills it with zeros, so that it has this length.
  bool resize(std::uint64_t bytes);
  /// Returns when all is on the disk.
  bool sync();
  bool close();

 private:
  int descriptor_ = -1;
};

/// Removes the name of a file; if that is impossible, returns false, with errno.
bool remove_file(const std::filesystem::path& path);

/// Gives a file another name, in one step, and removes the file that had it; returns when the names are on
/// the disk, where the system can say so. If that is impossible, returns false, with errno.
bool rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Creates an empty file for this process among those that are temporary; nothing, with errno, if that is
/// impossible.
std::filesystem::path create_temporary_file(const std::filesystem::path& folder);

/// A file that exists while this object does, and that one process at a time can hold: others can when it
/// ends, however it ends.
class LockFile {
 public:
  /// What has become of it.
  enum class State {
    held,
    held_by_another,  ///< Another process, or object, holds it.
    not_created,      ///< The file cannot be opened, as errno says.
    not_locked,       ///< The file cannot be locked, as errno says.
  };

  explicit LockFile(const std::filesystem::path& path);
  /// Removes the file.
  ~LockFile();
  LockFile(LockFile&& other) noexcept;
  LockFile& operator=(LockFile&&) = delete;

  State state() const { return state_; }

 private:
  std::filesystem::path path_;
  std::intptr_t file_ = -1;
  State state_ = State::not_created;
};

}  // namespace hardball::platform
