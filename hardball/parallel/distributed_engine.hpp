// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/parallel/cluster.hpp"
#include "hardball/parallel/division.hpp"
#include "hardball/parallel/layout.hpp"
#include "hardball/parallel/make_domains.hpp"
#include "hardball/parallel/system_size.hpp"
#include "hardball/parallel/thread_team.hpp"
#include "hardball/parallel/traveler.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/world/curve_order.hpp"
#include "hardball/world/velocity_edit.hpp"

namespace hardball {

/// The share of one process in an engine that spans several processes: to the same contacts as Engine.
/// No process holds more than the spheres in its domains, and those near them. Its members are called in all
/// processes at once, with the same arguments but for the spheres and the sums.
template <EventQueue Queue, BroadPhase Phase, class Sums>
class DistributedEngine {
 public:
  using Observe = Function<void(const Contact&)>;

  /// Divides a system as it is at `now`, of which each process brings some of the spheres, wherever they are;
  /// all are brought once. `empty`: the world without spheres. `division` is that of each process. Error:
  /// there are too many domains for so small a box.
  DistributedEngine(World empty, Travelers brought, const PhaseSettings& phase, const Division& division,
                    const Time& now, Processes& processes)
      : processes_(processes),
        empty_(std::move(empty)),
        phase_(phase),
        layout_(division, processes.size()),
        team_(std::make_unique<ThreadTeam>(division.threads)) {
    const SystemSize size = size_of(brought, now);
    spheres_ = size.spheres;
    layout_.lay_out(empty_.box(), size, sample_centers(brought, now));
    occupy(std::move(brought), now);
  }

  /// As Engine::run. Adds to `sums` the contacts that are counted in this process. If contacts are observed,
  /// the first process tells its observer of all, in order. Asks RunLimits::stop of the first process.
  RunStatus run(const RunLimits& limits, Sums& sums, bool is_observed, const Observe& observe) {
    const ThreadTeam::Pinned pinned(*team_);
    cluster_->clear_sums(sums);
    try {
      const RunStatus status = run_windows(limits, sums, is_observed, observe);
      cluster_->add_sums_to(sums);
      return status;
    } catch (...) {
      if (cluster_) cluster_->add_sums_to(sums);  // otherwise it has failed to divide the system anew
      throw;
    }
  }

  /// As Engine::change_velocities, of spheres by id, whichever process owns them. Precondition: all contacts
  /// before `moment` have been handled, and none after it.
  void change_velocities(const Time& moment, std::span<const VelocityEdit> edits) {
    // Crossings may have been handled that happen in the same double, but later.
    if (now() > moment) occupy_anew(own_travelers(), moment);
    cluster_->each([&](Member& domain, std::size_t) {
      for (const VelocityEdit& edit : edits) domain.change_velocity(edit.id, edit.velocity, moment);
    });
  }

  /// The time up to which events have been handled.
  Time now() const { return cluster_->now(); }
  /// Contacts of the whole system, and the other work of all processes.
  Counters counters() const {
    Counters own;
    for (std::size_t k = 0; k < cluster_->size(); ++k) own = own + cluster_->domain(k).engine().counters();
    Counters all;
    for (const Counters& counters : processes_.gather(own)) all = all + counters;
    all.collision = cluster_->counted().collision;
    all.wall = cluster_->counted().wall;
    return counters_ + all;
  }
  WindowCounters window_counters() const { return windows_ + cluster_->window_counters(); }
  /// The last contact of spheres that passed through each other; see World.
  const Event& last_passage() const { return cluster_->domain(0).world().last_passage(); }
  PhaseLengths lengths() const { return cluster_->domain(0).engine().lengths(); }
  /// Of this process alone.
  std::size_t memory_bytes() const {
    std::size_t bytes = 0;
    for (std::size_t k = 0; k < cluster_->size(); ++k) bytes += cluster_->domain(k).memory_bytes();
    return bytes;
  }
  /// Calls visit(world, slot, idle_contacts) for every sphere of this process; see CollapseGuard.
  template <class Visit>
  void for_each_own(Visit&& visit) const {
    for (std::size_t k = 0; k < cluster_->size(); ++k) {
      const auto& domain = cluster_->domain(k);
      const CollapseGuard& collapse = domain.engine().aftermath().collapse;
      for (Slot slot = 0; slot < domain.world().size(); ++slot) {
        if (domain.residents().is_own(slot))
          visit(domain.world(), slot, collapse.idle_contacts(domain.world().id(slot)));
      }
    }
  }
  /// Calls visit(world) for every domain of this process, whose world has copies of spheres near it, too.
  template <class Visit>
  void for_each_domain(Visit&& visit) const {
    for (std::size_t k = 0; k < cluster_->size(); ++k) visit(cluster_->domain(k).world());
  }
  void validate() const {
    for (std::size_t k = 0; k < cluster_->size(); ++k) {
      cluster_->domain(k).engine().validate();
      cluster_->domain(k).validate();
    }
  }

