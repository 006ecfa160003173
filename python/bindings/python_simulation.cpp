// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/python_simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include "apps/cli/seconds_since.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/processes/in_all.hpp"
#include "hardball/recording/recording_header.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "python/bindings/processes.hpp"
#include "python/bindings/responses.hpp"
#include "python/bindings/thermostats.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

void throw_if_interrupted() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

// Sets a variable until the end of the scope.
template <class Value>
class Setting {
 public:
  Setting(Value& variable, Value value)
      : variable_(variable), before_(std::exchange(variable, std::move(value))) {}
  ~Setting() { variable_ = std::move(before_); }
  Setting(const Setting&) = delete;

 private:
  Value& variable_;
  Value before_;
};

}  // namespace

class PythonSimulation::Claim {
 public:
  explicit Claim(const PythonSimulation& owner) : runner_(owner.runner_, std::this_thread::get_id()) {}

 private:
  Setting<std::optional<std::thread::id>> runner_;
};

void* PythonSimulation::operator new(std::size_t size) {
  return std::memset(::operator new(size), 0, size);
}

void PythonSimulation::operator delete(void* memory) {
  ::operator delete(memory);
}

PythonSimulation::PythonSimulation(const PythonSimulation& other)
    : simulation_(other.simulation()),
      until_(other.until_),
      measures_(other.measures_),
      has_warned_(other.has_warned_),
      origin_(other.origin_),
      seconds_(other.seconds_) {
  if (other.response_) set_response(other.response_->function());
  set_listener(other.listener_ ? other.listener_->function() : py::none());
}

PythonSimulation::PythonSimulation(PythonSimulation&& other)
    : simulation_((other.check_idle("Simulation"), std::move(other.simulation_to_edit()))),
      until_(other.until_),
      measures_(std::move(other.measures_)),
      has_warned_(other.has_warned_),
      listener_(std::move(other.listener_)),
      response_(std::move(other.response_)),
      origin_(std::move(other.origin_)),
      output_(std::move(other.output_)),
      appended_(std::move(other.appended_)),
      seconds_(other.seconds_) {
  other.is_made_ = false;
  listen();
}

const Simulation& PythonSimulation::simulation() const {
  if (!is_made_) {
    throw Error("it has not been initialized", "Simulation",
                "call super().__init__(...) before anything else");
  }
  if (runner_ && *runner_ != std::this_thread::get_id()) {
    throw RunFailure("the simulation is running in another thread; wait until it ends");
  }
  return simulation_;
}

Simulation& PythonSimulation::simulation_to_edit() {
  simulation();
  of_state_.clear();
  return simulation_;
}

void PythonSimulation::check_idle(const char* what) const {
  simulation();
  if (!runner_) return;
  throw Error("the simulation is running", what, "call it when the run has ended, or run a copy");
}

std::optional<double> PythonSimulation::until() const {
  simulation();
  return until_;
}

void PythonSimulation::set_until(std::optional<double> until) {
  simulation_to_edit();
  until_ = until;
}

void PythonSimulation::listen() {
  Observer observer = output_ ? output_->observer(simulation_) : Observer();
  if (records_) {
    observer.contact = [this, write = observer.contact](const Contact& contact) {
      if (records_) records_->record(contact);
      if (write) write(contact);
    };
  }
  simulation_.observe(std::move(observer));
  hears_steps_ = is_stepping_;
  if (!listener_ && !is_stepping_) return simulation_.on_contact(nullptr);
  simulation_.on_contact([this](const Contact& contact) {
    if (is_stepping_) last_ = contact;
    if (!listener_) return;
    const py::gil_scoped_acquire lock;
    of_state_.clear();
    const Callback listener = *listener_;  // which may replace itself
    try {
      listener(contact);
    } catch (py::error_already_set& error) {
      if (simulation_.processes().size() > 1) require_in_all(error);
      throw;
    }
  });
}

