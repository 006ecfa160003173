// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "hardball/domains/division.hpp"
#include "hardball/domains/domain_group.hpp"
#include "hardball/domains/layout.hpp"
#include "hardball/domains/sphere_transfer.hpp"
#include "hardball/domains/system_size.hpp"
#include "hardball/domains/thread_team.hpp"
#include "hardball/engine/engine_base.hpp"
#include "hardball/processes/processes.hpp"

namespace hardball {

/// Runs one system in several domains, in as many threads as wanted, and perhaps in several processes, each
/// of which has some of the domains.
///
/// A process holds the spheres of its domains and those near them; all others, too, from when somebody first
/// asks for the world. A window of time is taken whole: the number of steps limits only the start of windows.
/// RunLimits::stop is not asked.
class DomainsEngine final : public EngineBase {
 public:
  /// Divides a world as it is at `now`, which all processes have whole. `division` is that of each process.
  /// Precondition: as for Engine; the features of the setting go with threads. Error: the box is too small
  /// for this many processes.
  DomainsEngine(World world, const PhaseSettings& phase, const Division& division, const Time& now,
                Processes& processes = one_process());
  /// Divides a system of which each process brings some of the spheres, wherever they are; all are brought
  /// once. `empty`: the world without spheres. Precondition and error: as for the other constructor.
  DomainsEngine(World empty, SphereTransfers brought, const PhaseSettings& phase, const Division& division,
                const Time& now, Processes& processes);
  DomainsEngine(const DomainsEngine& other);
  std::unique_ptr<EngineBase> clone() const override { return std::make_unique<DomainsEngine>(*this); }

  const World& world() const override {
    gather();
    return world_;
  }
  World& mutable_world() override;
  const World& setting() const override { return world_; }
  std::size_t size() const override { return holds_all_ ? world_.size() : spheres_; }
  Time now() const override { return is_open_ ? now_ : group_->now(); }
  Counters counters() const override;
  bool are_threads_hindered() const override { return team_->is_hindered(); }
  WindowCounters windows() const override { return windows_before_ + group_->window_counters(); }
  std::size_t memory_bytes() const override;
  /// The lengths of the first domain.
  PhaseLengths lengths() const override { return group_->domain(0).engine().lengths(); }
  std::vector<Block> blocks() const override;
  GasStatistics statistics(const Time& moment) const override;
  Totals totals(const Time& moment) const override;
  Audit audit(const Time& moment) const override;
  const Event& last_passage() const override;
  bool has_spins() const override;
  void for_each_sphere(const Function<void(const World&, Slot)>& visit) const override;
  std::vector<SphereSearch::Part> search_parts(const Time& moment) const override;
  const World& sample() const override;
  void for_each(std::size_t count, const Function<void(std::size_t)>& work) override;

  RunStatus run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) override;
  std::optional<Event> next_contact(const Time& until) override;

  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) override;
  void put(const Time& moment, std::span<const NewPlace> places) override;
  SphereId add(const Sphere& sphere, const Time& moment) override;
  void remove(SphereId id, const Time& moment) override;

  bool needs_rebuild() const override { return needs_rebuild_; }
  void rebuild(const Time& now, const PhaseSettings& settings) override;

  void begin_journal(const Time& moment) override;
  void end_journal() override;
  void rewind(const Time& moment) override;
  void rewind_to_begin() override;

  PostContactState post_contact_state() const override;
  void take_over(const PostContactState& post_contact_state) override;

  void validate() const override;

  /// The spheres of this process.
  SphereTransfers own_transfers() const;

 private:
  struct LookAhead {
    World world;
    PostContactState post_contact_state;
    Counters counters;
  };
  struct Gathering {
    std::mutex mutex;
    std::atomic<bool> is_done{true};  // whether the world is up to date
  };

  bool is_alone() const { return processes_->size() == 1; }
  const Partition& partition() const { return layout_.partition(); }
  DomainsOfProcess domains_of_process() const { return {partition().size() / processes_->size()}; }

  // Precondition: the world is up to date, and has all spheres.
  void divide(const Time& now);
  std::vector<Vec3> centers(const Time& now) const;
  void occupy(const World& world, const PostContactState& post_contact_state, const Time& now);
  // Lays out and occupies domains where each process brings some of the spheres.
  void lay_out(const SphereTransfers& brought, const Time& now);
  void occupy(SphereTransfers brought, const Time& now);
  Vec3 position_of(const SphereTransfer& transfer, const Time& now) const;
  SystemSize size_of(const SphereTransfers& brought, const Time& now) const;
  std::vector<Vec3> sample_centers(const SphereTransfers& brought, const Time& now) const;
  SphereTransfers near_others(const World& own, const Time& now) const;

  CollapseGuard own_counts() const;
  void outdate();
  void end_division();
  void keep_for_rewind();
  void gather() const;
  void gather_changed_here(const Time& now) const;
  void gather_changed_elsewhere(const std::vector<SphereState>& changed, const Time& now) const;
  void gather_all() const;
  template <class Visit>
  void take_changed(Visit&& visit) const;

  void add_sums_to(ContactSums& sums) const;
  RunStatus run_windows(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer);
  bool run_window(double end, std::uint64_t most, ContactSums& sums, const ContactObserver& observer);
  std::uint64_t steps_so_far() const;
  std::exception_ptr tell(const ContactObserver& observer);
  bool deliver(ContactSums& sums, const ContactObserver& observer);
  void apply(const Contact& contact);
  void settle();
  void close();
  void review_division(ContactSums& sums, bool have_sums);

  Processes* processes_;
  PhaseSettings phase_;
  std::uint64_t spheres_ = 0;  // in all processes, unless the world has all
  mutable bool holds_all_;     // whether the world has all spheres, up to date or not
  mutable World world_;
  mutable World sample_{Box::open()};
  std::unique_ptr<ThreadTeam> team_;
  Layout layout_;
  std::unique_ptr<DomainGroup> group_;
  Counters counters_;  // of earlier divisions
  WindowCounters windows_before_;
  PostContactState post_contact_;  // while outdated
  std::unique_ptr<Gathering> gathering_ = std::make_unique<Gathering>();
  bool needs_rebuild_ = false;
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