 private:
  using DomainEngine = Engine<Queue, Phase>;
  using Domains = Cluster<DomainEngine, Sums>;
  using Member = typename Domains::Member;

  // Makes the domains of the layout that are in this process.
  void occupy(Travelers brought, const Time& now) {
    const Partition& partition = layout_.partition();
    const DomainsOfProcess domains{partition.size() / processes_.size()};
    World world = empty_;
    Aftermath aftermath;
    const auto send_to_owner = [&](const Traveler& traveler, const auto& send_to) {
      send_to(domains.process_of(partition.domain_at(position_of(traveler, now))));
    };
    insert(sent(std::move(brought), processes_, send_to_owner), world, [&](const Traveler& traveler) {
      aftermath.collapse.set_idle_contacts(traveler.state.id, traveler.idle_contacts);
    });
    insert(near_others(world, domains, now), world, [](const Traveler&) {});
    world.reorder(order_along_curve(world, now));
    const auto first = static_cast<DomainNumber>(processes_.rank() * domains.each);
    cluster_ = std::make_unique<Domains>(
        make_domains<DomainEngine, Sums, Phase>(layout_, first, domains.each, world, now, aftermath, phase_,
                                                team_->as_function()),
        now, layout_.windows(), team_->as_function(), Exchange(processes_, domains));
  }

  Vec3 position_of(const Traveler& traveler, const Time& now) const {
    Vec3 position = empty_.motion().position_at(traveler.state.path, now);
    empty_.box().fold(position);
    return position;
  }

  SystemSize size_of(const Travelers& brought, const Time& now) const {
    SystemSize own;
    brought.for_each([&](const Traveler& traveler) {
      own.note(length(empty_.motion().velocity_at(traveler.state.path, now)), traveler.state.radius);
    });
    SystemSize all;
    for (const SystemSize& other : processes_.gather(own)) all.add(other);
    return all;
  }

  // Enough centers to divide the whole evenly.
  std::vector<Vec3> sample_centers(const Travelers& brought, const Time& now) const {
    constexpr std::uint64_t kSample = 1 << 18;
    const std::uint64_t every = spheres_ / kSample + 1;
    std::vector<Vec3> own;
    brought.for_each([&](const Traveler& traveler) {
      if (traveler.state.id % every == 0) own.push_back(position_of(traveler, now));
    });
    std::vector<Vec3> centers;
    for (const std::string& part : processes_.gather(bytes_of(own))) append_bytes(part, centers);
    return centers;
  }

