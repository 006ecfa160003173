// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "hardball/measure/block_average.hpp"
#include "hardball/measure/measurement.hpp"

namespace hardball {

/// The initial part of a run, which still depends on its initial state.
struct Transient {
  std::optional<double> end;  ///< When it ends [T], if there is one.
  bool is_over = true;        ///< Whether it ends in the first half of the run. If not, nothing is left out.

  /// An average without it.
  BlockAverage left_out_of(const BlockAverage& average) const;

  /// Records in a finished measurement what was left out. If the transient is not over, the means depend on
  /// the length of the run, and their errors are removed.
  void note_in(Measurement& measurement) const;
};

/// Looks for a transient in the most sensitive quantities: one sixteenth of the run after another is left out
/// until one agrees within two standard errors with the second half of the run, for each quantity. In a run
/// that is too short for the error of its second half to be known, no transient can be detected. Source:
/// Geweke, in Bayesian Statistics 4 (1992) 169, the comparison; Heidelberger and Welch, Oper. Res. 31 (1983)
/// 1109, leaving out step by step, up to half.
Transient find_transient(const BlockAverage& average, std::span<const FunctionOfMeans> quantities,
                         BlockAverage::Groups groups = BlockAverage::Groups::none);

}  // namespace hardball
