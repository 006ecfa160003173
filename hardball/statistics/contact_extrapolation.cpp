// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/contact_extrapolation.hpp"

#include <cmath>

namespace hardball {
namespace {

constexpr std::size_t kCoefficients = 4;

// Integral of x^power over a bin.
double power_integral(std::size_t bin, std::size_t power) {
  const auto exponent = static_cast<int>(power) + 1;
  const auto low = static_cast<double>(bin) / ContactExtrapolation::kBins;
  const auto high = static_cast<double>(bin + 1) / ContactExtrapolation::kBins;
  return (std::pow(high, exponent) - std::pow(low, exponent)) / exponent;
}

// A polynomial in the gap: its means in the bins, and its value at contact.
struct GapPolynomial {
  ContactExtrapolation::Bins means{};
  double at_contact = 0;

  double product(const GapPolynomial& other) const {
    double sum = 0;
    for (std::size_t bin = 0; bin < means.size(); ++bin) sum += means[bin] * other.means[bin];
    return sum;
  }
  void add(double factor, const GapPolynomial& other) {
    for (std::size_t bin = 0; bin < means.size(); ++bin) means[bin] += factor * other.means[bin];
    at_contact += factor * other.at_contact;
  }
};

}  // namespace

ContactExtrapolation::ContactExtrapolation(double width, double radius, std::size_t dimensions)
    : width_(width) {
  // At the gap x width the area grows as (1 + c x)^2, the circumference in two dimensions as 1 + c x.
  const double c = width / radius;
  const auto integral = [c, dimensions](std::size_t bin, std::size_t power) {
    if (dimensions == 2) return power_integral(bin, power) + c * power_integral(bin, power + 1);
    return power_integral(bin, power) + 2 * c * power_integral(bin, power + 1) +
           c * c * power_integral(bin, power + 2);
  };
  // Least squares by orthogonal polynomials, each of which adds its part. Source: Golub and Van Loan, Matrix
  // Computations, section 5.2 (modified Gram and Schmidt).
  std::array<GapPolynomial, kCoefficients> basis;
  for (std::size_t power = 0; power < kCoefficients; ++power) {
    GapPolynomial& next = basis[power];
    next.at_contact = power == 0 ? 1 : 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      next.means[bin] = integral(bin, power) / integral(bin, 0);
    }
    for (std::size_t lower = 0; lower < power; ++lower) {
      next.add(-next.product(basis[lower]) / basis[lower].product(basis[lower]), basis[lower]);
    }
    const double share = next.at_contact / next.product(next);
    for (std::size_t bin = 0; bin < kBins; ++bin) weight_[bin] += share * next.means[bin];
  }
}

double ContactExtrapolation::at_contact(const Bins& density) const {
  double sum = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) sum += weight_[bin] * density[bin];
  return sum;
}

}  // namespace hardball
