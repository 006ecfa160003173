// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Engines that go back to a moment and run again repeat their history to the last bit, across contacts,
// crossings, mergers, births, deaths and changes of velocities.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/run/make_engine.hpp"
#include "hardball/world/images.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::rewind_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 320;
constexpr std::uint64_t kParts = 4;
constexpr int kPieces = 12;
constexpr int kRewinds = 6;

// What is left of a contact in the log.
struct Entry {
  Time time;
  SphereId first;
  std::uint32_t second;
  Velocities after;
};

// An engine that is edited at fixed times in a way that depends on the time and the world alone.
class EditedEngine {
 public:
  EditedEngine(const RandomWorld& made, const EngineOptions& options, std::uint64_t seed)
      : options_(options), seed_(seed), until_(made.until) {
    World world = made.world;
    const GasStatistics statistics = gas_statistics(world, Time(0));
    kind_ = choose_engine(world, statistics, options_, Time(0));
    length_ = choose_length(world, statistics, kind_, options_, Time(0));
    engine_ = make_engine(std::move(world), kind_, options_, length_, Time(0));
    engine_->begin_journal(Time(0));
    sums_.tally.begin(this->world(), Time(0));
  }

  const std::vector<Entry>& log() const { return log_; }
  const World& world() const { return engine_->world(); }
  std::uint64_t edits() const { return edits_; }
  Counters counters() const { return engine_->counters(); }
  // Then its counters began anew.
  bool was_replaced() const { return was_replaced_; }

  // Runs to the end from where it is.
  void run() {
    for (; piece_ < kPieces; ++piece_) {
      const Time end(time_of(piece_ + 1));
      run_until(end);
      edit(end);
    }
  }

  void rewind(const Time& moment) {
    engine_->rewind(moment);
    while (!log_.empty() && log_.back().time > moment) log_.pop_back();
    is_cut_off_ = false;
    piece_ = 0;
    while (piece_ < kPieces && Time(time_of(piece_ + 1)) <= moment) ++piece_;
    engine_->validate();
  }

  double time_of(int piece) const { return until_ * piece / kPieces; }

 private:
  void run_until(const Time& end) {
    constexpr std::uint64_t kMax = 400;  // spheres may collapse
    const auto observe = [this](const Contact& contact) {
      log_.push_back({contact.time, contact.first, contact.second, contact.after});
      return true;
    };
    while (log_.size() < kMax) {
      rebuild_if_outdated();
      const std::uint64_t left = kMax - log_.size();
      if (engine_->run({.until = end, .contacts = left}, sums_, {.on_contact = observe}) ==
          RunStatus::time_reached)
        return;
    }
    is_cut_off_ = true;
  }

  void rebuild_if_outdated() {
    if (!engine_->needs_rebuild()) return;
    const Time now = engine_->now();
    const GasStatistics statistics = gas_statistics(world(), now);
    kind_ = choose_engine(world(), statistics, options_, now, kind_);
    length_ = allowed_cell_edge(world(), kind_, choose_length(world(), statistics, kind_, options_, now));
    was_replaced_ = true;
    engine_ = make_engine(std::move(engine_->mutable_world()), kind_, options_, length_, now);
  }

  void edit(const Time& moment) {
    if (is_cut_off_) return;
    Random random(seed_ * 1000003 + static_cast<std::uint64_t>(piece_));
    const double kind = random.uniform();
    const auto slot_at_random = [&] {
      const auto rank = static_cast<double>(world().size()) * random.uniform();
      return world().slot_of_rank(static_cast<std::size_t>(rank));
    };
    const auto in_plane = [&](Vec3 vector) {
      if (world().box().is_flat()) vector.z = 0;
      return vector;
    };
    if (world().size() < 2) return;
    if (!log_.empty() && log_.back().time > moment) return;  // a contact in the same double
    engine_->rewind(moment);                                 // a crossing in the same double
    if (kind < 0.3) {
      const Slot slot = slot_at_random();
      const Vec3 before = world().velocity(slot, moment);
      const Vec3 after = in_plane(2 * length(before) * random.direction());
      const NewVelocity change{slot, before, after};
      engine_->change_velocities(moment, {&change, 1});
      ++edits_;
    } else if (kind < 0.5) {
      engine_->remove(world().id(slot_at_random()), moment);
      ++edits_;
    } else if (kind < 0.9) {
      const Slot beside = slot_at_random();
      Sphere sphere;
      sphere.radius = world().base_radius(beside) * (0.7 + 0.5 * random.uniform());
      sphere.velocity = world().velocity(slot_at_random(), moment);
      sphere.position = world().position(beside, moment) +
                        1.5 * (sphere.radius + world().base_radius(beside)) * in_plane(random.direction());
      try {
        engine_->add(sphere, moment);
        ++edits_;
      } catch (const Error&) {
        // No room.
      }
    }
  }

