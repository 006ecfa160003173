// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// Sums over bonds of the spherical harmonics of one even degree, order 0 up to the degree; those of negative
/// order are their conjugates. They are normalized so that the squares for one bond add up to one.
template <std::size_t kDegree>
struct Harmonics {
  std::array<double, kDegree + 1> real{};
  std::array<double, kDegree + 1> imaginary{};

  void add(const Harmonics& other) {
    for (std::size_t m = 0; m <= kDegree; ++m) {
      real[m] += other.real[m];
      imaginary[m] += other.imaginary[m];
    }
  }
  /// The scalar product of the sums with those of other bonds, which does not depend on the axes.
  double product(const Harmonics& other) const {
    double sum = real[0] * other.real[0];
    for (std::size_t m = 1; m <= kDegree; ++m)
      sum += 2 * (real[m] * other.real[m] + imaginary[m] * other.imaginary[m]);
    return sum;
  }
  /// The root of the sum of squares, for a mean over `bonds`: 1 if all have one direction.
  double invariant(double bonds) const { return std::sqrt(product(*this)) / bonds; }
};

/// Factors of the harmonics of one degree, by their order.
template <std::size_t kDegree>
using HarmonicFactors = std::array<double, kDegree + 1>;

/// sqrt((l - m)! / (l + m)!), for m from 0 to l.
template <std::size_t kDegree>
HarmonicFactors<kDegree> normalization() {
  HarmonicFactors<kDegree> factor{};
  double square = 1;
  for (std::size_t m = 0; m <= kDegree; ++m) {
    if (m > 0) square /= static_cast<double>((kDegree + m) * (kDegree - m + 1));
    factor[m] = std::sqrt(square);
  }
  return factor;
}

/// Sums over the bonds of one sphere, or of all.
struct BondsInSpace {
  double count = 0;
  Harmonics<4> four;
  Harmonics<6> six;

  /// Adds the bond along a unit vector. Associated Legendre functions without their powers of sin(theta) are
  /// polynomials in z, multiplied by powers of x + i y. Source: Abramowitz and Stegun, Handbook of
  /// Mathematical Functions, 8.5.3 (recurrence by degree).
  void add(const Vec3& direction) {
    static const HarmonicFactors<4> kFour = normalization<4>();
    static const HarmonicFactors<6> kSix = normalization<6>();
    ++count;
    const double z = direction.z;
    double real = 1;  // of (x + i y)^m
    double imaginary = 0;
    double diagonal = 1;  // the polynomial of degree m and order m, (2 m - 1)!!
    for (std::size_t m = 0; m <= 6; ++m) {
      const auto order = static_cast<double>(m);
      double before = 0;
      double legendre = diagonal;
      for (std::size_t degree = m; degree <= 6; ++degree) {
        if (degree == 4) {
          four.real[m] += kFour[m] * legendre * real;
          four.imaginary[m] += kFour[m] * legendre * imaginary;
        }
        const auto l = static_cast<double>(degree);
        const double next = ((2 * l + 1) * z * legendre - (l + order) * before) / (l + 1 - order);
        if (degree == 6) break;
        before = legendre;
        legendre = next;
      }
      six.real[m] += kSix[m] * legendre * real;
      six.imaginary[m] += kSix[m] * legendre * imaginary;
      diagonal *= 2 * order + 1;
      const double turned = real * direction.x - imaginary * direction.y;
      imaginary = real * direction.y + imaginary * direction.x;
      real = turned;
    }
  }
  void add(const BondsInSpace& other) {
    count += other.count;
    four.add(other.four);
    six.add(other.six);
  }
  double invariant_four() const { return four.invariant(count); }
  double invariant_six() const { return six.invariant(count); }
};

/// Sums of exp(4 i theta) and exp(6 i theta) over the bonds of one disc, or of all.
struct BondsInPlane {
  double count = 0;
  std::complex<double> four;
  std::complex<double> six;

  void add(const Vec3& direction) {
    ++count;
    const std::complex<double> turn(direction.x, direction.y);
    const std::complex<double> square = turn * turn;
    four += square * square;
    six += square * square * square;
  }
  void add(const BondsInPlane& other) {
    count += other.count;
    four += other.four;
    six += other.six;
  }
  double invariant_four() const { return std::abs(four) / count; }
  double invariant_six() const { return std::abs(six) / count; }
};

}  // namespace hardball
