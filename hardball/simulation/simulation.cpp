// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/simulation/any_engine.hpp"
#include "hardball/simulation/user_data.hpp"
#include "hardball/theory/moments.hpp"
#include "hardball/tuning/size_classes.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/curve_order.hpp"

namespace hardball {
namespace {

// Engine and cell edge are reviewed after this many crossings and contacts per sphere.
constexpr std::uint64_t kEventsPerReview = 8;

// Fewest steps between two reviews.
constexpr std::uint64_t kSliceSteps = 1024;

// Fewer spheres fit in the caches in any order.
constexpr std::size_t kSpheresToOrder = 10000;

// A flag of the format that says nothing.
constexpr bool kUnused = false;

// Progress of the set-up after its stages [1].
constexpr double kOrdered = 0.2;
constexpr double kAudited = 0.5;

// The paper's engine and all pairs would gain nothing.
void put_in_order(World& world, EngineKind engine, const Time& moment) {
  const bool gains = engine == EngineKind::cells || engine == EngineKind::neighbors;
  if (gains && !world.has_journal() && world.size() >= kSpheresToOrder)
    world.reorder(order_along_curve(world, moment));
}

Time latest_change(const World& world) {
  Time latest(0);
  for (const Path& path : world.paths()) latest = later(latest, path.time);
  return latest;
}

// Contacts before the start do not count.
void begin_paths(World& world, const Time& moment) {
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Path& path = world.path(slot);
    if (path.time < moment) world.rewrite_path(slot, moment, world.velocity(slot, moment));
  }
}

std::uint64_t steps_of(const Counters& done) {
  return done.contacts() + done.enter + done.leave + done.stale;
}

// The options but for `instructions`: where a saved simulation is loaded, others may be available. Before
// version 3 the responses were among them.
struct SavedOptions {
  EngineOptions options;
  std::optional<ResponseTable> responses = {};

  static void persist(auto& archive, auto& self) {
    auto& options = self.options;
    archive(options.engine, options.queue, options.cell_edge);
    if constexpr (std::remove_cvref_t<decltype(archive)>::kIsReading) {
      if (archive.version() < 3) {
        double coefficient = 1;
        double elastic_below = 0;
        archive(coefficient, elastic_below, self.responses);
        const Bounce plain(Restitution(coefficient, elastic_below));
        if (!self.responses) self.responses = ResponseTable(plain, plain);
      }
    }
    archive(options.unit_costs);
    archive.require(options.engine >= EngineKind::automatic && options.engine <= EngineKind::paper &&
                    options.queue >= QueueKind::calendar && options.queue <= QueueKind::ordered);
  }
};

std::vector<Vec3> centers_at(const World& world, const Time& moment) {
  std::vector<Vec3> centers;
  centers.reserve(world.size());
  world.for_each_by_id([&](Slot slot) { centers.push_back(world.position(slot, moment)); });
  return centers;
}

}  // namespace

Simulation::Simulation(World world, const EngineOptions& options, const OnProgress& on_progress)
    : options_(options), user_data_(ValuePointer<UserData>::make()), watch_(options.unit_costs) {
  check(options_);
  const Progress progress(on_progress);
  progress.note(0, 1);
  now_ = latest_change(world);
  begin_paths(world, now_);
  kind_ = choose_engine(world, options_, now_);
  put_in_order(world, kind_, now_);
  require_no_overlap(world, now_, progress.part(kOrdered, kAudited));  // faster in order
  start_engine(std::move(world), progress.part(kAudited, 1));
  tally_.begin(this->world(), now_);
  progress.note_end();
}

// Precondition: the kind of engine has been chosen, and the spheres are in its order.
void Simulation::start_engine(World world, const Progress& progress) {
  const double length = choose_length(world, kind_, options_, now_);
  engine_ = make_engine(std::move(world), kind_, options_, length, now_, progress);
  watch_.restart(length);
  last_review_ = now_;
  spheres_at_choice_ = size();
  const Counters done = counters();
  next_review_ = done.enter + done.contacts() + kEventsPerReview * size();
}

std::string Simulation::save() const {
  if (activity_ == Activity::running) check_idle("save");
  return archived(SavedOptions{options_}, kind_, world(), now_, hash_, tally_, thermostat_, *user_data_,
                  engine_->aftermath().merged, kUnused, counters(), engine_->aftermath().collapse);
}

