// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "hardball/kernels/contact_kernel_body.hpp"
#include "hardball/kernels/kernels.hpp"
#include "hardball/kernels/near_kernel_body.hpp"

namespace hardball {
namespace {

// Two numbers at a time, by the compiler's generic vectors: SSE2 on x86-64, NEON on ARM.
struct Lanes {
  static constexpr std::size_t kWidth = 2;
  using Vector = double __attribute__((vector_size(16)));
  using Bits = long long __attribute__((vector_size(16)));
  struct Mask {
    Bits v;  // all bits of a number, or none
    friend Mask operator&(const Mask& a, const Mask& b) { return {a.v & b.v}; }
    friend Mask operator|(const Mask& a, const Mask& b) { return {a.v | b.v}; }
  };

  Lanes() = default;
  Lanes(Vector vector) : v(vector) {}
  explicit Lanes(double value) : v{value, value} {}

  static Lanes load(const double* values) { return Vector{values[0], values[1]}; }
  static Lanes gather(const double* values, const std::uint32_t* at) {
    return Vector{values[at[0]], values[at[1]]};
  }
  static void load(const Path* paths, const std::uint32_t* at, PathsOfLanes<Lanes>& out) {
    const Path& a = paths[at[0]];
    const Path& b = paths[at[1]];
    out.position.x = Vector{a.position.x, b.position.x};
    out.position.y = Vector{a.position.y, b.position.y};
    out.position.z = Vector{a.position.z, b.position.z};
    out.velocity.x = Vector{a.velocity.x, b.velocity.x};
    out.velocity.y = Vector{a.velocity.y, b.velocity.y};
    out.velocity.z = Vector{a.velocity.z, b.velocity.z};
    out.high = Vector{a.time.high, b.time.high};
    out.low = Vector{a.time.low, b.time.low};
  }
  static void load(const Vec3* points, const std::uint32_t* at, VectorOfLanes<Lanes>& out) {
    const Vec3& a = points[at[0]];
    const Vec3& b = points[at[1]];
    out.x = Vector{a.x, b.x};
    out.y = Vector{a.y, b.y};
    out.z = Vector{a.z, b.z};
  }
  static void keep(const std::uint32_t* at, unsigned lanes, std::uint32_t* out) {
    out[0] = at[0];
    out[lanes & 1] = at[1];
  }
  void store(double* out) const { out[0] = v[0], out[1] = v[1]; }

  Vector v;
};

Lanes operator+(const Lanes& a, const Lanes& b) {
  return a.v + b.v;
}
Lanes operator-(const Lanes& a, const Lanes& b) {
  return a.v - b.v;
}
Lanes operator*(const Lanes& a, const Lanes& b) {
  return a.v * b.v;
}
Lanes operator/(const Lanes& a, const Lanes& b) {
  return a.v / b.v;
}
Lanes::Mask operator<(const Lanes& a, const Lanes& b) {
  return {a.v < b.v};
}
Lanes::Mask operator>(const Lanes& a, const Lanes& b) {
  return {a.v > b.v};
}
Lanes::Mask operator<=(const Lanes& a, const Lanes& b) {
  return {a.v <= b.v};
}
Lanes::Mask operator==(const Lanes& a, const Lanes& b) {
  return {a.v == b.v};
}
Lanes::Mask not_(const Lanes::Mask& mask) {
  return {~mask.v};
}
unsigned bits(const Lanes::Mask& mask) {
  return (mask.v[0] != 0 ? 1U : 0U) | (mask.v[1] != 0 ? 2U : 0U);
}
Lanes select(const Lanes::Mask& mask, const Lanes& a, const Lanes& b) {
  return mask.v ? a.v : b.v;
}
Lanes maximum(const Lanes& a, const Lanes& b) {
  return select(a > b, a, b);
}
Lanes minimum(const Lanes& a, const Lanes& b) {
  return select(a < b, a, b);
}
Lanes square_root(const Lanes& a) {
  return Lanes::Vector{std::sqrt(a.v[0]), std::sqrt(a.v[1])};
}
double least_of(const Lanes& a) {
  return a.v[0] < a.v[1] ? a.v[0] : a.v[1];
}
// Adding and subtracting this number rounds to the nearest integer. Precondition: |a| < 2^51.
Lanes round_to_integer(const Lanes& a) {
  const Lanes pusher(0x1.8p52);
  return (a + pusher) - pusher;
}

}  // namespace

const Kernels kPortableKernels{earliest_contact<Lanes>, pick_near<Lanes>};

}  // namespace hardball
