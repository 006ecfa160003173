// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hardball/domains/domain.hpp"

namespace hardball {

/// The contacts of all domains in their total order.
///
/// Each domain's log has all contacts of its own spheres in that order. A contact of spheres of two owners is
/// in both logs. Simultaneous contacts are not ordered by ids where one causes the other, so what comes next
/// is the least contact of those at which all logs that have it have arrived. Cost: O(domains) each.
class MergedLog {
 public:
  explicit MergedLog(std::vector<std::span<const LoggedContact>> logs)
      : logs_(std::move(logs)), next_(logs_.size()) {}

  /// The next contact; null at the end.
  const Contact* next() {
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::size_t least = kNone;
    for (std::size_t log = 0; log < logs_.size(); ++log) {
      if (!is_ready(log)) continue;
      if (least == kNone || comes_before(head(log).contact, head(least).contact)) least = log;
    }
    if (least == kNone) return nullptr;
    const LoggedContact& logged = head(least);
    ++next_[least];
    if (logged.other_owner != LoggedContact::kNobody) ++next_[logged.other_owner];
    return &logged.contact;
  }

 private:
  const LoggedContact& head(std::size_t log) const { return logs_[log][next_[log]]; }
  bool is_ready(std::size_t log) const {
    if (next_[log] == logs_[log].size()) return false;
    const LoggedContact& logged = head(log);
    if (logged.other_owner == LoggedContact::kNobody) return true;
    // Two domains have the contact; it comes from the one that counts it.
    if (!logged.counts) return false;
    const std::size_t other = logged.other_owner;
    return next_[other] < logs_[other].size() && is_same(head(other).contact, logged.contact);
  }
  static bool is_same(const Contact& a, const Contact& b) {
    return a.time == b.time && a.kind == b.kind && a.first == b.first && a.second == b.second;
  }
  static bool comes_before(const Contact& a, const Contact& b) {
    const Event first{a.time, a.kind, a.first, a.second, a.image};
    const Event second{b.time, b.kind, b.first, b.second, b.image};
    return first < second;
  }

  std::vector<std::span<const LoggedContact>> logs_;
  std::vector<std::size_t> next_;
};

}  // namespace hardball
