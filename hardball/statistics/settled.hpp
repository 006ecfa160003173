// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

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

}  // namespace hardball
