// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "hardball/errors/export.hpp"

namespace hardball {

/// What a world or a run can have and others exclude; description() says what each is.
enum class Feature : std::uint8_t {
  // Of a world.
  flat,
  gravity,
  growth,
  shear,
  steps,
  merging,
  custom_response,
  passing,
  roughness,
  kinematic,
  moving_walls,
  thermal_walls,
  oscillating_walls,
  curved_walls,
  obstacle_images,
  motions,
  undriven,
  // Of a run.
  thermostat,
  births,
  measures,
  threads,
  processes,
  all_pairs,
  paper,
  // Questions about a world.
  ray,
  first_contact,
};

/// How many features there are [1].
inline constexpr std::size_t kFeatures = static_cast<std::size_t>(Feature::first_contact) + 1;

/// A set of features.
class Features {
 public:
  constexpr Features() = default;
  constexpr Features(Feature feature)  // NOLINT(google-explicit-constructor)
      : bits_(std::uint32_t{1} << static_cast<unsigned>(feature)) {}

  constexpr bool has(Feature feature) const { return !(*this & feature).is_empty(); }
  constexpr bool is_empty() const { return bits_ == 0; }
  /// Adds a feature if `is_present`.
  constexpr void add(Feature feature, bool is_present) {
    if (is_present) bits_ |= Features(feature).bits_;
  }

  friend constexpr Features operator|(Features a, Features b) { return Features(a.bits_ | b.bits_); }
  friend constexpr Features operator&(Features a, Features b) { return Features(a.bits_ & b.bits_); }
  friend constexpr bool operator==(Features, Features) = default;

 private:
  static_assert(kFeatures <= 32);
  explicit constexpr Features(std::uint32_t bits) : bits_(bits) {}

  std::uint32_t bits_ = 0;
};

/// What users read about a feature.
struct FeatureDescription {
  std::string_view name;     ///< As in lists: "gravity".
  std::string_view where;    ///< What errors name as their place if it is first in an exclusion.
  std::string_view meaning;  ///< Without a full stop.
};

/// Two features that do not go together.
struct Exclusion {
  Feature first;            ///< The error says where this one is.
  Feature second;           ///< The feature that the first does not go with.
  std::string_view what;    ///< The problem, as errors state it.
  std::string_view remedy;  ///< What would be accepted.
};

HARDBALL_EXPORT const FeatureDescription& description(Feature feature);
/// All pairs that exclude each other; all other pairs go together.
HARDBALL_EXPORT std::span<const Exclusion> exclusions();

/// All features that any of these excludes.
HARDBALL_EXPORT Features excluded_by(Features features);
/// Whether a feature goes with all of these.
inline bool goes_with(Feature feature, Features others) {
  return (excluded_by(feature) & others).is_empty();
}

/// Error, as exclusions() states it: two of these exclude each other.
HARDBALL_EXPORT void check_exclusions(Features features);
/// Error, with `where` as its place: an exclusion whose first is `feature` and whose second is among
/// `others`.
HARDBALL_EXPORT void check_exclusions(Feature feature, Features others, const std::string& where);

}  // namespace hardball
