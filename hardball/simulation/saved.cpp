// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A simulation as bytes.
#include <optional>
#include <type_traits>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/simulation/saved.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/simulation/tuner.hpp"
#include "hardball/simulation/user_data.hpp"

namespace hardball {
namespace {

// Before version 3, a flag that says nothing.
struct UnusedFlag {
  static void persist(auto& archive, auto& /*self*/) {
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) {
      bool flag = false;
      if (archive.version() < 3) archive(flag);
    }
  }
};

// Since version 5.
struct SavedGrowth {
  std::optional<GrowthSchedule> schedule;
  static void persist(auto& archive, auto& self) {
    if (archive.version() >= 5) archive(self.schedule);
  }
};

}  // namespace

std::string Simulation::save() const {
  if (activity_.kind() == Activity::Kind::running) check_idle("save");
  const Aftermath aftermath = tuner_->engine().aftermath();
  return archived(SavedOptions{options()}, engine(), world(), now_, sums_.hash, sums_.tally, thermostat_,
                  *user_data_, aftermath.merged, UnusedFlag(), counters(), aftermath.collapse,
                  SavedGrowth{growth_});
}

std::string saved_simulation(const SavedOptions& options, EngineKind engine, const World& world,
                             const Time& now, const ContactSums& sums, const Counters& counters,
                             const CollapseGuard& collapse, const std::optional<Thermostat>& thermostat) {
  return archived(options, engine, world, now, sums.hash, sums.tally, thermostat, UserData(), MergedSpheres(),
                  UnusedFlag(), counters, collapse, SavedGrowth());
}

Simulation Simulation::load(std::string_view bytes, const std::string& where) {
  Simulation loaded;
  SavedOptions saved;
  EngineKind kind = EngineKind::automatic;
  World world(Box::open());
  Aftermath aftermath;
  UnusedFlag unused;
  Counters counters;
  SavedGrowth growth;
  restore(bytes, where, saved, kind, world, loaded.now_, loaded.sums_.hash, loaded.sums_.tally,
          loaded.thermostat_, *loaded.user_data_, aftermath.merged, unused, counters, aftermath.collapse,
          growth);
  loaded.growth_ = growth.schedule;
  if (saved.responses) {
    saved.responses->pass_as_in(world.interactions().table());
    world.set_interactions(*saved.responses);
  }
  check_moment(loaded.now_, where);
  loaded.sums_.tally.set_interactions(world.interactions());
  if (loaded.now_ < latest_change(world) ||
      loaded.sums_.tally.wall_count() != kFaces + world.surfaces().size())
    refuse_archive(where);
  for (const SphereId merged : aftermath.merged.ids()) static_cast<void>(world.slot_of(merged));
  ++counters.rebuilds;
  loaded.tuner_ = ValuePointer<Tuner>::make(saved.options, kind, counters);
  loaded.tuner_->prepare(world, loaded.now_);
  loaded.tuner_->start(std::move(world), loaded.now_);
  loaded.tuner_->engine().take_over(aftermath);
  return loaded;
}

}  // namespace hardball
