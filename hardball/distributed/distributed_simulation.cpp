// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/distributed/distributed_simulation.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/distributed/blocks_in_first.hpp"
#include "hardball/distributed/in_all.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/execution/follow.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/processes/bytes.hpp"
#include "hardball/simulation/any_engine.hpp"
#include "hardball/simulation/saved.hpp"
#include "hardball/theory/gas_statistics.hpp"

namespace hardball {
namespace {

// As archives have it.
struct SavedTraveler {
  Traveler traveler;

  static void persist(auto& archive, auto& self) {
    auto& state = self.traveler.state;
    archive(state.id, state.path, state.radius, state.mass, state.inertia_factor, state.folded, state.spin,
            state.species, self.traveler.idle_contacts);
  }
};

template <class T>
std::vector<T> gathered(Processes& processes, const std::vector<T>& own) {
  std::vector<T> all;
  for (const std::string& part : processes.gather(bytes_of(own))) append_bytes(part, all);
  return all;
}

// A small part of the spheres that has the whole range of radii, the same in all processes.
World sample_of(Processes& processes, const World& empty, const Travelers& brought, std::size_t spheres) {
  constexpr std::size_t kSample = 1 << 14;
  const std::size_t every = spheres / kSample + 1;
  std::vector<Traveler> own;
  std::optional<Traveler> smallest;
  std::optional<Traveler> largest;
  brought.for_each([&](const Traveler& traveler) {
    if (traveler.state.id % every == 0) own.push_back(traveler);
    if (!smallest || traveler.state.radius < smallest->state.radius) smallest = traveler;
    if (!largest || traveler.state.radius > largest->state.radius) largest = traveler;
  });
  if (smallest) own.insert(own.end(), {*smallest, *largest});
  World sample = empty;
  for (const Traveler& traveler : gathered(processes, own)) {
    if (!sample.contains(traveler.state.id)) sample.insert(traveler.state);
  }
  return sample;
}

// What this process brings of a world that all have whole.
Travelers share_of(const World& whole, const Processes& processes) {
  Travelers share;
  for (Slot slot = 0; slot < whole.size(); ++slot) {
    if (whole.id(slot) % processes.size() == processes.rank()) share.push_back({whole.state_of(slot)});
  }
  return share;
}

// Contacts before the start do not count.
void begin_paths(const World& empty, Travelers& brought, const Time& moment) {
  brought.for_each([&](Traveler& traveler) {
    if (!(traveler.state.path.time < moment)) return;
    World alone = empty;
    const Slot slot = alone.insert(traveler.state);
    alone.rewrite_path(slot, moment, alone.velocity(slot, moment));
    traveler.state = alone.state_of(slot);
  });
}

void check_can_be_distributed(const World& empty, const EngineOptions& options) {
  constexpr const char* kRemedy = "run it in one process";
  const std::string_view hindrance =
      empty.motion().has_growth() ? "a growth" : what_prevents_division(empty.box(), empty.interactions());
  if (!hindrance.empty())
    throw Error("processes cannot share " + std::string(hindrance), "processes", kRemedy);
  if (options.engine == EngineKind::all_pairs || options.engine == EngineKind::paper) {
    const auto kind = static_cast<std::size_t>(options.engine);
    throw Error("the engine " + std::string(kEngineNames[kind]) + " has one process", "engine",
                "use cells or neighbors, or run it in one process");
  }
}

std::vector<Traveler> unarchived(const std::string& block, const std::string& where) {
  std::vector<SavedTraveler> saved;
  restore(block, where, saved);
  std::vector<Traveler> travelers;
  travelers.reserve(saved.size());
  for (const SavedTraveler& each : saved) travelers.push_back(each.traveler);
  return travelers;
}

}  // namespace

// Where a simulation starts or continues.
struct DistributedSimulation::State {
  World empty = World(Box::open());
  EngineKind kind = EngineKind::automatic;
  std::optional<Time> now = {};  // none at the start
  ContactSums sums = {};
  Counters counters = {};
  std::optional<Thermostat> thermostat = {};

