// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Every instruction set against the plain loop over contact_time and the order of events, bit for bit.
#include "hardball/engine/predictor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/instruction_sets.hpp"

namespace hardball::predictor_test {
namespace {

using namespace support;

constexpr Boundary kPeriodic = Boundary::periodic;
constexpr Boundary kWall = Boundary::wall;
constexpr Boundary kOpen = Boundary::open;

// The least of the contacts by the order of events, found one by one.
struct Expected {
  Event event;
  Slot partner = 0;
};

Event contact_of(const World& world, Slot self, Slot other, const Image& image) {
  return make_collision(contact_time(world, self, other, image), world.id(self), world.id(other), image);
}

Expected plain_loop(const World& world, const Candidates& candidates, const Time& now) {
  Expected least;
  const Slot self = candidates.self();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Slot other = candidates.slot(i);
    const Image image =
        candidates.uses_minimum_image() ? nearest_image(world, self, other, now) : candidates.image(i);
    const Event event = contact_of(world, self, other, image);
    if (event.happens() && event < least.event) least = {event, other};
  }
  return least;
}

// Which cases have occurred.
struct Coverage {
  std::uint64_t queries = 0;
  std::uint64_t contacts = 0;
  std::uint64_t at_once = 0;  // contacts at the later start of the two paths
  std::uint64_t ties = 0;
  std::uint64_t pairs = 0;
  std::uint64_t pairs_in_contact = 0;
  std::uint64_t bounds = 0;             // of contacts that come
  std::uint64_t bounds_after_now = 0;   // among them
  std::uint64_t contacts_excluded = 0;  // pairs of which the bound says that they do not meet
  std::uint64_t chosen = 0;             // queries of many candidates, of which bounds choose some
};

// Compares all instruction sets with the plain loop.
class Comparison {
 public:
  Comparison() {
    for (const InstructionSet set : available_instruction_sets()) predictors_.emplace_back(set);
  }

  void compare(const World& world, const Candidates& candidates, const Time& now) {
    const Expected expected = plain_loop(world, candidates, now);
    record(world, candidates, now, expected);
    for (Predictor& predictor : predictors_) {
      expect_same(world, candidates, now, expected, predictor.earliest(world, candidates, now));
      if (testing::Test::HasFailure()) return;
    }
    if (!candidates.uses_minimum_image()) return;
    compare_pairs(world, candidates, now);
    compare_bounds(world, candidates, now);
  }

  const Coverage& coverage() const { return coverage_; }

 private:
  void record(const World& world, const Candidates& candidates, const Time& now, const Expected& expected) {
    ++coverage_.queries;
    if (!expected.event.happens()) return;
    ++coverage_.contacts;
    const Slot self = candidates.self();
    coverage_.at_once +=
        expected.event.time == later(world.path(self).time, world.path(expected.partner).time) ? 1U : 0U;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Slot other = candidates.slot(i);
      const Image image =
          candidates.uses_minimum_image() ? nearest_image(world, self, other, now) : candidates.image(i);
      const Event event = contact_of(world, self, other, image);
      coverage_.ties += event.time == expected.event.time && event != expected.event ? 1U : 0U;
    }
  }

