// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>

#include "hardball/kernels/bound_kernel_body.hpp"
#include "hardball/kernels/contact_kernel_body.hpp"
#include "hardball/kernels/kernels.hpp"
#include "hardball/kernels/near_kernel_body.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {
namespace {

// Two numbers at a time, by the compiler's generic vectors: SSE2 on x86-64, NEON on ARM.
struct Lanes {
  static constexpr std::size_t kWidth = 2;
  using Vector = double __attribute__((vector_size(16)));
  using Bits = long long __attribute__((vector_size(16)));
  struct Mask {
    Bits v;  // all bits of a number, or none
    friend Mask operator&&(const Mask& a, const Mask& b) { return {a.v & b.v}; }
    friend Mask operator||(const Mask& a, const Mask& b) { return {a.v | b.v}; }
  };

  Lanes() = default;
  Lanes(Vector vector) : v(vector) {}
  explicit Lanes(double value) : v{value, value} {}

  static Lanes load(const double* values) { return Vector{values[0], values[1]}; }
  static Lanes gather(const double* values, const std::uint32_t* at) {
    return Vector{values[at[0]], values[at[1]]};
  }
  static void load(const Path* paths, const std::uint32_t* at, PathOf<Lanes>& out) {
    const Path& a = paths[at[0]];
    const Path& b = paths[at[1]];
    out.position.x = Vector{a.position.x, b.position.x};
    out.position.y = Vector{a.position.y, b.position.y};
    out.position.z = Vector{a.position.z, b.position.z};
    out.velocity.x = Vector{a.velocity.x, b.velocity.x};
    out.velocity.y = Vector{a.velocity.y, b.velocity.y};
    out.velocity.z = Vector{a.velocity.z, b.velocity.z};
    out.time.high = Vector{a.time.high, b.time.high};
    out.time.low = Vector{a.time.low, b.time.low};
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
Lanes product_error(const Lanes& a, const Lanes& b, const Lanes& product) {
#if defined(__wasm__)
  return product_error_by_halves(a, b, product);
#else
  return Lanes::Vector{std::fma(a.v[0], b.v[0], -product.v[0]), std::fma(a.v[1], b.v[1], -product.v[1])};
#endif
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
Lanes::Mask operator!(const Lanes::Mask& mask) {
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

// Four numbers of single precision at a time.
struct Floats {
  static constexpr std::size_t kWidth = 4;
  using Vector = float __attribute__((vector_size(16)));
  using Bits = std::int32_t __attribute__((vector_size(16)));
  struct Mask {
    Bits v;  // all bits of a number, or none
    friend Mask operator&&(const Mask& a, const Mask& b) { return {a.v & b.v}; }
    friend Mask operator||(const Mask& a, const Mask& b) { return {a.v | b.v}; }
  };

  struct Integers {
    using Unsigned = std::uint32_t __attribute__((vector_size(16)));
    Integers() = default;
    Integers(Unsigned vector) : v(vector) {}
    explicit Integers(std::int32_t value) : Integers(static_cast<std::uint32_t>(value)) {}
    explicit Integers(std::uint32_t value) : v{value, value, value, value} {}
    static Integers load(const std::uint32_t* values) {
      return Unsigned{values[0], values[1], values[2], values[3]};
    }
    void store(std::uint32_t* values) const {
      for (int lane = 0; lane < 4; ++lane) values[lane] = v[lane];
    }
    static Integers load_halves(const std::uint32_t* block, const std::uint32_t* /*none*/) {
      return load(block);
    }
    static Integers of_halves(std::int32_t value, std::int32_t /*none*/) { return Integers(value); }
    void keep(unsigned lanes, std::uint32_t* out) const {
      for (int lane = 0; lane < 4; ++lane) {
        *out = v[lane];
        out += lanes >> lane & 1;
      }
    }
    static Integers ascending() { return Unsigned{0, 1, 2, 3}; }
    friend Integers operator+(const Integers& a, const Integers& b) { return a.v + b.v; }
    friend Integers operator-(const Integers& a, const Integers& b) { return a.v - b.v; }
    friend Integers operator&(const Integers& a, const Integers& b) { return a.v & b.v; }
    friend Integers operator|(const Integers& a, const Integers& b) { return a.v | b.v; }
    friend Mask operator==(const Integers& a, const Integers& b) { return {a.v == b.v}; }

    Unsigned v;  // modulo 2^32
  };

  Floats() = default;
  Floats(Vector vector) : v(vector) {}
  explicit Floats(float value) : v{value, value, value, value} {}

  static Floats load(const float* values) { return Vector{values[0], values[1], values[2], values[3]}; }
  static Floats gather(const float* values, const std::uint32_t* at) {
    return Vector{values[at[0]], values[at[1]], values[at[2]], values[at[3]]};
  }
  // Each lane's number modulo eight says which of eight values.
  static Floats pick(const float* eight, const Integers& which) {
    return Vector{eight[which.v[0] % 8], eight[which.v[1] % 8], eight[which.v[2] % 8], eight[which.v[3] % 8]};
  }
  // Four numbers of 32 bits at an address, from each of four structures.
  struct Four {
    Integers a, b, c, d;
  };
  static Four transposed(const CompactPath* paths, const std::uint32_t* at, std::size_t member) {
    const auto row = [&](std::size_t lane) {
      Integers::Unsigned numbers;
      std::memcpy(&numbers, reinterpret_cast<const char*>(paths + at[lane]) + member * sizeof(float),
                  sizeof numbers);
      return numbers;
    };
    const Integers::Unsigned low02 = __builtin_shufflevector(row(0), row(2), 0, 4, 1, 5);
    const Integers::Unsigned high02 = __builtin_shufflevector(row(0), row(2), 2, 6, 3, 7);
    const Integers::Unsigned low13 = __builtin_shufflevector(row(1), row(3), 0, 4, 1, 5);
    const Integers::Unsigned high13 = __builtin_shufflevector(row(1), row(3), 2, 6, 3, 7);
    return {__builtin_shufflevector(low02, low13, 0, 4, 1, 5),
            __builtin_shufflevector(low02, low13, 2, 6, 3, 7),
            __builtin_shufflevector(high02, high13, 0, 4, 1, 5),
            __builtin_shufflevector(high02, high13, 2, 6, 3, 7)};
  }
  static void load(const CompactPath* paths, const std::uint32_t* at, CompactPathsOfLanes<Floats>& out) {
    static_assert(sizeof(CompactPath) == 8 * sizeof(float));
    const Four position = transposed(paths, at, 0);
    out.x = position.a;
    out.y = position.b;
    out.z = position.c;
    out.tick = position.d;
    const Four velocity = transposed(paths, at, 4);
    out.velocity = {bit_cast<Vector>(velocity.a.v), bit_cast<Vector>(velocity.b.v),
                    bit_cast<Vector>(velocity.c.v)};
    out.revision = velocity.d;
  }

  Vector v;
};

Floats operator+(const Floats& a, const Floats& b) {
  return a.v + b.v;
}
Floats operator-(const Floats& a, const Floats& b) {
  return a.v - b.v;
}
Floats operator*(const Floats& a, const Floats& b) {
  return a.v * b.v;
}
Floats operator/(const Floats& a, const Floats& b) {
  return a.v / b.v;
}
Floats multiply_add(const Floats& a, const Floats& b, const Floats& c) {
  return a.v * b.v + c.v;
}
Floats::Mask operator<(const Floats& a, const Floats& b) {
  return {a.v < b.v};
}
// Of numbers with a sign.
Floats::Mask operator<(const Floats::Integers& a, const Floats::Integers& b) {
  return {reinterpret_cast<const Floats::Bits&>(a.v) < reinterpret_cast<const Floats::Bits&>(b.v)};
}
Floats::Mask operator>=(const Floats& a, const Floats& b) {
  return {a.v >= b.v};
}
Floats::Mask operator!(const Floats::Mask& mask) {
  return {~mask.v};
}
unsigned bits(const Floats::Mask& mask) {
  const auto bit = [&mask](int lane) { return mask.v[lane] != 0 ? 1U << lane : 0U; };
  return bit(0) | bit(1) | bit(2) | bit(3);
}
Floats select(const Floats::Mask& mask, const Floats& a, const Floats& b) {
  return mask.v ? a.v : b.v;
}
// Of a NaN and a number, the second argument.
Floats maximum(const Floats& a, const Floats& b) {
  return a.v > b.v ? a.v : b.v;
}
Floats minimum(const Floats& a, const Floats& b) {
  return a.v < b.v ? a.v : b.v;
}
Floats square_root(const Floats& a) {
  return Floats::Vector{std::sqrt(a.v[0]), std::sqrt(a.v[1]), std::sqrt(a.v[2]), std::sqrt(a.v[3])};
}
Floats to_floats(const Floats::Integers& a) {
  return __builtin_convertvector(reinterpret_cast<const Floats::Bits&>(a.v), Floats::Vector);
}
Floats::Integers bits_of(const Floats& a) {
  return bit_cast<Floats::Integers::Unsigned>(a.v);
}
template <int count>
Floats::Integers shifted_right(const Floats::Integers& a) {
  return a.v >> count;
}
Floats::Integers select(const Floats::Mask& mask, const Floats::Integers& a, const Floats::Integers& b) {
  return mask.v ? a.v : b.v;
}
Floats::Integers minimum(const Floats::Integers& a, const Floats::Integers& b) {
  return a.v < b.v ? a.v : b.v;
}
std::uint32_t least_of(const Floats::Integers& a) {
  const std::uint32_t low = a.v[0] < a.v[1] ? a.v[0] : a.v[1];
  const std::uint32_t high = a.v[2] < a.v[3] ? a.v[2] : a.v[3];
  return low < high ? low : high;
}

}  // namespace

const Kernels kPortableKernels{.earliest_contact = earliest_contact<Lanes>,
                               .contacts_of_pairs = contacts_of_pairs<Lanes>,
                               .earliest_step = earliest_step<Lanes>,
                               .bound_contacts = bound_contacts<Floats>,
                               .bound_contacts_of_two = bound_contacts_of_two<Floats>,
                               .bound_each_contact = bound_each_contact<Floats>,
                               .keep_between = keep_between<Floats>,
                               .bound_steps = bound_steps<Floats>,
                               .pick_near = pick_near<Floats>,
                               .find_differences = find_differences<Floats>,
                               .exclude = exclude<Floats>};

}  // namespace hardball
