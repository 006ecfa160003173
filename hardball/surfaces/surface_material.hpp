// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "hardball/errors/export.hpp"

namespace hardball {

/// How a surface or a face of the box reflects spheres that touch it.
struct SurfaceMaterial {
  std::optional<double> restitution = {};  ///< [1]; that of the response if absent.
  /// How rough it is, as BounceRules has it: from -1, smooth, to 1 [1]; that of the response if absent. A
  /// thermal wall does not turn spheres.
  std::optional<double> tangential_restitution = {};
  /// k T of a thermal wall [M L^2 T^-2], from which spheres return with random velocities; if absent, the
  /// surface reflects.
  std::optional<double> temperature = {};
  std::uint64_t seed = 0;  ///< Seed of a thermal wall's random numbers.
  /// Whether spheres return from a thermal wall within the plane z = 0: in a contact, as the box has it.
  bool is_flat = false;

  friend bool operator==(const SurfaceMaterial&, const SurfaceMaterial&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.restitution, self.temperature, self.seed, self.is_flat);
    if (archive.version() >= kSinceVersion) archive(self.tangential_restitution);
  }
  static constexpr std::uint32_t kSinceVersion = 15;  // of archives that have tangential_restitution
};

/// Error, with `where` as its place: a restitution that is not between 0 and 1, or a tangential one that is
/// not between -1 and 1; a temperature that is negative or not finite.
HARDBALL_EXPORT void check_material(const SurfaceMaterial& material, std::string_view where);

}  // namespace hardball
