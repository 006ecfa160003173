// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Simulations steered as games and robots steer them, by edits, queries and copies in any order: one history,
// whatever the engine, and queries leave no trace in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::steering_test {
namespace {

using support::RandomWorld;

constexpr std::uint64_t kOperations = 1'000'000;
constexpr std::uint64_t kOperationsPerWorld = 200;
constexpr std::uint64_t kParts = 4;
// Some worlds may have any number of contacts in a short time.
constexpr std::uint64_t kMaxContacts = 20;

RandomWorld any_world(std::uint64_t seed) {
  if (seed % 3 == 0) return support::make_responsive_world(seed);
  return seed % 3 == 1 ? support::make_random_world(seed) : support::make_furnished_world(seed);
}

// A sum over all that was seen, in order.
class Digest {
 public:
  void record(std::uint64_t value) { sum_ = (std::rotl(sum_, 7) ^ value) * 0x9e3779b97f4a7c15; }
  void record(double value) { record(std::bit_cast<std::uint64_t>(value)); }
  void record(const Vec3& value) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) record(value[axis]);
  }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 1;
};

void note_queries(const Simulation& simulation, Random& random, SphereId id, double speed, double period,
                  Digest& seen) {
  const double until = simulation.time() + period * random.uniform();
  const auto next = simulation.first_contact(id, speed * random.direction(), until);
  if (next) {
    seen.record(next->time);
    seen.record(std::uint64_t{next->second});
  }
  const Vec3 place = simulation.position(id);
  const double far = 4 * simulation.world().largest_radius();
  const auto hit = simulation.ray(place, random.direction(), far);
  if (hit) seen.record(hit->point);
  const auto room = random.uniform() < 0.5 ? simulation.clearance(id) : simulation.clearance(place);
  if (room) seen.record(room->distance);
}

// What a program may do, chosen by a seed alone.
class Program {
 public:
  // If it saves, what others copy is saved and loaded.
  Program(const RandomWorld& made, const EngineOptions& options, std::uint64_t seed, bool saves)
      : simulation_(made.world, options), random_(seed), saves_(saves), period_(0.02 * made.until) {
    for (Slot slot = 0; slot < made.world.size(); ++slot) {
      ids_.push_back(made.world.id(slot));
      smallest_ =
          slot == 0 ? made.world.base_radius(slot) : std::min(smallest_, made.world.base_radius(slot));
      speed_ = std::max(speed_, length(made.world.path(slot).velocity));
    }
  }

  // The failure of a run that cannot continue: it is the same for all engines.
  std::string run(std::uint64_t operations) {
    try {
      for (std::uint64_t i = 0; i < operations; ++i) operate();
    } catch (const RunFailure& failure) {
      return failure.what();
    }
    return "";
  }

  Simulation& simulation() { return simulation_; }
  std::uint64_t seen() const { return seen_.value(); }
  std::uint64_t operations() const { return operations_; }

  void check_user_data() {
    std::erase_if(ids_, [&](SphereId id) { return !simulation_.contains(id); });
    for (const SphereId id : ids_) ASSERT_EQ(simulation_.sphere(id).user_data(), data_[id]);
  }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }
  Vec3 velocity() {
    const double speed = speed_ * random_.uniform();
    return speed * random_.direction();
  }
  SphereId any_sphere() { return ids_[below(ids_.size())]; }

  void operate() {
    ++operations_;
    // Spheres may have merged.
    std::erase_if(ids_, [&](SphereId id) { return !simulation_.contains(id); });
    if (ids_.empty()) return;
    const double kind = random_.uniform();
    if (kind < 0.25) {
      simulation_.run_contacts(1 + below(3), simulation_.time() + period_);
    } else if (kind < 0.3) {
      const double until = simulation_.time() + period_ * random_.uniform();
      simulation_.run({.until = Time(until), .contacts = kMaxContacts});
    } else if (kind < 0.5) {
      simulation_.sphere(any_sphere()).change_velocity(velocity());
    } else if (kind < 0.6) {
      change_many();
    } else if (kind < 0.65) {
      add();
    } else if (kind < 0.7 && ids_.size() > 2) {
      const std::size_t index = below(ids_.size());
      simulation_.remove(ids_[index]);
      data_.erase(ids_[index]);
      ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(index));
    } else if (kind < 0.75) {
      const SphereId id = any_sphere();
      simulation_.set_user_data(id, data_[id] = random_.bits());
    } else if (kind < 0.9) {
      note_queries(simulation_, random_, any_sphere(), speed_, period_, seen_);
    } else if (kind < 0.93) {
      for (const Contact& contact : simulation_.contacts_within(0.2 * period_, kMaxContacts)) {
        seen_.record(contact.point());
      }
    } else if (kind < 0.96) {
      const auto next = simulation_.next_contact(simulation_.time() + period_);
      if (next) seen_.record(next->time);
    } else {
      copy();
    }
    seen_.record(simulation_.time());
  }

  void change_many() {
    std::vector<VelocityEdit> changes;
    const double share = random_.uniform() * random_.uniform();
    for (const SphereId id : ids_) {
      if (random_.uniform() < share) changes.push_back({id, velocity()});
    }
    if (random_.uniform() < 0.5) std::ranges::reverse(changes);
    simulation_.change_velocities(changes);
  }

  void add() {
    const Vec3 place = simulation_.position(any_sphere()) + 4 * smallest_ * random_.direction();
    const Vec3 its_velocity = velocity();
    try {
      ids_.push_back(simulation_.add({place, its_velocity, 0.7 * smallest_, 1}));
    } catch (const Error&) {
      // No room, whatever the engine.
    }
  }

  // Goes on with a copy, or runs it ahead and drops it.
  void copy() {
    Simulation copy = saves_ ? Simulation::load(simulation_.save()) : simulation_;
    if (random_.uniform() < 0.5) {
      simulation_ = std::move(copy);
      return;
    }
    copy.change_velocity(any_sphere(), velocity());
    copy.run_contacts(2, copy.time() + period_);
    seen_.record(copy.event_log_hash());
  }

  Simulation simulation_;
  Random random_;
  bool saves_;
  double period_;
  double speed_ = 0;
  double smallest_ = 0;
  std::vector<SphereId> ids_;
  std::map<SphereId, std::uint64_t> data_;
  Digest seen_;
  std::uint64_t operations_ = 0;
};

