// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/polynomial.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::polynomial_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

constexpr double kForever = std::numeric_limits<double>::infinity();

Polynomial make(const std::vector<double>& coefficients) {
  Polynomial p;
  for (std::size_t i = 0; i < coefficients.size(); ++i) p.coefficients[i] = {coefficients[i], 0};
  return p;
}

// The coefficients of a (t - r_1) (t - r_2) ..., rounded.
Polynomial with_roots(double a, const std::vector<double>& roots) {
  std::vector<double> coefficients{a};
  for (const double root : roots) {
    coefficients.push_back(0);
    for (std::size_t i = coefficients.size(); i-- > 1;)
      coefficients[i] = coefficients[i - 1] - root * coefficients[i];
    coefficients[0] *= -root;
  }
  return make(coefficients);
}

Quad value_of(const Polynomial& p, const Quad& t) {
  Quad value = 0;
  for (std::size_t i = Polynomial::kMaxDegree + 1; i-- > 0;) {
    value = value * t + Quad(p.coefficients[i].high) + Quad(p.coefficients[i].low);
  }
  return value;
}

TEST(Polynomial, HasItsValueDegreeAndDerivative) {
  const Polynomial p = make({1, -2, 3, 0.5});
  EXPECT_EQ(p(2).high, 1 - 4 + 12 + 4);
  EXPECT_EQ(p.degree(), 3U);
  EXPECT_EQ(p.derivative()(2).high, -2 + 12 + 6);
  EXPECT_EQ(make({}).degree(), 0U);
}

TEST(EarliestDescent, IsWhereTheGapCloses) {
  EXPECT_EQ(earliest_descent(make({1, -2})), 0.5);
  EXPECT_EQ(earliest_descent(make({1, 2})), kForever);
  EXPECT_EQ(earliest_descent(make({2, -3, 1})), 1) << "the first of the roots 1 and 2";
  EXPECT_EQ(earliest_descent(make({-2, 3, -1})), 2) << "overlapping, it opens at 1 and closes at 2";
  EXPECT_EQ(earliest_descent(make({1, -2, 1})), kForever) << "it only grazes";
  EXPECT_EQ(earliest_descent(with_roots(1, {1, 2, 3, 4})), 1);
  EXPECT_EQ(earliest_descent(with_roots(-1, {1, 2, 3, 4})), 2);
  EXPECT_EQ(earliest_descent(with_roots(-1, {-1, -2, -3, 4})), 4);
  EXPECT_EQ(earliest_descent(with_roots(1, {-1, -2, -3, -4})), kForever);
  EXPECT_EQ(earliest_descent(with_roots(-1, {-1, -2, 8})), 8);
}

TEST(EarliestDescent, IsAtOnceIfClosedAndClosing) {
  EXPECT_EQ(earliest_descent(make({0, -1})), 0);
  EXPECT_EQ(earliest_descent(make({-1, -1, 5})), 0);
  EXPECT_EQ(earliest_descent(make({0, 0, -1})), 0) << "at rest, and pressed";
  EXPECT_EQ(earliest_descent(make({0, 0, 0, 0, -1})), 0);
  EXPECT_EQ(earliest_descent(make({0, 0, 1})), kForever);
  EXPECT_EQ(earliest_descent(make({0, 0})), kForever);
  EXPECT_EQ(earliest_descent(make({0, 0, 0, 1, -1})), 1);
}

TEST(EarliestDescent, IsAtTheTurnOfAGapThatStaysClosed) {
  EXPECT_EQ(earliest_descent(make({-2, 2, -1})), 1);
  EXPECT_EQ(earliest_descent(make({-4, 4, 0, 0, -1})), 1);
}

// A search in small steps with 113 bits, and bisection; nothing if the result depends on rounding.
struct Reference {
  bool is_clear = true;
  Quad time = -1;
};

Reference search(const Polynomial& p, double end, int steps) {
  Reference found;
  Quad before = value_of(p, 0);
  if (before <= 0) return {false, 0};
  for (int i = 1; i <= steps; ++i) {
    const Quad t = Quad(end) * i / steps;
    const Quad value = value_of(p, t);
    if (value <= 0) {
      Quad low = Quad(end) * (i - 1) / steps;
      Quad high = t;
      for (int step = 0; step < 120; ++step) {
        const Quad middle = (low + high) / 2;
        (value_of(p, middle) > 0 ? low : high) = middle;
      }
      found.time = high;
      return found;
    }
    before = value;
  }
  return found;
}

TEST(EarliestDescent, IsExactForRandomQuartics) {
  Random random(2026);
  int found = 0;
  for (int i = 0; i < static_cast<int>(support::cases(3000)); ++i) {
    const auto degree = 3 + static_cast<std::size_t>(2 * random.uniform());
    std::vector<double> coefficients{random.uniform()};
    for (std::size_t k = 1; k <= degree; ++k) coefficients.push_back(random.normal());
    const Polynomial p = make(coefficients);
    const double wait = earliest_descent(p);
    const Reference reference = search(p, 4, 2000);
    if (!reference.is_clear) continue;
    if (reference.time < 0) {
      // A dip between two steps of the search may be found here only.
      if (wait < 4) {
        EXPECT_LT(abs(value_of(p, Quad(wait))), 1e-5) << i;
      }
      continue;
    }
    ++found;
    // The least double at which the polynomial is not positive.
    ASSERT_LE(value_of(p, Quad(wait)), 0) << i;
    ASSERT_GT(value_of(p, Quad(std::nextafter(wait, 0.0))), 0) << i;
    ASSERT_LE(Quad(wait), reference.time + Quad(wait) * std::numeric_limits<double>::epsilon()) << i;
  }
  EXPECT_GT(found, static_cast<int>(support::cases(1000)));
}

TEST(EarliestDescent, IsAccurateForParabolas) {
  Random random(7);
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < static_cast<int>(support::cases(100000)); ++i) {
    // From far above, from close by, and nearly grazing.
    const double scale = std::ldexp(random.uniform(), -static_cast<int>(40 * random.uniform()));
    const Polynomial p = make({scale * random.uniform(), random.normal(), random.normal()});
    const double wait = earliest_descent(p);
    if (!std::isfinite(wait) || wait == 0) continue;
    const Quad a = p.coefficients[2].high;
    const Quad b = p.coefficients[1].high;
    const Quad c = p.coefficients[0].high;
    const Quad root = sqrt(b * b - 4 * a * c);
    const Quad exact = b < 0 ? 2 * c / (root - b) : (-b - root) / (2 * a);
    ASSERT_LE(abs(Quad(wait) - exact), 4 * kUlp * exact) << i;
  }
}

}  // namespace
}  // namespace hardball::polynomial_test
