// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "hardball/errors/language.hpp"

namespace hardball {

/// How far a file has been written, and what its end contains: what is needed to continue it.
struct FilePosition {
  std::uint64_t bytes = 0;  ///< Its length.
  std::optional<std::uint64_t> checksum =
      {};  ///< Of its last bytes, kSummedBytes at most; not known of devices.

  friend bool operator==(const FilePosition&, const FilePosition&) = default;
  static void persist(auto& archive, auto& self) { archive(self.bytes, self.checksum); }
};

}  // namespace hardball