  // All pairs at once, each in both directions.
  void compare_pairs(const World& world, const Candidates& candidates, const Time& now) {
    const Slot self = candidates.self();
    for (const Predictor& predictor : predictors_) {
      pairs_.begin(2 * candidates.size() + 1);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        pairs_.add(self, candidates.slot(i));
        pairs_.add(candidates.slot(i), self);
      }
      const std::size_t count = pairs_.count;
      predictor.compute(world, now, pairs_);
      for (std::size_t i = 0; i < count; ++i) {
        const Slot a = pairs_.first[i];
        const Slot b = pairs_.second[i];
        const Time expected = contact_time(world, a, b, nearest_image(world, a, b, now));
        ASSERT_TRUE(same_bits(pairs_.high[i], expected.high))
            << to_text(pairs_.high[i]) << " instead of " << to_text(expected.high) << ", pair " << i;
        ASSERT_TRUE(same_bits(pairs_.low[i], expected.low)) << "pair " << i;
        ++coverage_.pairs;
        coverage_.pairs_in_contact += expected == kNever ? 0U : 1U;
      }
    }
  }

  // Bounds from copies of paths made at various times before, for the candidates within the distance for
  // which the copies are good. Some spheres are too fast to be bounded.
  void compare_bounds(const World& world, const Candidates& candidates, const Time& now) {
    const Slot self = candidates.self();
    const auto apart = [&](Slot other) {
      const Vec3 shift = world.box().shift(nearest_image(world, self, other, now));
      return length(separation_at(world.motion(), world.path(self), world.path(other), shift, now));
    };
    double farthest = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      farthest = std::max(farthest, apart(candidates.slot(i)));
    }
    // A place and what a sphere has moved since it was copied stay below half the box.
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (world.box().is_periodic(axis)) farthest = std::min(farthest, 0.24 * world.box().size()[axis]);
    }
    farthest *= random_.uniform() < 0.5 ? 1 : random_.uniform();
    farthest = std::max(farthest, 2 * world.largest_radius());
    near_.begin(self, true);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (candidates.slot(i) == self || apart(candidates.slot(i)) <= farthest) near_.add(candidates.slot(i));
    }
    near_.end();
    copies_.reset(world, farthest, now);
    for (Slot slot = 0; slot < world.size(); ++slot) {
      if (slot == self) continue;
      const double speed = length(world.path(slot).velocity);
      const double longest_age = speed > 0 ? std::min(copies_.longest_age(slot), farthest / speed) : 1000;
      copies_.copy(world, slot, after(now, -longest_age * random_age()));
    }
    for (const Predictor& predictor : predictors_) {
      const BoundedContacts found = predictor.bound(copies_, near_, now);
      ASSERT_LE(found.least, found.second);
      ASSERT_GE(found.least, rounded_down(now));
      for (std::size_t i = 0; i < near_.size(); ++i) {
        const Slot other = near_.slot(i);
        if (other == self) continue;
        const Time contact = contact_time(world, self, other, nearest_image(world, self, other, now));
        const double bound = other == found.partner ? found.least : found.second;
        if (contact == kNever) coverage_.contacts_excluded += bound == kNever.high ? 1U : 0U;
        // A contact in the past cannot be: in the engine it would have happened.
        if (contact == kNever || contact < now) continue;
        ASSERT_LE(bound, contact.high) << "slots " << self << " and " << other;
        ++coverage_.bounds;
        coverage_.bounds_after_now += bound > now.high ? 1U : 0U;
      }
    }
    compare_chosen(world, now);
  }

  // Exact contacts of those that bounds choose among the near ones whose contacts are still to come.
  void compare_chosen(const World& world, const Time& now) {
    const Slot self = near_.self();
    to_come_.begin(self, true);
    for (std::size_t i = 0; i < near_.size(); ++i) {
      const Slot other = near_.slot(i);
      if (!(contact_time(world, self, other, nearest_image(world, self, other, now)) < now))
        to_come_.add(other);
    }
    to_come_.end();
    const Expected expected = plain_loop(world, to_come_, now);
    for (const Predictor& predictor : predictors_) {
      expect_same(world, to_come_, now, expected, predictor.earliest(world, copies_, to_come_, now));
    }
    constexpr std::size_t kMany = 12;
    coverage_.chosen += to_come_.size() > kMany && expected.event.happens() ? 1U : 0U;
  }

  // From 0 to 1, both included.
  double random_age() {
    const double what = random_.uniform();
    return what < 0.2 ? 0 : what < 0.4 ? 1 : random_.uniform();
  }

  static void expect_same(const World& world, const Candidates& candidates, const Time& now,
                          const Expected& expected, const PredictedContact& found) {
    ASSERT_EQ(found.happens(), expected.event.happens());
    ASSERT_TRUE(same_bits(found.time.high, expected.event.time.high))
        << to_text(found.time.high) << " instead of " << to_text(expected.event.time.high);
    if (!found.happens()) return;
    ASSERT_TRUE(same_bits(found.time.low, expected.event.time.low));
    ASSERT_EQ(found.partner, expected.partner);
    const Slot self = candidates.self();
    const Image image =
        candidates.uses_minimum_image() ? nearest_image(world, self, found.partner, now) : found.image;
    ASSERT_EQ(make_collision(found.time, world.id(self), world.id(found.partner), image), expected.event);
  }

  std::vector<Predictor> predictors_;
  PairContacts pairs_;
  CompactPaths copies_;
  Candidates near_;
  Candidates to_come_;
  Random random_{11};
  Coverage coverage_;
};

