// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/statistics/measurement.hpp"

/// What measured numbers are worth: which have no error, or are left out, and why.
namespace hardball {

/// By how much means differ among runs whose starts were drawn with other random numbers, as their energy is
/// that of the start. All are zero where the energy of the start is prescribed, or does not last.
struct StartSpread {
  /// Standard deviation of the temperature at which runs settle, over that temperature [1]; an
  /// upper estimate, up to twice too large.
  double temperature = 0;
  /// By how much, relative to the temperature, it moves numbers that depend on where the spheres are [1].
  double sensitivity_of_places = 0;
};

/// How far a run has come from its start.
struct Settled {
  double end = 0;         ///< How long it depended on its start, since measuring began [T].
  bool is_over = true;    ///< Whether that is at most half of the run. If not, means depend on its length.
  std::string reason;     ///< Why it is not over, without a comma; empty if it is.
  bool is_steady = true;  ///< Whether energy is conserved, or the temperature has settled.
  StartSpread spread;     ///< What other random numbers at the start would change.
};

inline constexpr const char* kNotSteady = "the temperature keeps changing and there is no steady state";

/// Removes the error of a quantity unless its value is exact, for a reason without a comma; the theory is
/// then for comparison only.
void leave_open(Quantity& quantity, const std::string& reason);

/// Removes the errors of all quantities, as leave_open() does for one.
void leave_quantities_open(Measurement& measurement, const std::string& reason);

/// Removes the errors of all quantities and columns of a finished measurement if its transient is not over.
void leave_unsettled_open(Measurement& measurement);

/// Removes the value and the error of a quantity, for a reason without a comma.
void leave_out(Quantity& quantity, const std::string& reason);

/// Leaves out a number that by its nature is not negative, where it comes out negative by chance.
void require_not_negative(Quantity& quantity);

/// Gives every quantity that has no error a reason, and adds to errors what differs among runs from other
/// random starts: to numbers that are proportional to a power of time, as far as the temperature sets its
/// scale, and to all, as far as places depend on the temperature. Of a run that has not settled it removes
/// errors: all, or where only the temperature keeps changing those of quantities with a unit of time.
/// Precondition: `duration` is set.
void qualify(Measurement& measurement, const Settled& settled);

}  // namespace hardball
