// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace hardball {

/// By which a file is known again when a run is resumed: the XXH64 of the bytes.
std::uint64_t checksum_of(std::string_view bytes);

/// How much of the end of a file is summed for that, so that longer files do not take longer to continue.
inline constexpr std::uint64_t kSummedBytes = std::uint64_t{1} << 20;

}  // namespace hardball
