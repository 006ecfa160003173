// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/domains_engine.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/domains/sample.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/execution/follow.hpp"
#include "hardball/processes/bytes.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/curve_order.hpp"
#include "hardball/world/sphere_edit.hpp"

namespace hardball {
namespace {

// Makes `count` domains of a layout, from number `first` on. `world` has the spheres as they are at `now`, at
// least all that these domains own or hold; `post_contact_state` is what contacts of theirs left behind.
std::vector<std::unique_ptr<Domain>> make_domains(const Layout& layout, DomainNumber first, std::size_t count,
                                                  const World& world, const Time& now,
                                                  const PostContactState& post_contact_state,
                                                  const PhaseSettings& phase, const ForEach& for_each) {
  std::vector<DomainNumber> owners;
  owners.reserve(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot)
    owners.push_back(layout.partition().domain_at(world.position(slot, now)));
  std::vector<std::unique_ptr<Domain>> domains(count);
  for_each_or_throw(for_each, count, [&](std::size_t k) {
    domains[k] = std::make_unique<Domain>(world, owners, now, layout.partition(),
                                          static_cast<DomainNumber>(first + k), layout.halo(), phase);
    domains[k]->take_over(post_contact_state);
  });
  return domains;
}

// The sum of what each process has added up.
template <class Sum>
Sum sum_of_all(Processes& processes, const Sum& own) {
  if (processes.size() == 1) return own;
  Sum all;
  for (const std::string& bytes : processes.gather(archived(own))) {
    Sum part;
    restore(bytes, "the sum of a process", part);
    all.add(part);
  }
  return all;
}

}  // namespace

DomainsEngine::DomainsEngine(World world, const PhaseSettings& phase, const Division& division,
                             const Time& now, Processes& processes)
    : processes_(&processes),
      phase_(phase),
      holds_all_(true),
      world_(std::move(world)),
      team_(std::make_unique<ThreadTeam>(division.threads)),
      layout_(division, processes.size()) {
  divide(now);
}

DomainsEngine::DomainsEngine(World empty, SphereTransfers brought, const PhaseSettings& phase,
                             const Division& division, const Time& now, Processes& processes)
    : processes_(&processes),
      phase_(phase),
      holds_all_(false),
      world_(std::move(empty)),
      team_(std::make_unique<ThreadTeam>(division.threads)),
      layout_(division, processes.size()) {
  lay_out(brought, now);
  occupy(std::move(brought), now);
}

DomainsEngine::DomainsEngine(const DomainsEngine& other)
    : EngineBase(other),
      processes_(other.processes_),
      phase_(other.phase_),
      spheres_(other.spheres_),
      holds_all_(other.holds_all_),
      world_(other.world_),
      team_(std::make_unique<ThreadTeam>(other.team_->size())),
      layout_(other.layout_),
      group_(std::make_unique<DomainGroup>(*other.group_, team_->as_function())),
      counters_(other.counters_),
      windows_before_(other.windows_before_),
      post_contact_(other.post_contact_),
      needs_rebuild_(other.needs_rebuild_),
      looks_ahead_(other.looks_ahead_),
      before_look_ahead_(other.before_look_ahead_) {
  HARDBALL_CHECK(!other.is_open_);
  gathering_->is_done = other.gathering_->is_done.load();
}

void DomainsEngine::divide(const Time& now) {
  layout_.lay_out(world_.box(), SystemSize::of(world_, now), centers(now));
  occupy(world_, post_contact_, now);
}

std::vector<Vec3> DomainsEngine::centers(const Time& now) const {
  std::vector<Vec3> centers;
  centers.reserve(world_.size());
  for (Slot slot = 0; slot < world_.size(); ++slot) centers.push_back(world_.position(slot, now));
  return centers;
}

// Makes the domains of the layout that are in this process.
void DomainsEngine::occupy(const World& world, const PostContactState& post_contact_state, const Time& now) {
  const DomainsOfProcess domains = domains_of_process();
  const auto first = static_cast<DomainNumber>(processes_->rank() * domains.each);
  group_ = std::make_unique<DomainGroup>(make_domains(layout_, first, domains.each, world, now,
                                                      post_contact_state, phase_, team_->as_function()),
                                         now, layout_.windows(), team_->as_function(),
                                         Exchange(*processes_, domains));
  needs_rebuild_ = false;
  gathering_->is_done = holds_all_;
}

void DomainsEngine::lay_out(const SphereTransfers& brought, const Time& now) {
  const SystemSize size = size_of(brought, now);
  spheres_ = size.spheres;
  layout_.lay_out(world_.box(), size, sample_centers(brought, now));
}

void DomainsEngine::occupy(SphereTransfers brought, const Time& now) {
  const DomainsOfProcess domains = domains_of_process();
  World world = world_.without_spheres();
  PostContactState post_contact_state;
  const auto send_to_owner = [&](const SphereTransfer& transfer, const auto& send_to) {
    send_to(domains.process_of(partition().domain_at(position_of(transfer, now))));
  };
  insert(sent(std::move(brought), *processes_, send_to_owner), world, [&](const SphereTransfer& transfer) {
    post_contact_state.collapse.set_idle_contacts(transfer.state.id, transfer.idle_contacts);
  });
  insert(near_others(world, now), world, [](const SphereTransfer&) {});
  world.reorder(order_along_curve(world, now));
  occupy(world, post_contact_state, now);
}

Vec3 DomainsEngine::position_of(const SphereTransfer& transfer, const Time& now) const {
  Vec3 position = world_.motion().position_at(transfer.state.path, now);
  world_.box().fold(position);
  return position;
}

SystemSize DomainsEngine::size_of(const SphereTransfers& brought, const Time& now) const {
  const double growth = world_.motion().growth().largest_scale() * world_.room_to_grow();
  SystemSize own;
  brought.for_each([&](const SphereTransfer& transfer) {
    own.record(length(world_.motion().velocity_at(transfer.state.path, now)), growth * transfer.state.radius);
  });
  SystemSize all;
  for (const SystemSize& other : processes_->gather(own)) all.add(other);
  return all;
}

// Enough centers to divide the whole evenly.
std::vector<Vec3> DomainsEngine::sample_centers(const SphereTransfers& brought, const Time& now) const {
  constexpr std::uint64_t kSample = 1 << 18;
  const std::uint64_t every = spheres_ / kSample + 1;
  std::vector<Vec3> own;
  brought.for_each([&](const SphereTransfer& transfer) {
    if (transfer.state.id % every == 0) own.push_back(position_of(transfer, now));
  });
  std::vector<Vec3> centers;
  for (const std::string& part : processes_->gather(bytes_of(own))) append_bytes(part, centers);
  return centers;
}

// What others must know of these spheres here: copies of those near domains in other processes are exchanged.
SphereTransfers DomainsEngine::near_others(const World& own, const Time& now) const {
  const DomainsOfProcess domains = domains_of_process();
  std::vector<std::vector<DomainNumber>> neighbors;
  for (std::size_t k = 0; k < domains.each; ++k) {
    const auto number = static_cast<DomainNumber>(processes_->rank() * domains.each + k);
    neighbors.push_back(partition().neighbors(number, layout_.halo().neighborhood()));
  }
  std::vector<std::size_t> processes;
  const auto find_processes_near = [&](const Vec3& position) {
    processes.clear();
    for (const DomainNumber near : neighbors[partition().domain_at(position) % domains.each]) {
      const std::size_t process = domains.process_of(near);
      if (process == processes_->rank() || ranges::find(processes, process) != processes.end()) continue;
      if (partition().block(near).distance(position) <= layout_.halo().depth) processes.push_back(process);
    }
  };
  SphereTransfers wanted;
  for (Slot slot = 0; slot < own.size(); ++slot) {
    find_processes_near(own.position(slot, now));
    if (!processes.empty()) wanted.push_back({own.state_of(slot)});
  }
  return sent(std::move(wanted), *processes_, [&](const SphereTransfer& transfer, const auto& send_to) {
    find_processes_near(position_of(transfer, now));
    ranges::for_each(processes, send_to);
  });
}

World& DomainsEngine::mutable_world() {
  settle();
  outdate();
  return world_;
}

Counters DomainsEngine::counters() const {
  Counters own;
  for (std::size_t k = 0; k < group_->size(); ++k) own = own + group_->domain(k).engine().counters();
  Counters all;
  for (const Counters& each : processes_->gather(own)) all = all + each;
  all.collision = group_->counted().collision + open_counts_.collision;
  all.wall = group_->counted().wall + open_counts_.wall;
  return counters_ + all;
}

std::size_t DomainsEngine::memory_bytes() const {
  std::size_t own = world_.memory_bytes();
  for (std::size_t k = 0; k < group_->size(); ++k) own += group_->domain(k).memory_bytes();
  std::size_t all = 0;
  for (const std::size_t each : processes_->gather(own)) all += each;
  return all;
}

std::vector<Block> DomainsEngine::blocks() const {
  const std::span<const Block> blocks = partition().blocks();
  return {blocks.begin(), blocks.end()};
}

GasStatistics DomainsEngine::statistics(const Time& moment) const {
  if (needs_rebuild_) return gas_statistics(world_, moment);
  if (!fills_box(world_)) {
    GasStatistics statistics = gas_statistics(sample(), moment);
    statistics.spheres = size();
    return statistics;
  }
  std::vector<GasSums> parts(group_->size());
  group_->each([&](const Domain& domain, std::size_t k) {
    domain.for_each_own([&](Slot slot) { parts[k].record(domain.world(), slot, moment); });
  });
  GasSums own;
  for (const GasSums& part : parts) own.add(part);
  return gas_statistics(sum_of_all(*processes_, own), world_);
}

Totals DomainsEngine::totals(const Time& moment) const {
  if (is_alone()) return totals_of(world(), moment);
  Totals own;
  for_each_sphere([&](const World& world, Slot slot) { own.record(world, slot, moment); });
  return sum_of_all(*processes_, own);
}

Audit DomainsEngine::audit(const Time& moment) const {
  if (holds_all_) return hardball::audit(world(), moment);
  std::vector<Audit> found;
  for (std::size_t k = 0; k < group_->size(); ++k)
    found.push_back(hardball::audit(group_->domain(k).world(), moment));
  std::vector<Audit> all;
  for (const std::string& part : processes_->gather(bytes_of(found))) append_bytes(part, all);
  Audit worst;
  for (const Audit& each : all) {
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

const Event& DomainsEngine::last_passage() const {
  return needs_rebuild_ || is_open_ ? world_.last_passage() : group_->domain(0).world().last_passage();
}

bool DomainsEngine::has_spins() const {
  bool has_spins = world_.has_spins();
  for (std::size_t k = 0; k < group_->size(); ++k) has_spins |= group_->domain(k).world().has_spins();
  return has_spins;
}

void DomainsEngine::for_each_sphere(const Function<void(const World&, Slot)>& visit) const {
  if (needs_rebuild_ || is_open_) {
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      if (world_.id(slot) % processes_->size() == processes_->rank()) visit(world_, slot);
    }
    return;
  }
  for (std::size_t k = 0; k < group_->size(); ++k) {
    const Domain& domain = group_->domain(k);
    domain.for_each_own([&](Slot slot) { visit(domain.world(), slot); });
  }
}

std::vector<SphereSearch::Part> DomainsEngine::search_parts(const Time& moment) const {
  std::vector<SphereSearch::Part> parts;
  if (needs_rebuild_ || is_open_ || !is_alone()) return parts;
  for (std::size_t k = 0; k < group_->size(); ++k) {
    const Domain& domain = group_->domain(k);
    if (domain.engine().search_parts(moment).empty()) return {};
    parts.push_back({&domain.world(), &domain.engine().phase(),
                     [&domain](Slot slot) { return domain.ownership().is_own(slot); }});
  }
  return parts;
}

const World& DomainsEngine::sample() const {
  if (holds_all_) return world();
  const SphereTransfers own = own_transfers();
  sample_ = sample_of(*processes_, world_, own, size());
  return sample_;
}

void DomainsEngine::for_each(std::size_t count, const Function<void(std::size_t)>& work) {
  const ThreadTeam::Pinned pinned(*team_);
  team_->for_each(count, work);
}

RunStatus DomainsEngine::run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) {
  const ThreadTeam::Pinned pinned(*team_);
  keep_for_rewind();
  if (observer.needs_world()) return run_windows(limits, sums, observer);
  group_->clear_sums(sums);
  try {
    const RunStatus status = run_windows(limits, sums, observer);
    add_sums_to(sums);
    return status;
  } catch (...) {
    if (group_) add_sums_to(sums);  // otherwise it has failed to divide the system anew
    throw;
  }
}

std::optional<Event> DomainsEngine::next_contact(const Time& until) {
  const ThreadTeam::Pinned pinned(*team_);
  if (!std::isfinite(until.high) && !group_->has_events()) return std::nullopt;
  const Event next = group_->next_contact(within_range(until).high);
  return next.happens() ? std::optional(next) : std::nullopt;
}

void DomainsEngine::change_velocities(const Time& moment, std::span<const NewVelocity> changes) {
  settle();
  gather();
  keep_for_rewind();
  for (const NewVelocity& change : changes) world_.change_velocity(change.slot, moment, change.after);
  if (needs_rebuild_) return;
  group_->each([&](Domain& domain, std::size_t) {
    for (const NewVelocity& change : changes)
      domain.change_velocity(world_.id(change.slot), change.after, moment);
  });
}

void DomainsEngine::put(const Time& moment, std::span<const NewPlace> places) {
  settle();
  gather();
  keep_for_rewind();
  for (const NewPlace& place : places) world_.put(place.slot, moment, place.position, place.after);
  if (needs_rebuild_) return;
  group_->each([&](Domain& domain, std::size_t) {
    for (const NewPlace& place : places) domain.put(place, moment);
  });
}

SphereId DomainsEngine::add(const Sphere& sphere, const Time& moment) {
  settle();
  gather();
  const SphereId id = world_.add(sphere, moment);
  const auto slot = static_cast<Slot>(world_.size() - 1);
  try {
    require_room(world_, slot, all_slots(world_), moment);
  } catch (const Error&) {
    world_.undo_add();
    throw;
  }
  if (2 * sphere.radius > layout_.halo().contact) outdate();
  if (needs_rebuild_) return id;
  const SphereState state = world_.state_of(slot);
  const DomainNumber owner = partition().domain_at(state.path.position);
  group_->each([&](Domain& domain, std::size_t) {
    domain.add(state, owner, moment);
    domain.make_ready();
  });
  return id;
}

void DomainsEngine::remove(SphereId id, const Time& moment) {
  settle();
  gather();
  world_.remove(id, moment);
  if (needs_rebuild_) return;
  group_->each([&](Domain& domain, std::size_t) { domain.remove(id, moment); });
}

void DomainsEngine::rebuild(const Time& now, const PhaseSettings& settings) {
  phase_ = settings;
  if (holds_all_) {
    end_division();
    put_in_order(world_, now);
    return divide(now);
  }
  SphereTransfers own = own_transfers();
  end_division();
  lay_out(own, now);
  occupy(std::move(own), now);
}

void DomainsEngine::begin_journal(const Time& moment) {
  HARDBALL_CHECK(needs_rebuild_ || moment >= now());
  looks_ahead_ = true;
  before_look_ahead_.reset();
}

void DomainsEngine::end_journal() {
  looks_ahead_ = false;
  before_look_ahead_.reset();
}

// Since then, nothing but crossings has happened.
void DomainsEngine::rewind(const Time& moment) {
  if (!needs_rebuild_ && now() > moment) outdate();
}

void DomainsEngine::rewind_to_begin() {
  outdate();
  if (!before_look_ahead_) return;
  world_ = before_look_ahead_->world;
  post_contact_ = before_look_ahead_->post_contact_state;
  const Counters done = counters() - before_look_ahead_->counters;
  counters_.collision -= done.collision;
  counters_.wall -= done.wall;
}

PostContactState DomainsEngine::post_contact_state() const {
  if (needs_rebuild_) return post_contact_;
  PostContactState all;
  for (const std::string& part : processes_->gather(archived(own_counts()))) {
    CollapseGuard of_process;
    restore(part, "the counts of a process", of_process);
    all.collapse.take_over(of_process);
  }
  return all;
}

void DomainsEngine::take_over(const PostContactState& post_contact_state) {
  for (std::size_t k = 0; k < group_->size(); ++k) group_->domain(k).take_over(post_contact_state);
}

void DomainsEngine::validate() const {
  if (needs_rebuild_) return;
  for (std::size_t k = 0; k < group_->size(); ++k) {
    group_->domain(k).engine().validate();
    if (!is_open_) group_->domain(k).validate();
  }
}

SphereTransfers DomainsEngine::own_transfers() const {
  const CollapseGuard counts = own_counts();
  SphereTransfers own;
  for_each_sphere([&](const World& world, Slot slot) {
    own.push_back({world.state_of(slot), counts.idle_contacts(world.id(slot))});
  });
  return own;
}

// Of the spheres of this process.
CollapseGuard DomainsEngine::own_counts() const {
  if (needs_rebuild_) return post_contact_.collapse;
  CollapseGuard own;
  for (std::size_t k = 0; k < group_->size(); ++k) own.take_over(group_->domain(k).engine().collapse_guard());
  return own;
}

// From here on the world is the truth, until everything is rebuilt.
void DomainsEngine::outdate() {
  if (needs_rebuild_) return;
  gather();
  post_contact_ = post_contact_state();
  needs_rebuild_ = true;
}

// Keeps what the domains have been doing, as others follow.
void DomainsEngine::end_division() {
  if (holds_all_) outdate();
  const Counters work = counters();
  windows_before_ = windows();
  counters_ = work;
  ++counters_.rebuilds;
  if (holds_all_) return;
  world_.note_passage(group_->domain(0).world().last_passage());
  group_.reset();  // so that there is memory for others
}

// What is there before anything happens in a look ahead.
void DomainsEngine::keep_for_rewind() {
  if (looks_ahead_ && !before_look_ahead_)
    before_look_ahead_ = LookAhead{world(), post_contact_state(), counters()};
}

// Brings the world up to date; several const queries may need it at once.
void DomainsEngine::gather() const {
  if (is_telling_)
    throw Error("contacts are logged when later ones have happened", "observe", "use on_contact");
  if (gathering_->is_done.load(std::memory_order_acquire) || is_open_ || needs_rebuild_) return;
  const std::scoped_lock lock(gathering_->mutex);
  if (gathering_->is_done) return;
  const Time now = group_->now();
  if (!holds_all_) {
    gather_all();
  } else if (is_alone()) {
    gather_changed_here(now);
  } else {
    std::vector<SphereState> changed;
    take_changed([&](const World& world, Slot slot) { changed.push_back(world.state_of(slot)); });
    for (const std::string& part : processes_->gather(bytes_of(changed))) {
      std::vector<SphereState> of_process;
      append_bytes(part, of_process);
      gather_changed_elsewhere(of_process, now);
    }
  }
  world_.note_passage(group_->domain(0).world().last_passage());
  gathering_->is_done = true;
}

void DomainsEngine::gather_changed_here(const Time& now) const {
  bool have_spun = false;
  const auto bring = [&](Domain& domain, std::size_t) {
    // Spheres that follow one another there mostly do here, too.
    Slot ahead = 0;  // how much farther on the last one is here
    domain.take_changed([&](Slot from) {
      const std::optional<Slot> slot = world_.find(domain.world().id(from), from + ahead);
      HARDBALL_CHECK(slot);
      SphereEdit(world_, now, *slot).store_motion(*slot, domain.world(), from);
      ahead = *slot - from;
    });
  };
  for (std::size_t k = 0; k < group_->size(); ++k) have_spun |= group_->domain(k).world().has_spins();
  if (have_spun && !world_.has_spins()) {
    for (std::size_t k = 0; k < group_->size(); ++k) bring(group_->domain(k), k);
  } else {
    group_->each(bring);
  }
}

void DomainsEngine::gather_changed_elsewhere(const std::vector<SphereState>& changed, const Time& now) const {
  for (const SphereState& state : changed) {
    const Slot slot = world_.slot_of(state.id);
    SphereEdit(world_, now, slot).store(slot, state);
  }
}

// In the order of ids, so that worlds are the same in all processes.
void DomainsEngine::gather_all() const {
  SphereTransfers all = sent(own_transfers(), *processes_, [&](const SphereTransfer&, const auto& send_to) {
    for (std::size_t rank = 0; rank < processes_->size(); ++rank) send_to(rank);
  });
  std::vector<SphereState> states;
  states.reserve(all.size());
  while (!all.empty()) {
    for (const SphereTransfer& transfer : all.take_some()) states.push_back(transfer.state);
  }
  ranges::sort(states, {}, &SphereState::id);
  world_.insert_all(states.size(), [&](std::size_t k) { return states[k]; });
  holds_all_ = true;
  take_changed([](const World&, Slot) {});
}

// Calls visit(world, slot) for each sphere of this process that has changed since the last call.
template <class Visit>
void DomainsEngine::take_changed(Visit&& visit) const {
  for (std::size_t k = 0; k < group_->size(); ++k) {
    Domain& domain = group_->domain(k);
    domain.take_changed([&](Slot slot) { visit(domain.world(), slot); });
  }
}

// Adds what the domains of all processes have added up.
void DomainsEngine::add_sums_to(ContactSums& sums) const {
  if (is_alone()) return group_->add_sums_to(sums);
  ContactSums own = sums.part();
  group_->add_sums_to(own);
  for (const std::string& part : processes_->gather(archived(own.hash, own.tally))) {
    ContactSums of_process;
    restore(part, "the sums of a process", of_process.hash, of_process.tally);
    sums.add(of_process);
  }
}

RunStatus DomainsEngine::run_windows(const RunLimits& limits, ContactSums& sums,
                                     const ContactObserver& observer) {
  std::uint64_t contacts = limits.contacts;
  std::uint64_t steps = limits.steps;
  while (contacts > 0) {
    if (needs_rebuild_) return RunStatus::outdated;
    if (steps == 0) return RunStatus::steps_reached;
    const bool has_end = std::isfinite(limits.until.high);
    if (!has_end && !group_->has_events()) return RunStatus::time_reached;
    const double end = within_range(limits.until).high;
    const std::uint64_t contacts_before = group_->counted().contacts();
    const std::uint64_t steps_before = steps_so_far();
    const bool continues = run_window(end, contacts, sums, observer);
    contacts -= group_->counted().contacts() - contacts_before;
    steps -= std::min(steps, steps_so_far() - steps_before + 1);
    if (!continues) return RunStatus::observer_stopped;
    if (!needs_rebuild_ && group_->committed() == end && group_->is_complete())
      return RunStatus::time_reached;
    if (!needs_rebuild_) review_division(sums, !observer.needs_world());
  }
  return RunStatus::contacts_reached;
}

// Those that all processes know of without messages.
std::uint64_t DomainsEngine::steps_so_far() const {
  std::uint64_t steps = group_->counted().contacts();
  if (!is_alone()) return steps;
  for (std::size_t k = 0; k < group_->size(); ++k) {
    const Counters counters = group_->domain(k).engine().counters();
    steps += counters.enter + counters.stale;
  }
  return steps;
}

// Runs through one window; false if the observer has stopped the run.
bool DomainsEngine::run_window(double end, std::uint64_t most, ContactSums& sums,
                               const ContactObserver& observer) {
  if (observer.needs_world()) {
    gather();
    group_->open_window(end, most, {.log = true, .sums = false});
    return deliver(sums, observer);
  }
  group_->open_window(end, most, {.log = static_cast<bool>(observer)});
  const std::exception_ptr failure = observer ? tell(observer) : nullptr;
  group_->commit_window();
  gathering_->is_done = false;
  if (failure) std::rethrow_exception(failure);
  return true;
}

// Calls the observer with the contacts of the open window, without the world. Returns what it has thrown.
std::exception_ptr DomainsEngine::tell(const ContactObserver& observer) {
  std::exception_ptr failure;
  MergedLog log = group_->merged_log();
  is_telling_ = true;
  try {
    while (const Contact* contact = log.next()) observer.on_contact(*contact);
  } catch (...) {
    failure = std::current_exception();
  }
  is_telling_ = false;
  return failure;
}

// Calls the observer with the contacts of the open window, and with the world as it is after each.
bool DomainsEngine::deliver(ContactSums& sums, const ContactObserver& observer) {
  MergedLog log = group_->merged_log();
  is_open_ = true;
  taken_ = 0;
  while (const Contact* logged = log.next()) {
    const Contact contact = *logged;  // the log is discarded if the window is cut
    apply(contact);
    sums.record(contact);
    bool continues = false;
    try {
      continues = observer.on_contact(contact);
    } catch (...) {
      settle();
      throw;
    }
    if (!continues) settle();
    if (!is_open_) return continues;
  }
  HARDBALL_CHECK(open_counts_.contacts() == group_->open_contacts());
  close();
  group_->commit_window();
  return true;
}

// Lets a contact of the open window happen in the world.
void DomainsEngine::apply(const Contact& contact) {
  now_ = contact.time;
  ++taken_;
  ++(contact.is_collision() ? open_counts_.collision : open_counts_.wall);
  follow(world_, contact);
}

// Takes of the open window only what has been delivered.
void DomainsEngine::settle() {
  if (!is_open_) return;
  close();
  group_->cut_window(taken_);
}

void DomainsEngine::close() {
  is_open_ = false;
  open_counts_ = {};
}

// Divides the system anew if that pays. The domains may have added up contacts.
void DomainsEngine::review_division(ContactSums& sums, bool have_sums) {
  if (!layout_.is_review_due(group_->window_counters().windows)) return;
  const Load load = group_->load();
  if (!layout_.may_improve(load, size())) return;
  const Time now = group_->now();
  const auto divide_anew = [&](auto&& occupy_it) {
    if (have_sums) add_sums_to(sums);
    end_division();
    occupy_it();
    if (have_sums) group_->clear_sums(sums);
  };
  if (holds_all_) {
    gather();
    if (layout_.improve(load, world_.box(), SystemSize::of(world_, now), centers(now)))
      divide_anew([&] { occupy(world_, post_contact_, now); });
    return;
  }
  SphereTransfers own = own_transfers();
  if (layout_.improve(load, world_.box(), size_of(own, now), sample_centers(own, now)))
    divide_anew([&] { occupy(std::move(own), now); });
}

}  // namespace hardball
