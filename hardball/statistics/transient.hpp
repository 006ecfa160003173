// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>

#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/statistics/qualification.hpp"

namespace hardball {

/// The initial part of a run, which still depends on its initial state.
struct Transient {
  std::optional<double> end;  ///< When it ends [T], if there is one.
  bool is_over = true;        ///< Whether it ends in the first half of the run. If not, nothing is left out.
  std::string reason = {};    ///< Why it is not over, without a comma; empty if it is.

  /// An average without it.
  BlockAverage left_out_of(const BlockAverage& average) const;

  /// Records in a measurement what was left out. If the transient is not over, the means depend on the length
  /// of the run: see leave_unsettled_open().
  void note_in(Measurement& measurement) const;
};

/// Looks for a transient in the most sensitive quantities: one sixteenth of the run after another is left out
/// until one agrees within two standard errors with the second half of the run, and so does what is left of
/// the first half, for each quantity. It is not over if none agrees, and the halves differ by more than three
/// standard errors; this also holds where samples are few, as far as groups give errors. Where the error of
/// the second half is not known, no transient can be detected. Source: Geweke, in Bayesian Statistics 4
/// (1992) 169, the comparison; Heidelberger and Welch, Oper. Res. 31 (1983) 1109, leaving out step by step,
/// up to half.
Transient find_transient(const BlockAverage& average, std::span<const FunctionOfMeans> quantities,
                         BlockAverage::Groups groups = BlockAverage::Groups::none);

/// A transient that also covers the part of the run that depends on its start by other evidence.
Transient find_transient(const BlockAverage& average, std::span<const FunctionOfMeans> quantities,
                         const Settled& settled, BlockAverage::Groups groups = BlockAverage::Groups::none);

/// The one that lasts longer.
Transient longer(const Transient& a, const Transient& b);

}  // namespace hardball
