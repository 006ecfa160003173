// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Both queues against a list searched linearly.
#include "hardball/events/event_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/ordered_queue.hpp"

namespace hardball::event_queue_test {
namespace {

TEST(Event, OrderIsByTimeThenKindThenIdsThenImage) {
  const Event event{Time(1), EventKind::collision, 2, 5, {{0, 1, 0}}};
  const auto with = [&](auto&& change) {
    Event other = event;
    change(other);
    return other;
  };
  // Each of these comes later, whatever the members after the changed one.
  EXPECT_LT(event, with([](Event& e) { e = {Time(1, 1e-20), EventKind::enter, 0, 0, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e = {Time(1), EventKind::wall, 0, 0, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e = {Time(1), EventKind::collision, 3, 0, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e = {Time(1), EventKind::collision, 2, 6, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e.image = {{0, 1, 1}}; }));
  EXPECT_LT(event, with([](Event& e) { e.image = {{1, -9, -9}}; }));
  EXPECT_EQ(event, with([](Event&) {}));
  EXPECT_LT(event, Event{}) << "an event that does not happen comes last";
  EXPECT_FALSE(Event{}.happens());
}

TEST(Event, OrderOfKindsLetsCellsKnowOfSpheresBeforeTheyTouch) {
  EXPECT_LT(EventKind::enter, EventKind::leave);
  EXPECT_LT(EventKind::leave, EventKind::collision);
  EXPECT_LT(EventKind::collision, EventKind::wall);
}

TEST(Event, CollisionPutsTheLowerIdFirstAndTurnsTheImageWithIt) {
  const Event event = make_collision(Time(2), 3, 7, {{1, 0, -2}});
  EXPECT_EQ(event, make_collision(Time(2), 7, 3, {{-1, 0, 2}}));
  EXPECT_EQ(event.first, 3U);
  EXPECT_EQ(event.second, 7U);
  EXPECT_EQ(event.image, (Image{{1, 0, -2}}));
}

TEST(Face, IsTwiceTheAxisPlusOneForTheUpper) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const bool upper : {false, true}) {
      const Face face = face_of(axis, upper);
      EXPECT_EQ(face, 2 * axis + (upper ? 1 : 0));
      EXPECT_EQ(axis_of(face), axis);
      EXPECT_EQ(is_upper(face), upper);
    }
  }
}

// The reference, and the event table of the queues.
class ListQueue {
 public:
  explicit ListQueue(std::size_t owners) : entries_(owners) {}
  Event event(Owner owner) const { return entries_[owner]; }
  double time(Owner owner) const { return entries_[owner].time.high; }
  void schedule(Owner owner, const Event& event) { entries_[owner] = event; }
  Owner least() const {
    Scheduled least{Event{}, kNoOwner};
    for (Owner owner = 0; owner < entries_.size(); ++owner) {
      const Scheduled entry{entries_[owner], owner};
      if (entry.event.happens() && entry < least) least = entry;
    }
    return least.owner;
  }
  void pop() { entries_[least()] = Event{}; }

 private:
  std::vector<Event> entries_;
};
static_assert(EventTable<ListQueue>);

// How long after the current time new events are scheduled.
enum class Waits { even, ties, bursts, all_scales, mostly_now, one_moment, low_parts, mostly_never };

constexpr std::array kAllWaits = {Waits::even,       Waits::ties,        Waits::bursts,
                                  Waits::all_scales, Waits::mostly_now,  Waits::one_moment,
                                  Waits::low_parts,  Waits::mostly_never};

double random_wait(Random& random, Waits waits) {
  switch (waits) {
    case Waits::even:
      return random.uniform();
    case Waits::ties:
      return std::floor(4 * random.uniform());
    case Waits::bursts:
      return random.uniform() < 0.9 ? 10 : random.uniform();
    case Waits::all_scales:
      return std::exp2(1990 * random.uniform() - 995);
    case Waits::mostly_now:
      return random.uniform() < 0.7 ? 0 : 1e-18 * random.uniform();
    case Waits::one_moment:
      return 0;
    case Waits::low_parts:
      return 1e-20 * std::floor(4 * random.uniform());
    case Waits::mostly_never:
      break;
  }
  return random.uniform() < 0.7 ? std::numeric_limits<double>::infinity() : random.uniform();
}

Event random_event(Random& random, const Time& now, Waits waits) {
  Event event;
  event.time = after(now, random_wait(random, waits));
  event.kind = static_cast<EventKind>(random.bits() % 4);
  event.first = static_cast<Slot>(random.bits() % 3);
  event.second = static_cast<Slot>(random.bits() % 3);
  event.image[random.bits() % 3] = static_cast<std::int32_t>(random.bits() % 3) - 1;
  return event;
}

template <class Queue>
class EveryQueue : public testing::Test {};
using Queues = testing::Types<CalendarQueue, support::OrderedQueue>;
TYPED_TEST_SUITE(EveryQueue, Queues);

// A queue and its event table, which a test cannot let get out of step.
template <class Queue>
struct Pair {
  Queue queue;
  ListQueue list;

  explicit Pair(std::size_t owners, const Time& start = Time(0)) : list(owners) {
    queue.reset(owners, start);
  }
  void reset(std::size_t owners, const Time& start) {
    list = ListQueue(owners);
    queue.reset(owners, start);
  }
  void schedule(Owner owner, const Event& event) {
    list.schedule(owner, event);
    queue.schedule(owner, list);
  }
  Owner least() { return queue.least(list); }
  void pop() {
    queue.pop();
    list.pop();
  }
  // All remaining owners, in order.
  std::vector<Owner> emptied() {
    std::vector<Owner> owners;
    for (Owner owner = least(); owner != kNoOwner; owner = least()) {
      EXPECT_EQ(owner, list.least());
      owners.push_back(owner);
      pop();
    }
    EXPECT_EQ(list.least(), kNoOwner);
    return owners;
  }
};

Event wall_at(const Time& time, SphereId sphere) {
  return {time, EventKind::wall, sphere, 0, {}};
}

TYPED_TEST(EveryQueue, AgreesWithAListUnderRandomTraffic) {
  Pair<TypeParam> pair(0);
  Random random(1);
  for (const Waits waits : kAllWaits) {
    for (const std::size_t owners : {std::size_t{1}, std::size_t{2}, std::size_t{30}, std::size_t{300}}) {
      // The same queue again: reset must leave nothing behind.
      pair.reset(owners, Time(3));
      EXPECT_EQ(pair.least(), kNoOwner);
      Time now(3);
      const auto schedule = [&](Owner owner) { pair.schedule(owner, random_event(random, now, waits)); };
      for (Owner owner = 0; owner < owners; ++owner) schedule(owner);
      for (std::uint64_t step = 0; step < support::cases(3000); ++step) {
        const Owner least = pair.list.least();
        ASSERT_EQ(pair.least(), least) << "step " << step << ", " << owners << " owners";
        const double what = random.uniform();
        if (least != kNoOwner && what < 0.7) {
          now = pair.list.event(least).time;
          pair.pop();
          if (what < 0.6) schedule(least);
        }
        // Others are replaced, one or two at a time, or all together.
        const std::uint64_t others = what < 0.99 ? random.bits() % 3 : owners;
        for (std::uint64_t i = 0; i < others; ++i) schedule(static_cast<Owner>(random.bits() % owners));
      }
    }
  }
}

TYPED_TEST(EveryQueue, AgreesWithAListThatGoesBackInTime) {
  Random random(5);
  for (const Waits waits : kAllWaits) {
    for (const std::size_t owners : {std::size_t{3}, std::size_t{40}, std::size_t{1000}}) {
      Pair<TypeParam> pair(owners, Time(3));
      std::vector<Time> moments{Time(3)};
      const auto event = [&] { return random_event(random, moments.back(), waits); };
      for (Owner owner = 0; owner < owners; ++owner) pair.schedule(owner, event());
      for (std::uint64_t step = 0; step < support::cases(6000); ++step) {
        const Owner least = pair.list.least();
        ASSERT_EQ(pair.least(), least) << "step " << step << ", " << owners << " owners";
        if (least == kNoOwner) break;
        moments.push_back(later(moments.back(), pair.list.event(least).time));
        pair.pop();
        pair.schedule(least, event());
        const double what = random.uniform();
        if (what > 0.01) continue;
        // Mostly a little, sometimes by many turns of the ring.
        const std::uint64_t most = what < 0.001 ? moments.size() : std::min<std::size_t>(moments.size(), 40);
        moments.resize(moments.size() - random.bits() % most);
        std::vector<Owner> changed;
        for (std::uint64_t k = 0; k < 1 + owners / 8; ++k) {
          changed.push_back(static_cast<Owner>(random.bits() % owners));
          pair.list.schedule(changed.back(), event());
        }
        if constexpr (requires { pair.queue.go_back(0.0, pair.list); })
          pair.queue.go_back(moments.back().high, pair.list);
        for (const Owner owner : changed) pair.queue.schedule(owner, pair.list);
      }
    }
  }
}

// An event table that knows when two owners share one event.
struct SharingList : ListQueue {
  using ListQueue::ListQueue;
  bool share_event(Owner a, Owner b) const { return event(a) == event(b); }
};

TYPED_TEST(EveryQueue, ShowsEitherOfTwoOwnersThatShareTheLeastEvent) {
  for (const Waits waits : kAllWaits) {
    constexpr Owner kOwners = 60;
    Random random(2);
    TypeParam queue;
    SharingList list(kOwners);
    queue.reset(kOwners, Time(0));
    Time now(0);
    const auto schedule_pair = [&](Owner a, Owner b) {
      const Event event = random_event(random, now, waits);
      for (const Owner owner : {a, b}) {
        list.schedule(owner, event);
        queue.schedule(owner, list);
      }
    };
    for (Owner owner = 0; owner < kOwners; owner += 2) schedule_pair(owner, owner + 1);
    for (std::uint64_t step = 0; step < support::cases(3000); ++step) {
      const Owner expected = list.least();
      const Owner shown = queue.least(list);
      ASSERT_EQ(shown == kNoOwner, expected == kNoOwner);
      if (shown == kNoOwner) break;
      ASSERT_EQ(list.event(shown), list.event(expected)) << "step " << step;
      now = list.event(shown).time;
      queue.pop();
      list.schedule(shown, Event{});
      // The partner gets an event with another owner, or keeps an event that no one shares.
      const auto other = static_cast<Owner>(random.bits() % kOwners);
      schedule_pair(shown, other == shown ? (other + 1) % kOwners : other);
    }
  }
}

TYPED_TEST(EveryQueue, EmptiesInOrder) {
  constexpr std::size_t kOwners = 2000;
  Pair<TypeParam> pair(kOwners);
  Random random(2);
  std::vector<Scheduled> expected;
  for (Owner owner = 0; owner < kOwners; ++owner) {
    const Waits waits = owner % 2 == 0 ? Waits::all_scales : Waits::ties;
    expected.push_back({random_event(random, Time(0), waits), owner});
    pair.schedule(owner, expected.back().event);
  }
  std::sort(expected.begin(), expected.end());
  for (const Scheduled& entry : expected) {
    ASSERT_EQ(pair.least(), entry.owner);
    pair.pop();
  }
  EXPECT_EQ(pair.least(), kNoOwner);
  EXPECT_EQ(pair.queue.counters().scheduled, kOwners);
  EXPECT_EQ(pair.queue.counters().taken, kOwners);
}

TYPED_TEST(EveryQueue, ForgetsAnEntryThatIsReplacedByNever) {
  Pair<TypeParam> pair(2);
  pair.schedule(0, wall_at(Time(1), 0));
  pair.schedule(1, wall_at(Time(2), 1));
  pair.schedule(0, Event{});
  EXPECT_EQ(pair.least(), 1U);
  pair.schedule(1, Event{});
  EXPECT_EQ(pair.least(), kNoOwner);
}

// Nothing is left to happen again and again, at first in the middle of a turn of the ring.
TYPED_TEST(EveryQueue, IsFilledAgainAfterItHasBecomeEmpty) {
  Random random(8);
  for (std::uint64_t round = 0; round < support::cases(3000); ++round) {
    const auto owners = static_cast<std::size_t>(1 + random.bits() % 12);
    Pair<TypeParam> pair(owners);
    Time now(0);
    for (int filling = 0; filling < 4; ++filling) {
      const auto schedule = [&](Owner owner) {
        pair.schedule(owner, random_event(random, now, Waits::even));
      };
      for (Owner owner = 0; owner < owners; ++owner) schedule(owner);
      for (std::uint64_t step = random.bits() % 30; step > 0; --step) {
        const Owner least = pair.list.least();
        ASSERT_EQ(pair.least(), least) << "round " << round << ", filling " << filling;
        now = pair.list.event(least).time;
        pair.pop();
        schedule(least);
      }
      for (Owner owner = 0; owner < owners; ++owner) pair.schedule(owner, Event{});
      ASSERT_EQ(pair.least(), kNoOwner);
    }
  }
}

TYPED_TEST(EveryQueue, TakesEventsBeforeThoseItHasShown) {
  Pair<TypeParam> pair(3);
  pair.schedule(0, wall_at(Time(100), 0));
  ASSERT_EQ(pair.least(), 0U);
  pair.schedule(1, wall_at(Time(1), 1));
  ASSERT_EQ(pair.least(), 1U);
  pair.schedule(2, wall_at(Time(0.5), 2));
  ASSERT_EQ(pair.least(), 2U);
  pair.pop();
  ASSERT_EQ(pair.least(), 1U);
}

// The entry of the event that was replaced is still in the queue, and its time is the owner's time again.
TYPED_TEST(EveryQueue, MindsOnlyTheEventThatAnOwnerHasNow) {
  const Time moment(1);
  const Event early{moment, EventKind::enter, 1, 0, {}};
  const Event middle{moment, EventKind::collision, 1, 2, {}};
  const Event late{moment, EventKind::wall, 1, 0, {}};
  for (const bool shown_before : {false, true}) {
    for (const bool with_others : {false, true}) {
      SCOPED_TRACE(testing::Message() << shown_before << with_others);
      for (const auto& [first, second] : {std::pair(early, late), std::pair(late, early)}) {
        Pair<TypeParam> pair(40);
        // Others fill the bucket, so that the two entries are in a list or in a heap with them.
        for (Owner owner = 2; with_others && owner < 40; ++owner) {
          pair.schedule(owner, wall_at(Time(0.5 + 0.05 * owner), owner));
        }
        pair.schedule(0, first);
        pair.schedule(1, middle);
        if (shown_before) static_cast<void>(pair.least());
        pair.schedule(0, second);
        while (pair.list.time(pair.list.least()) < moment.high) {
          ASSERT_EQ(pair.least(), pair.list.least());
          pair.pop();
        }
        const std::vector<Owner> order =
            second == early ? std::vector<Owner>{0, 1} : std::vector<Owner>{1, 0};
        for (const Owner owner : order) {
          ASSERT_EQ(pair.list.least(), owner) << "in the reference";
          ASSERT_EQ(pair.least(), owner);
          pair.pop();
        }
        const std::vector<Owner> rest = pair.emptied();
        EXPECT_EQ(std::count(rest.begin(), rest.end(), 0U), 0) << "its event has already been taken";
        EXPECT_EQ(std::count(rest.begin(), rest.end(), 1U), 0);
      }
    }
  }
}

// Alternating between two events at the same time, sometimes popped and rescheduled at that time.
TYPED_TEST(EveryQueue, MindsOnlyTheEventThatAnOwnerHasNowHoweverOftenItChanges) {
  Random random(4);
  for (std::uint64_t round = 0; round < support::cases(300); ++round) {
    const std::size_t owners = 1 + random.bits() % 6;
    Pair<TypeParam> pair(owners);
    const auto schedule = [&] {
      const double moment = 1 + static_cast<double>(random.bits() % 2);
      Event event = random_event(random, Time(moment), Waits::one_moment);
      event.time.low = random.uniform() < 0.5 ? 0 : 1e-20 * static_cast<double>(random.bits() % 3);
      pair.schedule(static_cast<Owner>(random.bits() % owners), event);
    };
    for (int step = 0; step < 60; ++step) {
      for (std::uint64_t i = random.bits() % 5; i > 0; --i) schedule();
      ASSERT_EQ(pair.least(), pair.list.least());
      if (pair.list.least() != kNoOwner && random.uniform() < 0.5) pair.pop();
    }
    pair.emptied();
    if (this->HasFailure()) return;
  }
}

// Like the planned contact of a sphere whose partner's path changes.
TYPED_TEST(EveryQueue, KeepsAnOwnerWhoseEventBecomesALesserOneAtTheSameTime) {
  Random random(5);
  for (std::uint64_t round = 0; round < support::cases(2000); ++round) {
    const std::size_t owners = 2 + random.bits() % 30;
    Pair<TypeParam> pair(owners);
    for (Owner owner = 0; owner < owners; ++owner) {
      const double moment = 1 + static_cast<double>(random.bits() % 3);
      pair.schedule(owner,
                    make_collision(Time(moment, 1e-20), static_cast<SphereId>(random.bits() % 9), 10, {}));
    }
    std::vector<bool> has_come(owners);
    Event last{Time(0), EventKind::enter, 0, 0, {}};
    for (std::size_t left = owners; left > 0; --left) {
      if (random.uniform() < 0.7) static_cast<void>(pair.least());
      const auto changed = static_cast<Owner>(random.bits() % owners);
      const Event scheduled = pair.list.event(changed);
      if (scheduled.happens()) pair.list.schedule(changed, {scheduled.time, EventKind::enter, 0, 0, {}});
      const Owner least = pair.least();
      ASSERT_NE(least, kNoOwner) << "an owner is missing";
      ASSERT_FALSE(has_come[least]);
      has_come[least] = true;
      const Event event = pair.list.event(least);
      // Unchanged ones come in order; changed ones, at the right time.
      ASSERT_GE(event.time, last.time);
      if (event.kind == EventKind::collision) {
        ASSERT_GE(event, last);
        last = event;
      }
      pair.queue.pop();
      pair.list.schedule(least, Event{});
    }
    ASSERT_EQ(pair.least(), kNoOwner);
  }
}

TYPED_TEST(EveryQueue, DistinguishesTimesThatRoundToOneDouble) {
  constexpr std::size_t kOwners = 100;
  for (const double moment : {1.0, 1e12}) {
    Pair<TypeParam> pair(kOwners);
    std::vector<Owner> expected;
    for (Owner rank = 0; rank < kOwners; ++rank) {
      // Scattered, and in reverse order of kind.
      const auto owner = static_cast<Owner>(rank * 37 % kOwners);
      const double low = moment * 0x1p-90 * (static_cast<double>(rank) - 50);
      pair.schedule(owner, {Time(moment, low), rank < 50 ? EventKind::wall : EventKind::enter, 0, 0, {}});
      expected.push_back(owner);
      // Calling least() in between makes the bucket current before the rest is scheduled.
      if (rank % 30 == 10) {
        EXPECT_EQ(pair.least(), expected.front());
      }
    }
    EXPECT_EQ(pair.emptied(), expected);
  }
}

TYPED_TEST(EveryQueue, KeepsTheOrderOfEventsWhenAllHappenAtOneTime) {
  constexpr std::size_t kOwners = 3000;
  for (const double moment : {0.0, 7.0}) {
    Pair<TypeParam> pair(kOwners);
    std::vector<Owner> expected;
    for (Owner rank = 0; rank < kOwners; ++rank) {
      const auto owner = static_cast<Owner>(rank * 1009 % kOwners);
      expected.push_back(owner);
      pair.schedule(owner, make_collision(Time(moment), rank / 3, 5000 + rank % 3, {}));
    }
    EXPECT_EQ(pair.emptied(), expected);
  }
}

// Endless rescheduling leaves dead entries: they must not accumulate, wherever they are.
TYPED_TEST(EveryQueue, KeepsItsMemoryInProportionToItsOwners) {
  constexpr std::size_t kOwners = 500;
  for (const Waits waits : {Waits::even, Waits::bursts, Waits::all_scales, Waits::mostly_now,
                            Waits::one_moment, Waits::low_parts}) {
    SCOPED_TRACE(static_cast<int>(waits));
    Pair<TypeParam> pair(kOwners);
    Random random(3);
    Time now(0);
    for (Owner owner = 0; owner < kOwners; ++owner) pair.schedule(owner, random_event(random, now, waits));
    for (std::uint64_t step = 0; step < support::cases(200000); ++step) {
      pair.schedule(static_cast<Owner>(random.bits() % kOwners), random_event(random, now, waits));
      if (step % 5 != 0) continue;
      const Owner least = pair.least();
      ASSERT_NE(least, kNoOwner);
      now = pair.list.event(least).time;
      pair.queue.pop();
      pair.schedule(least, random_event(random, now, waits));
    }
    // At most 5 entries of some 72 bytes per owner, in three or four containers that may each hold all of
    // them at twice the capacity.
    EXPECT_LT(pair.queue.memory_bytes(), kOwners * 3500);
  }
}

TYPED_TEST(EveryQueue, RefusesToPopNothing) {
  TypeParam queue;
  queue.reset(1, Time(0));
  EXPECT_THROW(queue.pop(), BrokenInvariant);
}

}  // namespace
}  // namespace hardball::event_queue_test
