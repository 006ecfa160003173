// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hardball {

/// The text as the content of an element or an attribute of XML or HTML. Invalid UTF-8 becomes U+FFFD, and
/// what XML does not allow, such as control characters, is omitted.
std::string xml_escaped(std::string_view text);

}  // namespace hardball