class Steering : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Steering, GivesOneHistory) {
  std::uint64_t operations = 0;
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = GetParam(); operations < support::cases(kOperations) / kParts; seed += kParts) {
    const RandomWorld made = any_world(seed);
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    std::vector<support::EngineVariant> variants = support::engine_variants(made.world);
    EngineOptions reference = variants.front().options;
    ASSERT_EQ(reference.engine, EngineKind::all_pairs);
    const support::EngineVariant& variant = variants[1 + seed / kParts % (variants.size() - 1)];
    SCOPED_TRACE(variant.name);
    Program expected(made, reference, seed, false);
    const std::string expected_failure = expected.run(kOperationsPerWorld);
    try {
      Program program(made, variant.options, seed, true);
      const std::string failure = program.run(kOperationsPerWorld);
      operations += program.operations();
      contacts += program.simulation().counters().contacts();
      ASSERT_EQ(failure, expected_failure);
      ASSERT_EQ(program.simulation().event_log_hash(), expected.simulation().event_log_hash());
      ASSERT_EQ(program.seen(), expected.seen());
      ASSERT_EQ(program.simulation().positions(), expected.simulation().positions());
      ASSERT_EQ(program.simulation().tally().initial_energy(),
                expected.simulation().tally().initial_energy());
      program.check_user_data();
      expected.check_user_data();
    } catch (const Error& error) {
      if (error.where() != "cell edge") throw;
    }
  }
  EXPECT_GT(contacts, operations / 5);
}

INSTANTIATE_TEST_SUITE_P(Part, Steering, testing::Range<std::uint64_t>(0, kParts));

// The same run with and without queries between its pieces and from the listener: not even the work differs.
TEST(Queries, LeaveNoTrace) {
  constexpr std::uint64_t kWorlds = 60;
  constexpr int kPieces = 10;
  std::uint64_t asked = 0;
  for (std::uint64_t seed = 0; seed < support::cases(kWorlds); ++seed) {
    const RandomWorld made = any_world(seed);
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    for (const support::EngineVariant& variant : support::engine_variants(made.world)) {
      SCOPED_TRACE(variant.name);
      try {
        Simulation plain(made.world, variant.options);
        Simulation queried(made.world, variant.options);
        Random random(seed);
        Digest seen;
        const double period = made.until / kPieces;
        const auto ask = [&] {
          const auto slot = static_cast<Slot>(random.uniform() * static_cast<double>(queried.size()));
          const double speed = length(queried.world().path(slot).velocity);
          note_queries(queried, random, queried.world().id(slot), speed, period, seen);
          ++asked;
        };
        queried.on_contact([&](const Contact&) { ask(); });
        for (int piece = 1; piece <= kPieces; ++piece) {
          const RunLimits limits{.until = Time(piece * period), .contacts = 20};
          ask();
          const support::History expected = support::run_on(plain, limits);
          const support::History history = support::run_on(queried, limits);
          ASSERT_EQ(difference(history, expected), "");
          ASSERT_EQ(queried.counters(), plain.counters());
          if (!expected.failure.empty()) break;
        }
      } catch (const Error& error) {
        if (error.where() != "cell edge") throw;
      }
    }
  }
  EXPECT_GT(asked, 100 * support::cases(kWorlds));
}

}  // namespace
}  // namespace hardball::steering_test
