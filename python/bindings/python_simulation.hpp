// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "python/bindings/callback.hpp"
#include "python/bindings/event_records.hpp"
#include "python/bindings/run_output.hpp"

namespace hardball::python {

/// A simulation as Python holds it: runs without the interpreter's lock that Ctrl-C ends, the arrays of the
/// present state, and the measures and functions that belong to it.
///
/// While it runs in one thread, the others are refused; a listener or response runs in the same thread and
/// may do what the library allows, but not run it again.
class PythonSimulation {
 public:
  /// Memory of zeros: pybind11 hands out objects whose classes in Python have not called __init__, which are
  /// recognized by it.
  static void* operator new(std::size_t size);
  static void operator delete(void* memory);

  explicit PythonSimulation(Simulation simulation) : simulation_(std::move(simulation)) {}
  PythonSimulation(const PythonSimulation& other);
  PythonSimulation(PythonSimulation&& other);

  /// Error, of both: __init__ has not been called; RunFailure: it is running in another thread.
  const Simulation& simulation() const;
  /// To be changed: arrays made before are of the past.
  Simulation& simulation_to_edit();

  /// What `make` returns, or has returned before for this name and the present state.
  template <class Make>
  auto of_state(std::string_view name, Make&& make) {
    using Object = decltype(make());
    simulation();
    // Whatever Python does meanwhile, a reference into the map would not outlive.
    if (const auto found = of_state_.find(name); found != of_state_.end())
      return pybind11::reinterpret_borrow<Object>(found->second);
    Object object = make();
    of_state_[name] = object;
    return object;
  }

  /// Runs until the first of the limits is met, and returns the contacts if `record`, otherwise their number.
  /// `on_progress`, a function or None, is called several times a second with the time. Error: as for
  /// Simulation::run; a Python exception of the functions called, or KeyboardInterrupt.
  pybind11::object run(std::optional<double> until, std::optional<std::uint64_t> collisions,
                       std::optional<std::uint64_t> contacts, bool record,
                       const pybind11::object& on_progress);
  /// Runs to the next contact up to `until` [T] and returns it; nothing, at `until`, if there is none.
  std::optional<Contact> step(double until);
  /// The next contact up to `until` [T], without carrying it out. Error: KeyboardInterrupt, too.
  std::optional<NextContact> next_event(double until);
  /// See the functions of these names in Simulation. Error: KeyboardInterrupt, too, here and below.
  std::optional<NextContact> first_contact(SphereId id, const Vec3& velocity, double until) const;
  std::optional<RayHit> ray(const Vec3& origin, const Vec3& direction, double most,
                            const BodyMask& mask) const;
  std::vector<RayHit> ray_hits(const Vec3& origin, const Vec3& direction, double most,
                               const BodyMask& mask) const;
  std::vector<std::optional<RayHit>> rays(std::vector<Vec3> origins, std::vector<Vec3> directions,
                                          double most, const BodyMask& mask, std::size_t threads) const;
  /// See Simulation::contacts_within.
  std::vector<Contact> contacts_within(double duration, std::uint64_t most);
  /// Records in a file how the simulation would continue, up to `until` [T] or for a number of contacts,
  /// without interference: listeners are not called. Error: as for run; the recording grows beyond
  /// `most_bytes`.
  void record_ahead(const std::filesystem::path& path, double until, std::uint64_t contacts,
                    std::uint64_t most_bytes) const;
  /// See Simulation::positions_at.
  std::vector<Vec3> positions_at(double time);

  /// See Simulation::change_velocities; the measures record the edits.
  void change_velocities(std::span<const VelocityEdit> edits);

  /// Replaces the function called after every contact, or the response; None removes it.
  void set_listener(const pybind11::object& listener);
  void set_response(const pybind11::object& response);
  const std::optional<Callback>& response() const { return response_; }
  /// Replaces the thermostat; None removes it.
  void set_thermostat(const pybind11::object& thermostat, std::uint64_t seed);

