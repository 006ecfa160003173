// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/kernels/kernels.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {

const Kernels& kernels_of(InstructionSet instructions) {
  if (!is_available(instructions)) {
    throw Error("this machine does not support the requested vector instructions", "instructions",
                "use the default, or the portable ones");
  }
#if defined(__x86_64__) && defined(__GNUC__)
  if (instructions == InstructionSet::avx512) return kAvx512Kernels;
  if (instructions == InstructionSet::avx2) return kAvx2Kernels;
#endif
  return kPortableKernels;
}

}  // namespace hardball
