// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/id_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::id_order_test {
namespace {

std::vector<Slot> slots_of(const IdOrder& order) {
  std::vector<Slot> slots;
  order.for_each([&](Slot slot) { slots.push_back(slot); });
  return slots;
}

// Against a sorted vector: spheres come and go as in a world, where the last takes the slot of one removed,
// and the removals are undone now and then, the last first.
TEST(IdOrder, AgreesWithASortedVector) {
  for (const bool starts_sorted : {true, false}) {
    Random random(7);
    std::vector<SphereId> ids(2000);  // by slot
    std::iota(ids.begin(), ids.end(), SphereId{0});
    if (!starts_sorted) {
      for (std::size_t i = ids.size(); i > 1; --i) std::swap(ids[i - 1], ids[random.bits() % i]);
    }
    SphereId next = 2000;
    IdOrder order;
    order.sort(ids, next);
    struct Removed {
      SphereId id;
      Slot slot;
    };
    std::vector<Removed> removed;
    const auto rank_of = [&](SphereId id) {
      return static_cast<std::size_t>(
          std::ranges::count_if(ids, [id](SphereId other) { return other < id; }));
    };
    for (std::uint64_t step = 0; step < support::cases(3000); ++step) {
      const double what = random.uniform();
      if (what < 0.2) {
        order.append();
        ids.push_back(next++);
        removed.clear();
      } else if (what < 0.8 && !ids.empty()) {
        const auto slot = static_cast<Slot>(random.bits() % ids.size());
        const std::size_t rank = rank_of(ids[slot]);
        if (slot + 1 < ids.size()) order.move(rank_of(ids.back()), slot);
        order.erase(rank);
        removed.push_back({ids[slot], slot});
        ids[slot] = ids.back();
        ids.pop_back();
      } else if (!removed.empty()) {
        const auto [id, slot] = removed.back();
        removed.pop_back();
        const auto last = static_cast<Slot>(ids.size());
        if (slot < last) {
          order.move(rank_of(ids[slot]), last);
          ids.push_back(ids[slot]);
          ids[slot] = id;
        } else {
          ids.push_back(id);
        }
        order.insert(rank_of(id), slot);
      }
      std::vector<Slot> expected(ids.size());
      std::iota(expected.begin(), expected.end(), Slot{0});
      std::ranges::sort(expected, {}, [&](Slot slot) { return ids[slot]; });
      ASSERT_EQ(order.size(), ids.size());
      ASSERT_EQ(slots_of(order), expected) << "step " << step;
      for (std::size_t rank = 0; rank < ids.size(); rank += 97) ASSERT_EQ(order[rank], expected[rank]);
    }
  }
}

TEST(IdOrder, TakesNoMemoryWhileSlotsAreInOrder) {
  IdOrder order;
  for (int i = 0; i < 100; ++i) order.append();
  order.erase(99);
  EXPECT_EQ(order.memory_bytes(), 0U);
  order.move(98, 5);
  order.erase(5);
  EXPECT_GT(order.memory_bytes(), 0U);
  EXPECT_EQ(order.size(), 98U);
}

}  // namespace
}  // namespace hardball::id_order_test
