// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include <algorithm>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/processes/bytes.hpp"
#include "hardball/run/engine_manager.hpp"
#include "hardball/run/run_schedule.hpp"
#include "hardball/simulation/user_data.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {
namespace {

// Progress of the set-up after its stages [1].
constexpr double kOrdered = 0.2;
constexpr double kAudited = 0.5;

// Contacts before the start do not count.
void begin_paths(World& world, const Time& moment) {
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Path& path = world.path(slot);
    if (path.time < moment) world.rewrite_path(slot, moment, world.velocity(slot, moment));
  }
}

std::vector<Vec3> centers_at(const World& world, const Time& moment) {
  std::vector<Vec3> centers;
  centers.reserve(world.size());
  world.for_each_by_id([&](Slot slot) { centers.push_back(world.position(slot, moment)); });
  return centers;
}

}  // namespace

Simulation::Simulation(World world, const EngineOptions& options, const OnProgress& on_progress)
    : Simulation(std::move(world), options, one_process(), on_progress) {}

Simulation::Simulation(World world, const EngineOptions& options, Processes& processes,
                       const OnProgress& on_progress)
    : manager_(ValuePointer<EngineManager>::make(options, processes)),
      now_(latest_change(world)),
      user_data_(ValuePointer<UserData>::make()) {
  check_features(options, processes, world.features());
  const Progress progress(on_progress);
  progress.record(0, 1);
  begin_paths(world, now_);
  assign_levels(world, now_);
  manager_->prepare(world, now_);
  require_no_overlap(world, now_, progress.part(kOrdered, kAudited));  // faster in order
  manager_->start(std::move(world), now_, progress.part(kAudited, 1));
  sums_.tally.begin(this->world(), now_);
  progress.note_end();
}

Simulation Simulation::from_parts(World part, const EngineOptions& options, Processes& processes) {
  if (processes.size() == 1) return Simulation(std::move(part), options);
  check_features(options, processes, part.features());
  Simulation simulation;
  simulation.manager_ = ValuePointer<EngineManager>::make(options, processes);
  simulation.start_parts(std::move(part), std::nullopt, {});
  require_sound(simulation.audit(), simulation.now_);
  simulation.sums_.tally.begin(simulation.setting(), simulation.totals(), simulation.now_);
  return simulation;
}

// Starts at a moment, or when the last sphere was added.
void Simulation::start_parts(World part, const std::optional<Time>& moment, const CollapseGuard& counts) {
  now_ = moment.value_or(latest_change(part));
  if (!moment) {
    for (const Time& other : manager_->processes().gather(now_)) now_ = later(now_, other);
    begin_paths(part, now_);
  }
  SphereTransfers brought;
  for (Slot slot = 0; slot < part.size(); ++slot)
    brought.push_back({part.state_of(slot), counts.idle_contacts(part.id(slot))});
  manager_->start(part.without_spheres(), std::move(brought), now_);
}

Simulation::Simulation() : user_data_(ValuePointer<UserData>::make()) {}
Simulation::Simulation(const Simulation&) = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(const Simulation&) = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

Time Simulation::latest_change(const World& world) {
  Time latest(0);
  for (const Path& path : world.paths()) latest = later(latest, path.time);
  return latest;
}

void Simulation::on_contact(Function<void(const Contact&)> listener) {
  next_listener_ = std::move(listener);
  if (!activity_.is_listening()) take_next_listener();
}

void Simulation::observe(Observer observer) {
  check_editable("observe");
  observer_ = std::move(observer);
}

void Simulation::take_next_listener() {
  if (!next_listener_) return;
  listener_ = std::move(*next_listener_);
  next_listener_.reset();
}

std::uint64_t Simulation::run_contacts(std::uint64_t count, double until) {
  const std::uint64_t before = counters().contacts();
  run({.until = Time(until), .contacts = count});
  return counters().contacts() - before;
}

RunStatus Simulation::run(const RunLimits& limits, Measures& measures) {
  check_idle("run");
  // Without measures, the world is not needed.
  if (!measures.is_any_wanted()) return run_with(limits, nullptr);
  measures.check_spheres(world());
  if (growth() || setting().motion().has_growth())
    check_exclusions(Feature::measures, Feature::growth, "measures");
  return run_with(limits, &measures);
}

