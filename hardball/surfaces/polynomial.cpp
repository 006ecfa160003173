// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "hardball/standard/bit_cast.hpp"

namespace hardball {
namespace {

constexpr double kNoDescent = std::numeric_limits<double>::infinity();

// The points t >= 0 at which a polynomial changes its sign.
struct Points {
  std::array<double, Polynomial::kMaxDegree> at{};
  std::size_t count = 0;

  void add(double point) { at[count++] = point; }
};

double sign_of(const DoubleDouble<>& number) {
  if (number.high != 0) return number.high;
  return number.low;
}

// The double halfway between two that are not negative, by the number of doubles in between.
double halfway(double low, double high) {
  const auto a = bit_cast<std::uint64_t>(low);
  const auto b = bit_cast<std::uint64_t>(high);
  return bit_cast<double>(a + (b - a) / 2);
}

double stepped(double number, std::int64_t steps) {
  const auto bits = bit_cast<std::int64_t>(number);
  return bit_cast<double>(std::max<std::int64_t>(0, bits + steps));
}

// The least double after `low` at which the polynomial has lost the sign it has at `low`. Precondition: at
// `high` it has lost it, and it is monotonic in between.
double sign_change(const Polynomial& p, double low, double high) {
  const bool begins_positive = sign_of(p(low)) > 0;
  const auto is_before = [&](double t) { return (sign_of(p(t)) > 0) == begins_positive; };
  // Newton's method leads close to it, and a few steps to either side of where it leads enclose it.
  const Polynomial slope = p.derivative();
  double guess = low + (high - low) / 2;
  constexpr int kMaxSteps = 12;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double next = guess - p(guess).high / slope(guess).high;
    if (!(next > low && next < high) || next == guess) break;
    guess = next;
  }
  constexpr std::int64_t kBeside = 4;
  for (const double end : {stepped(guess, -kBeside), stepped(guess, kBeside)}) {
    if (!(end > low && end < high)) continue;
    (is_before(end) ? low : high) = end;
  }
  for (double middle = halfway(low, high); middle != low; middle = halfway(low, high)) {
    (is_before(middle) ? low : high) = middle;
  }
  return high;
}

// A point after `begin` at which a polynomial, monotonic from there on, has the sign that it ends with.
double beyond(const Polynomial& p, double begin, bool ends_positive) {
  double step = std::max(1.0, begin);
  while ((sign_of(p(begin + step)) > 0) != ends_positive) step *= 2;
  return begin + step;
}

// Where the polynomial changes its sign, found between the points at which its derivative does.
Points sign_changes(const Polynomial& p) {
  Points found;
  const std::size_t degree = p.degree();
  if (degree == 0) return found;
  const Points turns = sign_changes(p.derivative());
  double begin = 0;
  for (std::size_t i = 0; i <= turns.count; ++i) {
    const bool is_last = i == turns.count;
    const bool begins_positive = sign_of(p(begin)) > 0;
    const bool ends_positive = is_last ? sign_of(p.coefficients[degree]) > 0 : sign_of(p(turns.at[i])) > 0;
    if (begins_positive != ends_positive) {
      const double end = is_last ? beyond(p, begin, ends_positive) : turns.at[i];
      found.add(sign_change(p, begin, end));
    }
    if (!is_last) begin = turns.at[i];
  }
  return found;
}

// The sign of a polynomial just after t.
double sign_after(const Polynomial& p, double t) {
  Polynomial derivative = p;
  for (std::size_t i = 0; i <= Polynomial::kMaxDegree; ++i, derivative = derivative.derivative()) {
    const double sign = sign_of(derivative(t));
    if (sign != 0) return sign;
  }
  return 0;
}

double earliest_descent_of_line_or_parabola(const Polynomial& p) {
  const double constant = sign_of(p.coefficients[0]);
  const double slope = sign_of(p.coefficients[1]);
  const double half_curvature = sign_of(p.coefficients[2]);
  if (half_curvature == 0) return slope < 0 ? std::max(0.0, -constant / slope) : kNoDescent;
  const DoubleDouble<> four{4, 0};
  const DoubleDouble<> discriminant =
      p.coefficients[1] * p.coefficients[1] - four * (p.coefficients[0] * p.coefficients[2]);
  const bool has_roots = sign_of(discriminant) > 0;
  const double root = has_roots ? std::sqrt(std::max(discriminant.high, 0.0)) : 0;
  if (half_curvature > 0) {
    if (slope >= 0 || !has_roots) return kNoDescent;
  } else {
    if (!has_roots) return std::max(0.0, -slope / (2 * half_curvature));
    if (slope > 0) return (-slope - root) / (2 * half_curvature);
  }
  return std::max(0.0, 2 * constant / (root - slope));
}

}  // namespace

DoubleDouble<> Polynomial::operator()(double t) const {
  const DoubleDouble<> factor{t, 0};
  DoubleDouble<> value = coefficients[kMaxDegree];
  for (std::size_t i = kMaxDegree; i-- > 0;) value = value * factor + coefficients[i];
  return value;
}

std::size_t Polynomial::degree() const {
  std::size_t degree = kMaxDegree;
  while (degree > 0 && sign_of(coefficients[degree]) == 0) --degree;
  return degree;
}

Polynomial Polynomial::derivative() const {
  Polynomial derivative;
  for (std::size_t i = 1; i <= kMaxDegree; ++i) {
    derivative.coefficients[i - 1] = DoubleDouble<>{static_cast<double>(i), 0} * coefficients[i];
  }
  return derivative;
}

Descents descents(const Polynomial& p) {
  Descents found;
  const auto add = [&](double begin, double end) {
    if (begin < end) found.intervals[found.count++] = {begin, end};
  };
  if (p.degree() <= 2) {
    const double half_curvature = sign_of(p.coefficients[2]);
    const double turn = half_curvature > 0 ? -sign_of(p.coefficients[1]) / (2 * half_curvature) : kNoDescent;
    add(earliest_descent_of_line_or_parabola(p), turn);
    return found;
  }
  const Polynomial slope = p.derivative();
  const Points turns = sign_changes(slope);
  double begin = 0;
  bool descends = sign_after(slope, 0) < 0;
  for (std::size_t i = 0; i <= turns.count; ++i) {
    const bool is_last = i == turns.count;
    if (descends) {
      const double turn = is_last ? kNoDescent : turns.at[i];
      if (!(sign_of(p(begin)) > 0)) {
        add(begin, turn);
      } else {
        const double end = is_last ? beyond(p, begin, false) : turn;
        if (!(sign_of(p(end)) > 0)) add(sign_change(p, begin, end), turn);
      }
    }
    if (is_last) break;
    begin = turns.at[i];
    descends = !(sign_of(slope(begin)) > 0);
  }
  return found;
}

double earliest_descent(const Polynomial& p) {
  if (p.degree() <= 2) return earliest_descent_of_line_or_parabola(p);
  const Descents found = descents(p);
  return found.count > 0 ? found.intervals[0].begin : kNoDescent;
}

}  // namespace hardball
