// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/errors/version.hpp"

#if defined(__BASE_FILE__)
#define HARDBALL_SOURCE __BASE_FILE__
#else
#define HARDBALL_SOURCE "build"
#endif

// Options that compilers report in macros.
#if defined(__FAST_MATH__)
#define HARDBALL_INEXACT_OPTION "-ffast-math"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#define HARDBALL_INEXACT_OPTION "-ffinite-math-only"
#elif defined(__ASSOCIATIVE_MATH__)
#define HARDBALL_INEXACT_OPTION "-fassociative-math"
#elif defined(__RECIPROCAL_MATH__)
#define HARDBALL_INEXACT_OPTION "-freciprocal-math"
#elif defined(__NO_SIGNED_ZEROS__)
#define HARDBALL_INEXACT_OPTION "-fno-signed-zeros"
#else
#define HARDBALL_INEXACT_OPTION nullptr
#endif

namespace hardball {

/// How a source that includes the library was compiled. Inline functions of the headers are compiled with the
/// options of the source, and the results of a run depend on them.
struct Compilation {
  // In all versions these three come first, so that any two versions can be compared.
  std::uint32_t major_version;
  std::uint32_t minor_version;
  const char* source;  ///< The file, as the compiler was given it.
  // The others are read only if the versions agree.
  std::size_t vector_size;
  std::size_t string_size;
  const char* inexact_option;  ///< Under which arithmetic is not that of IEEE 754; null if there is none.
  // Results whose arithmetic the compiler cannot foresee, and what they are by IEEE 754:
  double product_and_sum;  ///< (1 + e) (1 + e) - (1 + 2 e), with e of 2^-30; 0, as the product is rounded.
  double reordered_sum;    ///< (1 + e) - 1, with e of 2^-60; 0.
  double quotient;         ///< 49 / 49, among others by the same number; 1.
  double sum_of_zeros;     ///< -0 + 0; 0.
  double overflow;         ///< 2^1023 * 4 / 4; infinite.
  double constant;         ///< 0.1.
};

/// Compares how a source was compiled with how the library was; check_compilations reports the first that
/// differs.
HARDBALL_EXPORT void register_compilation(const Compilation& compilation);

/// Error: a source that includes the library was compiled with headers of another version, with objects of
/// other sizes, or with options under which results differ.
HARDBALL_EXPORT void check_compilations();

/// The base of a class of which every program makes objects: the check comes before their first member is
/// written, which may have another place in another version.
class CompilationCheck {
 protected:
  CompilationCheck() { check_compilations(); }
};

// Each source has these for itself: the linker would keep those of one source if they had one name in all.
static Compilation compilation_of_this_source() {
  const volatile double one = 1;
  const volatile double beyond_one = 1 + 0x1p-30;
  const volatile double rounded_square = 1 + 0x1p-29;
  const volatile double tiny = 0x1p-60;
  const volatile double negative_zero = -0.0;
  const volatile double huge = 0x1p1023;
  const volatile double four = 4;
  const volatile double divisors[] = {49, 98, 147, 196};
  volatile double quotients[4] = {};
  const double factor = beyond_one;
  const double divisor = divisors[0];
  for (int k = 3; k >= 0; --k) quotients[k] = divisors[k] / divisor;
  const double start = one;
  return {.major_version = HARDBALL_VERSION_MAJOR,
          .minor_version = HARDBALL_VERSION_MINOR,
          .source = HARDBALL_SOURCE,
          .vector_size = sizeof(std::vector<double>),
          .string_size = sizeof(std::string),
          .inexact_option = HARDBALL_INEXACT_OPTION,
          .product_and_sum = factor * factor - rounded_square,
          .reordered_sum = (start + tiny) - start,
          .quotient = quotients[0],
          .sum_of_zeros = negative_zero + 0.0,
          .overflow = huge * four / four,
          .constant = 0.1};
}

[[maybe_unused]] static const bool kIsRegistered = (register_compilation(compilation_of_this_source()), true);

}  // namespace hardball

#undef HARDBALL_SOURCE
#undef HARDBALL_INEXACT_OPTION
