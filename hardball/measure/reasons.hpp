// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Reasons why measured numbers have no value or no error, each without a comma.
namespace hardball {

inline constexpr const char* kStillCrystal =
    "the spheres still have the order of the crystal in which they started";
inline constexpr const char* kStillInPlace = "the spheres have not left the places at which they started";
inline constexpr const char* kStillSpreading = "the spheres are still spreading evenly through the box";
inline constexpr const char* kCounted = "it is a count of this run";
inline constexpr const char* kReachChosen = "it is a choice of the measure";
inline constexpr const char* kLagChosen = "it is the lag at which the constant was read";
/// Where all spheres pass through each other.
inline constexpr const char* kVelocitiesOfTheStart =
    "the spheres pass through each other and keep the velocities of their start";

}  // namespace hardball
