// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/page.hpp"

#include "hardball/errors/error.hpp"

namespace hardball::viewer {
namespace {

constexpr std::string_view kStyleFile = "page.css";
constexpr std::string_view kScriptFile = "page.js";

// The offset of `part` in the text. Error (BrokenInvariant): nowhere, or twice.
std::size_t find_only(std::string_view text, std::string_view part) {
  const std::size_t at = text.find(part);
  HARDBALL_CHECK(at != std::string_view::npos && text.find(part, at + 1) == std::string_view::npos);
  return at;
}

void replace_all(std::string& text, std::string_view part, std::string_view replacement) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + replacement.size())) {
    text.replace(at, part.size(), replacement);
  }
}

// The range of text from the tag that names a file to the end of its element.
struct Element {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Element element_with(std::string_view index, std::string_view file, std::string_view closing) {
  const std::size_t name = find_only(index, file);
  const std::size_t begin = index.rfind('<', name);
  const std::size_t end = index.find(closing, name);
  HARDBALL_CHECK(begin != std::string_view::npos && end != std::string_view::npos);
  return {begin, end + closing.size()};
}

// In a script, these would end the element or open a comment.
std::string for_script_element(std::string_view script) {
  std::string text(script);
  replace_all(text, "</script", "<\\/script");
  replace_all(text, "<!--", "<\\!--");
  return text;
}

}  // namespace

std::string with_token(const Page& page, const std::string& token) {
  std::string index(page.index);
  for (const std::string_view file : {kStyleFile, kScriptFile}) {
    index.insert(find_only(index, file) + file.size(), "?token=" + token);
  }
  return index;
}

OnePiece::OnePiece(const Page& page) {
  const Element style = element_with(page.index, kStyleFile, ">");
  const Element script = element_with(page.index, kScriptFile, "</script>");
  HARDBALL_CHECK(style.end <= script.begin);
  // The tag without its address.
  std::string opening(page.index.substr(script.begin, page.index.find('>', script.begin) + 1 - script.begin));
  const std::string address = " src=\"" + std::string(kScriptFile) + "\"";
  opening.erase(find_only(opening, address), address.size());
  head = std::string(page.index.substr(0, style.begin)) + "<style>" + std::string(page.style) + "</style>" +
         std::string(page.index.substr(style.end, script.begin - style.end)) +
         "<script type=\"application/octet-stream\" id=\"recording\">";
  tail = "</script>\n" + opening + for_script_element(page.script) + "</script>" +
         std::string(page.index.substr(script.end));
}

}  // namespace hardball::viewer
