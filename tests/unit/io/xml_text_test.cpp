// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/xml_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace hardball::xml_text_test {
namespace {

TEST(XmlEscaped, KeepsTextAndEscapesMarkup) {
  EXPECT_EQ(xml_escaped("σ = 2r, 𝜑\n\tend"), "σ = 2r, 𝜑\n\tend");
  EXPECT_EQ(xml_escaped("<a href=\"x\">&amp;</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;amp;&lt;/a&gt;");
}

TEST(XmlEscaped, OmitsWhatXmlDoesNotAllow) {
  EXPECT_EQ(xml_escaped(std::string("a\0b\x1b\r\x7f", 6)), "ab\x7f");
  EXPECT_EQ(xml_escaped("a\uFFFEb\uFFFFc\uFFFD"), "abc\uFFFD");
}

TEST(XmlEscaped, ReplacesInvalidUtf8) {
  const std::string mark = "\uFFFD";
  EXPECT_EQ(xml_escaped("caf\xe9"), "caf" + mark) << "Latin-1";
  EXPECT_EQ(xml_escaped("\xe2\x82"), mark + mark) << "truncated";
  EXPECT_EQ(xml_escaped("\xc0\xbc"), mark + mark) << "an overlong form of <";
  EXPECT_EQ(xml_escaped("\xe0\x80\xbc"), mark + mark + mark) << "a longer one";
  EXPECT_EQ(xml_escaped("\xed\xa0\x80"), mark + mark + mark) << "half of a surrogate pair";
  EXPECT_EQ(xml_escaped("\xf4\x90\x80\x80"), mark + mark + mark + mark) << "beyond the last code point";
  EXPECT_EQ(xml_escaped("\xff<"), mark + "&lt;");
}

}  // namespace
}  // namespace hardball::xml_text_test
