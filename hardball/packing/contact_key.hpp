// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// Two bodies that touch: spheres by id, `image` being that of the second which the first meets, or a sphere
/// and a wall, numbered from kFaces on where it is curved.
struct ContactKey {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  bool is_wall = false;
  Image image = {};

  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.first, self.second, self.is_wall, self.image);
  }
};

}  // namespace hardball

template <>
struct std::hash<hardball::ContactKey> {
  std::size_t operator()(const hardball::ContactKey& key) const {
    std::uint64_t bits = (std::uint64_t{key.first} << 32 | key.second) ^ (key.is_wall ? 1 : 0);
    for (const std::int32_t boxes : key.image.boxes)
      bits = bits * 0x9E3779B97F4A7C15 + static_cast<std::uint32_t>(boxes);
    return static_cast<std::size_t>(bits ^ bits >> 32);
  }
};
