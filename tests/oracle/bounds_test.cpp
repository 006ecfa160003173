// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Bounds of contact times against the contact times themselves: no bound may come late, whatever the pair,
// the box, the units and the age of the copies from which bounds are computed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/engine/predictor.hpp"
#include "hardball/engine/step_candidates.hpp"
#include "hardball/interaction/step_potential.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/step_levels.hpp"
#include "support/effort.hpp"
#include "support/instruction_sets.hpp"
#include "support/record.hpp"

namespace hardball::bounds_test {
namespace {

// How worlds are made. Lengths are in units of the largest reach, speeds in units of a common speed.
struct Regime {
  std::string name;
  double farthest = 3;  // the greatest distance of candidates
  double box = 20;      // edge; of open space, the interval in which spheres are
  Boundary boundary = Boundary::periodic;
  double smallest_radius = 0.5;
  double slowest = 0.1;        // the least speed, and the least relative speed
  double drift = 0;            // a velocity common to all
  double share_at_rest = 0;    // of the spheres
  double fastest = 1;          // the speed of one sphere in each world
  bool fast_one_asks = false;  // it is the one whose contacts are bounded
  double length_unit = 1;      // [L]
  double speed_unit = 1;       // [L/T]
  double growth = 0;           // of radii, in units of themselves over the length unit over the speed unit
  double gravity = 0;          // times the length unit over the square of the speed unit, in any direction
  double slide =
      0;  // the speed of the images above, in units of the common one; most spheres are at the face
  double start = 0;           // [T], over the length unit divided by the speed unit
  double contacts = 1.0 / 3;  // the least share of pairs that meet, or of which copies say nothing
  double early = 1e-3;        // by how much half of the bounds are early at most, see Outcome
  double for_nothing = 0.02;  // the share of pairs with a bound among those that miss by less than a tenth
};

void PrintTo(const Regime& regime, std::ostream* out) {
  *out << regime.name;
}

enum class Meeting { generic, grazing, touching, far, receding, at_relative_rest };
constexpr std::array kMeetings = {Meeting::generic, Meeting::grazing,  Meeting::touching,
                                  Meeting::far,     Meeting::receding, Meeting::at_relative_rest};

// A sphere in slot 0 and others that it may meet.
struct Encounters {
  World world;
  std::vector<Meeting> meetings;  // by slot
  double farthest = 0;            // [L]
  Time now;
};

constexpr Slot kOthers = 16;

class EncounterMaker {
 public:
  EncounterMaker(const Regime& regime, Random& random) : regime_(regime), random_(random) {}

  Encounters make() {
    const double edge = regime_.box * regime_.length_unit;
    const Boundary boundary = regime_.boundary;
    Encounters made;
    gravity_ = regime_.gravity * regime_.speed_unit * regime_.speed_unit / regime_.length_unit *
               (regime_.gravity > 0 ? random_.direction() : Vec3{});
    Box box({boundary, boundary, boundary}, {edge, edge, edge});
    if (regime_.slide != 0) {
      box.set_shear({.rate = regime_.slide * regime_.speed_unit / edge,
                     .offset = (20 * random_.uniform() - 10) * edge});
    }
    made.world = World(box, gravity_);
    made.farthest = regime_.farthest * regime_.length_unit;
    const double start = regime_.start * regime_.length_unit / regime_.speed_unit;
    made.now = after(Time(start), random_.uniform() * regime_.length_unit / regime_.speed_unit);
    drift_ = regime_.drift * regime_.speed_unit * random_.direction();
    const Slot fast = regime_.fast_one_asks ? 0 : 1;
    const double own_radius = radius();
    const Vec3 own_velocity = velocity(fast == 0);
    Vec3 own_place;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      // Far enough from walls.
      const double inset = boundary == Boundary::wall ? made.farthest + regime_.length_unit : 0;
      own_place[axis] = inset + random_.uniform() * (edge - 2 * inset);
    }
    if (regime_.slide != 0 && chance(0.8))
      own_place.y = (2 * random_.uniform() - 1) * made.farthest + (chance(0.5) ? edge : 0);
    add(made, own_place, own_velocity, own_radius, Meeting::generic);
    for (Slot other = 1; other <= kOthers; ++other) {
      const double other_radius = radius();
      const double reach = own_radius + other_radius;
      const Meeting meeting = kMeetings[random_.bits() % kMeetings.size()];
      const double distance = choose_distance(meeting, reach, made.farthest);
      const double sine = std::min(1.0, reach * passing(meeting) / distance);
      // Along the line on which they approach each other or recede, and across.
      const Vec3 along = fast == 0 ? (1 / length(own_velocity)) * own_velocity : random_.direction();
      const double sign = meeting == Meeting::receding ? -1 : 1;
      const Vec3 apart =
          distance * (sine * across(along) + sign * std::sqrt((1 - sine) * (1 + sine)) * along);
      add(made, own_place + apart,
          fast == 0 ? velocity(false) : approach(meeting, along, own_velocity, other == fast), other_radius,
          meeting);
    }
    if (regime_.growth != 0) grow(made);
    return made;
  }

