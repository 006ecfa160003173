// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/memory/page_arena.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <set>
#include <thread>
#include <vector>

#include "hardball/numbers/random.hpp"

namespace hardball::page_arena_test {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;

void* allocate_block(std::size_t bytes) {
  return ::operator new(bytes);
}
void free_block(void* memory) noexcept {
  ::operator delete(memory);
}

// An array whose bytes all have one value.
struct Array {
  unsigned char* memory;
  std::size_t bytes;
  unsigned char value;
};

Array filled(PageArena& arena, std::size_t bytes, std::uint64_t number) {
  const Array array{static_cast<unsigned char*>(arena.allocate(bytes)), bytes,
                    static_cast<unsigned char>(number)};
  std::memset(array.memory, array.value, bytes);
  return array;
}

bool is_kept(const Array& array) {
  for (std::size_t i = 0; i < array.bytes; ++i) {
    if (array.memory[i] != array.value) return false;
  }
  return true;
}

TEST(PageArena, SharesBlocksAmongArrays) {
  PageArena arena(kBlock, allocate_block, free_block);
  std::set<void*> arrays;
  for (int i = 0; i < 8; ++i) arrays.insert(arena.allocate(kBlock / 10));
  EXPECT_EQ(arrays.size(), 8U);
  EXPECT_EQ(arena.memory_bytes(), kBlock);
  for (void* const array : arrays) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array) % 16, 0U);
    arena.free(array, kBlock / 10);
  }
}

TEST(PageArena, ReusesGapsAndJoinsThem) {
  PageArena arena(kBlock, allocate_block, free_block);
  constexpr std::size_t kQuarter = kBlock / 4 - 1024;
  std::vector<void*> quarters;
  for (int i = 0; i < 4; ++i) quarters.push_back(arena.allocate(kQuarter));
  for (const std::size_t i : {1U, 3U, 2U}) arena.free(quarters[i], kQuarter);
  void* const whole = arena.allocate(3 * kQuarter);
  EXPECT_EQ(whole, quarters[1]);
  EXPECT_EQ(arena.memory_bytes(), kBlock);
  arena.free(whole, 3 * kQuarter);
  arena.free(quarters[0], kQuarter);
}

TEST(PageArena, GivesEmptyBlocksBackButOne) {
  PageArena arena(kBlock, allocate_block, free_block);
  std::vector<void*> blocks;
  for (int i = 0; i < 5; ++i) blocks.push_back(arena.allocate(kBlock / 2 + 1));
  EXPECT_EQ(arena.memory_bytes(), 5 * kBlock);
  for (void* const block : blocks) arena.free(block, kBlock / 2 + 1);
  EXPECT_EQ(arena.memory_bytes(), kBlock);
}

// Arrays of all sizes come and go at random: none overlaps another, and no more blocks are held than twice
// what arrays need.
TEST(PageArena, KeepsArraysApartUnderRandomTraffic) {
  PageArena arena(kBlock, allocate_block, free_block);
  Random random(1);
  std::vector<Array> arrays;
  std::size_t bytes = 0;
  std::size_t most = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    if (arrays.size() < 40 || random.uniform() < 0.45) {
      arrays.push_back(filled(arena, 1 + random.bits() % (i % 7 == 0 ? kBlock / 2 : 8000), i));
      bytes += arrays.back().bytes;
    } else {
      const std::size_t which = random.bits() % arrays.size();
      ASSERT_TRUE(is_kept(arrays[which]));
      arena.free(arrays[which].memory, arrays[which].bytes);
      bytes -= arrays[which].bytes;
      arrays[which] = arrays.back();
      arrays.pop_back();
    }
    most = std::max(most, bytes);
  }
  EXPECT_LE(arena.memory_bytes(), 2 * most + kBlock);
  for (const Array& array : arrays) {
    EXPECT_TRUE(is_kept(array));
    arena.free(array.memory, array.bytes);
  }
  void* const whole = arena.allocate(kBlock - 256);
  EXPECT_EQ(arena.memory_bytes(), kBlock) << "all gaps have become one";
  arena.free(whole, kBlock - 256);
}

TEST(PageArena, MayBeUsedBySeveralThreads) {
  PageArena arena(kBlock, allocate_block, free_block);
  std::vector<std::thread> threads;
  std::vector<int> faults(4);
  for (std::size_t t = 0; t < faults.size(); ++t) {
    threads.emplace_back([&, t] {
      Random random(t);
      for (int i = 0; i < 300; ++i) {
        const Array one = filled(arena, 1 + random.bits() % 20000, t);
        const Array other = filled(arena, 1 + random.bits() % 20000, t + 16);
        faults[t] += is_kept(one) && is_kept(other) ? 0 : 1;
        arena.free(one.memory, one.bytes);
        arena.free(other.memory, other.bytes);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(faults, std::vector<int>(4));
  EXPECT_EQ(arena.memory_bytes(), kBlock);
}

}  // namespace
}  // namespace hardball::page_arena_test
