// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A listener that edits the simulation: the history is the same with every engine, and the same as with these
// edits made between runs.
#include <gtest/gtest.h>

#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::listener_edits_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 800;
constexpr std::uint64_t kParts = 4;

// Edits of all kinds, chosen by the number of the contact alone.
class Editor {
 public:
  Editor(const RandomWorld& made, std::uint64_t seed) : random_(seed), speed_(rms_speed(made.world)) {
    for (Slot slot = 0; slot < made.world.size(); ++slot) {
      ids_.push_back(made.world.id(slot));
      smallest_ =
          slot == 0 ? made.world.base_radius(slot) : std::min(smallest_, made.world.base_radius(slot));
    }
  }

  void edit(Simulation& simulation, const Contact& contact) {
    const double kind = random_.uniform();
    if (kind < 0.4) return;
    if (kind < 0.7) {
      simulation.change_velocity(any_sphere(), velocity());
    } else if (kind < 0.8) {
      // The spheres of the contact themselves, so that the next event may be at the same moment.
      simulation.change_velocity(contact.first, velocity());
      if (contact.is_collision()) simulation.change_velocity(contact.second, velocity());
    } else if (kind < 0.9 && ids_.size() > 2) {
      const std::size_t index = below(ids_.size());
      simulation.remove(ids_[index]);
      ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(index));
    } else {
      add_beside(simulation, contact);
    }
    ++edits_;
  }

  std::uint64_t edits() const { return edits_; }

 private:
  static double rms_speed(const World& world) {
    double squares = 0;
    for (const Path& path : world.paths()) squares += dot(path.velocity, path.velocity);
    return world.size() > 0 ? std::sqrt(squares / static_cast<double>(world.size())) : 0;
  }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }
  SphereId any_sphere() { return ids_[below(ids_.size())]; }
  Vec3 velocity() {
    const double speed = speed_ * random_.uniform();
    return speed * random_.direction();
  }

  // Close to the contact, as far as there is room.
  void add_beside(Simulation& simulation, const Contact& contact) {
    const double radius = 0.5 * smallest_;
    const Vec3 place = contact.position + (contact.first_radius + 1.5 * radius) * random_.direction();
    const Vec3 its_velocity = velocity();
    try {
      ids_.push_back(simulation.add({place, its_velocity, radius, 1}));
    } catch (const Error&) {
      // No room, whatever the engine.
    }
  }

  Random random_;
  double speed_;
  double smallest_ = 0;
  std::vector<SphereId> ids_;
  std::uint64_t edits_ = 0;
};

// Spheres that edits keep sending at each other may collide endlessly at one moment; the collapse guard ends
// that.
History edited_by_listener(Simulation& simulation, Editor& editor, const RunLimits& limits) {
  simulation.on_contact([&](const Contact& contact) { editor.edit(simulation, contact); });
  return run_on(simulation, limits);
}

History edited_between_runs(Simulation& simulation, Editor& editor, const RunLimits& limits) {
  std::optional<Contact> last;
  simulation.on_contact([&](const Contact& contact) { last = contact; });
  History history;
  for (std::uint64_t done = 0; done < limits.contacts; ++done) {
    last.reset();
    history = run_on(simulation, {.until = limits.until, .contacts = 1});
    if (!last || !history.failure.empty()) break;
    editor.edit(simulation, *last);
  }
  return run_on(simulation, {.until = limits.until, .contacts = 0});
}

class ListenerEdits : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ListenerEdits, GiveOneHistory) {
  std::uint64_t edits = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const RandomWorld made = make_random_world(seed);
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(made.until), .contacts = 40 + 20 * (seed % 5)};
    EngineOptions reference{.engine = EngineKind::all_pairs};
    Simulation pieces(made.world, reference);
    Editor editor_of_pieces(made, seed);
    const History expected = edited_between_runs(pieces, editor_of_pieces, limits);
    edits += editor_of_pieces.edits();
    for (const EngineVariant& variant : engine_variants(made.world)) {
      SCOPED_TRACE(variant.name);
      try {
        Simulation simulation(made.world, variant.options);
        Editor editor(made, seed);
        const History history = edited_by_listener(simulation, editor, limits);
        ASSERT_EQ(history.contacts, expected.contacts);
        ASSERT_EQ(history.hash, expected.hash);
        ASSERT_EQ(simulation.size(), pieces.size());
        if (!history.failure.empty()) continue;
        // Applies the edits made at the last contact.
        simulation.on_contact(nullptr);
        simulation.run({.until = simulation.now(), .steps = 0});
        simulation.validate();
        ASSERT_EQ(simulation.positions(), pieces.positions());
      } catch (const Error& error) {
        if (error.where() != "cell edge") throw;
      }
    }
  }
  EXPECT_GT(edits, 5 * cases(kWorlds) / kParts);
}

INSTANTIATE_TEST_SUITE_P(Part, ListenerEdits, testing::Range<std::uint64_t>(0, kParts));

}  // namespace
}  // namespace hardball::listener_edits_test
