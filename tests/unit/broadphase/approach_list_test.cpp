// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/approach_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "hardball/numbers/random.hpp"

namespace hardball::approach_list_test {
namespace {

constexpr double kRadius = 5;
constexpr double kSkin = 1;
constexpr double kUsualSpeed = 2;

// A large sphere in slot 0, and others near its surface, slower than the usual speed but for each tenth.
class Approach : public testing::Test {
 protected:
  Approach() {
    Random random(3);
    world_.add({kCenter, {0.1, 0, 0}, kRadius, 1000});
    for (int i = 0; i < 600; ++i) {
      const double distance = kRadius + 0.1 + 2.5 * random.uniform();
      const double speed = (i % 10 == 0 ? 20 : 0.9) * kUsualSpeed * random.uniform();
      world_.add({kCenter + distance * random.direction(), speed * random.direction(), 0.1, 1});
    }
    copies_.reset(world_, 15, Time(0));
    large_.reset(world_.size());
    large_.set(0, true);
  }

  Candidates others(std::size_t count) const {
    Candidates candidates;
    candidates.begin(0, true);
    for (Slot slot = 1; slot <= count; ++slot) candidates.add(slot);
    candidates.end();
    return candidates;
  }
  void make(const Candidates& all) {
    list_.make({world_, copies_, large_, kUsualSpeed, kSkin}, 0, {0.25, 0, 0}, Time(0), all);
  }
  bool has(Slot slot) const { return std::ranges::count(list_.slots(), slot) > 0; }
  // The least gap to the surface of the large one until the list expires [L].
  double least_gap(Slot slot) const {
    double least = kSkin * 100;
    for (int i = 0; i <= 1000; ++i) {
      const Time time(list_.expiry() * i / 1000);
      least =
          std::min(least, length(world_.position(slot, time) - kCenter) - kRadius - world_.base_radius(slot));
    }
    return least;
  }

  static constexpr Vec3 kCenter{20, 20, 20};
  World world_{Box::periodic({40, 40, 40})};
  CompactPaths copies_;
  SlotSet large_;
  ApproachList list_;
};

TEST_F(Approach, IsNotListedForFewCandidates) {
  make(others(ApproachList::kMinToList - 1));
  EXPECT_FALSE(list_.exists());
  list_.add(7);
  EXPECT_FALSE(list_.exists());
  make(others(ApproachList::kMinToList));
  EXPECT_TRUE(list_.exists());
}

TEST_F(Approach, IsListedIfItIsInTime) {
  make(others(600));
  ASSERT_TRUE(list_.exists());
  EXPECT_GT(list_.expiry(), 0);
  EXPECT_EQ(list_.middle(), (Vec3{0.25, 0, 0}));
  EXPECT_GT(list_.skin(), 0);
  EXPECT_LE(list_.skin(), ApproachList::kGreatestDepth * kSkin);
  std::size_t listed = 0;
  for (Slot slot = 1; slot <= 600; ++slot) {
    EXPECT_TRUE(has(slot) || least_gap(slot) >= list_.skin()) << slot;
    listed += has(slot) ? 1U : 0U;
  }
  EXPECT_GT(listed, 0U);
  EXPECT_LT(listed, 300U) << "most are far away";
}

TEST_F(Approach, OfALargeSphereIsAlwaysListed) {
  large_.set(600, true);
  make(others(600));
  EXPECT_TRUE(has(600));
}

TEST_F(Approach, IsListedInWholeVectors) {
  make(others(600));
  for (const Slot added : {1000U, 1001U, 1002U}) {
    list_.add(added);
    EXPECT_EQ(list_.slots().back(), added);
    const Slot* padding = list_.slots().data() + list_.slots().size();
    EXPECT_TRUE(std::all_of(padding, padding + Candidates::kPadding, [](Slot slot) { return slot == 0; }));
  }
  list_.replace(1001, 5000);
  EXPECT_TRUE(has(1000) && has(5000) && !has(1001));
  // The large sphere is in another slot.
  list_.replace(0, 6000);
  list_.add(1003);
  EXPECT_EQ(*(list_.slots().data() + list_.slots().size()), 6000U);
}

TEST_F(Approach, IsListedFartherIfListsAreHardlyUsed) {
  make(others(600));
  const double first = list_.expiry();
  make(others(600));
  EXPECT_DOUBLE_EQ(list_.expiry(), 1.5 * first) << "without a contact, searching was all the cost";
  for (int i = 0; i < 10000; ++i) list_.note_contact();
  make(others(600));
  EXPECT_DOUBLE_EQ(list_.expiry(), first);
}

}  // namespace
}  // namespace hardball::approach_list_test