  // What others must know of these spheres here: copies of those near domains in other processes are
  // exchanged.
  Travelers near_others(const World& own, const DomainsOfProcess& domains, const Time& now) const {
    std::vector<std::vector<DomainNumber>> neighbors;
    for (std::size_t k = 0; k < domains.each; ++k) {
      const auto number = static_cast<DomainNumber>(processes_.rank() * domains.each + k);
      neighbors.push_back(layout_.partition().neighbors(number, layout_.halo().neighborhood()));
    }
    std::vector<std::size_t> processes;
    const auto find_processes_near = [&](const Vec3& position) {
      processes.clear();
      for (const DomainNumber near : neighbors[layout_.partition().domain_at(position) % domains.each]) {
        const std::size_t process = domains.process_of(near);
        if (process == processes_.rank() || std::ranges::find(processes, process) != processes.end())
          continue;
        if (layout_.partition().block(near).distance(position) <= layout_.halo().depth)
          processes.push_back(process);
      }
    };
    Travelers wanted;
    for (Slot slot = 0; slot < own.size(); ++slot) {
      find_processes_near(own.position(slot, now));
      if (!processes.empty()) wanted.push_back({own.state_of(slot)});
    }
    return sent(std::move(wanted), processes_, [&](const Traveler& traveler, const auto& send_to) {
      find_processes_near(position_of(traveler, now));
      std::ranges::for_each(processes, send_to);
    });
  }

  // Whether the first process is told to stop.
  bool is_told_to_stop(const RunLimits& limits) const {
    return processes_.gather(processes_.is_first() && limits.stop && limits.stop() ? 1 : 0).front() == 1;
  }

  Travelers own_travelers() const {
    Travelers own;
    for_each_own([&](const World& world, Slot slot, std::uint32_t idle_contacts) {
      own.push_back({world.state_of(slot), idle_contacts});
    });
    return own;
  }

  // Divides the system anew if that pays.
  void review_division(Sums& sums) {
    if (!layout_.is_review_due(cluster_->window_counters().windows)) return;
    const Load load = cluster_->load();
    if (!layout_.may_improve(load, spheres_)) return;
    const Time now = cluster_->now();
    Travelers own = own_travelers();
    if (!layout_.improve(load, empty_.box(), size_of(own, now), sample_centers(own, now))) return;
    cluster_->add_sums_to(sums);
    occupy_anew(std::move(own), now);
    cluster_->clear_sums(sums);
  }

  // Precondition: nothing but crossings has been handled since `moment`.
  void occupy_anew(Travelers own, const Time& moment) {
    counters_ = counters();
    ++counters_.rebuilds;
    windows_ = window_counters();
    empty_.note_passage(last_passage());
    cluster_.reset();  // so that there is memory for others
    occupy(std::move(own), moment);
  }

  RunStatus run_windows(const RunLimits& limits, Sums& sums, bool is_observed, const Observe& observe) {
    std::uint64_t contacts = limits.contacts;
    while (contacts > 0) {
      if (is_told_to_stop(limits)) return RunStatus::stopped;
      const bool has_end = std::isfinite(limits.until.high);
      if (!has_end && !cluster_->has_events()) return RunStatus::time_reached;
      const double end = within_range(limits.until).high;
      contacts -= cluster_->open_window(end, contacts, {.log = is_observed});
      if (is_observed) deliver(observe);
      cluster_->commit_window();
      if (cluster_->committed() == end && cluster_->is_complete()) return RunStatus::time_reached;
      review_division(sums);
    }
    return RunStatus::contacts_reached;
  }

  // Tells the first process of the contacts of the open window.
  void deliver(const Observe& observe) {
    // By domain.
    std::vector<std::vector<LoggedContact>> logs(processes_.is_first() ? layout_.partition().size() : 0);
    for (std::size_t k = 0; k < cluster_->size(); ++k) {
      std::size_t domain = k;
      for (const std::string& log : processes_.gather_in_first(bytes_of(cluster_->domain(k).log()))) {
        append_bytes(log, logs[domain]);
        domain += cluster_->size();
      }
    }
    MergedLog merged({logs.begin(), logs.end()});
    std::uint64_t told = 0;
    for (const Contact* contact = merged.next(); contact; contact = merged.next(), ++told) observe(*contact);
    HARDBALL_CHECK(!processes_.is_first() || told == cluster_->open_contacts());
  }

  Processes& processes_;
  World empty_;
  PhaseSettings phase_;
  std::uint64_t spheres_ = 0;  // in all processes
  Layout layout_;
  Counters counters_;  // of earlier divisions
  WindowCounters windows_;
  std::unique_ptr<ThreadTeam> team_;
  std::unique_ptr<Domains> cluster_;
};

}  // namespace hardball
