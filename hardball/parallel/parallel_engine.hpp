// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/execution/aftermath.hpp"
#include "hardball/execution/follow.hpp"
#include "hardball/parallel/cluster.hpp"
#include "hardball/parallel/division.hpp"
#include "hardball/parallel/layout.hpp"
#include "hardball/parallel/make_domains.hpp"
#include "hardball/parallel/system_size.hpp"
#include "hardball/parallel/thread_team.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/sphere_edit.hpp"

namespace hardball {

/// An engine that runs one system in several domains, in as many threads as wanted: to the same contacts as
/// Engine, and with the same interface. The world as a whole is brought up to date when it is asked for.
///
/// `Sums` adds up contacts: note(contact); part() makes empty sums, to be filled elsewhere; add(part).
template <EventQueue Queue, BroadPhase Phase, class Sums>
class ParallelEngine {
 public:
  /// Takes over a world as it is at `now`. Precondition: as for Engine; spheres do not merge, and the
  /// response is no function, which might not bear being called by several threads at once.
  ParallelEngine(World world, const PhaseSettings& phase, const Division& settings, const Time& now)
      : phase_(phase), world_(std::move(world)), team_(new_team(settings.threads)), layout_(settings) {
    divide(now);
  }
  ParallelEngine(const ParallelEngine& other)
      : phase_(other.phase_),
        world_(other.world_),
        team_(new_team(other.team_->size())),
        layout_(other.layout_),
        cluster_(std::make_unique<Domains>(*other.cluster_, team_->as_function())),
        counters_(other.counters_),
        windows_before_(other.windows_before_),
        aftermath_(other.aftermath_),
        is_outdated_(other.is_outdated_),
        looks_ahead_(other.looks_ahead_),
        before_look_ahead_(other.before_look_ahead_) {
    HARDBALL_CHECK(!other.is_open_);
    gathering_->is_done = other.gathering_->is_done.load();
  }
  ParallelEngine(ParallelEngine&&) noexcept = default;
  ParallelEngine& operator=(ParallelEngine&&) noexcept = default;

  const World& world() const {
    gather();
    return world_;
  }
  /// The world with its spheres on the paths that they had when it was last asked for.
  const World& world_as_gathered() const { return world_; }
  /// The world for editing between runs; `rebuild` must follow.
  World& world_to_edit() {
    settle();
    outdate();
    return world_;
  }
  /// A sum over all spheres as they are at `moment`, for which the world need not be brought up to date:
  /// note(world, slot, moment) adds a sphere, and add(part) what was added elsewhere. Precondition: not
  /// is_outdated().
  template <class SumOverSpheres>
  SumOverSpheres sum_over_spheres(const Time& moment) const {
    HARDBALL_CHECK(!is_outdated_);
    std::vector<SumOverSpheres> parts(cluster_->size());
    cluster_->each([&](auto& domain, std::size_t number) { domain.note_own_spheres(parts[number], moment); });
    SumOverSpheres all;
    for (const SumOverSpheres& part : parts) all.add(part);
    return all;
  }
  static bool supports(const World& world, double length) {
    return Phase::supports(world, length) &&
           what_prevents_division(world.box(), world.interactions()).empty();
  }
  /// Calls work(k) for each k below `count`, in all threads, and returns when all have returned.
  /// Precondition: `work` does not throw.
  void for_each(std::size_t count, const Function<void(std::size_t)>& work) {
    const ThreadTeam::Pinned pinned(*team_);
    team_->for_each(count, work);
  }
  /// Of the first domain.
  PhaseLengths lengths() const { return cluster_->domain(0).engine().lengths(); }
  std::size_t domains() const { return cluster_->size(); }
  /// The blocks of the domains.
  const Partition& partition() const { return layout_.partition(); }
  /// Of all divisions so far.
  WindowCounters window_counters() const { return windows_before_ + cluster_->window_counters(); }
  /// The time up to which events have been handled.
  Time now() const { return is_open_ ? now_ : cluster_->now(); }

