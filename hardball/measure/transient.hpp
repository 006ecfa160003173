// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "hardball/measure/block_average.hpp"
#include "hardball/measure/measurement.hpp"

namespace hardball {

/// The beginning of a run, in which it still depends on its start state.
struct Transient {
  std::optional<double> end;  ///< Up to when it lasts [T], if there is one.
  bool is_over = true;        ///< Whether it ends in the first half of the run. If not, nothing is left out.

  /// What is left of an average without it.
  BlockAverage left_out_of(const BlockAverage& average) const;

  /// Notes in a finished measurement what was left out. If the transient is not over, the means depend on
  /// the length of the run, and no error is left to them.
  void note_in(Measurement& measurement) const;
};

/// Looks for a transient in some quantities, those that tell best: a sixteenth of the run after the other is
/// left out until one agrees within two standard errors with the second half of the run, for each quantity. A
/// run that is too short to know the error of its second half has no transient that could be told from it.
/// Source: Geweke, in Bayesian Statistics 4 (1992) 169, the comparison; Heidelberger and Welch, Oper. Res. 31
/// (1983) 1109, to leave out step by step, and half at the most.
Transient find_transient(const BlockAverage& average, std::span<const FunctionOfMeans> quantities,
                         BlockAverage::Groups groups = BlockAverage::Groups::none);

}  // namespace hardball
