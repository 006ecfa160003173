// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace hardball {

/// How a system is divided among domains. It changes the speed and never the motion.
struct Division {
  std::size_t domains = 1;      ///< In each process; half as many, again and again, if the box is too small.
  std::size_t threads = 1;      ///< Threads of each process.
  double halo = 1.75;           ///< Depth of halos, in diameters of the largest sphere; above one [1].
  double window = 0.02;         ///< Contacts for each sphere in a window, two spheres being in each [1]; up
                                ///< to twice as many in small domains.
  double first_window = 0.001;  ///< Length of the first window, in radii at the mean speed [1].
};

}  // namespace hardball