  Counters counters() const {
    Counters counters = counters_;
    counters.collision += cluster_->counted().collision + open_counts_.collision;
    counters.wall += cluster_->counted().wall + open_counts_.wall;
    for (std::size_t k = 0; k < cluster_->size(); ++k) {
      Counters work = cluster_->domain(k).engine().counters();
      work.collision = 0;
      work.wall = 0;
      counters = counters + work;
    }
    return counters;
  }

  std::size_t memory_bytes() const {
    std::size_t bytes = world_.memory_bytes();
    for (std::size_t k = 0; k < cluster_->size(); ++k) bytes += cluster_->domain(k).memory_bytes();
    return bytes;
  }

  /// As Engine::run, and adds the contacts to `sums`: before the observer is told if it looks around,
  /// otherwise at the end of the run. The number of steps limits only the start of windows: a window is taken
  /// whole.
  RunStatus run(const RunLimits& limits, Sums& sums, const ContactObserver& observer) {
    const ThreadTeam::Pinned pinned(*team_);
    keep_for_rewind();
    if (observer.needs_world()) return run_windows(limits, sums, observer);
    cluster_->clear_sums(sums);
    try {
      const RunStatus status = run_windows(limits, sums, observer);
      cluster_->add_sums_to(sums);
      return status;
    } catch (...) {
      cluster_->add_sums_to(sums);
      throw;
    }
  }

  /// As Engine::next_contact.
  std::optional<Event> next_contact(const Time& until) {
    const ThreadTeam::Pinned pinned(*team_);
    if (!std::isfinite(until.high) && !cluster_->has_events()) return std::nullopt;
    const Event next = cluster_->next_contact(within_range(until).high);
    return next.happens() ? std::optional(next) : std::nullopt;
  }

  /// As Engine::change_velocities; `slot` is that in world().
  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) {
    settle();
    gather();
    keep_for_rewind();
    for (const NewVelocity& change : changes) world_.change_velocity(change.slot, moment, change.after);
    if (is_outdated_) return;
    cluster_->each([&](auto& domain, std::size_t) {
      for (const NewVelocity& change : changes)
        domain.change_velocity(world_.id(change.slot), change.after, moment);
    });
  }

  /// As Engine::add. Cost: O(n).
  SphereId add(const Sphere& sphere, const Time& moment) {
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
    if (is_outdated_) return id;
    const SphereState state = world_.state_of(slot);
    const DomainNumber owner = partition().domain_at(state.path.position);
    cluster_->each([&](auto& domain, std::size_t) {
      domain.add(state, owner, moment);
      domain.make_ready();
    });
    return id;
  }

  /// As Engine::remove.
  void remove(SphereId id, const Time& moment) {
    settle();
    gather();
    world_.remove(id, moment);
    if (is_outdated_) return;
    cluster_->each([&](auto& domain, std::size_t) { domain.remove(id, moment); });
  }

  bool is_outdated() const { return is_outdated_; }

  /// As of Engine; but all is rebuilt after going back. Cost: O(n).
  void begin_journal(const Time& moment) {
    HARDBALL_CHECK(is_outdated_ || moment >= now());
    looks_ahead_ = true;
    before_look_ahead_.reset();
  }
  void end_journal() {
    looks_ahead_ = false;
    before_look_ahead_.reset();
  }
  /// Goes back to `moment`, since when nothing but crossings has happened.
  void rewind(const Time& moment) {
    if (!is_outdated_ && now() > moment) outdate();
  }
  void rewind_to_begin() {
    if (!before_look_ahead_) return outdate();
    outdate();
    world_ = before_look_ahead_->world;
    aftermath_ = before_look_ahead_->aftermath;
    const Counters done = counters() - before_look_ahead_->counters;
    counters_.collision -= done.collision;
    counters_.wall -= done.wall;
  }

  /// As Engine::rebuild; divides the world anew.
  void rebuild(const Time& now, const PhaseSettings& settings) {
    end_division();
    phase_ = settings;
    divide(now);
  }

  Aftermath aftermath() const {
    if (is_outdated_) return aftermath_;
    Aftermath all;
    for (std::size_t k = 0; k < cluster_->size(); ++k)
      all.collapse.take_over(cluster_->domain(k).engine().aftermath().collapse);
    return all;
  }
  void take_over(const Aftermath& aftermath) {
    for (std::size_t k = 0; k < cluster_->size(); ++k) cluster_->domain(k).take_over(aftermath);
  }