// Lets slots and ids run in different orders, so that ties are not decided by slots.
void shuffle(World& world, Random& random) {
  std::vector<Slot> order(world.size());
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.bits() % i]);
  world.reorder(order);
}

double spread(Random& random, double low_exponent, double high_exponent) {
  return std::exp2(low_exponent + random.uniform() * (high_exponent - low_exponent));
}

// Worlds in which spheres may overlap: nothing runs in them.
struct Settings {
  std::array<Boundary, kAxes> boundary{};
  bool mixed_radii = false;
  double start = 0;  // near which paths start [T]
};

// A sphere in the middle, and others that it may meet in every possible way.
class PairMaker {
 public:
  PairMaker(const Settings& settings, std::uint64_t seed)
      : settings_(settings), random_(seed), now_(with_low_part(settings.start + 3)) {
    world_ = World(Box(settings.boundary, {kSize, kSize, kSize}));
  }

  World make(std::size_t others) {
    self_radius_ = radius();
    self_velocity_ = normal();
    self_now_ = Vec3{kSize / 2, kSize / 2, kSize / 2} + 3 * random_.direction();
    add(self_now_, self_velocity_, self_radius_);
    for (std::size_t i = 0; i < others; ++i) add_other();
    return world_;
  }

  const Time& now() const { return now_; }

 private:
  static constexpr double kSize = 128;

  // A time about halfway between two doubles.
  static Time with_low_part(double high) { return {high, 0.4 * (std::nextafter(high, 1e300) - high)}; }

  Vec3 normal() { return {random_.normal(), random_.normal(), random_.normal()}; }
  double radius() { return settings_.mixed_radii ? 0.5 + random_.uniform() : 0.75; }

  // A sphere that is at `place` now, on a path that started earlier.
  void add(const Vec3& place, const Vec3& velocity, double radius) {
    double age = 0;
    Time begin = now_;
    switch (random_.bits() % 4) {
      case 0:
        break;
      case 1:  // at a time that differs from now only in the low part
        begin.low *= random_.uniform();
        break;
      default:
        age = 3 * random_.uniform();
        begin = after(now_, -age);
    }
    world_.add({place - age * velocity, velocity, radius, 1}, begin);
  }

