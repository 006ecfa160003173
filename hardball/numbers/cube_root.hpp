// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball {

/// The cube root of a positive normal number, to a few units in the last place and the same on every machine:
/// the C library's may differ from one to the next.
double cube_root(double x);

}  // namespace hardball