  void validate() const {
    if (is_outdated_) return;
    for (std::size_t k = 0; k < cluster_->size(); ++k) {
      cluster_->domain(k).engine().validate();
      if (!is_open_) cluster_->domain(k).validate();
    }
  }

 private:
  using DomainEngine = Engine<Queue, Phase>;
  using Domains = Cluster<DomainEngine, Sums>;
  struct LookAhead {
    World world;
    Aftermath aftermath;
    Counters counters;
  };
  struct Gathering {
    std::mutex mutex;
    std::atomic<bool> is_done{true};  // whether the world is up to date
  };

  static std::unique_ptr<ThreadTeam> new_team(std::size_t threads) {
    return std::make_unique<ThreadTeam>(threads);
  }

  // Precondition: the world is up to date.
  void divide(const Time& now) {
    layout_.lay_out(world_.box(), SystemSize::of(world_, now), centers(now));
    occupy(now);
  }

  std::vector<Vec3> centers(const Time& now) const {
    std::vector<Vec3> centers;
    centers.reserve(world_.size());
    for (Slot slot = 0; slot < world_.size(); ++slot) centers.push_back(world_.position(slot, now));
    return centers;
  }

  // Makes the domains of the layout.
  void occupy(const Time& now) {
    cluster_ = std::make_unique<Domains>(
        make_domains<DomainEngine, Sums, Phase>(layout_, 0, partition().size(), world_, now, aftermath_,
                                                phase_, team_->as_function()),
        now, layout_.windows(), team_->as_function());
    is_outdated_ = false;
    gathering_->is_done = true;
  }

  // Keeps what the domains have been doing, as others follow.
  void end_division() {
    outdate();
    Counters work = counters();
    ++work.rebuilds;
    counters_ = work;
    windows_before_ = window_counters();
  }

  // What is there before anything happens in a look ahead.
  void keep_for_rewind() {
    if (looks_ahead_ && !before_look_ahead_) before_look_ahead_ = LookAhead{world(), aftermath(), counters()};
  }

  // From here on the world tells what is the case, until all is rebuilt.
  void outdate() {
    if (is_outdated_) return;
    gather();
    aftermath_ = aftermath();
    is_outdated_ = true;
  }

  // Brings the world up to date; several const queries may need it at once.
  void gather() const {
    if (is_telling_)
      throw Error("contacts are logged when later ones have happened", "log_contacts", "use on_contact");
    if (gathering_->is_done.load(std::memory_order_acquire) || is_open_ || is_outdated_) return;
    const std::scoped_lock lock(gathering_->mutex);
    if (gathering_->is_done) return;
    const Time now = cluster_->now();
    bool have_spun = false;
    const auto bring = [&](auto& domain, std::size_t) {
      // Spheres that follow one another there mostly do here, too.
      Slot ahead = 0;  // how much farther on the last one is here
      domain.take_changed([&](Slot from) {
        const std::optional<Slot> slot = world_.find(domain.world().id(from), from + ahead);
        HARDBALL_CHECK(slot);
        SphereEdit(world_, now, *slot).store_motion(*slot, domain.world(), from);
        ahead = *slot - from;
      });
    };
    for (std::size_t k = 0; k < cluster_->size(); ++k) have_spun |= cluster_->domain(k).world().has_spins();
    if (have_spun && !world_.has_spins()) {
      for (std::size_t k = 0; k < cluster_->size(); ++k) bring(cluster_->domain(k), k);
    } else {
      cluster_->each(bring);
    }
    world_.note_passage(cluster_->domain(0).world().last_passage());
    gathering_->is_done = true;
  }