  void add_other() {
    const double other_radius = radius();
    const double reach = self_radius_ + other_radius;
    const Vec3 along = random_.direction();
    Vec3 across;
    do {
      across = cross(along, random_.direction());
    } while (length(across) < 0.1);
    across = (1 / length(across)) * across;
    const double speed = spread(random_, -3, 3);
    // Meeting with this squared cosine, from this distance.
    const auto meeting = [&](double impact, double distance) {
      const double before = std::sqrt(std::max(0.0, 1 - impact * impact)) + distance;
      add(self_now_ + reach * (impact * across - before * along), self_velocity_ + speed * along,
          other_radius);
    };
    const double distance = random_.uniform() < 0.2 ? spread(random_, -50, 0) : 8 * random_.uniform();
    switch (random_.bits() % 9) {
      case 0:  // anything
        add(self_now_ + 8 * Vec3{random_.normal(), random_.normal(), random_.normal()}, normal(),
            other_radius);
        break;
      case 1:  // a squared cosine from 0 to 1/2, around the limit for more digits
        meeting(std::sqrt(1 - 0.5 * random_.uniform()), distance);
        break;
      case 2:
        meeting(std::sqrt(11.0 / 16 + spread(random_, -52, -10) * (random_.uniform() - 0.5)), distance);
        break;
      case 3:  // grazing, or just missing
        meeting(1 + spread(random_, -54, -3) * (random_.uniform() < 0.5 ? 1 : -1), distance);
        break;
      case 4:  // head on, or nearly
        meeting(random_.uniform() < 0.5 ? 0 : 0.8 * random_.uniform(), distance);
        break;
      case 5:  // overlapping, approaching or receding
        add(self_now_ + reach * random_.uniform() * random_.direction(), self_velocity_ + normal(),
            other_radius);
        break;
      case 6:  // touching, up to rounding
        add(self_now_ + reach * random_.direction(), self_velocity_ + normal(), other_radius);
        break;
      case 7:  // at relative rest, or nearly
        add(self_now_ + 2 * reach * random_.uniform() * random_.direction(),
            self_velocity_ + (random_.uniform() < 0.5 ? 0 : 1e-15) * normal(), other_radius);
        break;
      default:  // receding
        meeting(random_.uniform(), -4 - distance);
    }
  }

  Settings settings_;
  Random random_;
  Time now_;
  World world_;
  double self_radius_ = 0;
  Vec3 self_velocity_;
  Vec3 self_now_;
};

// Some of the others, in any order.
std::vector<Slot> some_others(const World& world, Slot self, Random& random) {
  std::vector<Slot> others;
  const double kept = random.uniform() < 0.5 ? 1 : random.uniform();
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (slot != self && random.uniform() < kept) others.push_back(slot);
  }
  for (std::size_t i = others.size(); i > 1; --i) std::swap(others[i - 1], others[random.bits() % i]);
  return others;
}

void collect_nearest(Candidates& candidates, Slot self, const std::vector<Slot>& others) {
  candidates.begin(self, true);
  for (const Slot other : others) candidates.add(other);
  candidates.end();
}

// The nearest images among others, in any order.
void collect_listed(Candidates& candidates, const World& world, Slot self, const std::vector<Slot>& others,
                    const Time& now, Random& random) {
  candidates.begin(self, false);
  for (const Slot other : others) {
    Image image = nearest_image(world, self, other, now);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) image[axis] = 0;
    }
    candidates.add(other, image, world.box());
    if (random.uniform() < 0.7) continue;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (world.box().is_periodic(axis)) image[axis] += static_cast<std::int32_t>(random.bits() % 3) - 1;
    }
    candidates.add(other, image, world.box());
  }
  candidates.end();
}

class EveryPredictor : public testing::TestWithParam<Settings> {};

