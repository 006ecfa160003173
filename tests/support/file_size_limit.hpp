// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#if !defined(_WIN32)
#include <sys/resource.h>
#endif

#include <csignal>
#include <cstdint>

namespace hardball::support {

/// While it exists, no file may exceed so many bytes, on systems that can see to that.
class FileSizeLimit {
 public:
#if defined(_WIN32)
  explicit FileSizeLimit(std::uint64_t /*bytes*/) {}
#else
  explicit FileSizeLimit(std::uint64_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
  }
#endif
  FileSizeLimit(const FileSizeLimit&) = delete;

 private:
#if !defined(_WIN32)
  rlimit before_{};
#endif
};

}  // namespace hardball::support
