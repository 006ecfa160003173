// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"

namespace hardball {

/// The vector instructions of the kernels. All give the same bits.
enum class InstructionSet {
  portable,  ///< The compiler's baseline: on x86-64 two numbers in double precision at a time.
  avx2,      ///< Four numbers in double precision at a time, eight in single precision.
  avx512,    ///< Sixteen numbers in single precision at a time, and mask registers.
};
template <>
inline constexpr std::array<std::string_view, 3> kNames<InstructionSet>{"portable", "avx2", "avx512"};

/// The most numbers processed at a time: arrays that kernels read are padded by as many.
inline constexpr std::size_t kWidestVector = 16;

/// Whether this program has kernels with these instructions.
HARDBALL_EXPORT bool is_compiled_in(InstructionSet instructions);

/// Whether this program and this machine support these instructions.
HARDBALL_EXPORT bool is_available(InstructionSet instructions);

/// The instructions available with which runs take the least time: on Intel's processors avx2, although
/// avx512 is wider. Source: docs/performance.md.
HARDBALL_EXPORT InstructionSet fastest_instruction_set();

}  // namespace hardball