// Runs without the lock; calls look() with it, if given, several times a second, and ends at Ctrl-C.
RunStatus PythonSimulation::run_interruptibly(RunLimits limits, const Function<void()>& look) {
  const bool is_shared = simulation_.processes().size() > 1;
  bool has_advanced = false;  // however often checkpoints are wanted
  limits.stop = [&] {
    {
      const py::gil_scoped_acquire lock;
      throw_if_interrupted();
      if (look) look();
    }
    if (!output_) return false;
    output_->keep_current();
    return output_->has_failed() ||
           (std::exchange(has_advanced, true) && !is_shared && output_->schedule().is_checkpoint_due());
  };
  const py::gil_scoped_release release;
  const RunStatus status =
      measures_.is_any_wanted() ? simulation_.run(limits, measures_) : simulation_.run(limits);
  if (output_) output_->throw_if_failed();
  if (status == RunStatus::stopped && is_shared)
    throw RunFailure("process 0 has been interrupted, which ends the run in all");
  return status;
}

// As run_interruptibly, in one thread, for what usually takes less time than to give up the lock: others get
// it only if it takes long.
RunStatus PythonSimulation::run_a_step(RunLimits limits) {
  throw_if_interrupted();
  bool is_long = false;
  limits.stop = [&is_long] {
    if (!std::exchange(is_long, true)) return false;
    { const py::gil_scoped_release release; }
    throw_if_interrupted();
    return false;
  };
  return measures_.is_any_wanted() ? simulation_.run(limits, measures_) : simulation_.run(limits);
}

// Runs, and writes what is due on the way.
RunStatus PythonSimulation::run_and_write(const RunLimits& limits, const Function<void()>& look) {
  if (!output_) return run_interruptibly(limits, look);
  const auto contacts = [&] { return simulation_.counters().contacts(); };
  const std::uint64_t last =
      limits.contacts < kNoLimit - contacts() ? contacts() + limits.contacts : kNoLimit;
  const double until = limits.until.value();
  for (;;) {
    const double due = output_->next_time(until);
    const std::uint64_t counted = output_->schedule().snapshot_contacts();
    const Time next = due < until ? Time(due) : limits.until;
    const RunStatus status =
        run_interruptibly({.until = next, .contacts = std::min(last, counted) - contacts()}, look);
    const py::gil_scoped_release release;
    if (status == RunStatus::contacts_reached && contacts() == counted) output_->write_counted(simulation_);
    const bool is_over = status == RunStatus::time_reached && next == limits.until;
    if (status == RunStatus::time_reached && due <= until)
      output_->write_due(simulation_, measures_, due, until);
    if (simulation_.processes().of_first(output_->schedule().is_checkpoint_due()))
      output_->write_checkpoint(simulation_, measures_);
    if (is_over || (status == RunStatus::contacts_reached && contacts() == last)) return status;
  }
}

py::object PythonSimulation::run(std::optional<double> end, std::optional<std::uint64_t> collisions,
                                 std::optional<std::uint64_t> contacts, bool record,
                                 const py::object& on_progress) {
  check_idle("run");
  simulation_to_edit();
  const Claim claim(*this);
  if (!end && !collisions && !contacts) end = until_;
  if (!end && !collisions && !contacts) {
    throw Error("no limit is given", "run", "give until, collisions or contacts");
  }
  const Time last = end ? Time(*end) : kNever;
  const Setting<std::optional<EventRecords>> recording(
      records_, record ? std::optional<EventRecords>(std::in_place) : std::nullopt);
  listen();
  const auto show = [&] {
    of_state_.clear();
    if (!on_progress.is_none()) on_progress(simulation_.time());
  };
  const Counters before = simulation_.counters();
  const auto left = [&] {
    const Counters done = simulation_.counters() - before;
    return std::min(contacts.value_or(kNoLimit) - done.contacts(),
                    collisions.value_or(kNoLimit) - done.collision);
  };
  const auto begin = std::chrono::steady_clock::now();
  RunStatus status = RunStatus::contacts_reached;
  do {
    status = run_and_write({.until = last, .contacts = left()}, show);
  } while (status == RunStatus::contacts_reached && left() > 0);
  (output_ ? output_->seconds : seconds_).run += cli::seconds_since(begin);
  show();
  if (record) return records_->take();
  return py::int_((simulation_.counters() - before).contacts());
}

std::optional<Contact> PythonSimulation::step(double end) {
  check_idle("events");
  simulation_to_edit();
  const Claim claim(*this);
  last_.reset();
  const Setting<bool> stepping(is_stepping_, true);
  if (!hears_steps_) listen();
  const RunLimits limits{.until = Time(end), .contacts = 1};
  const bool is_alone = simulation_.options().threads == 1 && simulation_.processes().size() == 1;
  if (is_alone && !output_) {
    run_a_step(limits);
  } else {
    run_and_write(limits);
  }
  of_state_.clear();
  return last_;
}

