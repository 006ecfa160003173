// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/growth.hpp"
#include "hardball/geometry/motion.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// How much closer to a wall than its radius a center may lie through rounding alone, relative to the box.
inline constexpr double kWallTolerance = 1e-12;

/// Error, with `where` as its place: a vector in a box of two dimensions has a component along z; `what`
/// names it.
void refuse_out_of_plane(const Vec3& vector, const std::string& what, const std::string& where);

/// Error: gravity is outside the operating range; a surface does not fit into the box; or, in two dimensions,
/// either leaves the plane.
void check_setting(const Box& box, const Motion& motion, std::span<const Surface> surfaces);

/// Error: an epoch of growth has a number that is not finite, an end before its begin, or a scale that is not
/// positive throughout.
void check_growth(const Growth& growth);

/// Error: a wall moves, oscillates or has a temperature, which growth excludes.
void check_walls_for_growth(const Box& box, std::span<const Surface> surfaces);

/// The radius of the largest sphere that fits into the box and into each surface that is closed around an
/// axis or a center [L]; infinite in open space.
HARDBALL_EXPORT double largest_fitting_radius(const Box& box, std::span<const Surface> surfaces);

/// Error: no sphere can reach a surface, since faces of the box are in front of it.
void check_reachable(const Box& box, std::span<const Surface> surfaces);

}  // namespace hardball
