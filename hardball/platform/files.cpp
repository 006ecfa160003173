// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/platform/files.hpp"

#include <cerrno>
#include <utility>

namespace hardball::platform {

File::~File() {
  const int reason = errno;
  close();
  errno = reason;
}

File::File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

File& File::operator=(File&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

LockFile::LockFile(LockFile&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), state_(other.state_) {}

}  // namespace hardball::platform