std::optional<NextContact> PythonSimulation::next_event(double end) {
  simulation();
  const Claim claim(*this);
  // There may never be one, and much to do before each horizon, so the horizon approaches `end` only as fast
  // as the user can interrupt.
  constexpr auto kPatience = std::chrono::milliseconds(20);
  double span = usual_wait();
  for (;;) {
    const double next = simulation_.time() + span;
    const double horizon = next < kLargestTime ? std::min(end, next) : end;
    const auto begin = std::chrono::steady_clock::now();
    const std::optional<NextContact> found = [&] {
      const py::gil_scoped_release release;
      return simulation_.next_contact(horizon);
    }();
    if (found || !(horizon < end)) return found;
    throw_if_interrupted();
    const bool is_quick = std::chrono::steady_clock::now() - begin < kPatience;
    if (simulation_.processes().of_first(is_quick)) span *= 2;
  }
}

// A time in which there is a contact, or in which a sphere crosses some cells.
double PythonSimulation::usual_wait() const {
  constexpr double kMany = 100;
  const World& world = simulation().world();
  const auto contacts = static_cast<double>(simulation_.counters().contacts());
  if (contacts > 0 && simulation_.time() > 0) return kMany * simulation_.time() / contacts;
  double fastest = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    fastest = std::max(fastest, length(world.velocity(slot, simulation_.now())));
  }
  const double wait = world.largest_radius() / fastest;
  return wait > 0 && std::isfinite(wait) ? wait : 1;
}

// What query(horizon) finds up to the horizon `end`, with horizons that double from `begin` on where a search
// may take long, through many images of a periodic box; an interruption takes no longer than before.
template <class Query>
auto PythonSimulation::search(double begin, double span, double end, Query&& query) const {
  simulation();
  const Claim claim(*this);
  const Box& box = simulation_.world().box();
  const bool is_long = std::isfinite(end) && (box.is_periodic(0) || box.is_periodic(1) || box.is_periodic(2));
  for (;; span *= 2) {
    const double horizon = is_long && begin + span < end ? begin + span : end;
    auto found = [&] {
      const py::gil_scoped_release release;
      return query(horizon);
    }();
    if (found || horizon == end || std::isnan(end)) return found;
    throw_if_interrupted();
  }
}

std::optional<NextContact> PythonSimulation::first_contact(SphereId id, const Vec3& velocity,
                                                           double end) const {
  constexpr double kUsualWaits = 1000;
  return search(simulation().time(), kUsualWaits * usual_wait(), end,
                [&](double horizon) { return simulation_.first_contact(id, velocity, horizon); });
}

// A distance that a ray goes in little time.
double PythonSimulation::usual_length() const {
  constexpr double kLargestRadii = 1000;
  const double largest = simulation().world().largest_radius();
  return largest > 0 ? kLargestRadii * largest : 1;
}

std::optional<RayHit> PythonSimulation::ray(const Vec3& origin, const Vec3& direction, double most,
                                            const BodyMask& mask) const {
  return search(0, usual_length(), most,
                [&](double horizon) { return simulation_.ray(origin, direction, horizon, mask); });
}

std::vector<RayHit> PythonSimulation::ray_hits(const Vec3& origin, const Vec3& direction, double most,
                                               const BodyMask& mask) const {
  std::vector<RayHit> hits;
  search(0, usual_length(), most, [&](double horizon) {
    hits = simulation_.ray_hits(origin, direction, horizon, mask);
    return false;
  });
  return hits;
}

std::vector<std::optional<RayHit>> PythonSimulation::rays(std::vector<Vec3> origins,
                                                          std::vector<Vec3> directions, double most,
                                                          const BodyMask& mask, std::size_t threads) const {
  std::vector<std::optional<RayHit>> hits;
  // Those that have hit nothing yet go on.
  std::vector<std::size_t> left;
  search(0, usual_length(), most, [&](double horizon) {
    std::vector<std::optional<RayHit>> found = simulation_.rays(origins, directions, horizon, mask, threads);
    if (hits.empty()) {
      hits = std::move(found);
      left.resize(hits.size());
      std::iota(left.begin(), left.end(), std::size_t{0});
    } else {
      for (std::size_t i = 0; i < left.size(); ++i) hits[left[i]] = found[i];
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (hits[left[i]]) continue;
      left[kept] = left[i];
      origins[kept] = origins[i];
      directions[kept] = directions[i];
      ++kept;
    }
    left.resize(kept);
    origins.resize(kept);
    directions.resize(kept);
    return left.empty();
  });
  return hits;
}

