// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/kernels/bound_kernel.hpp"
#include "hardball/kernels/contact_kernel.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/kernels/near_kernel.hpp"

namespace hardball {

/// Arithmetic on many pairs at a time, with one instruction set.
struct Kernels {
  ContactKernel earliest_contact;
  PairKernel contacts_of_pairs;
  StepKernel earliest_step;
  BoundKernel bound_contacts;
  BoundPairKernel bound_contacts_of_two;
  EachBoundKernel bound_each_contact;
  KeepBetweenKernel keep_between;
  StepBoundKernel bound_steps;
  NearKernel pick_near;
  DifferenceKernel find_differences;
  ExcludeKernel exclude;
};

/// Error: the instruction set is not available.
const Kernels& kernels_of(InstructionSet instructions);

extern const Kernels kPortableKernels;
#if defined(__x86_64__) && defined(__GNUC__)
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;
#endif

}  // namespace hardball