// With measures, if there are any.
RunStatus Simulation::run_with(const RunLimits& limits, Measures* measures) {
  check_idle("run");
  check_not_past(limits.until);
  check_driven();
  moving_.reset();
  const Activity::During running(activity_, Activity::Kind::running);
  const ContactObserver listening{.on_contact = [this, measures](const Contact& contact) {
    on_every_contact(contact, measures);
    return !is_rescheduled_;
  }};
  const ContactObserver logging{.on_contact =
                                    [this, measures](const Contact& contact) {
                                      log(contact, measures);
                                      return true;
                                    },
                                .looks_around = false};
  RunSchedule schedule(limits, now_);
  manager_->begin_run();
  do {
    is_rescheduled_ = false;
    manager_->engine().end_journal();
    manager_->make_ready(now_);
    const Time sample = measures ? measures->next_sample() : kNever;
    const bool listens = listener_ || next_listener_ || setting().interactions().may_merge();
    const bool logs = observer_.contact || (measures && measures->has_begun());
    RunSchedule::Item item = RunSchedule::Item::nothing;
    try {
      item = schedule.advance(*manager_, actors_.next().next(), sample,
                              actors_.contacts_left(sums_.tally, size()), sums_,
                              listens ? listening
                              : logs  ? logging
                                      : ContactObserver());
    } catch (...) {
      now_ = later(now_, sums_.tally.last_change());
      throw;
    }
    now_ = later(later(now_, sums_.tally.last_change()), schedule.reached());
    // Not `now_`, which after a limited number of steps may depend on the engine.
    const Time moment = later(schedule.reached(), sums_.tally.last_change());
    actors_.for_each([&](Actor& actor) { actor.note_contacts(sums_.tally, size(), moment); });
    if (item == RunSchedule::Item::action) schedule.spend(act(moment, measures));
    if (item == RunSchedule::Item::sample) {
      measures->sample(world(), moment, [this](std::size_t count, const Function<void(std::size_t)>& work) {
        manager_->engine().for_each(count, work);
      });
      schedule.spend(1);
    }
    manager_->review_if_due(now_);
  } while (!schedule.is_over());
  return schedule.status();
}

// To be called with every contact when it has been carried out.
void Simulation::on_every_contact(const Contact& contact, Measures* measures) {
  now_ = contact.time;
  if (contact.outcome == ContactOutcome::merge) [[unlikely]]
    note_merger(contact, measures);
  log(contact, measures);
  if (listener_ || next_listener_)
    call_listener(contact, measures ? Activity::Kind::measuring : Activity::Kind::listening);
}

// To be called with every contact, in order, perhaps when others have been carried out.
void Simulation::log(const Contact& contact, Measures* measures) {
  if (measures) measures->record(contact);
  if (observer_.contact) observer_.contact(contact);
}

void Simulation::note_merger(const Contact& contact, const Measures* measures) {
  note_removed(contact.second);
  if (measures && measures->is_any_wanted()) {
    check_exclusions(Feature::measures, Feature::merging,
                     "spheres " + to_text(contact.first) + " and " + to_text(contact.second));
  }
}

void Simulation::call_listener(const Contact& contact, Activity::Kind activity) {
  take_next_listener();
  if (!listener_) return;
  moving_.reset();
  const Activity::During listening(activity_, activity);
  listener_(contact);
}

// Lets an actor act, and returns how many velocities it has changed, at least one. Precondition: all contacts
// that round to that time or an earlier one have been handled, and `now_` is no earlier.
std::uint64_t Simulation::act(const Time& moment, Measures* measures) {
  Actor& actor = actors_.next();
  const Action action = actor.act(world(), sums_.tally, moment);
  if (action.epoch) {
    begin_epoch(action, actor, moment, measures);
    return size();
  }
  carry_out(action, moment);
  sums_.tally.note_edit(action.energy, moment);
  tell_of_changes(moment, action.changes, measures);
  tell_of_motion(action, moment);
  if (!action.surfaces.empty()) return size();
  return std::max<std::uint64_t>(1, action.changes.size() + action.places.size());
}

void Simulation::carry_out(const Action& action, const Time& moment) {
  EngineBase& engine = manager_->engine();
  // An event in the same double may have carried the engine on.
  engine.rewind(moment);
  if (action.surfaces.empty()) {
    engine.change_velocities(moment, action.changes);
    if (!action.places.empty()) engine.put(moment, action.places);
    return;
  }
  World& world = engine.mutable_world();
  for (const NewPlace& place : action.places) world.put(place.slot, moment, place.position, place.after);
  for (const auto& [number, surface] : action.surfaces) world.set_surface(number, surface);
  manager_->rebuild(moment);
}