TEST_P(EveryPredictor, AgreesWithThePlainLoop) {
  Comparison comparison;
  Candidates candidates;
  for (std::uint64_t seed = 0; seed < cases(1000); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    PairMaker maker(GetParam(), seed);
    World world = maker.make(random.bits() % (seed % 4 == 0 ? 200 : 71));
    ASSERT_EQ(world.base_radii().is_common(), world.size() == 1 || !GetParam().mixed_radii);
    shuffle(world, random);
    // Most meet sphere 0 in the middle; from another one they differ.
    for (const Slot self : {world.slot_of(0), static_cast<Slot>(random.bits() % world.size())}) {
      const std::vector<Slot> others = some_others(world, self, random);
      collect_nearest(candidates, self, others);
      comparison.compare(world, candidates, maker.now());
      collect_listed(candidates, world, self, others, maker.now(), random);
      comparison.compare(world, candidates, maker.now());
      if (HasFatalFailure()) return;
      // One at a time, so that each kind of pair is tested in each lane.
      for (std::size_t i = 0; i < std::min<std::size_t>(others.size(), 8); ++i) {
        std::vector<Slot> lanes(i + 1, self);
        lanes[i] = others[i];
        collect_nearest(candidates, self, lanes);
        comparison.compare(world, candidates, maker.now());
      }
      if (HasFatalFailure()) return;
    }
  }
  const Coverage& coverage = comparison.coverage();
  EXPECT_GT(coverage.contacts, coverage.queries / 3);
  EXPECT_GT(coverage.at_once, coverage.queries / 10);
  EXPECT_GT(coverage.queries, cases(1000) * 10);
  EXPECT_GT(coverage.pairs_in_contact, coverage.pairs / 8);
  EXPECT_GT(coverage.bounds, coverage.queries);
  EXPECT_GT(coverage.bounds_after_now, coverage.bounds / 10);
  EXPECT_GT(coverage.contacts_excluded, coverage.bounds / 10);
  EXPECT_GT(coverage.chosen, coverage.queries / 20);
}

constexpr std::array kAllPeriodic = {kPeriodic, kPeriodic, kPeriodic};
constexpr std::array kAllWalls = {kWall, kWall, kWall};
constexpr std::array kAllOpen = {kOpen, kOpen, kOpen};
constexpr std::array kMixture = {kOpen, kPeriodic, kWall};
INSTANTIATE_TEST_SUITE_P(Settings, EveryPredictor,
                         testing::Values(Settings{kAllPeriodic, false, 0}, Settings{kAllPeriodic, true, 0},
                                         Settings{kAllPeriodic, false, 1e12}, Settings{kAllWalls, false, 0},
                                         Settings{kAllWalls, true, 1e12}, Settings{kAllOpen, true, 0},
                                         Settings{kAllOpen, false, 1e12}, Settings{kMixture, false, 0},
                                         Settings{kMixture, true, 1e12}));

// Reach 13, all numbers dyadic: a sphere coming from any side with an impact parameter of 0, 5 or 12 is 13,
// 12 or 5 away along its path when it touches. So whole groups of contacts happen at exactly one time, by the
// plain and by the grazing formula. An impact parameter of 13 is an exact graze, which is not a contact.
TEST(Predictor, DecidesExactTiesByTheOrderOfEvents) {
  constexpr std::array<std::array<double, 2>, 4> kMeetings = {{{0, 13}, {5, 12}, {12, 5}, {13, 0}}};
  Comparison comparison;
  Candidates candidates;
  for (std::uint64_t seed = 0; seed < cases(4000); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const auto below = [&random](std::uint64_t n) { return static_cast<double>(random.bits() % n); };
    const bool periodic = seed % 2 == 0;
    const bool mixed_radii = seed % 3 == 0;
    const double start = seed % 5 == 0 ? 1e12 : 0;
    const double low = seed % 10 == 0 ? 0x1p-60 : 0;
    const Time now(start + 8, low);
    World world(Box(periodic ? kAllPeriodic : kAllOpen, {512, 512, 512}));
    const Vec3 place{below(512), below(512), below(512)};
    const Vec3 velocity{below(3) - 1, below(3) - 1, below(3) - 1};
    // On paths that started at integer times before; positions in the box, so that nothing is folded twice.
    const auto add = [&](const Vec3& place_now, const Vec3& v, double radius) {
      const double age = below(9);
      world.add({place_now - age * v, v, radius, 1}, Time(start + 8 - age, low));
    };
    add(place, velocity, 6.5);
    const std::uint64_t others = random.bits() % (seed % 4 == 1 ? 200 : 71);
    const double few_moments = 1 + below(4);
    for (std::uint64_t i = 0; i < others; ++i) {
      const std::size_t axis = random.bits() % 3;
      const double side = random.bits() % 2 == 0 ? 1 : -1;
      const auto [impact, ahead] = kMeetings[random.bits() % 4];
      const double speed = std::ldexp(1, static_cast<int>(random.bits() % 3));
      const double wait = std::floor(below(32) / 32 * few_moments);
      Vec3 apart;
      apart[axis] = side * (ahead + speed * wait);
      apart[(axis + 1 + random.bits() % 2) % 3] = random.bits() % 2 == 0 ? impact : -impact;
      Vec3 v;
      v[axis] = -side * speed;
      const double radius = 6.5;
      add(place + apart, velocity + v, radius);
    }
    // A distant sphere has another radius.
    if (mixed_radii) add(place + Vec3{200, 0, 0}, velocity, 1);
    shuffle(world, random);
    const Slot self = world.slot_of(0);
    const std::vector<Slot> all = some_others(world, self, random);
    collect_nearest(candidates, self, all);
    comparison.compare(world, candidates, now);
    collect_listed(candidates, world, self, all, now, random);
    comparison.compare(world, candidates, now);
    // A repeated candidate is harmless.
    std::vector<Slot> twice = all;
    twice.insert(twice.begin(), all.rbegin(), all.rend());
    collect_nearest(candidates, self, twice);
    comparison.compare(world, candidates, now);
    if (HasFailure()) return;
  }
  EXPECT_GT(comparison.coverage().ties, 10 * cases(4000));
}

