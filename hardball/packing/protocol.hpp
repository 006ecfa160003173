// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// How spheres are packed: the numbers of the protocol. Pressures are PV/NkT of the median sphere, and
/// collisions count for each sphere. Source: docs/decisions/0034-packings.md.
namespace hardball::protocol {

/// The packing fraction of the random start.
inline constexpr double kStart = 0.3;
inline constexpr double kStartOfDiscs = 0.4;
/// Growth to the first pressure is as fast as this: a fluid forgets it.
inline constexpr double kFillingRate = 0.1;
inline constexpr double kFilled = 10;
/// A pressure is averaged over at least this many collisions.
inline constexpr double kWindow = 10;
/// From this pressure on spheres that are to jam relax at constant size between steps of growth.
inline constexpr double kRelaxedFrom = 1e3;
/// A step of growth multiplies sizes by one plus this over the pressure.
inline constexpr double kStep = 0.2;
/// Collisions before the window in which the pressure is measured.
inline constexpr double kRelaxation = 30;
/// Spheres have jammed beyond this pressure.
inline constexpr double kJammed = 1e9;
/// Collisions from which the forces between spheres that have jammed are averaged.
inline constexpr double kWeighing = 100;
/// Spheres that are to be as dense as a goal and reach this pressure have locked.
inline constexpr double kLocked = 1e4;
/// How often packing begins anew with another number of spheres, where that follows from their diameter.
inline constexpr int kRecounts = 12;
/// A pressure is reached between the pressure wanted and this many times it; the aim is kSought times it.
inline constexpr double kHighest = 1.1;
inline constexpr double kSought = 1.05;
/// Collisions that reaching a pressure takes.
inline constexpr double kApproach = 400;
/// Spheres that jam within this distance of the packing fraction wanted have reached it.
inline constexpr double kExact = 1e-8;
/// How often the rate is halved when spheres have locked.
inline constexpr int kAttempts = 3;
/// The least rate that is chosen automatically.
inline constexpr double kSlowest = 1e-3;

}  // namespace hardball::protocol
