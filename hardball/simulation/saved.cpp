// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A simulation as bytes.
#include <algorithm>
#include <optional>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/run/engine_manager.hpp"
#include "hardball/simulation/saved.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/simulation/user_data.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// A sphere as archives have it.
struct SavedTransfer {
  SphereTransfer transfer;

  static void persist(auto& archive, auto& self) {
    auto& state = self.transfer.state;
    archive(state.id, state.path, state.radius, state.mass, state.inertia_factor, state.folded, state.spin,
            state.species, self.transfer.idle_contacts);
  }
};

}  // namespace

// All but the spheres, of a simulation that several processes share.
struct Simulation::Saved {
  SavedOptions options;
  World setting = World(Box::open());
  EngineKind kind = EngineKind::automatic;
  std::optional<Time> now = {};
  ContactSums sums = {};
  Counters counters = {};
  Actors actors = {};
  UserData user_data = {};

  static void persist(auto& archive, auto& self) {
    archive(self.options, self.setting, self.kind, self.now, self.sums.hash, self.sums.tally, self.counters,
            self.actors.thermostat.thermostat, self.actors.growth.schedule, self.user_data,
            self.actors.motions.schedule);
  }
};

std::string Simulation::save() const {
  if (activity_.kind() == Activity::Kind::running) check_idle("save");
  const PostContactState post_contact_state = manager_->engine().post_contact_state();
  return archived(SavedOptions{options()}, engine(), world(), now_, sums_.hash, sums_.tally, thermostat(),
                  *user_data_, post_contact_state.merged, counters(), post_contact_state.collapse, growth(),
                  actors_.motions.schedule);
}

Simulation Simulation::load(std::string_view bytes, const std::string& where, Processes& processes) {
  Simulation loaded;
  SavedOptions saved;
  EngineKind kind = EngineKind::automatic;
  World world(Box::open());
  PostContactState post_contact_state;
  Counters counters;
  restore(bytes, where, saved, kind, world, loaded.now_, loaded.sums_.hash, loaded.sums_.tally,
          loaded.actors_.thermostat.thermostat, *loaded.user_data_, post_contact_state.merged, counters,
          post_contact_state.collapse, loaded.actors_.growth.schedule, loaded.actors_.motions.schedule);
  for (const SphereId merged : post_contact_state.merged.ids()) static_cast<void>(world.slot_of(merged));
  check_features(saved.options, processes, world.features());
  loaded.begin_loaded(saved.options, kind, counters, world, where, processes);
  loaded.manager_->prepare(world, loaded.now_);
  loaded.manager_->start(std::move(world), loaded.now_);
  loaded.manager_->engine().take_over(post_contact_state);
  return loaded;
}

// Makes the manager of an engine that continues another one, in a world or a part of it.
void Simulation::begin_loaded(const EngineOptions& options, EngineKind kind, Counters counters,
                              const World& world, const std::string& where, Processes& processes) {
  check_moment(now_, where);
  sums_.tally.set_interactions(world.interactions());
  if (now_ < latest_change(world) || !sums_.tally.matches(world)) refuse_archive(where);
  if (!actors_.motions.schedule.fits(world, now_)) refuse_archive(where);
  ++counters.rebuilds;
  manager_ = ValuePointer<EngineManager>::make(options, processes, kind, counters);
}

std::vector<std::vector<SphereTransfer>> Simulation::own_blocks() const {
  const CollapseGuard counts = manager_->engine().post_contact_state().collapse;
  SphereTransfers own;
  for_each_sphere([&](const World& world, Slot slot) {
    own.push_back({world.state_of(slot), counts.idle_contacts(world.id(slot))});
  });
  const std::size_t ranks = processes().size();
  SphereTransfers arrived =
      sent(std::move(own), processes(), [&](const SphereTransfer& transfer, const auto& send_to) {
        send_to(transfer.state.id / kBlock % ranks);
      });
  std::vector<std::vector<SphereTransfer>> sorted;
  const std::size_t blocks = blocks_of_spheres();
  for (std::size_t block = processes().rank(); block < blocks; block += ranks) sorted.emplace_back();
  while (!arrived.empty()) {
    for (const SphereTransfer& transfer : arrived.take_some())
      sorted[transfer.state.id / kBlock / ranks].push_back(transfer);
  }
  for (std::vector<SphereTransfer>& block : sorted)
    ranges::sort(block, {}, [](const SphereTransfer& transfer) { return transfer.state.id; });
  return sorted;
}

std::size_t Simulation::blocks_of_spheres() const {
  SphereId next = 0;
  for_each_sphere([&](const World& world, Slot slot) { next = std::max(next, world.id(slot) + 1); });
  return (ranges::max(processes().gather(next)) + kBlock - 1) / kBlock;
}

std::string Simulation::save_without_spheres() const {
  if (activity_.kind() == Activity::Kind::running) check_idle("save_without_spheres");
  Saved saved{SavedOptions{options()},
              setting().without_spheres(),
              engine(),
              now_,
              sums_,
              counters(),
              actors_,
              *user_data_};
  saved.setting.note_passage(manager_->engine().last_passage());
  return archived(saved);
}

std::string Simulation::saved_block(const std::vector<SphereTransfer>& block) {
  std::vector<SavedTransfer> saved;
  saved.reserve(block.size());
  for (const SphereTransfer& transfer : block) saved.push_back({transfer});
  return archived(saved);
}

Simulation Simulation::load_blocks(std::string_view saved, const std::vector<std::string>& blocks,
                                   const std::string& where, Processes& processes, std::size_t threads) {
  Saved head;
  restore(saved, where, head);
  head.options.options.threads = threads;
  World part = head.setting;
  PostContactState post_contact_state;
  for (const std::string& block : blocks) {
    std::vector<SavedTransfer> spheres;
    restore(block, where, spheres);
    part.insert_all(spheres.size(), [&](std::size_t k) { return spheres[k].transfer.state; });
    for (const auto& [transfer] : spheres)
      post_contact_state.collapse.set_idle_contacts(transfer.state.id, transfer.idle_contacts);
  }
  Simulation loaded;
  if (head.now) loaded.now_ = *head.now;
  loaded.sums_ = std::move(head.sums);
  loaded.actors_ = std::move(head.actors);
  *loaded.user_data_ = std::move(head.user_data);
  check_features(head.options.options, processes, part.features());
  loaded.begin_loaded(head.options.options, head.kind, head.counters, part, where, processes);
  if (processes.size() > 1) {
    loaded.start_parts(std::move(part), loaded.now_, post_contact_state.collapse);
    return loaded;
  }
  loaded.manager_->prepare(part, loaded.now_);
  loaded.manager_->start(std::move(part), loaded.now_);
  loaded.manager_->engine().take_over(post_contact_state);
  return loaded;
}

}  // namespace hardball