// Runs a copy without listeners. Calls watch(simulation) before, and check(simulation) several times a
// second.
template <class Watch, class Check>
void PythonSimulation::run_ahead(double end, std::uint64_t contacts, Watch&& watch, Check&& check) const {
  PythonSimulation copy(*this);
  copy.listener_.reset();
  copy.measures_ = Measures({.names = {}});
  Simulation& simulation = copy.simulation_;
  simulation.on_contact(nullptr);
  const Claim claim(copy);
  watch(simulation);
  copy.run_interruptibly({.until = Time(end), .contacts = contacts}, [&] { check(simulation); });
  check(simulation);
}

std::vector<Contact> PythonSimulation::contacts_within(double duration, std::uint64_t most) {
  // Throws what the library would, and finds nothing.
  std::vector<Contact> found = simulation_.contacts_within(duration, 0);
  run_ahead(
      simulation_.time() + duration, most,
      [&](Simulation& copy) {
        copy.observe({.contact = [&](const Contact& contact) { found.push_back(contact); }});
      },
      [](const Simulation&) {});
  return found;
}

void PythonSimulation::record_ahead(const std::filesystem::path& path, double end, std::uint64_t contacts,
                                    std::uint64_t most_bytes) const {
  std::optional<RecordingWriter> writer;
  const auto watch = [&](Simulation& copy) {
    RecordingHeader header = recording_header(copy);
    if (std::isfinite(end)) header.until = end;
    writer.emplace(path, header, copy.world());
    copy.observe(recording_observer(*writer, copy));
  };
  double reached = 0;
  run_ahead(end, contacts, watch, [&](const Simulation& copy) {
    reached = copy.time();
    if (writer->bytes() <= most_bytes) return;
    throw Error("the recording has more than " + to_text(most_bytes) + " bytes at time " + to_text(reached),
                "view", "give an earlier time or fewer contacts");
  });
  writer->close(reached);
}

std::vector<Vec3> PythonSimulation::positions_at(double time) {
  simulation();
  // If there is much to do before, this can be interrupted.
  if (std::isfinite(time) && time > simulation_.time() && !runner_) next_event(time);
  const Claim claim(*this);
  const py::gil_scoped_release release;
  return simulation_.positions_at(time);
}

void PythonSimulation::change_velocities(std::span<const VelocityEdit> edits) {
  simulation_to_edit().change_velocities(edits, measures_);
}

void PythonSimulation::set_listener(const py::object& listener) {
  simulation();
  if (listener.is_none()) {
    listener_.reset();
  } else if (PyCallable_Check(listener.ptr()) == 0) {
    throw Error("it is not callable", "on_contact", "give a function of a Contact, or None");
  } else {
    listener_.emplace(listener);
  }
  listen();
}

void PythonSimulation::set_response(const py::object& response) {
  Simulation& simulation = simulation_to_edit();
  if (response.is_none()) {
    simulation.respond_with(nullptr);
    response_.reset();
    return;
  }
  if (const std::optional<ResponseTable> table = response_table_of(response)) {
    simulation.respond_with(*table);
    response_.reset();
    return;
  }
  if (PyCallable_Check(response.ptr()) == 0 || PyType_Check(response.ptr()) != 0) {
    throw Error("it is not a response", "response",
                "give a Bounce, a Merging, a ResponseTable, a restitution or a function of a Contact");
  }
  // One reference to the function: the garbage collector counts them.
  const Callback function(response);
  simulation.respond_with(response_calling(function));
  response_ = function;
}

void PythonSimulation::set_thermostat(const py::object& thermostat, std::uint64_t seed) {
  simulation_to_edit().set_thermostat(
      thermostat.is_none() ? std::nullopt : std::optional(Thermostat(thermostat_of(thermostat), seed)));
}

