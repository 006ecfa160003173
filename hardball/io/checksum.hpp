// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace hardball {

/// The XXH64 of the bytes, by which a file is recognized when a run is resumed.
std::uint64_t checksum_of(std::string_view bytes);

/// How many bytes at the end of a file are summed, so that longer files do not take longer to continue.
inline constexpr std::uint64_t kSummedBytes = std::uint64_t{1} << 20;

}  // namespace hardball