Simulation Simulation::load(std::string_view bytes, const std::string& where) {
  Simulation loaded;
  World world(Box::open());
  Aftermath aftermath;
  SavedOptions saved;
  bool unused = false;
  restore(bytes, where, saved, loaded.kind_, world, loaded.now_, loaded.hash_, loaded.tally_,
          loaded.thermostat_, *loaded.user_data_, aftermath.merged, unused, loaded.counters_before_,
          aftermath.collapse);
  loaded.options_ = saved.options;
  check(loaded.options_);
  if (saved.responses) {
    saved.responses->pass_as_in(world.interactions().table());
    world.set_interactions(*saved.responses);
  }
  check_moment(loaded.now_, where);
  if (loaded.now_ < latest_change(world) || loaded.tally_.walls().size() != kFaces + world.surfaces().size())
    refuse_archive(where);
  for (const SphereId merged : aftermath.merged.ids()) static_cast<void>(world.slot_of(merged));
  ++loaded.counters_before_.rebuilds;
  loaded.watch_ = CellEdgeWatch(loaded.options_.unit_costs);
  loaded.kind_ = choose_engine(world, loaded.options_, loaded.now_, loaded.kind_);
  put_in_order(world, loaded.kind_, loaded.now_);
  loaded.start_engine(std::move(world));
  loaded.engine_->take_over(aftermath);
  return loaded;
}

Simulation::Simulation(const Simulation& other)
    : options_(other.options_),
      kind_(other.kind_),
      engine_(other.engine_),
      counters_before_(other.counters_before_),
      listener_(other.listener_),
      next_listener_(other.next_listener_),
      change_listener_(other.change_listener_),
      thermostat_(other.thermostat_),
      now_(other.now_),
      hash_(other.hash_),
      tally_(other.tally_),
      user_data_(other.user_data_),
      watch_(other.watch_),
      is_interrupted_(other.is_interrupted_),
      spheres_at_choice_(other.spheres_at_choice_),
      next_review_(other.next_review_),
      last_review_(other.last_review_),
      reviewed_(other.reviewed_) {}

Simulation::Simulation() : user_data_(ValuePointer<UserData>::make()) {}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

Simulation& Simulation::operator=(Simulation other) noexcept {
  options_ = other.options_;
  kind_ = other.kind_;
  engine_ = std::move(other.engine_);
  counters_before_ = other.counters_before_;
  listener_ = std::move(other.listener_);
  next_listener_ = std::move(other.next_listener_);
  change_listener_ = std::move(other.change_listener_);
  thermostat_ = std::move(other.thermostat_);
  now_ = other.now_;
  hash_ = other.hash_;
  tally_ = other.tally_;
  user_data_ = std::move(other.user_data_);
  watch_ = other.watch_;
  is_interrupted_ = other.is_interrupted_;
  spheres_at_choice_ = other.spheres_at_choice_;
  next_review_ = other.next_review_;
  last_review_ = other.last_review_;
  reviewed_ = other.reviewed_;
  return *this;
}

void Simulation::on_contact(Function<void(const Contact&)> listener) {
  next_listener_ = std::move(listener);
  const bool is_at_work = activity_ == Activity::listening || activity_ == Activity::measuring;
  if (!is_at_work) take_next_listener();
}

void Simulation::take_next_listener() {
  if (!next_listener_) return;
  listener_ = std::move(*next_listener_);
  next_listener_.reset();
}

void Simulation::respond_with(Function<Velocities(const Contact&)> response) {
  if (!response) return respond_with(nullptr);
  respond_with([response = std::move(response)](const Contact& contact) {
    return Outcome(contact, response(contact));
  });
}

void Simulation::respond_with(Function<Outcome(const Contact&)> response) {
  check_editable("respond_with");
  Interactions changed = world().interactions();
  changed.set_function(std::move(response));
  engine_->world_to_edit().set_interactions(changed);
}

void Simulation::respond_with(const ResponseTable& table) {
  check_editable("respond_with");
  ResponseTable changed = table;
  changed.pass_as_in(world().interactions().table());
  engine_->world_to_edit().set_interactions(changed);
}

