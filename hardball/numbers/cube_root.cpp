// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/numbers/cube_root.hpp"

#include <cmath>

namespace hardball {

// That of a number from 1 to 8, by Newton's method, and a power of two.
double cube_root(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const int power = (exponent + 3 * 2048 - 1) / 3 - 2048;
  const double reduced = std::ldexp(fraction, exponent - 3 * power);
  double root = 1.5;
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) root -= (root - reduced / (root * root)) / 3;
  return std::ldexp(root, power);
}

}  // namespace hardball
