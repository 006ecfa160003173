// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball {

/// How long windows are.
struct WindowSettings {
  double contacts = 1000;  ///< The target number in a window, of all domains together.
  /// The target number where spheres fly less than a tenth of a diameter in a window.
  double more_contacts = 1000;
  double first = 1;   ///< The length of the first window [T].
  double flight = 1;  ///< The time in which a sphere of mean speed flies the largest diameter [T].
};

}  // namespace hardball
