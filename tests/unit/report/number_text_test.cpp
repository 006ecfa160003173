// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace hardball::report::number_text_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NumberText, SetsNumbersAsInPrint) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-1.25), "−1.25");
  EXPECT_EQ(number_text(1234.5678), "1234.57");
  EXPECT_EQ(number_text(0.00012), "0.00012");
  EXPECT_EQ(number_text(999999), "999999");
  EXPECT_EQ(number_text(987654.3, 4), "987654") << "no digit before the point is lost";
  EXPECT_EQ(number_text(100, 2), "100");
}

TEST(NumberText, SetsPowersOfTenApart) {
  EXPECT_EQ(number_text(3.2e-16, 2), "3.2·10⁻¹⁶");
  EXPECT_EQ(number_text(-1e7), "−1·10⁷");
  EXPECT_EQ(number_text(1234567.5), "1.23457·10⁶");
  EXPECT_EQ(number_text(9.9999e-5, 2), "0.0001") << "rounding precedes the choice of the power";
  EXPECT_EQ(number_text(999999.9, 3), "1·10⁶");
}

TEST(NumberText, SaysWhatIsNoNumber) {
  EXPECT_EQ(number_text(kNone), "–");
  EXPECT_EQ(number_text(kInfinity), "∞");
  EXPECT_EQ(number_text(-kInfinity), "−∞");
}

TEST(CountText, SetsThousandsApart) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1000), "1,000");
  EXPECT_EQ(count_text(18446744073709551615U), "18,446,744,073,709,551,615");
}

TEST(MeasuredText, GivesTwoDigitsOfTheError) {
  EXPECT_EQ(measured_text(7.7523, 0.0342), "7.752(34)");
  EXPECT_EQ(measured_text(12.47, 0.03), "12.470(30)");
  EXPECT_EQ(measured_text(-0.5, 0.00099), "−0.50000(99)");
  EXPECT_EQ(measured_text(1, 0.0996), "1.00(10)") << "an error that rounds up to one digit more";
  EXPECT_EQ(measured_text(0, 0.01), "0.000(10)");
}

TEST(MeasuredText, KeepsThePointOfLargeErrors) {
  EXPECT_EQ(measured_text(123.4, 5.6), "123.4(5.6)");
  EXPECT_EQ(measured_text(1234, 56), "1234(56)");
  EXPECT_EQ(measured_text(12345, 678), "1.234(68)·10⁴");
  EXPECT_EQ(measured_text(0.1, 1.5), "0.1(1.5)") << "an error larger than the value";
}

TEST(MeasuredText, GivesValueAndErrorOnePowerOfTen) {
  EXPECT_EQ(measured_text(1.234e-7, 5e-9), "1.234(50)·10⁻⁷");
  EXPECT_EQ(measured_text(1e12, 2e9), "1.0000(20)·10¹²");
  EXPECT_EQ(measured_text(1e-9, 2e-6), "0.0(2.0)·10⁻⁶");
}

TEST(MeasuredText, IsANumberWhereNoErrorIsKnown) {
  EXPECT_EQ(measured_text(1.5, kNone), "1.5");
  EXPECT_EQ(measured_text(1.5, 0), "1.5");
  EXPECT_EQ(measured_text(1.5, 2e-16), "1.5") << "rounding is no error";
  EXPECT_EQ(measured_text(1.5, kInfinity), "1.5");
  EXPECT_EQ(measured_text(kNone, 0.1), "–");
}

TEST(DeviationText, IsInErrorsOrElseInPercent) {
  EXPECT_EQ(deviation_text(1.013, 0.01, 1), "+1.3 σ");
  EXPECT_EQ(deviation_text(0.9, 0.01, 1), "−10.0 σ");
  EXPECT_EQ(deviation_text(1.0021, kNone, 1), "+0.21%");
  EXPECT_EQ(deviation_text(1 - 1.4e-5, kNone, 1), "−0.0014%");
  EXPECT_EQ(deviation_text(1, kNone, 1), "0%");
  EXPECT_EQ(deviation_text(0.9999, 0.01, 1), "0.0 σ") << "not minus nothing";
  EXPECT_EQ(deviation_text(-1.5, kNone, -1), "−50.0%");
  EXPECT_EQ(deviation_text(0.5, 0.25, 0), "+2.0 σ") << "a theory of zero";
  EXPECT_EQ(deviation_text(0.5, kNone, 0), "–");
  EXPECT_EQ(deviation_text(1.5, 2e-16, 1), "+50.0%") << "rounding is no error";
  EXPECT_EQ(deviation_text(1, 0.1, kNone), "–");
  EXPECT_EQ(deviation_text(kNone, 0.1, 1), "–");
}

TEST(UnitText, RaisesExponents) {
  EXPECT_EQ(unit_text("1"), "");
  EXPECT_EQ(unit_text("L"), "L");
  EXPECT_EQ(unit_text("M L^-1 T^-2"), "M L⁻¹ T⁻²");
  EXPECT_EQ(unit_text("L^10"), "L¹⁰");
  EXPECT_EQ(unit_text("L^"), "L");
}

TEST(BytesText, ChoosesTheUnit) {
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(12'345'678), "12.3 MB");
  EXPECT_EQ(bytes_text(4.5e12), "4500 GB");
}

TEST(RateText, RoundsToThreeDigits) {
  EXPECT_EQ(rate_text(987'654.3), "988,000");
  EXPECT_EQ(rate_text(1'234'567), "1,230,000");
  EXPECT_EQ(rate_text(12.345), "12.3");
  EXPECT_EQ(rate_text(0), "0");
}

TEST(SecondsText, ChoosesTheUnit) {
  EXPECT_EQ(seconds_text(0.1234), "0.123 s");
  EXPECT_EQ(seconds_text(200.4), "3 min 20 s");
  EXPECT_EQ(seconds_text(7260), "2 h 01 min");
  EXPECT_EQ(seconds_text(3599.7), "1 h 00 min");
}

}  // namespace
}  // namespace hardball::report::number_text_test
