// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hardball/world/world.hpp"

namespace hardball {

/// A number of the caller's for each sphere, by id: zero until it is set, and kept until the sphere is
/// removed. Takes no memory until the first is set.
class UserData {
 public:
  /// Cost: O(log n).
  std::uint64_t get(SphereId id) const;
  /// Precondition: the world has the sphere. Cost: O(log n); O(n) where spheres have been added since the
  /// last number was set.
  void set(const World& world, SphereId id, std::uint64_t data);
  /// Cost: O(n).
  void remove(SphereId id);

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.entries_); }
  bool restored() const;

  struct Entry {
    SphereId id;
    std::uint64_t data;
    static void persist(auto& archive, auto& self) { archive(self.id, self.data); }
  };

  std::vector<Entry> entries_;  // in the order of ids
};

}  // namespace hardball
