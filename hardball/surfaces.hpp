// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Walls and obstacles: planes, tubes, hollow spheres, fixed spheres, meshes of triangles, and what they are
/// made of.
#include "hardball/errors/compilation.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/surfaces/surface.hpp"
