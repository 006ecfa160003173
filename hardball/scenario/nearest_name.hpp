// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hardball {

/// What to write instead of `word`: the nearest of them, if it is fewer changes away than a
/// slip of the pen makes, otherwise all of them. A change is an insertion, a removal, a replacement or an
/// exchange of neighbours; of several names equally near, the first is meant. `quote` is put about each name.
/// Precondition: there are names. Source: Damerau, Commun. ACM 7 (1964) 171.
std::string suggestion(std::string_view word, std::span<const std::string_view> names, char quote = '\'');

}  // namespace hardball
