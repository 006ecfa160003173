// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hardball::viewer {

/// The web page as built from apps/viewer/page: index.html, which refers to page.css and page.js by one
/// element each.
struct Page {
  std::string_view index;
  std::string_view style;
  std::string_view script;
};

/// The index with the token in the addresses of style and script. Error (BrokenInvariant): it lacks one of
/// them.
std::string with_token(const Page& page, const std::string& token);

/// The page in one file, with style and script inside, split where a recording is inserted as an element
/// before the script. Error (BrokenInvariant): as for with_token.
struct OnePiece {
  explicit OnePiece(const Page& page);

  std::string head;  ///< Up to the recording, including the opening tag of its element.
  std::string tail;  ///< From the closing tag on.
};

}  // namespace hardball::viewer
