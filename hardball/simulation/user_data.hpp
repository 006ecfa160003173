// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>

#include "hardball/events/event.hpp"

namespace hardball {

/// A number that the caller attaches to each sphere, by id: zero until it is set, and kept until the sphere
/// is removed. Uses memory only for those set. Cost: O(1).
class UserData {
 public:
  std::uint64_t get(SphereId id) const {
    const auto found = numbers_.find(id);
    return found != numbers_.end() ? found->second : 0;
  }
  void set(SphereId id, std::uint64_t data) { numbers_[id] = data; }
  void remove(SphereId id) { numbers_.erase(id); }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.numbers_); }

  std::unordered_map<SphereId, std::uint64_t> numbers_;
};

}  // namespace hardball
