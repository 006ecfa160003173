// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/errors/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace hardball::error_test {
namespace {

TEST(Error, SaysWhereWhatAndTheRemedyInOneLine) {
  const Error error("radius is -1", "line 3", "give a positive number");
  EXPECT_EQ(error.problem(), "radius is -1");
  EXPECT_EQ(error.where(), "line 3");
  EXPECT_EQ(error.remedy(), "give a positive number");
  EXPECT_STREQ(error.what(), "line 3: radius is -1; give a positive number");
}

TEST(Check, ThrowsAndNamesTheFailedCondition) {
  EXPECT_NO_THROW(HARDBALL_CHECK(1 + 1 == 2));
  try {
    HARDBALL_CHECK(1 + 1 == 3);
    FAIL();
  } catch (const BrokenInvariant& fault) {
    EXPECT_NE(std::string(fault.what()).find("1 + 1 == 3"), std::string::npos);
    EXPECT_NE(std::string(fault.what()).find("error_test.cpp"), std::string::npos);
  }
}

TEST(ToText, IsTheShortestThatReadsBackAsTheSameNumber) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(1e60), "1e+60");
  EXPECT_EQ(to_text(-2.0), "-2");
  EXPECT_EQ(to_text(7), "7");
  EXPECT_EQ(to_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(to_text(std::copysign(std::nan(""), -1)), "nan");
  for (const double number :
       {1.0 / 3, 2.2250738585072014e-308, 1.7976931348623157e308, 123456789.123456789}) {
    EXPECT_EQ(std::stod(to_text(number)), number);
  }
}

TEST(Error, IsShortWhateverItQuotes) {
  EXPECT_EQ(shortened("word"), "word");
  EXPECT_EQ(shortened(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(shortened(std::string(61, 'a')), std::string(57, 'a') + "...");
  // Characters of UTF-8 stay whole.
  std::string umlauts;
  for (int i = 0; i < 40; ++i) umlauts += "\xC3\xA4";
  EXPECT_EQ(shortened(umlauts), umlauts.substr(0, 56) + "...");
  const std::string endless(1'000'000, 'a');
  EXPECT_LT(std::string(Error(endless, endless, endless).what()).size(), 15'000U);
}

}  // namespace
}  // namespace hardball::error_test