  static void persist(auto& archive, auto& self) {
    archive(self.empty, self.kind, self.now, self.sums.hash, self.sums.tally, self.counters, self.thermostat);
  }
};

DistributedSimulation::DistributedSimulation(Processes& processes, World empty, Travelers brought,
                                             const EngineOptions& options)
    : DistributedSimulation(processes, State{.empty = std::move(empty)}, std::move(brought), options) {}

DistributedSimulation::DistributedSimulation(Processes& processes, State state, Travelers brought,
                                             const EngineOptions& options)
    : processes_(processes),
      empty_(std::move(state.empty)),
      options_(options),
      counters_before_(state.counters) {
  hardball::check(options);
  check_can_be_distributed(empty_, options);
  for (const std::size_t count : processes.gather(brought.size())) spheres_ += count;
  Time latest = state.now.value_or(Time(0));
  brought.for_each([&](const Traveler& traveler) {
    next_id_ = std::max(next_id_, traveler.state.id + 1);
    latest = later(latest, traveler.state.path.time);
  });
  next_id_ = std::ranges::max(processes.gather(next_id_));
  for (const Time& other : processes.gather(latest)) latest = later(latest, other);
  now_ = latest;
  if (!state.now) begin_paths(empty_, brought, now_);
  const World sample = sample_of(processes, empty_, brought, spheres_);
  GasStatistics statistics = gas_statistics(sample, now_);
  statistics.spheres = spheres_;
  kind_ = choose_engine(sample, statistics, options, now_, state.kind);
  const double length = choose_length(sample, statistics, kind_, options, now_);
  const std::size_t threads = std::max<std::size_t>(options.threads, 1);
  const Division division = options.division.value_or(Division{.domains = threads, .threads = threads});
  const bool has_large = kind_ == EngineKind::cells && LargeSphereGrid::supports(sample, length);
  engine_ = make_distributed({empty_, std::move(brought), division, now_, &processes_}, kind_,
                             {length, options.instructions.value_or(widest_instruction_set())}, has_large);
  before_ = std::move(state.sums);
  if (state.now) {
    before_.tally.set_interactions(empty_.interactions());
  } else {
    require_sound(audit(), now_);
    before_.tally.begin(empty_, totals(), now_);
  }
  own_ = before_.part();
  last_change_ = before_.tally.last_change();
  thermostat_ = std::move(state.thermostat);
  if (thermostat_) follow_in_first();
}

DistributedSimulation::DistributedSimulation(DistributedSimulation&& other) noexcept = default;
DistributedSimulation::~DistributedSimulation() = default;

DistributedSimulation DistributedSimulation::of(Processes& processes, const World& whole,
                                                const EngineOptions& options) {
  return DistributedSimulation(processes, whole.without_spheres(), share_of(whole, processes), options);
}

void DistributedSimulation::follow_in_first() {
  if (of_first(whole_ ? 1 : 0) == 1) return;
  const std::vector<std::vector<Traveler>> own = own_blocks();
  BlocksInFirst blocks(*this, own);
  if (processes_.is_first()) {
    whole_ = empty_;
    while (const std::optional<std::vector<Traveler>> block = blocks.next())
      whole_->insert_all(block->size(), [&](std::size_t k) { return (*block)[k].state; });
  }
  blocks.complete();
}

void DistributedSimulation::set_thermostat(Thermostat thermostat) {
  thermostat_ = std::move(thermostat);
  follow_in_first();
  in_first(processes_, [&] { thermostat_->begin(*whole_, now_); });
}

RunStatus DistributedSimulation::run(const RunLimits& limits, bool is_observed,
                                     const Function<void(const Contact&)>& observe) {
  if (!(limits.until.value() >= now_.value())) {
    throw Error(to_text(limits.until.value()) + " is in the past; the time is " + to_text(now_.value()),
                "until", "give a later time");
  }
  if (limits.until < kNever) check_moment(limits.until, "until");
  if (!thermostat_) return run_to_action(limits, is_observed, observe);
  const std::uint64_t before = counters().contacts();
  for (RunLimits left = limits;;) {
    const Time action(of_first(processes_.is_first() ? thermostat_->next() : 0));
    const bool acts = action.high <= limits.until.high && action < kNever;
    left.until = acts ? action : limits.until;
    left.contacts = limits.contacts - (counters().contacts() - before);
    const RunStatus status = run_to_action(left, is_observed, observe);
    if (status != RunStatus::time_reached || !acts) return status;
    act(of_first(later(action, last_change_)));
  }
}

// Without the actions of the thermostat.
RunStatus DistributedSimulation::run_to_action(const RunLimits& limits, bool is_observed,
                                               const Function<void(const Contact&)>& observe) {
  const bool follows = of_first(whole_ ? 1 : 0) == 1;
  const RunStatus status = engine_->run(limits, own_, is_observed || follows, [&](const Contact& contact) {
    if (whole_) {
      last_change_ = contact.time;
      follow(*whole_, contact);
    }
    if (is_observed) observe(contact);
  });
  const bool is_idle = status == RunStatus::time_reached && !(limits.until < kNever);
  if (!is_idle) now_ = later(now_, engine_->now());
  return status;
}

// The first process lets the thermostat act on all spheres, and tells the others.
void DistributedSimulation::act(const Time& moment) {
  std::span<const NewVelocity> changes;
  std::vector<VelocityEdit> own;
  in_first(processes_, [&] {
    const double energy_before = thermostat_->energy();
    changes = thermostat_->act(*whole_, moment);
    own_.tally.note_edit(thermostat_->energy() - energy_before, moment);
    for (const NewVelocity& change : changes) own.push_back({whole_->id(change.slot), change.after});
  });
  std::vector<VelocityEdit> edits;
  append_bytes(processes_.gather(bytes_of(own)).front(), edits);
  engine_->change_velocities(moment, edits);
  now_ = later(now_, moment);
  last_change_ = moment;
  for (const NewVelocity& change : changes) {
    const Slot slot = change.slot;
    whole_->change_velocity(slot, moment, change.after);
    if (!change_listener_) continue;
    change_listener_({moment, whole_->id(slot), whole_->mass(slot), whole_->path(slot).position,
                      change.before, change.after});
  }
}

double DistributedSimulation::cell_edge() const {
  const Vec3 edges = engine_->lengths().cell_edges;
  return (edges.x + edges.y + edges.z) / 3;
}

Counters DistributedSimulation::counters() const {
  return counters_before_ + engine_->counters();
}

ContactSums DistributedSimulation::sums() const {
  ContactSums all = before_;
  for (const std::string& part : processes_.gather(archived(own_.hash, own_.tally))) {
    ContactSums sums;
    restore(part, "the sums of a process", sums.hash, sums.tally);
    all.add(sums);
  }
  return all;
}

Totals DistributedSimulation::totals() const {
  Totals own;
  engine_->for_each_own([&](const World& world, Slot slot, std::uint32_t) { own.note(world, slot, now_); });
  Totals all;
  for (const std::string& part : processes_.gather(archived(own))) {
    Totals totals;
    restore(part, "the totals of a process", totals);
    all.add(totals);
  }
  return all;
}

Extent DistributedSimulation::extent() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Extent nothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const auto widen = [](Extent& extent, const Extent& other) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      extent.low[axis] = std::min(extent.low[axis], other.low[axis]);
      extent.high[axis] = std::max(extent.high[axis], other.high[axis]);
    }
  };
  Extent own = nothing;
  engine_->for_each_own([&](const World& world, Slot slot, std::uint32_t) {
    const Vec3 position = world.position(slot, now_);
    const double of_sphere = world.radius(slot, now_);
    const Vec3 radius{of_sphere, of_sphere, of_sphere};
    widen(own, {position - radius, position + radius});
  });
  Extent all = nothing;
  for (const Extent& other : processes_.gather(own)) widen(all, other);
  return spheres_ > 0 ? all : Extent{{0, 0, 0}, {1, 1, 1}};
}