// However often candidates are repeated, and into however many batches they are divided: of the second bound
// as well.
TEST(Predictor, BoundsDoNotDependOnRepetitions) {
  Candidates candidates;
  std::uint64_t differ = 0;
  for (std::uint64_t seed = 0; seed < cases(2000); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    PairMaker maker({kAllPeriodic, seed % 2 == 0, 0}, seed);
    const World world = maker.make(1 + random.bits() % 40);
    CompactPaths copies;
    copies.reset(world, 30, maker.now());
    const std::vector<Slot> all = some_others(world, 0, random);
    std::vector<Slot> repeated = all;
    const std::size_t more = all.empty() ? 0 : random.bits() % (seed % 3 == 0 ? 300 : 10);
    for (std::size_t i = 0; i < more; ++i) repeated.push_back(all[random.bits() % all.size()]);
    std::rotate(repeated.begin(), repeated.begin() + static_cast<std::ptrdiff_t>(all.size() / 2),
                repeated.end());
    for (const InstructionSet set : available_instruction_sets()) {
      const Predictor predictor(set);
      collect_nearest(candidates, 0, all);
      const BoundedContacts once = predictor.bound(copies, candidates, maker.now());
      collect_nearest(candidates, 0, repeated);
      const BoundedContacts often = predictor.bound(copies, candidates, maker.now());
      ASSERT_EQ(often.least, once.least);
      ASSERT_EQ(often.second, once.second);
      // Of two least bounds that are alike, either partner will do.
      const bool is_first = once.least < once.second;
      differ += is_first ? 1U : 0U;
      ASSERT_TRUE(often.partner == once.partner || !is_first);
    }
  }
  EXPECT_GT(differ, cases(2000) / 4);
}

// An exact graze is not a contact, whatever else is in the vector; a unit in the last place closer, it is
// one.
TEST(Predictor, KnowsExactGrazes) {
  Comparison comparison;
  Candidates candidates;
  Random random(3);
  for (std::uint64_t i = 0; i < cases(3000); ++i) {
    const double reach = std::floor(64 + 1000 * random.uniform()) / 64;
    const double distance = std::floor(1 + 1000 * random.uniform()) / 16;
    const double speed = std::floor(1 + 1000 * random.uniform()) / 32;
    World world;
    world.add({{0, 0, 0}, {}, reach / 2, 1});
    const double impact = i % 3 == 0   ? reach
                          : i % 3 == 1 ? std::nextafter(reach, 0)
                                       : std::nextafter(reach, 1e9);
    world.add({{distance, impact, 0}, {-speed, 0, 0}, reach / 2, 1});
    world.add({{2 * distance, 0, -impact}, {-speed, 0, 0}, reach / 2, 1});
    collect_nearest(candidates, 0, {1, 2});
    comparison.compare(world, candidates, Time(0));
    ASSERT_FALSE(HasFailure());
    ASSERT_EQ(plain_loop(world, candidates, Time(0)).event.happens(), i % 3 == 1);
  }
}

