// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/token.hpp"

#include <gtest/gtest.h>

#include <set>

namespace hardball::viewer::token_test {
namespace {

TEST(Token, HasThirtyTwoDigitsAndIsUnique) {
  std::set<std::string> tokens;
  for (int k = 0; k < 100; ++k) {
    const std::string token = make_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    tokens.insert(token);
  }
  EXPECT_EQ(tokens.size(), 100U);
}

TEST(Token, SecretsAreComparedWhole) {
  EXPECT_TRUE(is_same_secret("", ""));
  EXPECT_TRUE(is_same_secret("abc", "abc"));
  EXPECT_FALSE(is_same_secret("abc", "abd"));
  EXPECT_FALSE(is_same_secret("abc", "bbc"));
  EXPECT_FALSE(is_same_secret("abc", "ab"));
  EXPECT_FALSE(is_same_secret("abc", ""));
}

}  // namespace
}  // namespace hardball::viewer::token_test
