// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball {

/// How long windows are.
struct WindowSettings {
  double contacts = 1000;       ///< The target number in a window, of all domains together.
  double more_contacts = 1000;  ///< The same where spheres fly less than a tenth of a diameter meanwhile.
  double first = 1;             ///< The length of the first window [T].
  double flight = 1;            ///< In which a sphere of mean speed flies by the largest diameter [T].
};

}  // namespace hardball
