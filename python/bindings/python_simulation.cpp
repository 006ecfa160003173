// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/python_simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/recording_writer.hpp"
#include "hardball/simulation/recording_header.hpp"
#include "hardball/simulation/slice.hpp"
#include "hardball/world/range.hpp"
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

class PythonSimulation::Turn {
 public:
  explicit Turn(PythonSimulation& owner) : runner_(owner.runner_, std::this_thread::get_id()) {}

 private:
  // In this order: the lock is back before others may go on.
  Setting<std::optional<std::thread::id>> runner_;
  py::gil_scoped_release release_;
};

PythonSimulation::PythonSimulation(const PythonSimulation& other)
    : until(other.until), simulation_(other.simulation()), measures_(other.measures_) {
  if (other.response_) set_response(other.response_->function());
  set_listener(other.listener_ ? other.listener_->function() : py::none());
}

PythonSimulation::PythonSimulation(PythonSimulation&& other)
    : until(other.until),
      simulation_(std::move(other.simulation_to_edit())),
      measures_(std::move(other.measures_)),
      listener_(std::move(other.listener_)),
      response_(std::move(other.response_)) {
  listen();
}

const Simulation& PythonSimulation::simulation() const {
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

void PythonSimulation::listen() {
  if (!listener_ && !records_ && !is_stepping_) return simulation_.on_contact(nullptr);
  simulation_.on_contact([this](const Contact& contact) {
    if (records_) records_->note(contact);
    if (is_stepping_) last_ = contact;
    if (!listener_) return;
    const py::gil_scoped_acquire lock;
    of_state_.clear();
    const Callback listener = *listener_;  // which may replace itself
    listener(contact);
  });
}

RunStatus PythonSimulation::run_slice(const RunLimits& slice) {
  const Turn turn(*this);
  return measures_.is_any_wanted() ? simulation_.run(slice, measures_) : simulation_.run(slice);
}

py::object PythonSimulation::run(std::optional<double> end, std::optional<std::uint64_t> collisions,
                                 std::optional<std::uint64_t> contacts, bool record,
                                 const py::object& on_progress) {
  simulation_to_edit();
  if (!end && !collisions && !contacts) end = until;
  if (!end && !collisions && !contacts) {
    throw Error("no limit is given", "run", "give until, collisions or contacts");
  }
  const Time last = end ? Time(*end) : kNever;
  const Setting<std::optional<EventRecords>> recording(
      records_, record ? std::optional<EventRecords>(std::in_place) : std::nullopt);
  listen();
  const Counters before = simulation_.counters();
  for (;;) {
    const Counters done = simulation_.counters() - before;
    const std::uint64_t left = std::min(contacts.value_or(kNoLimit) - done.contacts(),
                                        collisions.value_or(kNoLimit) - done.collision);
    const RunStatus status =
        run_slice({.until = last, .contacts = left, .steps = steps_per_slice(simulation_)});
    throw_if_interrupted();
    of_state_.clear();
    if (!on_progress.is_none()) on_progress(simulation_.time());
    if (status == RunStatus::time_reached) break;
    const Counters reached = simulation_.counters() - before;
    if (contacts && reached.contacts() >= *contacts) break;
    if (collisions && reached.collision >= *collisions) break;
  }
  if (record) return records_->take();
  return py::int_((simulation_.counters() - before).contacts());
}

py::object PythonSimulation::step(double end) {
  simulation_to_edit();
  last_.reset();
  const Setting<bool> stepping(is_stepping_, true);
  listen();
  RunStatus status = RunStatus::steps_reached;
  while (status == RunStatus::steps_reached && !last_) {
    status = run_slice({.until = Time(end), .contacts = 1, .steps = steps_per_slice(simulation_)});
    throw_if_interrupted();
  }
  of_state_.clear();
  return last_ ? py::cast(*last_) : py::none();
}

std::optional<NextContact> PythonSimulation::next_event(double end) {
  // There may be none for ever, and much to do before each horizon, so that it comes nearer to `end` only as
  // fast as somebody who waits can interrupt.
  constexpr auto kPatience = std::chrono::milliseconds(20);
  double span = usual_wait();
  for (;;) {
    const double next = simulation().time() + span;
    const double horizon = next < kLargestTime ? std::min(end, next) : end;
    const auto begin = std::chrono::steady_clock::now();
    const std::optional<NextContact> found = next_contact(horizon);
    if (found || !(horizon < end)) return found;
    throw_if_interrupted();
    if (std::chrono::steady_clock::now() - begin < kPatience) span *= 2;
  }
}

std::optional<NextContact> PythonSimulation::next_contact(double end) {
  const Turn turn(*this);
  return simulation_.next_contact(end);
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

std::vector<Contact> PythonSimulation::contacts_within(double duration, std::uint64_t most) {
  simulation();
  const Turn turn(*this);
  return simulation_.contacts_within(duration, most);
}

void PythonSimulation::record_ahead(const std::filesystem::path& path, double end, std::uint64_t contacts,
                                    std::uint64_t most_bytes) const {
  PythonSimulation copy(*this);
  copy.listener_.reset();
  copy.measures_ = Measures({.names = {}});
  Simulation& simulation = copy.simulation_;
  RecordingHeader header = recording_header(simulation);
  if (std::isfinite(end)) header.until = end;
  RecordingWriter writer(path, header, simulation.world());
  simulation.on_contact([&](const Contact& contact) { writer.note(contact, simulation.world()); });
  simulation.on_velocity_change(
      [&](const VelocityChange& change) { writer.note(change, simulation.world()); });
  const Counters before = simulation.counters();
  for (;;) {
    const std::uint64_t left = contacts - (simulation.counters() - before).contacts();
    const RunStatus status =
        copy.run_slice({.until = Time(end), .contacts = left, .steps = steps_per_slice(simulation)});
    throw_if_interrupted();
    if (writer.bytes() > most_bytes) {
      throw Error("the recording has more than " + to_text(most_bytes) + " bytes at time " +
                      to_text(simulation.time()),
                  "view", "give an earlier time or fewer contacts");
    }
    if (status == RunStatus::time_reached || status == RunStatus::contacts_reached) break;
  }
  writer.close(simulation.time());
}

std::vector<Vec3> PythonSimulation::positions_at(double time) {
  simulation();
  const Turn turn(*this);
  return simulation_.positions_at(time);
}

void PythonSimulation::set_listener(const py::object& listener) {
  simulation();
  if (listener.is_none()) {
    listener_.reset();
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
  EngineOptions options;
  if (python::set_response(response, options)) {
    const Bounce simple(
        {.restitution = ConstantRestitution{options.restitution}, .elastic_below = options.elastic_below});
    const ResponseTable table = options.responses.value_or(ResponseTable(simple, simple));
    simulation.respond_with(std::function<Outcome(const Contact&)>(table));
    response_.emplace(response);
    return;
  }
  if (PyCallable_Check(response.ptr()) == 0) {
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
}

void PythonSimulation::restore_measures(std::string_view bytes, const std::string& where) {
  restore(bytes, where, measures_);
}

std::string PythonSimulation::save_measures() const {
  return archived(measures_);
}

std::vector<Measurement> PythonSimulation::results() const {
  const Simulation& simulation = this->simulation();
  Measures measures = measures_;
  measures.sample_the_rest(simulation.world(), simulation.now());
  return measures.results(simulation.world(), simulation.now());
}

}  // namespace hardball::python
