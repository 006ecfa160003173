// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "hardball/engine/run.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/measure/tally.hpp"
#include "hardball/response/contact.hpp"
#include "hardball/simulation/any_engine.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

class Measures;

/// A contact that lies ahead.
struct NextContact {
  double time = 0;  ///< [T]
  EventKind kind = EventKind::collision;
  SphereId first = 0;
  std::uint32_t second = 0;  ///< The id of the other sphere, or the Face of the box.
};

/// Spheres in motion: the one face of Hardball.
///
/// Every collision happens exactly when it should and in order; the history does not depend on the options,
/// on how a run is cut into pieces, or on what is asked in between. Copies are independent of each other, and
/// share only what their listeners and response refer to.
class Simulation {
 public:
  /// Starts at the latest time at which a sphere was added to the world, or zero. Spheres added earlier have
  /// moved freely until then and start a new path there; to continue a history, copy the simulation. Reports
  /// to `on_progress` how much of the set-up is done. Error: spheres that overlap or reach through a wall at
  /// the start; invalid options (see EngineOptions).
  explicit Simulation(World world, const EngineOptions& options = {}, const OnProgress& on_progress = {});
  Simulation(const Simulation& other);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation other) noexcept;
  ~Simulation();

  /// Called after every collision and wall contact, when the contact has been carried out and time() is its
  /// moment. What it throws ends the run after that contact, and the simulation can go on.
  ///
  /// The listener may ask for the state, copy the simulation, and edit it: change_velocity, add, remove, and
  /// replace response or listener. An edit takes effect at once, before any other event, those of the same
  /// moment included; so the history is the same for every engine. It may not run the simulation, ask what
  /// lies ahead, move it, assign to it or destroy it; nor edit it while measures look on. Error, from such
  /// calls: see check_idle and check_editable below for what they say.
  void on_contact(std::function<void(const Contact&)> listener);

  /// Replaces what contacts do to velocities; see Response. Between contacts the spheres must not be made to
  /// approach. The response may not run or edit the simulation (Error). Error, from running: the velocities
  /// returned still approach, or are not finite and of magnitude at most 1e60; the contact has not happened.
  void respond_with(std::function<Velocities(const Contact&)> response);

  /// Runs to `time` [T], events at that very moment included. Error: `time` is before now, NaN, or finite and
  /// beyond 1e120.
  void run_until(double time);
  /// The same, and lets `measures` look on; see Measures.
  void run_until(double time, Measures& measures);
  /// Runs until `count` contacts have happened, and not past `until` [T]; returns how many did happen.
  /// Where spheres may part for ever, in open space or a periodic box, give a finite time.
  std::uint64_t run_contacts(std::uint64_t count, double until = std::numeric_limits<double>::infinity());
  /// Runs until the first of the limits is met. Error: RunLimits::until, as for run_until.
  RunStatus run(const RunLimits& limits);
  /// The same, and lets `measures` look on. The spheres must be those with which the measures began.
  RunStatus run(const RunLimits& limits, Measures& measures);

  /// The next collision or wall contact up to `until` [T], which does not yet happen. In a periodic box
  /// spheres may miss each other for ever: then give a finite time. Error: `until`, as for run_until.
  std::optional<NextContact> next_contact(double until = std::numeric_limits<double>::infinity());

  double time() const { return now_.value(); }  ///< [T]
  const Time& now() const { return now_; }

  /// Centre now [L], folded into a periodic box. Error: no sphere has this id.
  Vec3 position(SphereId id) const;
  /// [L/T] Error: no sphere has this id.
  Vec3 velocity(SphereId id) const;
  /// All centres now [L], in the order of ids, folded into a periodic box. Shape (size, 3).
  std::vector<Vec3> positions() const;
  /// All centres at `time` [L], finite, not before now and not past the next contact. Error: any other time.
  std::vector<Vec3> positions_at(double time);

  /// Gives a sphere a new velocity [L/T], now. Error: no such sphere, a number that is NaN, infinite or out
  /// of range.
  void change_velocity(SphereId id, const Vec3& velocity);
  /// Adds a sphere, now. Cost: O(n). Error: see World::add; it overlaps another sphere.
  SphereId add(const Sphere& sphere);
  /// Removes a sphere, now. Cost: O(n). Error: no sphere has this id.
  void remove(SphereId id);

  const World& world() const;
  std::size_t size() const { return world().size(); }

  Counters counters() const;
  /// Hash of all contacts so far, see EventLogHash.
  std::uint64_t event_log_hash() const { return hash_.value(); }
  const Tally& tally() const { return tally_; }
  /// The engine that runs, never `automatic`.
  EngineKind engine() const { return kind_; }
  /// Edges of a cell along each axis [L], a corner of one lying at the origin; zero if the engine has no
  /// cells.
  Vec3 cell_edges() const;
  /// Mean edge of the cells [L]; zero if the engine has none.
  double cell_edge() const;
  /// Radius of the ball in which a sphere moves before its list of neighbours changes [L]; zero if there are
  /// no lists.
  double slack() const;
  std::size_t memory_bytes() const;
  /// Checks all structures; throws BrokenInvariant. Cost: that of predicting all pairs of candidates.
  void validate() const;

 private:
  // What is going on, which decides what may be called.
  enum class Activity {
    none,       // nothing: everything may be called
    running,    // events are being handled; the response may be at work
    listening,  // the listener is at work
    measuring,  // the listener is at work, and measures depend on the spheres
  };

  // Back to what it was when the scope ends.
  class During {
   public:
    During(Activity& activity, Activity now) : activity_(activity), before_(activity) { activity = now; }
    ~During() { activity_ = before_; }
    During(const During&) = delete;
    During& operator=(const During&) = delete;

   private:
    Activity& activity_;
    Activity before_;
  };

  RunStatus run_observed(const RunLimits& limits, Measures* measures);
  void take_next_listener();
  void call_listener(const Contact& contact, Activity activity);
  void check_idle(const char* what) const;
  void check_editable(const char* what) const;
  void check_not_past(const Time& time) const;
  void apply_edits();
  void retune_if_due();
  void rebuild(const Time& moment);

  EngineOptions options_;
  EngineKind kind_ = EngineKind::cells;  // what the options make of it
  std::unique_ptr<AnyEngine> engine_;
  std::function<Velocities(const Contact&)> response_;  // the user's own, if there is one
  Counters counters_before_;                            // of engines given up
  std::function<void(const Contact&)> listener_;
  std::optional<std::function<void(const Contact&)>> next_listener_;  // given by the listener itself
  Activity activity_ = Activity::none;
  Time now_;
  EventLogHash hash_;
  Tally tally_;
  CellEdgeWatch watch_;
  bool edited_ = false;          // the engine's structures do not know the world any more
  std::uint64_t next_look_ = 0;  // the number of crossings and contacts at which to look again
  Time last_look_;
};

}  // namespace hardball