 private:
  // Evenly distributed in the logarithm.
  double spread(double low, double high) { return low * std::pow(high / low, random_.uniform()); }
  bool chance(double probability) { return random_.uniform() < probability; }

  double radius() {
    const double largest = 0.5;
    const bool is_mixed = regime_.smallest_radius < largest;
    return regime_.length_unit * (is_mixed ? spread(regime_.smallest_radius, largest) : largest);
  }

  double speed(bool is_fast) {
    return regime_.speed_unit * (is_fast ? regime_.fastest : spread(regime_.slowest, 1));
  }

  Vec3 velocity(bool is_fast) {
    if (chance(regime_.share_at_rest)) return {};
    return drift_ + speed(is_fast) * random_.direction();
  }

  double choose_distance(Meeting meeting, double reach, double farthest) {
    if (meeting == Meeting::touching) return reach * (1 + spread(1e-12, 1e-3));
    if (meeting == Meeting::far) return farthest * (1 - 1e-9);
    return reach + random_.uniform() * (farthest - reach);
  }

  // By how many reaches the centers pass each other.
  double passing(Meeting meeting) {
    if (meeting != Meeting::grazing) return 1.1 * random_.uniform();
    const double cosine = spread(1e-9, 1);
    return std::sqrt((1 - cosine) * (1 + cosine));
  }

  Vec3 across(const Vec3& along) {
    Vec3 found;
    do {
      found = cross(along, random_.direction());
    } while (length(found) < 0.1);
    return (1 / length(found)) * found;
  }

  // The velocity of the other sphere. Spheres at rest are passed as they are.
  Vec3 approach(Meeting meeting, const Vec3& along, const Vec3& own_velocity, bool is_fast) {
    if (chance(regime_.share_at_rest)) return {};
    if (meeting == Meeting::at_relative_rest) {
      return own_velocity + (chance(0.5) ? 0 : 1e-9 * speed(false)) * random_.direction();
    }
    return own_velocity - speed(is_fast) * along;
  }

  // An epoch that has begun some time ago, in which the scale is one now.
  void grow(Encounters& made) {
    const double unit = regime_.length_unit / regime_.speed_unit;
    const double rate = regime_.growth / unit;
    const double age = random_.uniform() * unit * std::min(1.0, 0.5 / std::fabs(regime_.growth));
    const double left = unit * std::min(10.0, 0.5 / std::fabs(regime_.growth));
    made.world.set_growth({after(made.now, -age), after(made.now, left), 1 - rate * age, rate});
  }

