// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/errors/compilation.hpp"

#include <atomic>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {
namespace {

constexpr const char* kRemedy = " (pkg-config --cflags hardball prints what is needed)";

// A result of arithmetic, and what a compiler does that gets another.
struct Expectation {
  double Compilation::*result;
  double expected;
  const char* deed;
  const char* option;  // that forbids it
};

constexpr Expectation kExpectations[] = {
    // More precision shows in other results, too.
    {&Compilation::overflow, std::numeric_limits<double>::infinity(),
     "computes in more than double precision", "-msse2 -mfpmath=sse"},
    {&Compilation::constant, 0.1, "reads constants in single precision", "-fno-single-precision-constant"},
    {&Compilation::product_and_sum, 0, "rounds a product and a sum in one", "-ffp-contract=off"},
    {&Compilation::reordered_sum, 0, "changes the order of sums", "-fno-associative-math"},
    {&Compilation::quotient, 1, "multiplies by reciprocals instead of dividing", "-fno-reciprocal-math"},
    {&Compilation::sum_of_zeros, 0, "ignores the sign of zero", "-fsigned-zeros"},
};

std::string version_text(std::uint32_t major, std::uint32_t minor) {
  return to_text(major) + "." + to_text(minor);
}

// What is wrong with how a source was compiled; nothing if all is right.
std::optional<Error> fault_of(const Compilation& source) {
  if (source.major_version != HARDBALL_VERSION_MAJOR || source.minor_version != HARDBALL_VERSION_MINOR) {
    return Error("this source is compiled with headers of Hardball " +
                     version_text(source.major_version, source.minor_version) +
                     ", and the library is version " +
                     version_text(HARDBALL_VERSION_MAJOR, HARDBALL_VERSION_MINOR),
                 source.source, "compile it with the headers that are installed with the library");
  }
  if (source.vector_size != sizeof(std::vector<double>) || source.string_size != sizeof(std::string)) {
    return Error(
        "this source is compiled with another standard library than Hardball, or in another mode of it",
        source.source, "compile both alike, without -D_GLIBCXX_DEBUG");
  }
  if (source.inexact_option) {
    return Error(std::string("this source is compiled with ") + source.inexact_option +
                     ", under which results differ from those of other builds",
                 source.source, "compile it without this option");
  }
  for (const Expectation& each : kExpectations) {
    if (bit_cast<std::uint64_t>(source.*each.result) == bit_cast<std::uint64_t>(each.expected)) continue;
    return Error(
        std::string("the compiler ") + each.deed + ", so that results differ from those of other builds",
        source.source, std::string("compile it with ") + each.option + kRemedy);
  }
  return {};
}

// That of the first source that has one; it is never released.
constinit std::atomic<const Error*> first_fault = nullptr;

}  // namespace

void register_compilation(const Compilation& compilation) {
  const std::optional<Error> fault = fault_of(compilation);
  if (!fault) return;
  auto owned = std::make_unique<const Error>(*fault);
  const Error* none = nullptr;
  if (first_fault.compare_exchange_strong(none, owned.get())) static_cast<void>(owned.release());
}

void check_compilations() {
  if (const Error* const fault = first_fault.load(std::memory_order_acquire)) throw Error(*fault);
}

}  // namespace hardball
