// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hardball/errors/language.hpp"

namespace hardball {

/// How far a file has been written, and what its end contains: what is needed to continue it.
struct FilePosition {
  std::uint64_t bytes = 0;  ///< Length of the file.
  std::optional<std::uint64_t> checksum =
      {};  ///< Checksum of its last bytes, kSummedBytes at most; unknown for devices.

  friend bool operator==(const FilePosition&, const FilePosition&) = default;
  static void persist(auto& archive, auto& self) { archive(self.bytes, self.checksum); }
};

}  // namespace hardball