  // On a path that has begun at some time before.
  void add(Encounters& made, const Vec3& place, const Vec3& velocity, double radius, Meeting meeting) {
    const double speed = length(velocity);
    double age = chance(0.2) || !(speed > 0) ? 0 : random_.uniform() * made.farthest / speed;
    // No contact lets a sphere fall much farther than the distance of candidates.
    const double gravity = length(gravity_);
    if (gravity > 0) age = std::min(age, 2 * std::sqrt(made.farthest / gravity));
    made.world.add({place, velocity, radius, 1}, made.now);
    if (age > 0) {
      const Time begin = after(made.now, -age);
      const auto slot = static_cast<Slot>(made.world.size() - 1);
      Path path = made.world.path(slot);
      path.position = path.position - age * (path.velocity - (0.5 * age) * gravity_);
      path.velocity = path.velocity - age * gravity_;
      path.time = begin;
      SphereEdit(made.world, begin, slot).store_path(slot, path, {});
    }
    made.meetings.push_back(meeting);
  }

  Regime regime_;
  Random& random_;
  Vec3 drift_;
  Vec3 gravity_;
};

// Copies every path as it was before, so long ago that the sphere has moved up to as far as it may, and for
// the sphere that asks, now.
void copy_paths(const Encounters& made, Random& random, CompactPaths& copies) {
  const World& world = made.world;
  // In a periodic box, the copy must lie in the same half of it as the sphere does now.
  double way = made.farthest;
  if (world.box().is_periodic(0)) way = std::min(way, 0.49 * world.box().size().x - made.farthest);
  copies.reset(world, std::max(made.farthest, CompactPaths::least_farthest(world.box())), way, made.now);
  for (Slot slot = 1; slot < world.size(); ++slot) {
    const double speed = length(world.path(slot).velocity);
    // At rest it may be any time, more than 2^32 ticks too.
    double longest_age =
        speed > 0 ? std::min(way / speed, copies.longest_age(slot)) : 1e4 * copies.time_unit();
    if (const double gravity = length(world.motion().gravity()); gravity > 0) {
      // At the copy it may have been faster by all that it has fallen.
      const double now = length(world.velocity(slot, made.now));
      longest_age =
          std::min(copies.longest_age(slot), 2 * way / (now + std::sqrt(now * now + 6 * gravity * way)));
    }
    const double part = random.uniform();
    double age = part < 0.2 ? 0 : part < 0.4 ? longest_age : random.uniform() * longest_age;
    copies.copy(world, slot, after(made.now, -age));
    // The image that was in a sheared box then may be faster than the one that is in it now.
    while (world.box().is_sheared() && age > copies.longest_age(slot)) {
      age /= 2;
      copies.copy(world, slot, after(made.now, -age));
    }
  }
  copies.copy(world, 0, made.now);
}

struct Outcome {
  std::uint64_t contacts = 0;
  std::uint64_t unbounded = 0;  // pairs of which copies say nothing
  // Generic pairs alone:
  std::uint64_t misses = 0;
  std::uint64_t bounded_misses = 0;  // which have a bound for nothing
  std::vector<double> early;  // by how much bounds are early, over the time in which the spheres move as far
                              // relative to each other as candidates may be apart [1]
};

double part_of(std::uint64_t part, std::uint64_t all) {
  return static_cast<double>(part) / static_cast<double>(all);
}

bool says_nothing(const CompactPaths& copies, Slot slot) {
  return std::isnan(copies.paths()[slot].velocity[0]);
}

class Bounds : public testing::TestWithParam<Regime> {
 protected:
  Bounds() {
    for (const InstructionSet set : support::available_instruction_sets()) predictors_.emplace_back(set);
  }

