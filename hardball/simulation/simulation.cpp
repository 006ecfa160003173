// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include <algorithm>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/simulation/agenda.hpp"
#include "hardball/simulation/tuner.hpp"
#include "hardball/simulation/user_data.hpp"
#include "hardball/world/audit.hpp"

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
    : tuner_(ValuePointer<Tuner>::make(options)),
      now_(latest_change(world)),
      user_data_(ValuePointer<UserData>::make()) {
  check_threads(options, world.box(), world.interactions());
  const Progress progress(on_progress);
  progress.note(0, 1);
  begin_paths(world, now_);
  world.assign_levels(now_);
  tuner_->prepare(world, now_);
  require_no_overlap(world, now_, progress.part(kOrdered, kAudited));  // faster in order
  tuner_->start(std::move(world), now_, progress.part(kAudited, 1));
  sums_.tally.begin(this->world(), now_);
  progress.note_end();
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

void Simulation::log_contacts(Function<void(const Contact&)> log) {
  check_editable("log_contacts");
  log_ = std::move(log);
}

void Simulation::take_next_listener() {
  if (!next_listener_) return;
  listener_ = std::move(*next_listener_);
  next_listener_.reset();
}

void Simulation::on_velocity_change(Function<void(const VelocityChange&)> listener) {
  check_editable("on_velocity_change");
  change_listener_ = std::move(listener);
}

void Simulation::on_epoch(Function<void(const Growth&)> listener) {
  check_editable("on_epoch");
  epoch_listener_ = std::move(listener);
}

std::uint64_t Simulation::run_contacts(std::uint64_t count, double until) {
  const std::uint64_t before = counters().contacts();
  run({.until = Time(until), .contacts = count});
  return counters().contacts() - before;
}

RunStatus Simulation::run(const RunLimits& limits, Measures& measures) {
  check_idle("run");
  measures.check_spheres(world());
  if ((growth_ || world().motion().has_growth()) && measures.is_any_wanted()) {
    throw Error("spheres grow, and measures need constant sizes", "measures",
                "run without measures until growth has been stopped");
  }
  return run_with(limits, &measures);
}

// With measures, if there are any.
RunStatus Simulation::run_with(const RunLimits& limits, Measures* measures) {
  check_idle("run");
  check_not_past(limits.until);
  const Activity::During running(activity_, Activity::Kind::running);
  const ContactObserver listening{.note = [this, measures](const Contact& contact) {
    note(contact, measures);
    return !is_rescheduled_;
  }};
  const ContactObserver logging{.note =
                                    [this, measures](const Contact& contact) {
                                      log(contact, measures);
                                      return true;
                                    },
                                .looks_around = false};
  Agenda agenda(limits, now_);
  do {
    is_rescheduled_ = false;
    tuner_->engine().end_journal();
    tuner_->make_ready(now_);
    const Time sample = measures ? measures->next_sample() : kNever;
    const bool listens = listener_ || next_listener_ || tuner_->engine().interactions().may_merge();
    const bool logs = log_ || (measures && measures->has_begun());
    Agenda::Item item = Agenda::Item::nothing;
    try {
      item = agenda.advance(*tuner_, next_action(), sample, contacts_of_epoch(), sums_,
                            listens ? listening
                            : logs  ? logging
                                    : ContactObserver());
    } catch (...) {
      now_ = later(now_, sums_.tally.last_change());
      throw;
    }
    now_ = later(later(now_, sums_.tally.last_change()), agenda.reached());
    // Not `now_`, which after a limited number of steps may depend on the engine.
    const Time moment = later(agenda.reached(), sums_.tally.last_change());
    if (growth_ && growth_->contacts_left(sums_.tally, size()) == 0) growth_->end_by(moment);
    if (item == Agenda::Item::action) agenda.spend(act(moment, measures));
    if (item == Agenda::Item::sample) {
      measures->sample(world(), moment, [this](std::size_t count, const Function<void(std::size_t)>& work) {
        tuner_->engine().for_each(count, work);
      });
      agenda.spend(1);
    }
    tuner_->review_if_due(now_);
  } while (!agenda.is_over());
  return agenda.status();
}

// To be called with every contact when it has been carried out.
void Simulation::note(const Contact& contact, Measures* measures) {
  now_ = contact.time;
  if (contact.outcome == ContactOutcome::merge) [[unlikely]]
    note_merger(contact, measures);
  log(contact, measures);
  if (listener_ || next_listener_)
    call_listener(contact, measures ? Activity::Kind::measuring : Activity::Kind::listening);
}

// To be called with every contact, in order, perhaps when others have been carried out.
void Simulation::log(const Contact& contact, Measures* measures) {
  if (measures) measures->note(contact);
  if (log_) log_(contact);
}

void Simulation::note_merger(const Contact& contact, const Measures* measures) {
  forget_at_thermostat(contact.second);
  user_data_->remove(contact.second);
  if (measures && measures->is_any_wanted()) {
    throw Error("spheres " + to_text(contact.first) + " and " + to_text(contact.second) +
                    " have merged, and measures need all spheres",
                "measures", "run without measures");
  }
}

void Simulation::call_listener(const Contact& contact, Activity::Kind activity) {
  take_next_listener();
  if (!listener_) return;
  const Activity::During listening(activity_, activity);
  listener_(contact);
}

// When the thermostat acts next, or an epoch of growth begins; kNever without either.
Time Simulation::next_action() const {
  const Time epoch = growth_ ? Time(growth_->next()) : kNever;
  return thermostat_ ? earlier(epoch, Time(thermostat_->next())) : epoch;
}

// Whether the next action is a new epoch: at the same time it comes before the thermostat.
bool Simulation::grows_next() const {
  return growth_ && (!thermostat_ || growth_->next() <= thermostat_->next());
}

// After how many contacts an epoch of growth is too long; at its end, which it has then, all may happen.
std::uint64_t Simulation::contacts_of_epoch() const {
  constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t left = growth_ ? growth_->contacts_left(sums_.tally, size()) : kAny;
  return left > 0 ? left : kAny;
}

void Simulation::begin_epoch(const GrowthEpoch& epoch, const Time& moment, Measures* measures) {
  // An event in the same double may have carried the engine on.
  tuner_->engine().rewind(moment);
  World& world = tuner_->engine().world_to_edit();
  std::vector<NewVelocity> changes;
  if (epoch.speed_factor != 1) {
    const double energy_before = world.kinetic_energy(moment);
    world.for_each_by_id([&](Slot slot) {
      const Vec3 velocity = world.velocity(slot, moment);
      changes.push_back({slot, velocity, epoch.speed_factor * velocity});
    });
    for (const NewVelocity& change : changes) world.rewrite_path(change.slot, moment, change.after);
    const double given = world.kinetic_energy(moment) - energy_before;
    sums_.tally.note_edit(given, moment);
    growth_->note_energy(given);
  }
  world.set_growth(epoch.growth);
  tell_of_changes(moment, changes, measures);
  tell_of_epoch(epoch.growth);
  tuner_->rebuild(moment);
}

void Simulation::tell_of_epoch(const Growth& epoch) {
  if (!epoch_listener_) return;
  const Activity::During running(activity_, Activity::Kind::running);
  epoch_listener_(epoch);
}

// Lets the thermostat act, and returns how many velocities it has changed, at least one. Precondition: all
// contacts that round to that time or an earlier one have been handled, and `now_` is no earlier.
std::uint64_t Simulation::act(const Time& moment, Measures* measures) {
  if (grows_next()) {
    begin_epoch(growth_->act(world(), sums_.tally, moment), moment, measures);
    return world().size();
  }
  const double energy_before = thermostat_->energy();
  const std::span<const NewVelocity> changes = let_thermostat_act(moment);
  sums_.tally.note_edit(thermostat_->energy() - energy_before, moment);
  tell_of_changes(moment, changes, measures);
  return std::max<std::uint64_t>(1, changes.size());
}

std::span<const NewVelocity> Simulation::let_thermostat_act(const Time& moment) {
  const std::span<const NewVelocity> changes = thermostat_->act(world(), moment);
  // An event in the same double may have carried the engine on.
  tuner_->engine().rewind(moment);
  tuner_->engine().change_velocities(moment, changes);
  return changes;
}

// The thermostat may act later than it would have: a run up to its next action ends.
void Simulation::forget_at_thermostat(SphereId id) {
  if (!thermostat_) return;
  thermostat_->note_removed(id);
  is_rescheduled_ = true;
}

void Simulation::tell_of_changes(const Time& moment, std::span<const NewVelocity> changes,
                                 Measures* measures) {
  if (!measures && !change_listener_) return;
  for (const NewVelocity& change : changes) {
    const Slot slot = change.slot;
    const VelocityChange done{
        moment,        world().id(slot), world().mass(slot), world().path(slot).position,
        change.before, change.after};
    if (measures) measures->note(done);
    if (!change_listener_) continue;
    const Activity::During running(activity_, Activity::Kind::running);
    change_listener_(done);
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
  if (!growth_ || growth_->is_over()) return;
  throw Error("spheres grow, and their number must stay", what, "wait until growth is over, or stop it");
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
  if (next_action().value() < time) {
    throw Error((grows_next() ? "an epoch of growth begins at " : "the thermostat acts at ") +
                    to_text(next_action().value()) + ", before the requested time, " + to_text(time),
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
  return tuner_->engine().world();
}

std::size_t Simulation::size() const {
  return tuner_->engine().size();
}

Counters Simulation::counters() const {
  return tuner_->counters();
}

void Simulation::set_threads(std::size_t threads) {
  check_idle("set_threads");
  EngineOptions changed = options();
  changed.threads = threads;
  check_threads(changed, world().box(), tuner_->engine().interactions());
  tuner_->set_threads(threads, now_);
}

const EngineOptions& Simulation::options() const {
  return tuner_->options();
}

std::vector<Block> Simulation::blocks() const {
  return tuner_->engine().blocks();
}

WindowCounters Simulation::windows() const {
  return tuner_->windows();
}

EngineKind Simulation::engine() const {
  return tuner_->kind();
}

Vec3 Simulation::cell_edges() const {
  return tuner_->engine().lengths().cell_edges;
}

double Simulation::cell_edge() const {
  const Vec3 edges = cell_edges();
  return (edges.x + edges.y + edges.z) / 3;
}

double Simulation::skin() const {
  return tuner_->engine().lengths().skin;
}

std::size_t Simulation::memory_bytes() const {
  return tuner_->engine().memory_bytes();
}

void Simulation::validate() const {
  tuner_->engine().validate();
}

}  // namespace hardball
