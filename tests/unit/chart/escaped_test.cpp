// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/chart/escaped.hpp"

#include <gtest/gtest.h>

#include <string>

namespace hardball::chart::escaped_test {
namespace {

TEST(Escaped, KeepsTextAndEscapesMarkup) {
  EXPECT_EQ(escaped("σ = 2r, 𝜑\n\tend"), "σ = 2r, 𝜑\n\tend");
  EXPECT_EQ(escaped("<a href=\"x\">&amp;</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;amp;&lt;/a&gt;");
}

TEST(Escaped, OmitsWhatXmlDoesNotAllow) {
  EXPECT_EQ(escaped(std::string("a\0b\x1b\r\x7f", 6)), "ab\x7f");
  EXPECT_EQ(escaped("a\uFFFEb\uFFFFc\uFFFD"), "abc\uFFFD");
}

TEST(Escaped, ReplacesInvalidUtf8) {
  const std::string mark = "\uFFFD";
  EXPECT_EQ(escaped("caf\xe9"), "caf" + mark) << "Latin-1";
  EXPECT_EQ(escaped("\xe2\x82"), mark + mark) << "truncated";
  EXPECT_EQ(escaped("\xc0\xbc"), mark + mark) << "an overlong form of <";
  EXPECT_EQ(escaped("\xe0\x80\xbc"), mark + mark + mark) << "a longer one";
  EXPECT_EQ(escaped("\xed\xa0\x80"), mark + mark + mark) << "half of a surrogate pair";
  EXPECT_EQ(escaped("\xf4\x90\x80\x80"), mark + mark + mark + mark) << "beyond the last code point";
  EXPECT_EQ(escaped("\xff<"), mark + "&lt;");
}

}  // namespace
}  // namespace hardball::chart::escaped_test
