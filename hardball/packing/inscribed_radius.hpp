// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/meshes/mesh.hpp"

namespace hardball {

/// A bound of the radius of the largest sphere within a closed mesh [L]: no less than that, and mostly no
/// more than 1% above. Where a mesh is much longer than wide, the bound may be looser. Cost: some thousand
/// questions for the nearest point. Precondition: the mesh is closed and has a volume.
double inscribed_radius(const Mesh& mesh);

}  // namespace hardball
