// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/packing/mesh_walls.hpp"
#include "hardball/packing/packing_plan.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball {

/// A moment in the history of a packing.
struct PackingMoment {
  std::uint64_t collisions = 0;
  double packing_fraction = 0;  ///< [1]
  double pressure = 0;          ///< PV/NkT of the median sphere in the window before [1].
  double rate = 0;              ///< As in GrowthRules; zero while sizes were constant.

  friend bool operator==(const PackingMoment&, const PackingMoment&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.collisions, self.packing_fraction, self.pressure, self.rate);
  }
};

/// Packs spheres: lets them grow in a random fluid until they are as dense as planned, or have jammed.
///
/// The history depends on the plan alone, and not on how a run is split, nor on the number of threads.
class HARDBALL_EXPORT Packer {
 public:
  enum class State : std::uint8_t {
    filling,   ///< Spheres grow fast while the fluid is dilute.
    growing,   ///< Spheres grow at the rate planned.
    relaxing,  ///< Sizes are constant between steps of growth.
    stepping,  ///< Spheres grow by one step.
    weighing,  ///< Sizes are constant for the last pressure and the forces.
    reached,   ///< Spheres are as dense as planned.
    jammed,    ///< Spheres are as dense as they get.
    locked,    ///< Spheres could not be made as dense as planned.
  };

  /// Places the spheres. Error: they cannot be placed; they overlap at the start.
  explicit Packer(PackingPlan plan, const EngineOptions& options = {}, const OnProgress& on_progress = {});

  const PackingPlan& plan() const { return plan_; }
  State state() const { return state_; }
  bool is_over() const { return state_ >= State::reached; }
  /// Runs on for a while, at most some hundred thousand collisions. Precondition: it is not over.
  void advance();

  const Simulation& simulation() const { return simulation_; }
  /// Whether packing ended because the largest sphere just fits.
  bool has_no_room() const { return has_no_room_; }
  /// The packing fraction at the present sizes [1].
  double packing_fraction() const;
  /// PV/NkT of the median sphere in the last window [1]; NaN before the first.
  double pressure() const { return pressure_; }
  /// All collisions and wall contacts so far, those of attempts that were given up included.
  std::uint64_t collisions() const;
  /// As in GrowthRules: that of the plan, or a lower one after attempts in which spheres locked.
  double rate() const { return rate_; }
  const std::vector<PackingMoment>& history() const { return history_; }
  /// The impulses that bodies exchanged while they were weighed [M L/T], images being those of positions();
  /// none but of spheres that have jammed. Cost: O(n).
  std::unordered_map<ContactKey, double> impulses() const;
  /// The share of the run that is done, by what was expected [1].
  double share_done() const;

  /// The whole state, from which `load` continues to the same history. Cost: O(n).
  std::string save() const;
  /// Error: the bytes are not from `save`.
  static Packer load(std::string_view bytes, const std::string& where);

  /// Lets `threads` threads share the work; affects only the speed.
  void set_threads(std::size_t threads) { simulation_.set_threads(threads); }

 private:
  friend class Persistence;
  Packer() : simulation_(World()) {}
  static void persist(auto& archive, auto& self) {
    constexpr bool kIsReading = std::remove_cvref_t<decltype(archive)>::kIsReading;
    std::string simulation;
    if constexpr (!kIsReading) simulation = self.simulation_.save();
    archive(simulation, self.plan_, self.state_, self.end_, self.rate_, self.attempts_, self.recounts_,
            self.given_up_, self.filled_, self.speed_, self.pressure_, self.virial_, self.energy_integral_,
            self.window_begin_, self.patience_, self.has_no_room_, self.steps_, self.weighed_at_,
            self.impulses_, self.history_, self.mean_pressure_, self.step_, self.has_locked_,
            self.most_that_fit_, self.least_that_do_not_, self.is_count_final_, self.is_sized_,
            self.too_dilute_, self.too_dense_, self.before_step_);
    if constexpr (kIsReading) {
      self.simulation_ = Simulation::load(simulation, kWhereSaved);
    }
  }
  bool restored() const;
  static constexpr const char* kWhereSaved = "the saved packing";

  void record(const Contact& contact);
  std::uint32_t wall_of(const Contact& contact);
  std::uint64_t contacts() const { return simulation_.counters().contacts(); }
  double contacts_for(double collisions) const {
    return collisions * static_cast<double>(simulation_.size());
  }
  void open_window();
  void close_window(double rate);
  bool run_at_constant_size(double collisions);
  void grow(double rate, double fraction);
  void begin_growing();
  void halve_speeds();
  void change_velocities(const Function<Vec3(SphereId)>& velocity_of);
  void be_patient();
  void relax();
  void step();
  void take_diameter();
  double bearing_pressure() const;
  double change_to_pressure() const;
  void forget_bracket();
  void renew_velocities();
  void go_back_to(const std::string& saved);
  void weigh(State end);
  void after_epoch();
  void after_step();
  void after_relaxation();
  void after_weighing();
  void end_attempt();
  void give_up_attempt();
  void begin();
  bool begins_with_another_count();
  void begin_with(std::size_t count);
  double mean_diameter() const;
  double wanted_pressure() const;
  bool is_next_to_pressure() const;
  bool has_pressure_wanted() const;
  double end_fraction() const;
  bool is_at_end() const;
  bool is_near_end() const;

  PackingPlan plan_;
  Simulation simulation_;
  State state_ = State::filling;
  State end_ = State::reached;  // after weighing
  double rate_ = 0;
  int attempts_ = 0;            // that were given up
  int recounts_ = 0;            // how often packing began anew with another count
  std::uint64_t given_up_ = 0;  // collisions in them
  std::string filled_;          // the simulation before it grew at the rate planned
  double speed_ = 0;            // thermal, at the start [L/T]
  double pressure_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> virial_;      // of each sphere in the window [M L^2/T]
  double energy_integral_ = 0;      // when the window began
  std::uint64_t window_begin_ = 0;  // in contacts of the simulation
  double patience_ = 0;             // when a window at constant size ends at the latest [T]
  bool has_no_room_ = false;
  int steps_ = 0;                  // of growth between relaxations
  double mean_pressure_ = 0;       // of all spheres in the last window
  double step_ = 1;                // over the longest, since growth failed in one
  bool has_locked_ = false;        // in such a step
  std::string before_step_;        // the simulation before the last one
  std::size_t most_that_fit_ = 0;  // of the counts tried
  std::size_t least_that_do_not_ = std::numeric_limits<std::size_t>::max();
  bool is_count_final_ = false;
  bool is_sized_ = false;  // spheres have the diameter planned
  // The last packing fractions at which the pressure was too low and too high; none if zero and infinite.
  double too_dilute_ = 0;
  double too_dense_ = std::numeric_limits<double>::infinity();
  std::vector<Vec3> weighed_at_;  // centers when weighing began, to which the images of impulses refer [L]
  std::unordered_map<ContactKey, double> impulses_;
  std::optional<MeshWalls> mesh_walls_;  // of a mesh, once they are needed
  std::vector<PackingMoment> history_;
};

template <>
inline constexpr std::array<std::string_view, 8> kNames<Packer::State>{
    "filling", "growing", "relaxing", "stepping", "weighing", "reached", "jammed", "locked"};

}  // namespace hardball
