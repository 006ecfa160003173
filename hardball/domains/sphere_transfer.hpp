// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hardball/processes/bytes.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/journal.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A sphere on its way from one process to another.
struct SphereTransfer {
  SphereState state;
  std::uint32_t idle_contacts = 0;  ///< See CollapseGuard.
};

/// Many of them, in pieces of memory that are freed one by one: there are as many as a process has spheres.
class SphereTransfers {
 public:
  void push_back(const SphereTransfer& transfer) {
    constexpr std::size_t kPiece = 1 << 14;
    if (pieces_.empty() || pieces_.back().size() == kPiece) pieces_.emplace_back().reserve(kPiece);
    pieces_.back().push_back(transfer);
    ++size_;
  }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Calls visit(transfer) for each, in the order in which they were added.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const auto& piece : pieces_) ranges::for_each(piece, visit);
  }
  template <class Visit>
  void for_each(Visit&& visit) {
    for (auto& piece : pieces_) ranges::for_each(piece, visit);
  }
  /// Takes some of them out; none if there are none left.
  std::vector<SphereTransfer> take_some() {
    std::vector<SphereTransfer> some;
    if (pieces_.empty()) return some;
    some.swap(pieces_.back());
    pieces_.pop_back();
    size_ -= some.size();
    return some;
  }

 private:
  std::vector<std::vector<SphereTransfer>> pieces_;
  std::size_t size_ = 0;
};

/// Sends spheres to other processes, and returns those that arrive here. For each one route(transfer,
/// send_to) calls send_to(rank) for every process that it is to reach. Memory: that of those sent or of those
/// that arrive, and little more.
template <class Route>
SphereTransfers sent(SphereTransfers transfers, Processes& processes, Route&& route) {
  SphereTransfers arrived;
  while (ranges::max(processes.gather(transfers.size())) > 0) {
    std::vector<std::string> outgoing(processes.size());
    for (const SphereTransfer& transfer : transfers.take_some())
      route(transfer, [&](std::size_t rank) { append_value(transfer, outgoing[rank]); });
    for (const std::string& part : processes.exchange_with_all(std::move(outgoing))) {
      std::vector<SphereTransfer> some;
      append_bytes(part, some);
      for (const SphereTransfer& transfer : some) arrived.push_back(transfer);
    }
  }
  return arrived;
}

/// Inserts spheres into a world, and calls visit(transfer) for each.
template <class Visit>
void insert(SphereTransfers transfers, World& world, Visit&& visit) {
  std::vector<SphereTransfer> some;
  world.insert_all(transfers.size(), [&](std::size_t) {
    if (some.empty()) some = transfers.take_some();
    const SphereTransfer next = some.back();
    some.pop_back();
    visit(next);
    return next.state;
  });
}

}  // namespace hardball
