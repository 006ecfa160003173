// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// Random numbers that are the same on every platform, compiler and library.
/// Source: Blackman and Vigna, ACM Trans. Math. Softw. 47 (2021) 36, xoshiro256++ seeded by SplitMix64.
class HARDBALL_EXPORT Random {
 public:
  explicit Random(std::uint64_t seed);

  /// 64 random bits.
  std::uint64_t bits();
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();
  /// Normal with mean zero and variance one. Source: Marsaglia and Bray, SIAM Rev. 6 (1964) 260.
  double normal();
  /// Independent normal components along the first `dimensions` axes, and zero along the others.
  Vec3 normal_vector(std::size_t dimensions);
  /// Uniform on the unit sphere. Source: Marsaglia, Ann. Math. Statist. 43 (1972) 645.
  Vec3 direction();
  /// Uniform on the unit circle in the plane z = 0. Source: von Neumann, Nat. Bur. Stand. Appl. Math. Ser. 12
  /// (1951) 36.
  Vec3 direction_in_plane();

 private:
  std::array<std::uint64_t, 4> state_;
};

/// The natural logarithm of a positive normal number, to about one unit in the last place, from additions,
/// multiplications and divisions alone: the C library's may differ in the last bit from one platform to the
/// next.
HARDBALL_EXPORT double portable_log(double x);

/// The exponential function of a number, to about one unit in the last place, without the C library; zero or
/// infinite where the result is out of range.
HARDBALL_EXPORT double portable_exp(double x);

}  // namespace hardball