void Simulation::tell_of_motion(const Action& action, const Time& moment) {
  moving_.reset();
  const Activity::During running(activity_, Activity::Kind::running);
  if (observer_.change) {
    for (const NewPlace& place : action.places) {
      // A rebuild may have moved it to another slot.
      const SphereId id = place.id;
      const Slot slot = world().slot_of(id);
      observer_.change(
          {moment, id, world().mass(slot), world().path(slot).position, place.before, place.after});
    }
  }
  if (observer_.surface) {
    for (const auto& [number, surface] : action.surfaces) observer_.surface(number, surface);
  }
}

void Simulation::begin_epoch(const Action& action, Actor& actor, const Time& moment, Measures* measures) {
  // An event in the same double may have carried the engine on.
  manager_->engine().rewind(moment);
  World& world = manager_->engine().mutable_world();
  if (!action.changes.empty()) {
    const double energy_before = kinetic_energy(world, moment);
    for (const NewVelocity& change : action.changes) world.rewrite_path(change.slot, moment, change.after);
    const double given = kinetic_energy(world, moment) - energy_before;
    sums_.tally.note_edit(given, moment);
    actor.note_energy(given);
  }
  world.set_growth(*action.epoch);
  tell_of_changes(moment, action.changes, measures);
  tell_of_epoch(*action.epoch);
  manager_->rebuild(moment);
}

void Simulation::tell_of_epoch(const Growth& epoch) {
  moving_.reset();
  if (!observer_.epoch) return;
  const Activity::During running(activity_, Activity::Kind::running);
  observer_.epoch(epoch);
}

// An actor may act later than it would have: a run up to its next action ends.
void Simulation::note_removed(SphereId id) {
  is_rescheduled_ |= actors_.note_removed(id);
  user_data_->remove(id);
}

void Simulation::tell_of_changes(const Time& moment, std::span<const NewVelocity> changes,
                                 Measures* measures) {
  moving_.reset();
  if (!measures && !observer_.change) return;
  for (const NewVelocity& change : changes) {
    const Slot slot = change.slot;
    const VelocityChange done{
        moment,        world().id(slot), world().mass(slot), world().path(slot).position,
        change.before, change.after};
    if (measures) measures->record(done);
    if (!observer_.change) continue;
    const Activity::During running(activity_, Activity::Kind::running);
    observer_.change(done);
  }
}

void Simulation::check_idle(const char* what) const {
  if (activity_.is_idle()) return;
  throw Error("the simulation is running", what, "call it when the run has ended, or run a copy");
}

void Simulation::check_editable(const char* what) const {
  if (activity_.kind() == Activity::Kind::running) {
    throw Error("responses and velocity listeners must not edit the simulation", what,
                "edit it from the listener, which is called after the contact");
  }
  if (activity_.kind() == Activity::Kind::measuring) {
    throw Error("the run takes measures, which do not allow edits", what,
                "run without measures, or edit the simulation when the run has ended");
  }
}

// How large spheres are to become is known from their volume.
void Simulation::check_not_growing(const char* what) const {
  if (!growth() || growth()->is_over()) return;
  check_exclusions(Feature::births, Feature::growth, what);
}

// Looks at all spheres only where it may matter, and once.
void Simulation::check_driven() {
  if (are_driven_ || setting().motion().is_straight()) return;
  bool are_driven = true;
  for_each_sphere([&](const World& world, Slot slot) {
    if (world.is_kinematic(slot) && !actors_.motions.schedule.drives(world.id(slot))) are_driven = false;
  });
  if (ranges::min(processes().gather(are_driven ? 1 : 0)) == 0)
    check_exclusions(Feature::undriven, Feature::gravity, "spheres");
  are_driven_ = true;
}

void Simulation::check_not_past(const Time& time) const {
  if (!(time.value() >= now_.value())) {
    throw Error(to_text(time.value()) + " is in the past; the time is " + to_text(now_.value()), "until",
                "give a later time");
  }
  if (time < kNever) check_moment(time, "until");
}

Vec3 Simulation::position(SphereId id) const {
  return world().position(world().slot_of(id), now_);
}

Vec3 Simulation::velocity(SphereId id) const {
  return world().velocity(world().slot_of(id), now_);
}

std::vector<Vec3> Simulation::positions() const {
  return centers_at(world(), now_);
}

