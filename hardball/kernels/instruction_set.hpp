// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace hardball {

/// The vector instructions of the kernels. All give the same bits.
enum class InstructionSet {
  portable,  ///< The compiler's baseline: on x86-64 two numbers at a time.
  avx2,      ///< Four numbers at a time.
  avx512,    ///< Four numbers at a time, with twice the registers and with mask registers.
};

/// The most numbers processed at a time: arrays that kernels read are padded by as many.
inline constexpr std::size_t kWidestVector = 8;

/// Whether this program and this machine support these instructions.
bool is_available(InstructionSet instructions);

/// The widest instructions available.
InstructionSet widest_instruction_set();

}  // namespace hardball