  // Bounds the contacts with each other sphere by itself, in some lane, and with all of them.
  void compare(const Encounters& made, const CompactPaths& copies, Outcome& outcome) {
    const World& world = made.world;
    std::vector<double> contacts(world.size(), kNever.high);
    for (Slot other = 1; other < world.size(); ++other) {
      const Time contact = contact_time(world, 0, other, nearest_image(world, 0, other, made.now));
      // What lies in the past cannot be: it would have happened. After the end of an epoch there is no
      // contact, but what would be one is bounded, too.
      if (contact >= made.now) contacts[other] = contact.high;
    }
    const double base = rounded_down(made.now);
    for (const Predictor& predictor : predictors_) {
      for (Slot other = 1; other < world.size(); ++other) {
        candidates_.begin(0, true);
        for (Slot before = 1; before < other; ++before) candidates_.add(0);
        candidates_.add(other);
        candidates_.end();
        const BoundedContacts found = predictor.bound(copies, candidates_, made.now);
        ASSERT_LE(found.least, contacts[other]) << "slot " << other;
        ASSERT_GE(found.least, base);
        ASSERT_EQ(found.partner, found.least < kNever.high ? other : 0);
        record(made, copies, other, contacts[other], found.least, outcome);
      }
      candidates_.begin(0, true);
      for (Slot other = 1; other < world.size(); ++other) candidates_.add(other);
      candidates_.end();
      const BoundedContacts found = predictor.bound(copies, candidates_, made.now);
      ASSERT_LE(found.least, found.second);
      for (Slot other = 1; other < world.size(); ++other) {
        ASSERT_LE(other == found.partner ? found.least : found.second, contacts[other]);
      }
    }
  }

 private:
  static void record(const Encounters& made, const CompactPaths& copies, Slot other, double contact,
                     double bound, Outcome& outcome) {
    if (says_nothing(copies, 0) || says_nothing(copies, other)) {
      ++outcome.unbounded;
      ASSERT_EQ(bound, rounded_down(made.now)) << "slot " << other;
      return;
    }
    outcome.contacts += contact < kNever.high ? 1U : 0U;
    if (made.meetings[other] != Meeting::generic) return;
    if (contact < kNever.high) {
      const Image image = nearest_image(made.world, 0, other, made.now);
      const Vec3 velocity = relative_state(made.world, 0, other, image, made.now).velocity;
      outcome.early.push_back((contact - bound) / (made.farthest / length(velocity)));
    } else {
      ++outcome.misses;
      outcome.bounded_misses += bound < kNever.high ? 1U : 0U;
    }
  }

  std::vector<Predictor> predictors_;
  Candidates candidates_;
};

TEST_P(Bounds, AreNeverLate) {
  const Regime& regime = GetParam();
  Outcome outcome;
  CompactPaths copies;
  const std::uint64_t worlds = support::cases(50000);
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Encounters made = EncounterMaker(regime, random).make();
    copies = CompactPaths();
    copy_paths(made, random, copies);
    compare(made, copies, outcome);
    if (HasFatalFailure()) return;
  }
  const std::uint64_t pairs = worlds * kOthers * support::available_instruction_sets().size();
  support::record("contacts", part_of(outcome.contacts, pairs));
  support::record("unbounded", part_of(outcome.unbounded, pairs));
  EXPECT_GT(part_of(outcome.contacts + outcome.unbounded, pairs), regime.contacts);
  if (outcome.unbounded == pairs) return;
  // Bounds are sharp, too.
  std::vector<double>& early = outcome.early;
  const auto middle = early.begin() + static_cast<std::ptrdiff_t>(early.size() / 2);
  std::nth_element(early.begin(), middle, early.end());
  support::record("early", *middle);
  support::record("for_nothing", part_of(outcome.bounded_misses, outcome.misses));
  EXPECT_LT(*middle, regime.early);
  // Where spheres grow fast, all meet.
  if (outcome.misses == 0 && regime.growth > 0) return;
  EXPECT_LT(part_of(outcome.bounded_misses, outcome.misses), regime.for_nothing);
}