Audit DistributedSimulation::audit() const {
  std::vector<Audit> found;
  engine_->for_each_domain([&](const World& world) { found.push_back(hardball::audit(world, now_)); });
  Audit worst;
  for (const Audit& each : gathered(processes_, found)) {
    worst.not_finite += each.not_finite;
    if (each.max_overlap > worst.max_overlap) {
      worst.max_overlap = each.max_overlap;
      worst.overlap_first = each.overlap_first;
      worst.overlap_second = each.overlap_second;
    }
    if (each.max_escape > worst.max_escape) {
      worst.max_escape = each.max_escape;
      worst.escaped = each.escaped;
    }
  }
  return worst;
}

std::vector<std::size_t> DistributedSimulation::species_counts() const {
  std::vector<std::size_t> own;
  engine_->for_each_own([&](const World& world, Slot slot, std::uint32_t) {
    const std::size_t species = world.species(slot);
    if (species >= own.size()) own.resize(species + 1);
    ++own[species];
  });
  std::vector<std::size_t> all;
  for (const std::string& part : processes_.gather(bytes_of(own))) {
    std::vector<std::size_t> counts;
    append_bytes(part, counts);
    all.resize(std::max(all.size(), counts.size()));
    for (std::size_t k = 0; k < counts.size(); ++k) all[k] += counts[k];
  }
  return all;
}

