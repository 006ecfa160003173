// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/tuning/moments.hpp"
#include "hardball/world/audit.hpp"

namespace hardball {
namespace {

// The cell edge is looked at again after this many crossings per sphere.
constexpr std::uint64_t kCrossingsPerLook = 8;

// Steps between two looks, at the least.
constexpr std::uint64_t kSliceSteps = 1024;

Time latest_change(const World& world) {
  Time latest(0);
  for (const Path& path : world.paths()) latest = later(latest, path.time);
  return latest;
}

std::vector<Vec3> centers_at(const World& world, const Time& moment) {
  std::vector<Vec3> centers;
  centers.reserve(world.size());
  world.for_each_by_id([&](Slot slot) { centers.push_back(world.position(slot, moment)); });
  return centers;
}

}  // namespace

Simulation::Simulation(World world, const EngineOptions& options)
    : options_(options), watch_(options.unit_costs) {
  now_ = latest_change(world);
  refuse_overlaps(world, now_);
  if (options_.engine == EngineKind::automatic) options_.engine = EngineKind::cells;
  const double edge = choose_cell_edge(world, options_, now_);
  engine_ = make_engine(std::move(world), options_, edge, now_);
  watch_.begin(edge);
  last_look_ = now_;
  next_look_ = kCrossingsPerLook * size();
  tally_.begin(this->world(), now_);
}

Simulation::Simulation(const Simulation& other)
    : options_(other.options_),
      engine_(other.engine_->clone()),
      listener_(other.listener_),
      now_(other.now_),
      hash_(other.hash_),
      tally_(other.tally_),
      watch_(other.watch_),
      edited_(other.edited_),
      next_look_(other.next_look_),
      last_look_(other.last_look_) {}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

Simulation& Simulation::operator=(Simulation other) noexcept {
  options_ = other.options_;
  engine_ = std::move(other.engine_);
  listener_ = std::move(other.listener_);
  now_ = other.now_;
  hash_ = other.hash_;
  tally_ = other.tally_;
  watch_ = other.watch_;
  edited_ = other.edited_;
  next_look_ = other.next_look_;
  last_look_ = other.last_look_;
  return *this;
}

void Simulation::on_contact(std::function<void(const Contact&)> listener) {
  listener_ = std::move(listener);
}

void Simulation::respond_with(std::function<Velocities(const Contact&)> response) {
  engine_->replace_response(std::move(response));
}

void Simulation::run_until(double time) {
  run({.until = Time(time)});
}

std::uint64_t Simulation::run_contacts(std::uint64_t count, double until) {
  const std::uint64_t before = counters().contacts();
  run({.until = Time(until), .contacts = count});
  return counters().contacts() - before;
}

RunStatus Simulation::run(const RunLimits& limits) {
  check_not_past(limits.until.value());
  apply_edits();
  const auto observe = [this](const Contact& contact) {
    now_ = contact.time;
    tally_.note(contact);
    hash_.note(contact);
    if (listener_) listener_(contact);
  };
  const std::uint64_t slice = std::max<std::uint64_t>(kSliceSteps, size());
  RunLimits left = limits;
  for (;;) {
    const std::uint64_t contacts_before = counters().contacts();
    const RunLimits piece{limits.until, left.contacts, std::min(left.steps, slice)};
    const RunStatus status = engine_->run(piece, observe);
    left.contacts -= counters().contacts() - contacts_before;
    left.steps -= piece.steps;
    const bool goes_on = status == RunStatus::steps_reached && left.steps > 0;
    if (status == RunStatus::time_reached && std::isfinite(limits.until.high)) {
      now_ = later(now_, limits.until);
    } else if (status == RunStatus::steps_reached && !goes_on) {
      // Only here is it an engine's own event that the run stops at; elsewhere engines must not differ.
      now_ = later(now_, engine_->now());
    }
    // Also before returning: a run may be cut into pieces of any size.
    retune_if_due();
    if (!goes_on) return status;
  }
}

std::optional<NextContact> Simulation::next_contact(double until) {
  check_not_past(until);
  apply_edits();
  const std::optional<Event> next = engine_->next_contact(Time(until));
  if (!next) return std::nullopt;
  return NextContact{next->time.value(), next->kind, next->first, next->second};
}

Vec3 Simulation::position(SphereId id) const {
  return world().position(world().slot_of(id), now_);
}

Vec3 Simulation::velocity(SphereId id) const {
  return world().path(world().slot_of(id)).velocity;
}

std::vector<Vec3> Simulation::positions() const {
  return centers_at(world(), now_);
}

std::vector<Vec3> Simulation::positions_at(double time) {
  const std::optional<NextContact> next = next_contact(time);
  if (next && next->time < time) {
    throw Error(
        "there is a contact at " + to_text(next->time) + ", before the time asked for, " + to_text(time),
        "positions_at", "run_until that contact first");
  }
  return centers_at(world(), Time(time));
}

void Simulation::change_velocity(SphereId id, const Vec3& velocity) {
  const Slot slot = world().slot_of(id);
  const double energy_before = kinetic_energy(world(), slot);
  if (edited_ || engine_->now() > now_) {
    engine_->world_to_edit().change_velocity(slot, now_, velocity);
    edited_ = true;
  } else {
    engine_->change_velocity(slot, now_, velocity);
  }
  tally_.note_edit(kinetic_energy(world(), slot) - energy_before, now_);
}

SphereId Simulation::add(const Sphere& sphere) {
  world().check(sphere);
  refuse_overlap(world(), sphere, now_);
  const SphereId id = engine_->world_to_edit().add(sphere, now_);
  edited_ = true;
  tally_.note_edit(kinetic_energy(world(), world().slot_of(id)), now_);
  return id;
}

void Simulation::remove(SphereId id) {
  const double energy = kinetic_energy(world(), world().slot_of(id));
  engine_->world_to_edit().remove(id);
  edited_ = true;
  tally_.note_edit(-energy, now_);
}

const World& Simulation::world() const {
  return engine_->world();
}

Counters Simulation::counters() const {
  return engine_->counters();
}

double Simulation::cell_edge() const {
  return engine_->cell_edge();
}

std::size_t Simulation::memory_bytes() const {
  return engine_->memory_bytes();
}

void Simulation::validate() const {
  engine_->validate();
}

void Simulation::check_not_past(double time) const {
  if (time >= now_.value()) return;
  throw Error("the time to run to is " + to_text(time) + " and it is " + to_text(now_.value()) + " already",
              "until", "give a time that is not in the past");
}

void Simulation::apply_edits() {
  if (!edited_) return;
  const double edge = choose_cell_edge(world(), options_, now_);
  engine_->rebuild(now_, edge);
  watch_.begin(edge);
  last_look_ = now_;
  edited_ = false;
}

void Simulation::retune_if_due() {
  if (options_.cell_edge || options_.engine == EngineKind::all_pairs || options_.engine == EngineKind::neighbors) return;
  const std::uint64_t crossings = counters().enter;
  if (crossings < next_look_) return;
  next_look_ = crossings + kCrossingsPerLook * size();
  const Time moment = later(now_, engine_->now());
  const std::optional<double> better = watch_.look(moments_of(world(), moment), duration(last_look_, moment));
  last_look_ = moment;
  if (better) engine_->rebuild(moment, allowed_cell_edge(world(), options_.engine, *better));
}

}  // namespace hardball