std::vector<Regime> all_regimes() {
  return {
      {.name = "ListsInABoxOf20", .farthest = 1.6},
      {.name = "ListsInABoxOf4", .farthest = 1.35, .box = 4.2},
      {.name = "CellsInABoxOf100", .farthest = 5, .box = 100},
      {.name = "LargeCells", .farthest = 17, .box = 300, .for_nothing = 0.2},
      {.name = "ABoxOf1e4", .box = 1e4},
      {.name = "ABoxOf2e7", .box = 2e7},
      {.name = "Walls", .box = 100, .boundary = Boundary::wall},
      {.name = "OpenOutTo1e7", .box = 1e7, .boundary = Boundary::open},
      {.name = "MixedRadii", .farthest = 5, .smallest_radius = 0.005, .early = 3e-3, .for_nothing = 0.6},
      {.name = "SideBySide", .farthest = 1.6, .slowest = 1e-6, .drift = 1, .early = 0.02, .for_nothing = 0.6},
      {.name = "CommonDrift", .drift = 100, .early = 0.03, .for_nothing = 0.6},
      {.name = "SlowAndAtRest", .slowest = 1e-6, .share_at_rest = 0.3, .early = 0.01, .for_nothing = 0.6},
      {.name = "OneThatIsFaster", .fastest = 8},
      {.name = "OneThatIsMuchFaster", .fastest = 1e4, .early = 0.2, .for_nothing = 0.9},
      {.name = "AMuchFasterOneThatAsks", .fastest = 1e4, .fast_one_asks = true},
      {.name = "Falling", .gravity = 0.3},
      {.name = "FallingFromRest",
       .slowest = 1e-6,
       .share_at_rest = 0.3,
       .gravity = 0.1,
       .early = 0.05,
       .for_nothing = 0.6},
      {.name = "FallingFast", .gravity = 100, .early = 0.2, .for_nothing = 1},
      {.name = "FallingInASmallBox", .farthest = 1.35, .box = 4.2, .gravity = 1},
      {.name = "FallingOfMixedRadii",
       .farthest = 5,
       .smallest_radius = 0.005,
       .gravity = 1,
       .early = 0.01,
       .for_nothing = 0.9},
      {.name = "Growing", .growth = 0.03},
      {.name = "GrowingFast", .growth = 1},
      {.name = "GrowingFasterThanTheyMove", .slowest = 1e-3, .growth = 100},
      {.name = "GrowingMixture", .farthest = 5, .smallest_radius = 0.005, .growth = 0.3, .for_nothing = 0.6},
      {.name = "GrowingAtRest", .slowest = 1e-6, .share_at_rest = 0.5, .growth = 0.01},
      {.name = "GrowingLate", .growth = 0.3, .start = 1e10},
      // Bounds take the sizes as constant.
      {.name = "Shrinking", .growth = -0.3, .contacts = 0.05, .early = 0.2, .for_nothing = 0.95},
      {.name = "SmallAndFast", .length_unit = 1e-9, .speed_unit = 300},
      {.name = "Large", .length_unit = 1e50},
      {.name = "SmallAndSlow", .length_unit = 1e-50, .speed_unit = 1e-50},
      {.name = "Sheared", .slide = 1},
      {.name = "ShearedFast", .slide = -30, .early = 3e-3, .for_nothing = 0.3},
      {.name = "ShearedMixtureInASmallBox",
       .farthest = 1.35,
       .box = 4.2,
       .smallest_radius = 0.05,
       .slide = 2,
       .for_nothing = 0.1},
      {.name = "ShearedLate", .slide = 0.5, .start = 1e7},
      {.name = "ShearedInABoxOf1e4", .box = 1e4, .slide = 10, .early = 0.1, .for_nothing = 0.95},
      {.name = "Late", .start = 1e10},
      {.name = "LateInASmallBox", .farthest = 1.35, .box = 4.2, .slowest = 1e-3, .start = 1e10},
  };
}