  EngineOptions options_;
  std::uint64_t seed_;
  double until_;
  EngineKind kind_;
  double length_ = 0;
  std::unique_ptr<EngineBase> engine_;
  ContactSums sums_;
  bool was_replaced_ = false;
  std::vector<Entry> log_;
  int piece_ = 0;
  bool is_cut_off_ = false;
  std::uint64_t edits_ = 0;
};

std::string difference(const std::vector<Entry>& a, const std::vector<Entry>& b) {
  if (a.size() != b.size()) return "lengths";
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool same = a[i].time == b[i].time && a[i].first == b[i].first && a[i].second == b[i].second &&
                      same_bits(a[i].after.first, b[i].after.first) &&
                      same_bits(a[i].after.second, b[i].after.second);
    if (!same) return "contact " + to_text(i);
  }
  return "";
}

std::string difference(const World& a, const World& b) {
  if (a.size() != b.size()) return "numbers of spheres";
  std::string found;
  a.for_each_by_id([&](Slot slot) {
    const SphereId id = a.id(slot);
    if (!b.contains(id)) {
      found = "sphere " + to_text(id) + " is missing";
      return;
    }
    const Slot other = b.slot_of(id);
    const bool same = a.path(slot) == b.path(other) && a.base_radius(slot) == b.base_radius(other) &&
                      a.mass(slot) == b.mass(other) && a.spin(slot) == b.spin(other) &&
                      a.species(slot) == b.species(other) &&
                      image_of(a, slot, a.path(slot).time) == image_of(b, other, a.path(slot).time);
    if (!same) found = "sphere " + to_text(id);
  });
  return found;
}

class Rewind : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Rewind, RepeatsTheHistory) {
  std::uint64_t rewinds = 0;
  std::uint64_t edits = 0;
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    RandomWorldMaker maker(seed);
    RandomWorld made = seed / kParts % 2 == 0 ? maker.make() : maker.make_responsive();
    if (seed / kParts % 3 == 0) {
      ResponseTable table = made.world.interactions().table();
      table.set(0, 1, Merging());
      made.world.set_interactions(table);
    }
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    for (const EngineVariant& variant : engine_variants(made.world)) {
      SCOPED_TRACE(variant.name);
      try {
        EditedEngine engine(made, variant.options, seed);
        engine.run();
        const std::vector<Entry> log = engine.log();
        const World world = engine.world();
        const std::uint64_t done = engine.counters().contacts();
        edits += engine.edits();
        contacts += log.size();
        Random random(seed);
        for (int i = 0; i < kRewinds; ++i) {
          const double share = random.uniform();
          // To the time of a contact, or to any.
          const Time moment = share < 0.5 && !log.empty() ? log[random.bits() % log.size()].time
                                                          : Time(engine.time_of(kPieces) * random.uniform());
          engine.rewind(moment);
          engine.run();
          ++rewinds;
          ASSERT_EQ(difference(engine.log(), log), "") << "rewind " << i << " to " << moment.high;
          ASSERT_EQ(difference(engine.world(), world), "") << "rewind " << i << " to " << moment.high;
        }
        if (!engine.was_replaced()) {
          ASSERT_EQ(engine.counters().contacts(), done);
        }
      } catch (const RunFailure&) {
        // Inelastic collapse, before or after.
      } catch (const Error& error) {
        if (error.where() != "cell edge") throw;
      }
    }
  }
  EXPECT_GT(rewinds, cases(kWorlds) / kParts * 8);
  EXPECT_GT(edits, cases(kWorlds) / kParts * 8);
  EXPECT_GT(contacts, cases(kWorlds) / kParts * 10);
}

INSTANTIATE_TEST_SUITE_P(Part, Rewind, testing::Range<std::uint64_t>(0, kParts));

}  // namespace
}  // namespace hardball::rewind_test
