// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hardball::viewer {

/// The web page as it was built from apps/viewer/page: index.html, which refers to the two others as page.css
/// and page.js by one element each.
struct Page {
  std::string_view index;
  std::string_view style;
  std::string_view script;
};

/// The index with the token in the addresses of style and script. Error (BrokenInvariant): it lacks one of
/// them.
std::string with_token(const Page& page, const std::string& token);

/// The page in one piece, style and script inside, parted where a recording goes in: an element of its own
/// before the script. Error (BrokenInvariant): as for with_token.
struct OnePiece {
  explicit OnePiece(const Page& page);

  std::string head;  ///< Up to the recording, the tag that opens its element included.
  std::string tail;  ///< From the tag that closes it on.
};

}  // namespace hardball::viewer