bool DistributedSimulation::has_spins() const {
  bool has_spins = false;
  engine_->for_each_domain([&](const World& world) { has_spins |= world.has_spins(); });
  return std::ranges::max(processes_.gather(has_spins ? 1 : 0)) == 1;
}

std::size_t DistributedSimulation::memory_bytes() const {
  std::size_t bytes = 0;
  for (const std::size_t each : processes_.gather(engine_->memory_bytes())) bytes += each;
  return bytes;
}

std::size_t DistributedSimulation::domains() const {
  std::size_t own = 0;
  engine_->for_each_domain([&](const World&) { ++own; });
  std::size_t all = 0;
  for (const std::size_t each : processes_.gather(own)) all += each;
  return all;
}

WindowCounters DistributedSimulation::window_counters() const {
  return engine_->window_counters();
}

void DistributedSimulation::validate() const {
  engine_->validate();
}

std::vector<std::vector<Traveler>> DistributedSimulation::own_blocks() const {
  Travelers own;
  engine_->for_each_own([&](const World& world, Slot slot, std::uint32_t idle_contacts) {
    own.push_back({world.state_of(slot), idle_contacts});
  });
  Travelers arrived = sent(std::move(own), processes_, [&](const Traveler& traveler, const auto& send_to) {
    send_to(traveler.state.id / kBlock % processes_.size());
  });
  std::vector<std::vector<Traveler>> sorted;
  for (std::size_t block = processes_.rank(); block < blocks(); block += processes_.size())
    sorted.emplace_back();
  while (!arrived.empty()) {
    for (const Traveler& traveler : arrived.take_some())
      sorted[traveler.state.id / kBlock / processes_.size()].push_back(traveler);
  }
  for (std::vector<Traveler>& block : sorted)
    std::ranges::sort(block, {}, [](const Traveler& traveler) { return traveler.state.id; });
  return sorted;
}

std::string DistributedSimulation::save() const {
  World empty = empty_;
  empty.note_passage(engine_->last_passage());
  return archived(SavedOptions{options_}, State{empty, kind_, now_, sums(), counters(), thermostat_});
}

std::string DistributedSimulation::saved_block(const std::vector<Traveler>& block) {
  std::vector<SavedTraveler> saved;
  saved.reserve(block.size());
  for (const Traveler& traveler : block) saved.push_back({traveler});
  return archived(saved);
}

DistributedSimulation DistributedSimulation::load(Processes& processes, std::string_view saved,
                                                  const std::vector<std::string>& blocks, std::size_t threads,
                                                  const std::string& where) {
  SavedOptions options;
  State state;
  restore(saved, where, options, state);
  Travelers brought;
  for (const std::string& block : blocks) {
    for (const Traveler& traveler : unarchived(block, where)) brought.push_back(traveler);
  }
  options.options.threads = threads;
  return DistributedSimulation(processes, std::move(state), std::move(brought), options.options);
}

DistributedSimulation DistributedSimulation::of(Processes& processes, const Simulation& whole,
                                                std::size_t threads) {
  EngineOptions options = whole.options();
  options.threads = threads;
  return DistributedSimulation(processes,
                               {whole.world().without_spheres(), whole.engine(), whole.now(), whole.sums(),
                                whole.counters(), whole.thermostat()},
                               share_of(whole.world(), processes), options);
}

Simulation DistributedSimulation::load_whole(std::string_view saved, const std::vector<std::string>& blocks,
                                             const std::string& where) {
  SavedOptions options;
  State state;
  restore(saved, where, options, state);
  World world = std::move(state.empty);
  CollapseGuard collapse;
  for (const std::string& block : blocks) {
    const std::vector<Traveler> spheres = unarchived(block, where);
    world.insert_all(spheres.size(), [&](std::size_t k) { return spheres[k].state; });
    for (const Traveler& traveler : spheres)
      collapse.set_idle_contacts(traveler.state.id, traveler.idle_contacts);
  }
  return Simulation::load(saved_simulation(options, state.kind, world, *state.now, state.sums, state.counters,
                                           collapse, state.thermostat),
                          where);
}

}  // namespace hardball
