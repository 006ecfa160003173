// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/statistics/measurement.hpp"
#include "hardball/statistics/settled.hpp"

/// What measured numbers are worth: which have no error, or are left out, and why.
namespace hardball {

inline constexpr const char* kNotSteady = "the temperature keeps changing and there is no steady state";

/// Removes the error of a quantity unless its value is exact, for a reason without a comma; the theory is
/// then for comparison only.
void leave_open(Quantity& quantity, const std::string& reason);

/// Removes the errors of all quantities, and those of columns, as leave_open() does for one.
void leave_all_open(Measurement& measurement, const std::string& reason);

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