void Simulation::respond_with(std::nullptr_t) {
  respond_with(Function<Outcome(const Contact&)>());
}

void Simulation::run_until(double time) {
  run({.until = Time(time)});
}

void Simulation::run_until(double time, Measures& measures) {
  run({.until = Time(time)}, measures);
}

std::uint64_t Simulation::run_contacts(std::uint64_t count, double until) {
  const std::uint64_t before = counters().contacts();
  run({.until = Time(until), .contacts = count});
  return counters().contacts() - before;
}

RunStatus Simulation::run(const RunLimits& limits) {
  return run_observed(limits, nullptr);
}

RunStatus Simulation::run(const RunLimits& limits, Measures& measures) {
  check_idle("run");
  measures.check_spheres(world());
  RunLimits left = limits;
  for (;;) {
    // A sample that is overdue after a run without these measures is taken now.
    const Time sample = later(measures.next_sample(), now_);
    const bool is_next = sample <= limits.until && sample < kNever;
    left.until = is_next ? sample : limits.until;
    const Counters before = counters();
    const RunStatus status = run_observed(left, &measures);
    if (status != RunStatus::time_reached || !is_next) return status;
    const Counters done = counters() - before;
    left.contacts -= done.contacts();
    left.steps -= std::min(left.steps, steps_of(done));
    measures.sample(world(), now_);
    // Samples are work, too.
    if (left.steps > 0) --left.steps;
    if (left.steps == 0) return RunStatus::steps_reached;
  }
}

// Runs until the first of the limits is met, notifying `measures`, if any, of every contact.
RunStatus Simulation::run_observed(const RunLimits& limits, Measures* measures) {
  check_idle("run");
  check_not_past(limits.until);
  const During running(activity_, Activity::running);
  const auto observe = [this, measures](const Contact& contact) {
    note(contact, measures);
    return !is_interrupted_;
  };
  RunLimits left = limits;
  for (;;) {
    is_interrupted_ = false;
    engine_->end_journal();
    rebuild_if_due();
    const std::uint64_t slice = std::max<std::uint64_t>(kSliceSteps, size());
    const Time action = next_action();
    const bool acts = action.high <= limits.until.high && action < kNever;
    const RunLimits piece{acts ? action : limits.until, left.contacts, std::min(left.steps, slice)};
    const Counters before = counters();
    RunStatus status = engine_->run(piece, observe);
    const Counters done = counters() - before;
    left.contacts -= done.contacts();
    left.steps -= status == RunStatus::steps_reached ? piece.steps : std::min(left.steps, steps_of(done));
    if (status == RunStatus::time_reached && std::isfinite(piece.until.high)) {
      now_ = later(now_, piece.until);
    }
    if (status == RunStatus::steps_reached && left.steps == 0) {
      // Only here may the time reached depend on the engine.
      now_ = later(now_, engine_->now());
    }
    if (status == RunStatus::time_reached && acts) {
      left.steps -= std::min(left.steps, act(measures));
      status = RunStatus::steps_reached;
    }
    // Also before returning: a run may be split into pieces of any size.
    if (!engine_->is_outdated()) retune_if_due();
    const bool continues = status == RunStatus::observer_stopped || status == RunStatus::outdated ||
                           (status == RunStatus::steps_reached && left.steps > 0);
    if (!continues) return status;
  }
}