// The kernels compute grazes only if they may come before the earliest other contact: here one comes just
// after, or just before, at every distance.
TEST(Predictor, LosesNoGrazeJustBeforeAnotherContact) {
  Comparison comparison;
  Candidates candidates;
  Random random(4);
  std::uint64_t grazes = 0;
  for (std::uint64_t i = 0; i < cases(30000); ++i) {
    const double distance = spread(random, -3, 24);
    const double impact = 1 - spread(random, -50, -1);
    const Vec3 along = random.direction();
    Vec3 across = cross(along, random.direction());
    across = (1 / length(across)) * across;
    World world;
    world.add({{}, {}, 0.5, 1});
    world.add({impact * across - (std::sqrt(std::max(0.0, 1 - impact * impact)) + distance) * along, along,
               0.5, 1});
    const Time graze = contact_time(world, 0, 1, {});
    if (graze == kNever) continue;
    // Head on, touching slightly later or earlier.
    const double wait = graze.high * (1 + spread(random, -52, -20) * (random.uniform() < 0.7 ? 1 : -1));
    world.add({{1 + wait, 0, 0}, {-1, 0, 0}, 0.5, 1});
    collect_nearest(candidates, 0, i % 2 == 0 ? std::vector<Slot>{1, 2} : std::vector<Slot>{2, 1});
    comparison.compare(world, candidates, Time(0));
    ASSERT_FALSE(HasFailure()) << "case " << i << ", distance " << distance;
    grazes += plain_loop(world, candidates, Time(0)).partner == 1 ? 1U : 0U;
  }
  EXPECT_GT(grazes, cases(30000) / 4);
}

TEST(Predictor, FindsNothingWithoutCandidates) {
  World world;
  world.add({{0, 0, 0}, {1, 0, 0}, 1, 1});
  Candidates candidates;
  for (const InstructionSet set : available_instruction_sets()) {
    Predictor predictor(set);
    collect_nearest(candidates, 0, {});
    EXPECT_FALSE(predictor.earliest(world, candidates, Time(0)).happens());
  }
}

TEST(NearestImage, IsTheNearestAndOppositeAsSeenFromTheOther) {
  Random random(5);
  for (std::uint64_t i = 0; i < cases(20000); ++i) {
    const Box box(i % 2 == 0 ? kAllPeriodic : kMixture, {3 + random.uniform(), 4, 5 + random.uniform()});
    World world(box);
    const auto place = [&] {
      return Vec3{0.5 + 2 * random.uniform(), 4 * random.uniform(), 0.5 + 4 * random.uniform()};
    };
    const auto velocity = [&] { return Vec3{random.normal(), random.normal(), random.normal()}; };
    world.add({place(), velocity(), 0.25, 1}, Time(1));
    world.add({place(), velocity(), 0.25, 1}, Time(2));
    const Time moment(2 + 10 * random.uniform());
    const Image image = nearest_image(world, 0, 1, moment);
    ASSERT_EQ(nearest_image(world, 1, 0, moment), -image);
    const Vec3 apart = world.unfolded_position(1, moment) - world.unfolded_position(0, moment);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!box.is_periodic(axis)) {
        ASSERT_EQ(image[axis], 0);
        continue;
      }
      for (const int step : {-1, 1}) {
        Image other = image;
        other[axis] += step;
        ASSERT_LE(std::fabs((apart + box.shift(image))[axis]),
                  std::fabs((apart + box.shift(other))[axis]) * (1 + 1e-14));
      }
    }
  }
}

}  // namespace
}  // namespace hardball::predictor_test