  /// Measures from now on what the settings say. Error: it is running.
  void set_measures(const MeasureSettings& settings);
  /// Warns of an edit (UserWarning) if the measures have begun, and have not been warned of before.
  void warn_of_edit(const char* what);
  /// Error: measures are on, during which spheres cannot change.
  void check_spheres_may_change(const char* what) const;
  /// Error: a recording is being written, which allows no other spheres and no other rules.
  void check_not_recording(const char* what) const;
  void restore_measures(std::string_view bytes, const std::string& where);
  std::string save_measures() const;
  std::vector<Measurement> results() const;
  std::vector<FaceForces> face_forces() const;

  /// The scenario that this is made from; null if there is none.
  const std::shared_ptr<const Origin>& origin() const { return origin_; }
  void set_origin(std::shared_ptr<const Origin> origin) { origin_ = std::move(origin); }

  /// Writes the present frame to a file, which is replaced, or continued if `appends` and it exists. Error:
  /// see Trajectory.
  void write(const std::filesystem::path& path, bool appends);
  /// Writes files during all further runs, as the scenario with these overrides says. Error: files are being
  /// written already; see RunOutput; here and below, it is running.
  void begin_output(const std::vector<std::string>& overrides, bool overwrites);
  /// Continues the files of a checkpoint.
  void continue_output(Origin origin, const cli::FilesState& files, const cli::RunState& state);
  /// Completes the files, and writes the results; does nothing if no files are being written. Error
  /// (RunFailure): that is impossible.
  void end_output(bool is_complete);
  /// Makes the recording that is being written complete up to now. Error: it is running; RunFailure: that is
  /// impossible.
  void flush_recording();
  /// The directory of the files that are being written; nothing without.
  std::optional<std::filesystem::path> output_directory() const;
  /// See end_of.
  RunEnd end() const;

  /// Calls visit(object) for each Python object that this refers to, for the garbage collector, until it
  /// returns something but zero, which is returned.
  template <class Visit>
  int visit_references(Visit&& visit) const {
    for (const std::optional<Callback>* callback : {&listener_, &response_}) {
      if (!*callback) continue;
      if (const int stop = visit((*callback)->function().ptr())) return stop;
    }
    return 0;
  }
  /// Drops what may refer back to this.
  void drop_references();

  /// The time at which a run without a limit ends [T].
  std::optional<double> until() const;
  void set_until(std::optional<double> until);

 private:
  // The time in which this thread alone has the simulation.
  class Claim;

  void check_idle(const char* what) const;
  void listen();
  RunStatus run_interruptibly(RunLimits limits, const Function<void()>& look = {});
  RunStatus run_a_step(RunLimits limits);
  RunStatus run_and_write(const RunLimits& limits, const Function<void()>& look = {});
  double usual_wait() const;
  template <class Query>
  auto search(double begin, double span, double end, Query&& query) const;
  double usual_length() const;
  template <class Watch, class Check>
  void run_ahead(double until, std::uint64_t contacts, Watch&& watch, Check&& check) const;

  bool is_made_ = true;
  Simulation simulation_;
  std::optional<double> until_;
  Measures measures_{{.names = {}}};
  bool has_warned_ = false;  // of an edit while these measure
  // Not shared with copies: the garbage collector counts references.
  std::optional<Callback> listener_;
  std::optional<Callback> response_;
  std::optional<EventRecords> records_;  // while they are recorded
  std::optional<Contact> last_;          // of a step
  bool is_stepping_ = false;
  bool hears_steps_ = false;  // the listener of the simulation notes them
  mutable std::optional<std::thread::id> runner_;
  std::map<std::string_view, pybind11::object> of_state_;
  std::shared_ptr<const Origin> origin_;
  std::unique_ptr<RunOutput> output_;                     // copies have none
  std::map<std::filesystem::path, Trajectory> appended_;  // files to which frames are appended
  cli::Seconds seconds_;                                  // spent in runs without output
};

}  // namespace hardball::python
