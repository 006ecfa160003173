// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "hardball/errors/error.hpp"

namespace hardball {

/// The names of the values of an enumeration, in their order, by which users know them everywhere: an array
/// of std::string_view, defined beside the enumeration.
template <class Enum>
inline constexpr std::nullptr_t kNames = nullptr;

/// An enumeration whose values have names.
template <class Enum>
concept Named = requires {
  kNames<Enum>.size();
};

template <Named Enum>
constexpr std::string_view name_of(Enum value) {
  return kNames<Enum>[static_cast<std::size_t>(value)];
}

/// The value of this name; none if there is none.
template <Named Enum>
constexpr std::optional<Enum> find_named(std::string_view name) {
  for (std::size_t i = 0; i < kNames<Enum>.size(); ++i) {
    if (kNames<Enum>[i] == name) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

/// All names, with commas.
template <Named Enum>
std::string all_names() {
  std::string all;
  for (const std::string_view name : kNames<Enum>) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

/// The value of this name. Error, with `where` as its place: there is none.
template <Named Enum>
Enum value_named(std::string_view name, std::string_view where) {
  if (const auto found = find_named<Enum>(name)) return *found;
  throw Error("unknown value '" + shortened(name) + "'", std::string(where),
              "choose one of " + all_names<Enum>());
}

}  // namespace hardball
