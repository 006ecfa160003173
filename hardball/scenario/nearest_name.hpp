// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "hardball/errors/language.hpp"

namespace hardball {

/// What to write instead of `word`: the nearest of `names` if `word` may be a misspelling of it, otherwise
/// all of them. An edit is an insertion, a removal, a replacement or a swap of adjacent letters; of several
/// names equally near, the first is suggested. Each name is put between `quote`. Precondition: there are
/// names. Source: Damerau, Commun. ACM 7 (1964) 171.
std::string suggestion(std::string_view word, std::span<const std::string_view> names, char quote = '\'');

}  // namespace hardball
