// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/number.hpp"

namespace hardball {

/// The sine and the cosine of an angle.
struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// The sine and cosine of an angle in radians, with errors below 1e-16, from additions and multiplications
/// alone: the C library's may differ from one platform to the next. Zero and one beyond 2^50. Cost: some 20
/// ns, and a few times that beyond a million.
///
/// The angle is reduced by quarter turns (Cody and Waite, Software Manual for the Elementary Functions,
/// 1980), and the rest summed by Taylor's series.
inline SineCosine sine_cosine(double angle) {
  constexpr double kQuartersPerRadian = 0x1.45f306dc9c883p-1;  // 2 / pi
  constexpr double kMostQuick = 0x1p20;                        // times the first parts below, exact
  constexpr double kMost = 0x1p50;                             // beyond it the quarters are not known
  if (!(std::fabs(angle) <= kMost)) return {0, 1};
  const double quarters = round_to_integer(angle * kQuartersPerRadian);
  DoubleDouble<> rest{};
  if (std::fabs(quarters) <= kMostQuick) {
    // pi / 2 in parts of 33, 33 and 53 bits.
    constexpr double kFirst = 0x1.921fb544p+0;
    constexpr double kSecond = 0x1.0b4611a6p-34;
    constexpr double kThird = 0x1.3198a2e037073p-69;
    rest = difference(angle - quarters * kFirst, quarters * kSecond);
    rest = normalized(rest.high, rest.low - quarters * kThird);
  } else {
    constexpr DoubleDouble<> kFirst{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
    constexpr double kSecond = -0x1.f1976b7ed8fbcp-110;
    rest = DoubleDouble<>{angle, 0} - product(quarters, kFirst.high);
    rest = rest - product(quarters, kFirst.low);
    rest = rest - product(quarters, kSecond);
  }
  const double high = rest.high;
  const double square = high * high;
  double odd = 0x1.952c77030ad4ap-49;            // 1 / 17!
  odd = odd * square - 0x1.ae7f3e733b81fp-41;    // 1 / 15!
  odd = odd * square + 0x1.6124613a86d09p-33;    // 1 / 13!
  odd = odd * square - 0x1.ae64567f544e4p-26;    // 1 / 11!
  odd = odd * square + 0x1.71de3a556c734p-19;    // 1 / 9!
  odd = odd * square - 0x1.a01a01a01a01ap-13;    // 1 / 7!
  odd = odd * square + 0x1.1111111111111p-7;     // 1 / 5!
  odd = odd * square - 0x1.5555555555555p-3;     // 1 / 3!
  double even = 0x1.ae7f3e733b81fp-45;           // 1 / 16!
  even = even * square - 0x1.93974a8c07c9dp-37;  // 1 / 14!
  even = even * square + 0x1.1eed8eff8d898p-29;  // 1 / 12!
  even = even * square - 0x1.27e4fb7789f5cp-22;  // 1 / 10!
  even = even * square + 0x1.a01a01a01a01ap-16;  // 1 / 8!
  even = even * square - 0x1.6c16c16c16c17p-10;  // 1 / 6!
  even = even * square + 0x1.5555555555555p-5;   // 1 / 4!
  const double half = 0.5 * square;
  const double near = 1 - half;
  const double sine = high + (high * square * odd + rest.low * near);
  const double cosine = near + (((1 - near) - half) + (square * square * even - high * rest.low));
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace hardball
