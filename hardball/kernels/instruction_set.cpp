// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/kernels/instruction_set.hpp"

namespace hardball {
namespace {

bool is_made_by_intel() {
#if defined(__x86_64__) && defined(__GNUC__)
  return __builtin_cpu_is("intel");
#else
  return false;
#endif
}

}  // namespace

bool is_compiled_in([[maybe_unused]] InstructionSet instructions) {
#if defined(__x86_64__) && defined(__GNUC__)
  return true;
#else
  return instructions == InstructionSet::portable;
#endif
}

bool is_available(InstructionSet instructions) {
  switch (instructions) {
    case InstructionSet::portable:
      return true;
#if defined(__x86_64__) && defined(__GNUC__)
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
#else
    case InstructionSet::avx2:
    case InstructionSet::avx512:
      return false;
#endif
  }
  return false;
}

InstructionSet fastest_instruction_set() {
  if (is_available(InstructionSet::avx512) && !is_made_by_intel()) return InstructionSet::avx512;
  if (is_available(InstructionSet::avx2)) return InstructionSet::avx2;
  return InstructionSet::portable;
}

}  // namespace hardball