void PythonSimulation::write(const std::filesystem::path& path, bool appends) {
  const World& world = simulation().world();
  const auto append = [&](Trajectory& trajectory) {
    trajectory.append(world, simulation_.now());
    trajectory.flush();
  };
  in_first(simulation_.processes(), [&] {
    const bool exists = std::filesystem::exists(path);
    if (!appends || !exists) appended_.erase(path);
    if (!appends) {
      Trajectory trajectory(path);
      append(trajectory);
      return trajectory.close();
    }
    if (has_single_frame(format_of(path)))
      throw Error("files of this format have a single frame", path.string(),
                  "write another file for each frame");
    auto found = appended_.find(path);
    if (found == appended_.end())
      found = appended_.emplace(path, exists ? Trajectory::after_last_frame(path) : Trajectory(path)).first;
    append(found->second);
  });
}

void PythonSimulation::begin_output(const std::vector<std::string>& overrides, bool overwrites) {
  check_idle("output");
  if (output_) {
    throw Error("files are being written to " + output_->directory().string(), "output",
                "complete them first, by close or at the end of a with block");
  }
  Origin origin;
  in_all(simulation_.processes(),
         [&] { origin = with_overrides(origin_ ? *origin_ : no_origin(), overrides); });
  output_ = std::make_unique<RunOutput>(std::move(origin), simulation_, measures_, overwrites);
  listen();
}

void PythonSimulation::continue_output(Origin origin, const cli::FilesState& files,
                                       const cli::RunState& state) {
  output_ = std::make_unique<RunOutput>(std::move(origin), simulation_, measures_, files, state);
  listen();
}

void PythonSimulation::end_output(bool is_complete) {
  check_idle("close");
  if (!output_) return;
  // Whatever happens, its files are given up.
  const std::unique_ptr<RunOutput> output = std::move(output_);
  simulation_.observe({});
  seconds_ = output->seconds;
  output->finish(simulation_, measures_, is_complete);
}

void PythonSimulation::flush_recording() {
  check_idle("live");
  if (output_) output_->flush_recording();
}

std::optional<std::filesystem::path> PythonSimulation::output_directory() const {
  simulation();
  return output_ ? std::optional(output_->directory()) : std::nullopt;
}

RunEnd PythonSimulation::end() const {
  check_idle("report");
  const Origin origin = output_ ? output_->origin() : origin_ ? *origin_ : no_origin();
  return end_of(origin, simulation_, measures_, output_ ? output_->seconds : seconds_, true);
}

void PythonSimulation::drop_references() {
  listener_.reset();
  response_.reset();
  simulation_.on_contact(nullptr);
  simulation_.respond_with(nullptr);
}

void PythonSimulation::set_measures(const MeasureSettings& settings) {
  simulation();
  if (runner_) throw Error("the simulation is running", "measure", "choose the measures between runs");
  measures_ = Measures(settings);
  has_warned_ = false;
}

void PythonSimulation::restore_measures(std::string_view bytes, const std::string& where) {
  restore(bytes, where, measures_);
}

void PythonSimulation::warn_of_edit(const char* what) {
  simulation();
  // In a run the library refuses edits that measures do not bear.
  if (runner_ || has_warned_ || !measures_.has_begun()) return;
  has_warned_ = true;
  const std::string message = std::string(what) +
                              " while measures are on: their results average over the states before and "
                              "after; measure(...) starts them again";
  // The caller is beyond a function of Python.
  constexpr py::ssize_t kLevel = 2;
  if (PyErr_WarnEx(PyExc_UserWarning, message.c_str(), kLevel) != 0) throw py::error_already_set();
}

void PythonSimulation::check_spheres_may_change(const char* what) const {
  check_not_recording(what);
  if (!measures_.is_any_wanted()) return;
  throw Error("measures are on, which do not allow this", what,
              "take the results, and end measuring with measure([])");
}

void PythonSimulation::check_not_recording(const char* what) const {
  if (!output_ || !output_->has_recording()) return;
  throw Error("a recording is being written, which does not allow this", what,
              "do it before, or write no recording");
}

std::string PythonSimulation::save_measures() const {
  simulation();
  return archived(measures_);
}

std::vector<FaceForces> PythonSimulation::face_forces() const {
  const Simulation& simulation = this->simulation();
  return measures_.face_forces(simulation.world(), simulation.now());
}

std::vector<Measurement> PythonSimulation::results() const {
  const Simulation& simulation = this->simulation();
  Measures measures = measures_;
  measures.sample_the_rest(simulation.world(), simulation.now());
  return measures.results(simulation.world(), simulation.now());
}

}  // namespace hardball::python
