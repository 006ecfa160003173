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

inline constexpr const char* kStillCrystal =
    "the spheres still have the order of the crystal in which they started";
inline constexpr const char* kStillInPlace = "the spheres have not left the places at which they started";
inline constexpr const char* kStillSpreading = "the spheres are still spreading evenly through the box";
inline constexpr const char* kStillChanging = "it still changes in the second half of the run";
inline constexpr const char* kNotSteady = "the temperature keeps changing and there is no steady state";
inline constexpr const char* kLagChosen = "it is the lag at which the constant was read";
/// Why there is no number where all spheres pass through each other.
inline constexpr const char* kVelocitiesOfTheStart =
    "the spheres pass through each other and keep the velocities of their start";

}  // namespace hardball
