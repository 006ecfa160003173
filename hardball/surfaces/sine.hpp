// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/time.hpp"

namespace hardball {

/// A sine and a cosine.
struct Circular {
  DoubleDouble<> sine;
  DoubleDouble<> cosine;
};

/// The sine and cosine of `frequency` [1/T] times `time` turns, to about 2^-98, from additions,
/// multiplications and divisions alone: the C library's may differ from one platform to the next. Of
/// more than 2^100 turns, zero and one.
Circular circular(double frequency, const Time& time);

}  // namespace hardball
