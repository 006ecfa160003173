// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Both queues against a list that is searched from end to end.
#include "hardball/events/event_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/events/ordered_queue.hpp"
#include "hardball/world/random.hpp"
#include "support/effort.hpp"

namespace hardball {
namespace {

TEST(Event, OrderIsByTimeThenKindThenIdsThenImage) {
  const Event event{Time(1), EventKind::collision, 2, 5, {{0, 1, 0}}};
  const auto with = [&](auto&& change) {
    Event other = event;
    change(other);
    return other;
  };
  // Each of these comes later, whatever the members that stand after the one changed.
  EXPECT_LT(event, with([](Event& e) { e = {Time(1, 1e-20), EventKind::enter, 0, 0, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e = {Time(1), EventKind::wall, 0, 0, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e = {Time(1), EventKind::collision, 3, 0, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e = {Time(1), EventKind::collision, 2, 6, {}}; }));
  EXPECT_LT(event, with([](Event& e) { e.image = {{0, 1, 1}}; }));
  EXPECT_LT(event, with([](Event& e) { e.image = {{1, -9, -9}}; }));
  EXPECT_EQ(event, with([](Event&) {}));
  EXPECT_LT(event, Event{}) << "what does not happen comes last";
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

// The plain truth.
class ListQueue {
 public:
  explicit ListQueue(std::size_t owners) : entries_(owners) {}
  void schedule(Owner owner, const Event& event) { entries_[owner] = event; }
  std::optional<Scheduled> least() const {
    std::optional<Scheduled> least;
    for (Owner owner = 0; owner < entries_.size(); ++owner) {
      if (!entries_[owner].happens()) continue;
      const Scheduled entry{entries_[owner], owner};
      if (!least || entry < *least) least = entry;
    }
    return least;
  }
  void pop() { entries_[least()->owner] = Event{}; }

 private:
  std::vector<Event> entries_;
};

// How long after the present new events lie.
enum class Waits { even, ties, bursts, all_scales, mostly_now, mostly_never };

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
using Queues = testing::Types<CalendarQueue, OrderedQueue>;
TYPED_TEST_SUITE(EveryQueue, Queues);

TYPED_TEST(EveryQueue, AgreesWithAListUnderRandomTraffic) {
  TypeParam queue;
  Random random(1);
  for (const Waits waits :
       {Waits::even, Waits::ties, Waits::bursts, Waits::all_scales, Waits::mostly_now, Waits::mostly_never}) {
    for (const std::size_t owners : {std::size_t{1}, std::size_t{2}, std::size_t{30}, std::size_t{300}}) {
      // The same queue again: reset must leave nothing behind.
      queue.reset(owners, Time(3));
      ListQueue list(owners);
      EXPECT_EQ(queue.least(), std::nullopt);
      Time now(3);
      const auto schedule = [&](Owner owner) {
        const Event event = random_event(random, now, waits);
        queue.schedule(owner, event);
        list.schedule(owner, event);
      };
      for (Owner owner = 0; owner < owners; ++owner) schedule(owner);
      for (std::uint64_t step = 0; step < support::cases(3000); ++step) {
        const std::optional<Scheduled> least = list.least();
        ASSERT_EQ(queue.least(), least) << "step " << step << ", " << owners << " owners";
        const double what = random.uniform();
        if (least && what < 0.7) {
          now = least->event.time;
          queue.pop();
          list.pop();
          if (what < 0.6) schedule(least->owner);
        }
        // Others are replaced, an event or two at a time, or all at once.
        const std::uint64_t others = what < 0.99 ? random.bits() % 3 : owners;
        for (std::uint64_t i = 0; i < others; ++i) schedule(static_cast<Owner>(random.bits() % owners));
      }
    }
  }
}

TYPED_TEST(EveryQueue, EmptiesInOrder) {
  TypeParam queue;
  Random random(2);
  constexpr std::size_t kOwners = 2000;
  queue.reset(kOwners, Time(0));
  std::vector<Scheduled> expected;
  for (Owner owner = 0; owner < kOwners; ++owner) {
    const Waits waits = owner % 2 == 0 ? Waits::all_scales : Waits::ties;
    expected.push_back({random_event(random, Time(0), waits), owner});
    queue.schedule(owner, expected.back().event);
  }
  std::sort(expected.begin(), expected.end());
  for (const Scheduled& entry : expected) {
    ASSERT_EQ(queue.least(), entry);
    queue.pop();
  }
  EXPECT_EQ(queue.least(), std::nullopt);
  EXPECT_EQ(queue.counters().scheduled, kOwners);
  EXPECT_EQ(queue.counters().taken, kOwners);
}

TYPED_TEST(EveryQueue, ForgetsAnEntryThatIsReplacedByNever) {
  TypeParam queue;
  queue.reset(2, Time(0));
  queue.schedule(0, {Time(1), EventKind::wall, 0, 0, {}});
  queue.schedule(1, {Time(2), EventKind::wall, 1, 0, {}});
  queue.schedule(0, Event{});
  ASSERT_TRUE(queue.least());
  EXPECT_EQ(queue.least()->owner, 1U);
  queue.schedule(1, Event{});
  EXPECT_EQ(queue.least(), std::nullopt);
}

TYPED_TEST(EveryQueue, TakesEventsBeforeThoseItHasShown) {
  TypeParam queue;
  queue.reset(3, Time(0));
  queue.schedule(0, {Time(100), EventKind::wall, 0, 0, {}});
  ASSERT_EQ(queue.least()->owner, 0U);
  queue.schedule(1, {Time(1), EventKind::wall, 1, 0, {}});
  ASSERT_EQ(queue.least()->owner, 1U);
  queue.schedule(2, {Time(0.5), EventKind::wall, 2, 0, {}});
  ASSERT_EQ(queue.least()->owner, 2U);
  queue.pop();
  ASSERT_EQ(queue.least()->owner, 1U);
}

// Rescheduling without end leaves dead entries behind: they must not pile up, wherever they lie.
TYPED_TEST(EveryQueue, KeepsItsMemoryInProportionToItsOwners) {
  constexpr std::size_t kOwners = 500;
  for (const Waits waits : {Waits::even, Waits::bursts, Waits::all_scales, Waits::mostly_now}) {
    TypeParam queue;
    queue.reset(kOwners, Time(0));
    Random random(3);
    Time now(0);
    for (Owner owner = 0; owner < kOwners; ++owner) queue.schedule(owner, random_event(random, now, waits));
    for (std::uint64_t step = 0; step < support::cases(200000); ++step) {
      queue.schedule(static_cast<Owner>(random.bits() % kOwners), random_event(random, now, waits));
      if (step % 5 != 0) continue;
      const std::optional<Scheduled> least = queue.least();
      ASSERT_TRUE(least);
      now = least->event.time;
      queue.pop();
      queue.schedule(least->owner, random_event(random, now, waits));
    }
    // At most 5 entries of some 72 bytes for each owner, in three or four places that may each have grown to
    // hold them all with twice the capacity.
    EXPECT_LT(queue.memory_bytes(), kOwners * 3500);
  }
}

TYPED_TEST(EveryQueue, RefusesToPopNothing) {
  TypeParam queue;
  queue.reset(1, Time(0));
  EXPECT_THROW(queue.pop(), BrokenInvariant);
}

}  // namespace
}  // namespace hardball
