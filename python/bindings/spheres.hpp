// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "hardball/world/world.hpp"

namespace hardball::python {

/// Spheres from arrays, or from one value for all; positions are of shape (n, 3) or, if `is_flat`, also (n,
/// 2). If `moment` is None, they are uniform: discs if `is_flat`. Error: shapes or lengths differ.
std::vector<Sphere> spheres_of(const pybind11::object& positions, const pybind11::object& velocities,
                               const pybind11::object& radius, const pybind11::object& mass,
                               const pybind11::object& spin, const pybind11::object& species,
                               const pybind11::object& moment, bool is_flat);

}  // namespace hardball::python
