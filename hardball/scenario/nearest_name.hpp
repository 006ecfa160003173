// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hardball {

/// The one of `names` that is fewest insertions, removals, replacements and exchanges of neighbours away from
/// `word`; of several such, the first. Precondition: there are names.
/// Source: Damerau, Commun. ACM 7 (1964) 171.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

}  // namespace hardball
