// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hardball::viewer {

/// A secret that cannot be guessed: 128 random bits from the operating system, as 32 hexadecimal digits.
std::string make_token();

/// Whether two texts are the same, compared in constant time.
bool is_same_secret(std::string_view a, std::string_view b);

}  // namespace hardball::viewer
