// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres are born, die, merge and change their velocities: engines that take note of it have the same
// history as engines that are made anew after every change.
#include <gtest/gtest.h>
#include <algorithm>

#include <cmath>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::births_and_deaths_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 600;
constexpr std::uint64_t kParts = 4;

// Changes a simulation at random, in a way that depends on the seed and the history alone.
class Editor {
 public:
  Editor(const World& world, std::uint64_t seed) : random_(seed) {
    double squares = 0;
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const Vec3& velocity = world.path(slot).velocity;
      squares += dot(velocity, velocity);
      radii_.push_back(world.base_radius(slot));
    }
    speed_ = std::sqrt(squares / static_cast<double>(world.size()));
    std::ranges::sort(radii_);
  }

  // Returns whether it has changed anything.
  bool edit(Simulation& simulation) {
    const double kind = random_.uniform();
    const std::vector<SphereId> ids = ids_of(simulation.world());
    if (kind < 0.3) return false;
    if (kind < 0.45 && !ids.empty()) {
      simulation.change_velocity(ids[below(ids.size())], velocity(simulation.world()));
    } else if (kind < 0.65 && ids.size() > 2) {
      simulation.remove(ids[below(ids.size())]);
    } else {
      add(simulation, ids);
    }
    return true;
  }

  std::uint64_t births() const { return births_; }

 private:
  static std::vector<SphereId> ids_of(const World& world) {
    std::vector<SphereId> ids;
    world.for_each_by_id([&](Slot slot) { ids.push_back(world.id(slot)); });
    return ids;
  }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }
  Vec3 in_plane(const World& world, Vec3 vector) const {
    if (world.box().is_flat()) vector.z = 0;
    return vector;
  }
  Vec3 velocity(const World& world) {
    const double speed = (random_.uniform() < 0.1 ? 30 : 1) * speed_ * random_.uniform();
    return in_plane(world, speed * random_.direction());
  }

  // Beside another sphere; of the size of one of those at the start, or larger than all by a third.
  void add(Simulation& simulation, const std::vector<SphereId>& ids) {
    const World& world = simulation.world();
    const double radius = random_.uniform() < 0.1 ? 1.3 * radii_.back() : radii_[below(radii_.size())];
    const Vec3 way = in_plane(world, random_.direction());
    const double distance = 1 + random_.uniform();
    const Vec3 its_velocity = velocity(world);
    const auto species = static_cast<SpeciesId>(below(kMaxRandomSpecies));
    if (ids.empty() || length(way) == 0) return;
    const SphereId beside = ids[below(ids.size())];
    const Vec3 place = simulation.position(beside) +
                       (distance * (radius + world.base_radius(world.slot_of(beside))) / length(way)) * way;
    try {
      Sphere sphere{place, its_velocity, radius, 1};
      sphere.species = species;
      simulation.add(sphere);
      ++births_;
    } catch (const Error&) {
      // No room, whatever the engine.
    }
  }

  Random random_;
  double speed_ = 0;
  std::vector<double> radii_;
  std::uint64_t births_ = 0;
};

// Runs contact by contact, with edits between.
template <class AfterEdit>
History run_with_edits(Simulation& simulation, Editor& editor, const RunLimits& limits,
                       AfterEdit&& after_edit) {
  History history;
  for (std::uint64_t done = 0; done < limits.contacts; ++done) {
    history = run_on(simulation, {.until = limits.until, .contacts = 1});
    if (!history.failure.empty()) return history;
    if (history.contacts <= done) break;
    if (editor.edit(simulation)) after_edit(simulation);
  }
  return run_on(simulation, {.until = limits.until, .contacts = 0});
}

void make_anew(Simulation& simulation) {
  simulation = Simulation::load(simulation.save());
}

History run_with_edits_of_listener(Simulation& simulation, Editor& editor, const RunLimits& limits) {
  simulation.on_contact([&](const Contact&) { editor.edit(simulation); });
  return run_on(simulation, limits);
}