  RunStatus run_windows(const RunLimits& limits, Sums& sums, const ContactObserver& observer) {
    std::uint64_t contacts = limits.contacts;
    std::uint64_t steps = limits.steps;
    while (contacts > 0) {
      if (is_outdated_) return RunStatus::outdated;
      if (steps == 0) return RunStatus::steps_reached;
      const bool has_end = std::isfinite(limits.until.high);
      if (!has_end && !cluster_->has_events()) return RunStatus::time_reached;
      const double end = within_range(limits.until).high;
      const Counters before = counters();
      const bool continues = run_window(end, contacts, sums, observer);
      const Counters done = counters() - before;
      contacts -= done.contacts();
      steps -= std::min(steps, done.contacts() + done.enter + done.stale + 1);
      if (!continues) return RunStatus::observer_stopped;
      if (!is_outdated_ && cluster_->committed() == end && cluster_->is_complete())
        return RunStatus::time_reached;
      if (!is_outdated_) review_division(sums, !observer.needs_world());
    }
    return RunStatus::contacts_reached;
  }

  // Divides the system anew if that pays. The domains may have added up contacts.
  void review_division(Sums& sums, bool have_sums) {
    if (!layout_.is_review_due(cluster_->window_counters().windows)) return;
    const Load load = cluster_->load();
    if (!layout_.may_improve(load, world_.size())) return;
    const Time now = cluster_->now();
    gather();
    if (!layout_.improve(load, world_.box(), SystemSize::of(world_, now), centers(now))) return;
    if (have_sums) cluster_->add_sums_to(sums);
    end_division();
    occupy(now);
    if (have_sums) cluster_->clear_sums(sums);
  }

  // Runs through one window; false if the observer has stopped the run.
  bool run_window(double end, std::uint64_t most, Sums& sums, const ContactObserver& observer) {
    if (observer.needs_world()) {
      gather();
      cluster_->open_window(end, most, {.log = true, .sums = false});
      return deliver(sums, observer);
    }
    cluster_->open_window(end, most, {.log = static_cast<bool>(observer)});
    const std::exception_ptr failure = observer ? tell(observer) : nullptr;
    cluster_->commit_window();
    gathering_->is_done = false;
    if (failure) std::rethrow_exception(failure);
    return true;
  }

  // Tells the observer of the contacts of the open window, without the world. Returns what it has thrown.
  std::exception_ptr tell(const ContactObserver& observer) {
    std::exception_ptr failure;
    is_telling_ = true;
    try {
      MergedLog log = cluster_->merged_log();
      while (const Contact* contact = log.next()) observer.note(*contact);
    } catch (...) {
      failure = std::current_exception();
    }
    is_telling_ = false;
    return failure;
  }

  // Tells the observer of the contacts of the open window, with the world as it is after each.
  bool deliver(Sums& sums, const ContactObserver& observer) {
    MergedLog log = cluster_->merged_log();
    is_open_ = true;
    taken_ = 0;
    while (const Contact* logged = log.next()) {
      const Contact contact = *logged;  // the log is discarded if the window is cut
      apply(contact);
      sums.note(contact);
      bool continues = false;
      try {
        continues = observer.note(contact);
      } catch (...) {
        settle();
        throw;
      }
      if (!continues) settle();
      if (!is_open_) return continues;
    }
    HARDBALL_CHECK(open_counts_.contacts() == cluster_->open_contacts());
    close();
    cluster_->commit_window();
    return true;
  }

  // Lets a contact of the open window happen in the world.
  void apply(const Contact& contact) {
    now_ = contact.time;
    ++taken_;
    ++(contact.is_collision() ? open_counts_.collision : open_counts_.wall);
    follow(world_, contact);
  }

  // Takes of the open window only what has been delivered.
  void settle() {
    if (!is_open_) return;
    close();
    cluster_->cut_window(taken_);
  }
  void close() {
    is_open_ = false;
    open_counts_ = {};
  }

  PhaseSettings phase_;
  mutable World world_;
  std::unique_ptr<ThreadTeam> team_;
  Layout layout_;
  std::unique_ptr<Domains> cluster_;
  Counters counters_;  // of earlier divisions
  WindowCounters windows_before_;
  Aftermath aftermath_;  // while outdated
  std::unique_ptr<Gathering> gathering_ = std::make_unique<Gathering>();
  bool is_outdated_ = false;
  bool is_telling_ = false;
  bool looks_ahead_ = false;
  std::optional<LookAhead> before_look_ahead_;
  // Of the open window, while its contacts are delivered:
  bool is_open_ = false;
  Time now_;
  std::uint64_t taken_ = 0;
  Counters open_counts_;
};

}  // namespace hardball