std::vector<Vec3> Simulation::positions_at(double time) {
  check_moment(Time(time), "positions_at");
  const Actor& actor = actors_.next();
  if (actor.next().value() < time) {
    throw Error(std::string(actor.deed()) + " at " + to_text(actor.next().value()) +
                    ", before the requested time, " + to_text(time),
                "positions_at", "run_until that time first");
  }
  const std::optional<NextContact> next = next_contact(time);
  if (next && next->time < time) {
    throw Error(
        "there is a contact at " + to_text(next->time) + ", before the requested time, " + to_text(time),
        "positions_at", "run_until that contact first");
  }
  return centers_at(world(), Time(time));
}

SphereHandle Simulation::sphere(SphereId id) {
  static_cast<void>(world().slot_of(id));
  return {*this, id};
}

std::uint64_t Simulation::user_data(SphereId id) const {
  static_cast<void>(world().slot_of(id));
  return user_data_->get(id);
}

void Simulation::set_user_data(SphereId id, std::uint64_t data) {
  static_cast<void>(world().slot_of(id));
  user_data_->set(id, data);
}

const World& Simulation::world() const {
  return manager_->engine().world();
}

const World& Simulation::setting() const {
  return manager_->engine().setting();
}

std::size_t Simulation::size() const {
  return manager_->engine().size();
}

Totals Simulation::totals() const {
  return manager_->engine().totals(now_);
}

Audit Simulation::audit() const {
  return manager_->engine().audit(now_);
}

void Simulation::for_each_sphere(const Function<void(const World&, Slot)>& visit) const {
  manager_->engine().for_each_sphere(visit);
}

std::vector<std::size_t> Simulation::species_counts() const {
  std::vector<std::size_t> own;
  for_each_sphere([&](const World& world, Slot slot) {
    const std::size_t species = world.species(slot);
    if (species >= own.size()) own.resize(species + 1);
    ++own[species];
  });
  std::vector<std::size_t> all;
  for (const std::string& part : processes().gather(bytes_of(own))) {
    std::vector<std::size_t> counts;
    append_bytes(part, counts);
    all.resize(std::max(all.size(), counts.size()));
    for (std::size_t k = 0; k < counts.size(); ++k) all[k] += counts[k];
  }
  return all;
}

bool Simulation::has_spins() const {
  const bool has_spins = manager_->engine().has_spins();
  return ranges::max(processes().gather(has_spins ? 1 : 0)) == 1;
}

Extent Simulation::extent() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Extent nothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const auto widen = [](Extent& extent, const Extent& other) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      extent.low[axis] = std::min(extent.low[axis], other.low[axis]);
      extent.high[axis] = std::max(extent.high[axis], other.high[axis]);
    }
  };
  Extent own = nothing;
  for_each_sphere([&](const World& world, Slot slot) {
    const Vec3 position = world.position(slot, now_);
    const double of_sphere = world.radius(slot, now_);
    const Vec3 radius{of_sphere, of_sphere, of_sphere};
    widen(own, {position - radius, position + radius});
  });
  Extent all = nothing;
  for (const Extent& other : processes().gather(own)) widen(all, other);
  return size() > 0 ? all : Extent{{0, 0, 0}, {1, 1, 1}};
}

Processes& Simulation::processes() const {
  return manager_->processes();
}

Counters Simulation::counters() const {
  return manager_->counters();
}

void Simulation::set_threads(std::size_t threads) {
  check_idle("set_threads");
  EngineOptions changed = options();
  changed.threads = threads;
  check_features(changed, processes(), setting().features());
  manager_->set_threads(threads, now_);
  moving_.reset();
}

const EngineOptions& Simulation::options() const {
  return manager_->options();
}

std::vector<Block> Simulation::blocks() const {
  return manager_->engine().blocks();
}

WindowCounters Simulation::windows() const {
  return manager_->windows();
}

EngineKind Simulation::engine() const {
  return manager_->kind();
}

Vec3 Simulation::cell_edges() const {
  return manager_->engine().lengths().cell_edges;
}

double Simulation::cell_edge() const {
  const Vec3 edges = cell_edges();
  return (edges.x + edges.y + edges.z) / 3;
}

double Simulation::skin() const {
  return manager_->engine().lengths().skin;
}

std::size_t Simulation::memory_bytes() const {
  return manager_->engine().memory_bytes();
}

void Simulation::validate() const {
  manager_->engine().validate();
}

}  // namespace hardball
