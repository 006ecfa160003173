// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/sine.hpp"

#include <cmath>

namespace hardball {
namespace {

constexpr DoubleDouble<> kExactTurn{0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52};  // 2 pi

// 1 - x / ((k + 1) k) + x^2 / ((k + 3) (k + 2) (k + 1) k) - ..., k being `first`. Up to an eighth of a turn,
// what is left out is below 2^-106.
DoubleDouble<> alternating_series(const DoubleDouble<>& x, int first) {
  constexpr int kTerms = 14;
  const DoubleDouble<> one{1, 0};
  DoubleDouble<> sum = one;
  for (int term = kTerms - 1; term >= 0; --term) {
    const double k = first + 2 * term;
    sum = one - divide(x * sum, k * (k + 1));
  }
  return sum;
}

}  // namespace

Circular circular(double frequency, const Time& time) {
  constexpr double kMaxTurns = 0x1p100;  // of more, not even the whole number is known
  DoubleDouble<> turns = product(frequency, time.high) + product(frequency, time.low);
  if (!(std::fabs(turns.high) < kMaxTurns)) return {{0, 0}, {1, 0}};
  turns = turns - DoubleDouble<>{std::floor(turns.high), 0};
  turns = turns - DoubleDouble<>{std::floor(turns.high), 0};
  const double quarter = std::floor(4 * turns.high + 0.5);
  const DoubleDouble<> angle = kExactTurn * (turns - DoubleDouble<>{quarter / 4, 0});
  const DoubleDouble<> square = angle * angle;
  const DoubleDouble<> sine = angle * alternating_series(square, 2);
  const DoubleDouble<> cosine = alternating_series(square, 1);
  switch (static_cast<int>(quarter) % 4) {
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
