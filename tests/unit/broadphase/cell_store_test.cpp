// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hardball/broadphase/point_lists.hpp"
#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/world/random.hpp"
#include "support/effort.hpp"

namespace hardball::cell_store_test {
namespace {

void insert(CellStore<SlotLists>& store, const CellIndex& cell, Slot slot) {
  store.insert(cell, slot);
}
void insert(CellStore<PointLists>& store, const CellIndex& cell, Slot slot) {
  store.insert(cell, slot, PackedPlace());
}

template <class Lists>
std::vector<Slot> occupants_of(const CellStore<Lists>& store, const CellIndex& cell) {
  std::vector<Slot> found;
  store.lists().for_each(store.list(cell), [&](Slot slot) { found.push_back(slot); });
  std::sort(found.begin(), found.end());
  return found;
}

template <class Lists>
class CellStoreOf : public testing::Test {};
using AllLists = testing::Types<SlotLists, PointLists>;
TYPED_TEST_SUITE(CellStoreOf, AllLists);

// The same operations on an array, a hash table and a map.
TYPED_TEST(CellStoreOf, AgreesWithAMapWhetherDenseOrHashed) {
  CellStore<TypeParam> dense;
  CellStore<TypeParam> hashed;
  for (const std::int32_t cells : {2, 5}) {
    dense.reset({cells, cells, cells}, 100);
    hashed.reset({0, 0, 0}, 10);  // more than expected
    ASSERT_TRUE(dense.is_dense());
    ASSERT_FALSE(hashed.is_dense());
    std::multimap<CellIndex, Slot> map;
    Random random(static_cast<std::uint64_t>(cells));
    const auto below = [&random](std::int32_t n) {
      return static_cast<std::int32_t>(random.bits() % static_cast<std::uint64_t>(n));
    };
    for (std::uint64_t step = 0; step < support::cases(20000); ++step) {
      const CellIndex cell{below(cells), below(cells), below(cells)};
      // Fill up and empty in turn, all the way down.
      const bool filling = step / 500 % 2 == 0;
      if (map.empty() || random.uniform() < (filling ? 0.8 : 0.2)) {
        // A sphere can be in a cell several times.
        const auto slot = static_cast<Slot>(below(20));
        insert(dense, cell, slot);
        insert(hashed, cell, slot);
        map.emplace(cell, slot);
      } else {
        auto chosen = map.lower_bound(cell);
        if (chosen == map.end()) chosen = map.begin();
        dense.erase(chosen->first, chosen->second);
        hashed.erase(chosen->first, chosen->second);
        map.erase(chosen);
      }
      const CellIndex searched{below(cells), below(cells), below(cells)};
      std::vector<Slot> expected;
      const auto [begin, end] = map.equal_range(searched);
      for (auto it = begin; it != end; ++it) expected.push_back(it->second);
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(occupants_of(dense, searched), expected) << "step " << step;
      ASSERT_EQ(occupants_of(hashed, searched), expected) << "step " << step;
    }
  }
}

TYPED_TEST(CellStoreOf, HoldsCellsFarFromTheOrigin) {
  CellStore<TypeParam> store;
  store.reset({0, 3, 0}, 5);
  Random random(1);
  std::vector<CellIndex> cells;
  for (Slot slot = 0; slot < 3000; ++slot) {
    const auto far = [&] { return static_cast<std::int32_t>(random.bits() >> 35) - (1 << 28); };
    cells.push_back({far(), static_cast<std::int32_t>(slot % 3), far()});
    insert(store, cells.back(), slot);
  }
  for (Slot slot = 0; slot < cells.size(); ++slot) {
    ASSERT_EQ(occupants_of(store, cells[slot]), std::vector<Slot>{slot});
    store.erase(cells[slot], slot);
    ASSERT_TRUE(occupants_of(store, cells[slot]).empty());
  }
}

TYPED_TEST(CellStoreOf, ReusesItsMemory) {
  CellStore<TypeParam> store;
  store.reset({0, 0, 0}, 100);
  std::size_t after_first = 0;
  for (std::int32_t round = 0; round < 200; ++round) {
    // A swarm of 100 that moves through space without end.
    for (Slot slot = 0; slot < 100; ++slot) insert(store, {round, static_cast<std::int32_t>(slot), 0}, slot);
    if (round > 0) {
      for (Slot slot = 0; slot < 100; ++slot) {
        store.erase({round - 1, static_cast<std::int32_t>(slot), 0}, slot);
      }
    }
    if (round == 1) after_first = store.memory_bytes();
  }
  EXPECT_EQ(store.memory_bytes(), after_first);
}

TYPED_TEST(CellStoreOf, IsHashedWhereAnArrayWouldBeLargerThanTheSpheres) {
  CellStore<TypeParam> store;
  store.reset({1000, 1000, 1000}, 100);
  EXPECT_FALSE(store.is_dense());
  EXPECT_LT(store.memory_bytes(), 100000U);
  store.reset({20, 20, 10}, 2);
  EXPECT_TRUE(store.is_dense());
}

TYPED_TEST(CellStoreOf, NoticesThatAnOccupantIsNotThere) {
  for (const std::int32_t cells : {0, 4}) {
    CellStore<TypeParam> store;
    store.reset({cells, cells, cells}, 4);
    insert(store, {1, 2, 3}, 7);
    EXPECT_THROW(store.erase({1, 2, 3}, 8), BrokenInvariant);
    EXPECT_THROW(store.erase({3, 2, 1}, 7), BrokenInvariant);
    EXPECT_NO_THROW(store.erase({1, 2, 3}, 7));
    EXPECT_THROW(store.erase({1, 2, 3}, 7), BrokenInvariant) << "it was there once";
  }
}

}  // namespace
}  // namespace hardball::cell_store_test
