// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/describe/field.hpp"

/// The fields that several kinds of thermostats have.
namespace hardball {

/// The temperature that a thermostat keeps.
template <class Get>
constexpr Field<Get> temperature_field(Get get) {
  return {.name = "temperature",
          .get = get,
          .range = NumberRange::positive,
          .dimension = "M L²/T²",
          .meaning = "the kT of the thermostat",
          .example = "1.0"};
}

/// The interval between actions on all spheres.
template <class Get>
constexpr Field<Get> every_field(Get get) {
  return {.name = "every",
          .get = get,
          .range = NumberRange::positive,
          .dimension = "T",
          .meaning = "the time between two actions on all spheres",
          .example = "0.1"};
}

}  // namespace hardball