// A sphere in slot 0 and others that are inside of steps with it: anywhere, at the edges, going in and out,
// grazing; on paths that have begun some time before.
World make_wells(Random& random, const Time& now) {
  StepRules rules{.steps = {{.ratio = 1.6, .energy = -1}}};
  if (random.uniform() < 0.5) rules.steps.insert(rules.steps.begin(), {.ratio = 1.3, .energy = -2});
  if (random.uniform() < 0.3) rules.core = 0;
  StepTable table;
  table.set_for_all(StepPotential(rules));
  Interactions interactions;
  interactions.set_steps(table);
  World world(Box::periodic({9, 8, 10}));
  world.set_interactions(interactions);
  const bool is_mixed = random.uniform() < 0.5;
  const auto radius = [&] { return is_mixed ? 0.3 + 0.2 * random.uniform() : 0.5; };
  const auto speed = [&] { return std::pow(10, -3 * random.uniform()); };
  const Vec3 place{9 * random.uniform(), 8 * random.uniform(), 10 * random.uniform()};
  const double own_radius = radius();
  world.add({place, speed() * random.direction(), own_radius, 1}, now);
  for (Slot other = 1; other <= kOthers; ++other) {
    const double other_radius = radius();
    const double outer = 1.6 * (own_radius + other_radius);
    const double inner = rules.core * (own_radius + other_radius);
    const double edge = random.uniform();
    const double distance = edge < 0.2   ? outer * (1 - std::pow(10, -3 - 12 * random.uniform()))
                            : edge < 0.4 ? inner * (1 + std::pow(10, -3 - 12 * random.uniform()))
                                         : inner + (outer - inner) * random.uniform();
    const Vec3 along = random.direction();
    Vec3 velocity = speed() * random.direction();
    // Along the line of centers, or nearly across it.
    if (random.uniform() < 0.3) velocity = (random.uniform() < 0.5 ? 1 : -1) * length(velocity) * along;
    if (random.uniform() < 0.3) velocity -= (1 - 1e-6) * dot(velocity, along) * along;
    world.add({place + distance * along, world.path(0).velocity + velocity, other_radius, 1}, now);
  }
  assign_levels(world, now);
  for (Slot slot = 1; slot < world.size(); ++slot) {
    Path path = world.path(slot);
    const double age = random.uniform() < 0.5 ? 0 : random.uniform() * 0.2;
    path.time = after(now, -age);
    path.position = path.position - age * path.velocity;
    SphereEdit(world, path.time, slot).store_path(slot, path, {});
  }
  return world;
}

TEST(StepBounds, AreNeverLate) {
  std::vector<Predictor> predictors;
  for (const InstructionSet set : support::available_instruction_sets()) predictors.emplace_back(set);
  std::uint64_t pairs_bounded = 0;
  std::vector<double> early;
  const std::uint64_t worlds = support::cases(50000);
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Time now(seed % 3 == 0 ? 1e6 * random.uniform() : random.uniform());
    const World world = make_wells(random, now);
    CompactPaths copies;
    copies.reset(world, 2, now);
    for (Slot slot = 1; slot < world.size(); ++slot)
      copies.copy(world, slot, random.uniform() < 0.5 ? now : world.path(slot).time);
    StepCandidates pairs;
    pairs.collect(world, 0);
    pairs.find_distances_for_bounds(world, copies);
    for (const Predictor& predictor : predictors) {
      const BoundedContacts found = predictor.bound_steps(copies, pairs, now);
      ASSERT_LE(found.least, found.second);
      for (const PairLevel& pair : pairs.pairs()) {
        const Time time = next_pair_event(world, 0, pair, nearest_image(world, 0, pair.partner, now)).time;
        // What would have happened before is not asked for.
        if (time < now) continue;
        const bool is_first = pair.partner == found.partner;
        ASSERT_LE(is_first ? found.least : found.second, time.high) << "slot " << pair.partner;
        ++pairs_bounded;
        const double speed = length(world.path(pair.partner).velocity - world.path(0).velocity);
        if (is_first && time < kNever) early.push_back((time.high - found.least) * speed);
      }
    }
  }
  EXPECT_GT(pairs_bounded, 8 * worlds * predictors.size());
  // Bounds are sharp, too.
  const auto middle = early.begin() + static_cast<std::ptrdiff_t>(early.size() / 2);
  std::nth_element(early.begin(), middle, early.end());
  support::record("early", *middle);
  EXPECT_LT(*middle, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Regimes, Bounds, testing::ValuesIn(all_regimes()),
                         [](const auto& regime) { return regime.param.name; });

}  // namespace
}  // namespace hardball::bounds_test
