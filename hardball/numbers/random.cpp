// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/numbers/random.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace hardball {

Random::Random(std::uint64_t seed) {
  for (std::uint64_t& word : state_) {
    seed += 0x9e3779b97f4a7c15;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    word = z ^ (z >> 31);
  }
}

std::uint64_t Random::bits() {
  const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t carry = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= carry;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double Random::normal() {
  for (;;) {
    const double u = 2 * uniform() - 1;
    const double v = 2 * uniform() - 1;
    const double s = u * u + v * v;
    if (s >= 1 || s == 0) continue;
    return u * std::sqrt(-2 * portable_log(s) / s);
  }
}

Vec3 Random::normal_vector(std::size_t dimensions) {
  Vec3 vector;
  for (std::size_t axis = 0; axis < dimensions; ++axis) vector[axis] = normal();
  return vector;
}

Vec3 Random::direction() {
  for (;;) {
    const double u = 2 * uniform() - 1;
    const double v = 2 * uniform() - 1;
    const double s = u * u + v * v;
    if (s >= 1) continue;
    const double scale = 2 * std::sqrt(1 - s);
    return {u * scale, v * scale, 1 - 2 * s};
  }
}

Vec3 Random::direction_in_plane() {
  for (;;) {
    const double u = 2 * uniform() - 1;
    const double v = 2 * uniform() - 1;
    const double s = u * u + v * v;
    if (s >= 1 || s == 0) continue;
    const double scale = 1 / std::sqrt(s);
    return {u * scale, v * scale, 0};
  }
}

double portable_log(double x) {
  // x = m 2^e with m between sqrt(1/2) and sqrt(2); log m = 2 artanh((m - 1) / (m + 1)).
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1);
  const double s2 = s * s;
  double series = 0;
  for (int odd = 23; odd >= 1; odd -= 2) series = series * s2 + 1.0 / odd;
  return 2 * s * series + exponent * std::numbers::ln2;
}

double portable_exp(double x) {
  // Beyond, the result is infinite or zero.
  constexpr double kLargest = 710;
  constexpr double kSmallest = -746;
  x = std::clamp(x, kSmallest, kLargest);
  // x = k log 2 + rest. The first part of log 2 has so few bits that its product with k is exact.
  constexpr double kHigh = 0x1.62e42feep-1;
  constexpr double kLow = 0x1.a39ef35793c76p-33;
  const double k = std::floor(x * std::numbers::log2e + 0.5);
  const double rest = (x - k * kHigh) - k * kLow;
  double series = 1;
  for (int i = 14; i >= 1; --i) series = 1 + series * rest / i;
  return std::ldexp(series, static_cast<int>(k));
}

}  // namespace hardball