class BirthsAndDeaths : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BirthsAndDeaths, GiveTheHistoryOfEnginesMadeAnew) {
  std::uint64_t births = 0;
  std::uint64_t mergers = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    RandomWorldMaker maker(seed);
    RandomWorld made = seed % 3 == 0   ? maker.make()
                       : seed % 3 == 1 ? maker.make_responsive()
                                       : maker.make_responsive_flat();
    if (made.world.size() == 0) continue;
    if (seed / kParts % 2 == 0) {
      ResponseTable table = made.world.interactions().table();
      table.set(0, 1, Merging());
      made.world.set_interactions(table);
    }
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(made.until), .contacts = 30 + 20 * (seed % 5)};
    std::vector<EngineVariant> variants = engine_variants(made.world);
    Simulation reference(made.world, variants.front().options);
    Editor editor_of_reference(made.world, seed);
    const History expected = run_with_edits(reference, editor_of_reference, limits, make_anew);
    births += editor_of_reference.births();
    mergers += reference.tally().mergers();
    for (const EngineVariant& variant : variants) {
      for (const bool by_listener : {false, true}) {
        SCOPED_TRACE(variant.name + (by_listener ? ", by a listener" : ", between runs"));
        try {
          Simulation simulation(made.world, variant.options);
          Editor editor(made.world, seed);
          const History history = by_listener ? run_with_edits_of_listener(simulation, editor, limits)
                                              : run_with_edits(simulation, editor, limits,
                                                               [](Simulation& edited) { edited.validate(); });
          ASSERT_EQ(difference(history, expected), "");
          if (history.failure.empty()) simulation.validate();
        } catch (const Error& error) {
          if (error.where() != "cell edge") throw;
        }
      }
    }
  }
  EXPECT_GT(births, cases(kWorlds) / kParts);
  EXPECT_GE(mergers, cases(kWorlds) / kParts / 40);
}

INSTANTIATE_TEST_SUITE_P(Part, BirthsAndDeaths, testing::Range<std::uint64_t>(0, kParts));

// A few large spheres, which list those near them, among many small ones.
World giants_among_dwarfs(std::size_t giants) {
  World world(Box::periodic({24, 24, 24}));
  Random random(3);
  const auto velocity = [&] { return Vec3{random.normal(), random.normal(), random.normal()}; };
  for (std::size_t i = 0; i < giants; ++i) {
    world.add({{4 + 8.0 * static_cast<double>(i), 12, 12}, 0.1 * velocity(), 3.5, 300});
  }
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) {
      for (int z = 0; z < 16; ++z) {
        const Vec3 place{1.5 * x + 0.4, 1.5 * y + 0.4, 1.5 * z + 0.4};
        bool is_free = true;
        for (Slot giant = 0; giant < giants; ++giant) {
          is_free &= length(place - world.path(giant).position) > 3.85;
        }
        if (is_free) world.add({place, velocity(), 0.3, 1});
      }
    }
  }
  return world;
}

TEST(BirthsAndDeaths, AmongLargeSpheresGiveTheHistoryOfOtherEngines) {
  for (const bool merges : {false, true}) {
    World world = giants_among_dwarfs(3);
    ResponseTable responses;
    if (merges) responses.set(0, 1, Merging());
    world.set_interactions(responses);
    const RunLimits limits{.until = Time(4), .contacts = cases(600)};
    std::vector<History> histories;
    for (const double edge : {0.8, 1.7, 6.0}) {
      Simulation simulation(world, {.engine = EngineKind::cells, .cell_edge = edge});
      Editor editor(world, 5);
      histories.push_back(run_with_edits(simulation, editor, limits, [](Simulation&) {}));
      simulation.validate();
      EXPECT_GT(editor.births(), limits.contacts / 20);
    }
    for (const History& history : histories) {
      EXPECT_EQ(difference(history, histories.front()), "");
    }
  }
}

}  // namespace
}  // namespace hardball::births_and_deaths_test
