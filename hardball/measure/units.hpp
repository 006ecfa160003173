// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/world/box.hpp"

/// Units that depend on the number of dimensions.
namespace hardball {

inline const char* pressure_unit(const Box& box) {
  return box.is_flat() ? "M T^-2" : "M L^-1 T^-2";
}
inline const char* viscosity_unit(const Box& box) {
  return box.is_flat() ? "M T^-1" : "M L^-1 T^-1";
}
inline const char* number_density_unit(const Box& box) {
  return box.is_flat() ? "L^-2" : "L^-3";
}

}  // namespace hardball