// To be called with every contact when it has been executed.
void Simulation::note(const Contact& contact, Measures* measures) {
  now_ = contact.time;
  tally_.note(contact);
  hash_.note(contact);
  if (contact.fate == Fate::merge) [[unlikely]]
    note_merger(contact, measures);
  if (measures) measures->note(contact);
  if (listener_ || next_listener_)
    call_listener(contact, measures ? Activity::measuring : Activity::listening);
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

// The thermostat may act later than it would have: a run up to its next action ends.
void Simulation::forget_at_thermostat(SphereId id) {
  if (!thermostat_) return;
  thermostat_->note_removed(id);
  is_interrupted_ = true;
}

void Simulation::call_listener(const Contact& contact, Activity activity) {
  take_next_listener();
  if (!listener_) return;
  const During listening(activity_, activity);
  listener_(contact);
}

std::optional<NextContact> Simulation::next_contact(double until) {
  check_idle("next_contact");
  check_not_past(Time(until));
  rebuild_if_due();
  const Time end(until);
  const Time action = next_action();
  const bool acts = action <= end && action < kNever;
  if (engine_->aftermath().merged.empty()) {
    if (!world().has_journal()) engine_->begin_journal(later(now_, engine_->now()));
    const std::optional<Event> next = engine_->next_contact(acts ? action : end);
    if (next) return NextContact{next->time.value(), next->kind, next->first, next->second};
    if (!acts) return std::nullopt;
  }
  std::optional<NextContact> first;
  look_ahead(end, 1, [&first](const Contact& contact) {
    first = {contact.time.value(), contact.kind, contact.first, contact.second};
    return true;
  });
  return first;
}

std::vector<Contact> Simulation::contacts_within(double duration, std::uint64_t most) {
  if (activity_ == Activity::running) check_idle("contacts_within");
  const Time until = after(now_, duration);
  check_not_past(until);
  check_moment(until, "duration");
  // The listener runs in the middle of a run of the engine.
  if (activity_ != Activity::none) return Simulation(*this).contacts_within(duration, most);
  std::vector<Contact> contacts;
  look_ahead(until, most, [&contacts](const Contact& contact) {
    contacts.push_back(contact);
    return true;
  });
  return contacts;
}

// Runs the engine ahead, up to so many contacts, calling observe(contact); then rewinds it.
void Simulation::look_ahead(const Time& until, std::uint64_t most,
                            const Function<bool(const Contact&)>& observe) {
  const During running(activity_, Activity::running);
  const std::optional<Thermostat> thermostat = thermostat_;
  const Counters before = counters();
  end_look_ahead(now_);
  rebuild_if_due();
  engine_->begin_journal(later(now_, engine_->now()));
  const auto take_back = [&] {
    engine_->rewind_to_begin();
    engine_->end_journal();
    thermostat_ = thermostat;
    const Counters done = counters();
    counters_before_.collision -= done.collision - before.collision;
    counters_before_.wall -= done.wall - before.wall;
  };
  try {
    run_ahead(until, most, observe);
  } catch (...) {
    take_back();
    throw;
  }
  take_back();
}

void Simulation::run_ahead(const Time& until, std::uint64_t most,
                           const Function<bool(const Contact&)>& observe) {
  Time last_change = tally_.last_change();
  std::uint64_t left = most;
  const auto note = [&](const Contact& contact) {
    last_change = contact.time;
    --left;
    is_interrupted_ = false;
    if (contact.fate == Fate::merge) forget_at_thermostat(contact.second);
    return observe(contact) && !is_interrupted_;
  };
  for (;;) {
    if (engine_->is_outdated()) rebuild(later(now_, engine_->now()));
    const Time action = next_action();
    const bool acts = action.high <= until.high && action < kNever;
    const RunStatus status = engine_->run({.until = acts ? action : until, .contacts = left}, note);
    if (status == RunStatus::outdated || status == RunStatus::observer_stopped) continue;
    if (status != RunStatus::time_reached || !acts) return;
    // An event in the same double may have carried the engine on.
    last_change = later(action, last_change);
    const std::span<const NewVelocity> changes = thermostat_->act(world(), last_change);
    engine_->rewind(last_change);
    engine_->change_velocities(last_change, changes);
  }
}

std::optional<NextContact> Simulation::first_contact(SphereId id, const Vec3& velocity, double until) const {
  return hardball::first_contact(world(), now_, id, velocity, Time(until));
}

std::optional<NextContact> Simulation::first_contact(const Sphere& sphere, double until) const {
  return hardball::first_contact(world(), now_, sphere, Time(until));
}

std::optional<RayHit> Simulation::ray(const Vec3& origin, const Vec3& direction, double most) const {
  return hardball::ray(world(), now_, origin, direction, most);
}

std::optional<Clearance> Simulation::clearance(const Vec3& point) const {
  return hardball::clearance(world(), now_, point);
}

std::optional<Clearance> Simulation::clearance(SphereId id) const {
  return hardball::clearance(world(), now_, id);
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
    throw Error("the thermostat acts at " + to_text(next_action().value()) + ", before the requested time, " +
                    to_text(time),
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

void Simulation::change_velocity(SphereId id, const Vec3& velocity) {
  check_editable("change_velocity");
  const VelocityEdit edit{id, velocity};
  edit_velocities({&edit, 1}, nullptr);
}

// Precondition: all events before `moment` have been handled, and no contact after it.
void Simulation::rewrite_velocities(const Time& moment, std::span<const NewVelocity> changes) {
  end_look_ahead(moment);
  engine_->change_velocities(moment, changes);
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
    const During running(activity_, Activity::running);
    change_listener_(done);
  }
}

void Simulation::on_velocity_change(Function<void(const VelocityChange&)> listener) {
  check_editable("on_velocity_change");
  change_listener_ = std::move(listener);
}

void Simulation::set_thermostat(std::optional<Thermostat> thermostat) {
  check_editable("set_thermostat");
  thermostat_ = std::move(thermostat);
  if (thermostat_) thermostat_->begin(world(), now_);
  // If a listener sets it, the run up to the next action of the former one ends.
  is_interrupted_ = true;
}

// When the thermostat acts next; kNever without one.
Time Simulation::next_action() const {
  return thermostat_ ? Time(thermostat_->next()) : kNever;
}

// Lets the thermostat act, and returns how many velocities it has changed, at least one. Precondition: all
// contacts that round to that time or an earlier one have been handled, and `now_` is no earlier.
std::uint64_t Simulation::act(Measures* measures) {
  // Not `now_`, which after a limited number of steps may depend on the engine.
  const Time moment = later(next_action(), tally_.last_change());
  const double energy_before = thermostat_->energy();
  const std::span<const NewVelocity> changes = thermostat_->act(world(), moment);
  rewrite_velocities(moment, changes);
  tally_.note_edit(thermostat_->energy() - energy_before, moment);
  tell_of_changes(moment, changes, measures);
  return std::max<std::uint64_t>(1, changes.size());
}

void Simulation::change_velocities(std::span<const VelocityEdit> edits) {
  check_editable("change_velocities");
  edit_velocities(edits, nullptr);
}

void Simulation::change_velocities(std::span<const VelocityEdit> edits, Measures& measures) {
  check_editable("change_velocities");
  measures.check_spheres(world());
  edit_velocities(edits, &measures);
}

void Simulation::edit_velocities(std::span<const VelocityEdit> edits, Measures* measures) {
  std::vector<VelocityEdit> sorted(edits.begin(), edits.end());
  std::ranges::sort(sorted, {}, &VelocityEdit::id);
  const auto twice = std::ranges::adjacent_find(sorted, {}, &VelocityEdit::id);
  if (twice != sorted.end()) {
    throw Error("sphere " + to_text(twice->id) + " is given two velocities", "change_velocities",
                "give each sphere once");
  }
  std::vector<NewVelocity> changes;
  std::vector<double> energies;
  for (const VelocityEdit& edit : sorted) {
    const Slot slot = world().slot_of(edit.id);
    static_cast<void>(world().image(slot, now_));  // whether it is where it can be changed
    world().check_velocity(edit.id, edit.velocity);
    changes.push_back({slot, world().velocity(slot, now_), edit.velocity});
    energies.push_back(kinetic_energy(world(), slot, now_));
  }
  rewrite_velocities(now_, changes);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    tally_.note_edit(kinetic_energy(world(), changes[i].slot, now_) - energies[i], now_);
  }
  tell_of_changes(now_, changes, measures);
}

SphereId Simulation::add(const Sphere& sphere) {
  check_editable("add");
  end_look_ahead(now_);
  const SphereId id = engine_->add(sphere, now_);
  tally_.note_edit(kinetic_energy(world(), world().slot_of(id), now_), now_);
  if (thermostat_) {
    thermostat_->note_added(id, now_);
    is_interrupted_ = true;
  }
  return id;
}

void Simulation::remove(SphereId id) {
  check_editable("remove");
  const double energy = kinetic_energy(world(), world().slot_of(id), now_);
  end_look_ahead(now_);
  engine_->remove(id, now_);
  user_data_->remove(id);
  tally_.note_edit(-energy, now_);
  forget_at_thermostat(id);
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
  return engine_->world();
}

Counters Simulation::counters() const {
  return counters_before_ + engine_->counters();
}

Vec3 Simulation::cell_edges() const {
  return engine_->lengths().cell_edges;
}

double Simulation::cell_edge() const {
  const Vec3 edges = cell_edges();
  return (edges.x + edges.y + edges.z) / 3;
}

double Simulation::skin() const {
  return engine_->lengths().skin;
}

std::size_t Simulation::memory_bytes() const {
  return engine_->memory_bytes();
}

void Simulation::validate() const {
  engine_->validate();
}

void Simulation::check_idle(const char* what) const {
  if (activity_ == Activity::none) return;
  throw Error("the simulation is running", what, "call it when the run has ended, or run a copy");
}

void Simulation::check_editable(const char* what) const {
  if (activity_ == Activity::running) {
    throw Error("responses and velocity listeners must not edit the simulation", what,
                "edit it from the listener, which is called after the contact");
  }
  if (activity_ == Activity::measuring) {
    throw Error("the run takes measures, which do not allow edits", what,
                "run without measures, or edit the simulation when the run has ended");
  }
}

void Simulation::check_not_past(const Time& time) const {
  if (!(time.value() >= now_.value())) {
    throw Error(to_text(time.value()) + " is in the past; the time is " + to_text(now_.value()), "until",
                "give a later time");
  }
  if (time < kNever) check_moment(time, "until");
}

// Brings an engine that has looked ahead back to `moment`.
void Simulation::end_look_ahead(const Time& moment) {
  engine_->rewind(moment);
  engine_->end_journal();
}

// Before the engine runs on: it may be outdated, or made for far more or fewer spheres.
void Simulation::rebuild_if_due() {
  const bool is_new_choice_due =
      16 * std::max(size(), spheres_at_choice_) > 17 * std::min(size(), spheres_at_choice_);
  if (!is_new_choice_due && !engine_->is_outdated()) return;
  end_look_ahead(now_);
  rebuild(now_);
}

void Simulation::retune_if_due() {
  const Counters done = counters();
  if (done.enter + done.contacts() < next_review_) return;
  next_review_ = done.enter + done.contacts() + kEventsPerReview * size();
  const Time moment = later(now_, engine_->now());
  const Moments moments = moments_of(world(), moment);
  const bool is_by_class = kind_ == EngineKind::cells && are_sizes_spread(moments);
  if (!are_alike(moments, reviewed_)) {
    reviewed_ = moments;
    if (choose_engine(world(), options_, moment, kind_) != kind_) return rebuild(moment);
    if (is_by_class && !options_.cell_edge) {
      constexpr double kEnough = 1.25;
      const double best = choose_length(world(), kind_, options_, moment);
      if (std::max(best / watch_.edge(), watch_.edge() / best) > kEnough) return rebuild(moment);
    }
  }
  const bool has_cells = kind_ == EngineKind::cells || kind_ == EngineKind::paper;
  if (!has_cells || is_by_class || options_.cell_edge) return;
  const std::optional<double> better = watch_.update(moments, duration(last_review_, moment));
  last_review_ = moment;
  if (!better) return;
  const double edge = allowed_cell_edge(world(), kind_, *better);
  if (!engine_->supports(edge)) return rebuild(moment);
  put_in_order(engine_->world_to_edit(), kind_, moment);
  engine_->rebuild(moment, edge);
}

// Rebuilds all regions and predictions, with another engine if that suits the world better.
void Simulation::rebuild(const Time& moment) {
  const EngineKind kind = choose_engine(world(), options_, moment, kind_);
  spheres_at_choice_ = size();
  // Spheres may have grown.
  const double length = allowed_cell_edge(world(), kind, choose_length(world(), kind, options_, moment));
  put_in_order(engine_->world_to_edit(), kind, moment);
  if (kind == kind_ && engine_->supports(length)) {
    engine_->rebuild(moment, length);
  } else {
    counters_before_ = counters();
    ++counters_before_.rebuilds;
    const Aftermath aftermath = engine_->aftermath();
    engine_ = make_engine(std::move(engine_->world_to_edit()), kind, options_, length, moment);
    engine_->take_over(aftermath);
    kind_ = kind;
  }
  watch_.restart(length);
  last_review_ = moment;
}

}  // namespace hardball
