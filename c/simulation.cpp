// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "c/arrays.hpp"
#include "c/guard.hpp"
#include "c/handles.hpp"
#include "c/hardball.h"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"

namespace hardball::c {

hb_kind kind_of(EventKind kind) {
  return kind == EventKind::collision ? HB_KIND_COLLISION : HB_KIND_WALL;
}

hb_contact contact_of(const Contact& contact) {
  hb_contact result{};
  result.time = contact.time.value();
  result.kind = kind_of(contact.kind);
  result.outcome = static_cast<hb_outcome>(contact.outcome);
  result.first = contact.first;
  result.second = contact.second;
  result.first_species = contact.first_species;
  result.second_species = contact.second_species;
  store(contact.point(), result.point);
  store(contact.normal(), result.normal);
  store(contact.before.first, result.first_before);
  store(contact.before.second, result.second_before);
  store(contact.after.first, result.first_after);
  store(contact.after.second, result.second_after);
  store(contact.impulse(), result.impulse);
  result.impact_speed = contact.impact_speed();
  return result;
}

namespace {

static_assert(static_cast<hb_outcome>(ContactOutcome::merge) == HB_OUTCOME_MERGE);
static_assert(static_cast<hb_engine>(EngineKind::paper) == HB_ENGINE_PAPER);
static_assert(static_cast<hb_boundary>(Boundary::flat) == HB_BOUNDARY_FLAT);
static_assert(static_cast<hb_run_status>(RunStatus::stopped) == HB_RUN_STOPPED);

EngineOptions options_of(const hb_options* options) {
  const hb_options defaults = HB_OPTIONS_INIT;
  const hb_options chosen = options == nullptr ? defaults : completed(options, defaults, "options");
  if (chosen.engine < HB_ENGINE_AUTO || chosen.engine > HB_ENGINE_PAPER)
    throw Error("the engine is " + to_text(chosen.engine), "options", "give one of HB_ENGINE_");
  EngineOptions result{.engine = static_cast<EngineKind>(chosen.engine), .threads = chosen.threads};
  if (chosen.cell_edge != 0) result.cell_edge = chosen.cell_edge;
  return result;
}

void keep_contacts(hb_simulation& handle, bool keep) {
  handle.keeps_contacts = keep;
  observe(handle);
}

// Marks a simulation as running for the time of a scope.
class Running {
 public:
  explicit Running(hb_simulation& handle) : handle_(handle) { handle_.is_running = true; }
  ~Running() { handle_.is_running = false; }
  Running(const Running&) = delete;

 private:
  hb_simulation& handle_;
};

// Error: as for Simulation::run; the contacts of the last run are then still there.
RunStatus run(hb_simulation& handle, const RunLimits& limits) {
  check_idle(handle);
  handle.spare.clear();
  handle.contacts.swap(handle.spare);
  const Running running(handle);
  try {
    return handle.measures ? handle.simulation.run(limits, *handle.measures) : handle.simulation.run(limits);
  } catch (const Error&) {
    if (handle.contacts.empty()) handle.contacts.swap(handle.spare);
    throw;
  }
}

RunLimits limits_of(const hb_limits& limits) {
  RunLimits result{.until = Time(limits.until), .contacts = limits.contacts, .steps = limits.steps};
  if (limits.stop != nullptr) {
    result.stop = [stop = limits.stop, context = limits.context] { return stop(context) != 0; };
  }
  return result;
}

// The type of each field, and how many numbers a row has.
struct FieldShape {
  hb_type type;
  std::size_t columns;
};

FieldShape shape_of(hb_field field) {
  switch (field) {
    case HB_FIELD_ID:
    case HB_FIELD_SPECIES:
      return {HB_U32, 1};
    case HB_FIELD_POSITION:
    case HB_FIELD_VELOCITY:
    case HB_FIELD_SPIN:
      return {HB_F64, kAxes};
    case HB_FIELD_RADIUS:
    case HB_FIELD_MASS:
      return {HB_F64, 1};
    case HB_FIELD_USER_DATA:
      return {HB_U64, 1};
    default:
      throw Error("it is " + to_text(field), "field", "give one of HB_FIELD_");
  }
}

void write_field(const Simulation& simulation, const World& world, hb_field field, Slot slot, std::size_t row,
                 const OutputRows& rows) {
  const Time& now = simulation.now();
  switch (field) {
    case HB_FIELD_ID:
      return rows.write_integer<std::uint32_t>(row, world.id(slot));
    case HB_FIELD_POSITION:
      return rows.write_vector(row, world.position(slot, now));
    case HB_FIELD_VELOCITY:
      return rows.write_vector(row, world.velocity(slot, now));
    case HB_FIELD_RADIUS:
      return rows.write_number(row, world.radius(slot, now));
    case HB_FIELD_MASS:
      return rows.write_number(row, world.mass(slot));
    case HB_FIELD_SPIN:
      return rows.write_vector(row, world.spin(slot));
    case HB_FIELD_SPECIES:
      return rows.write_integer<std::uint32_t>(row, world.species(slot));
    default:
      return rows.write_integer<std::uint64_t>(row, simulation.user_data(world.id(slot)));
  }
}

// The slots of these spheres, or of all in the order of ids.
std::vector<Slot> slots_of(const World& world, const hb_id* ids, std::size_t count) {
  std::vector<Slot> slots;
  if (ids != nullptr) {
    slots.reserve(count);
    for (std::size_t k = 0; k < count; ++k) slots.push_back(world.slot_of(ids[k]));
    return slots;
  }
  if (count != world.size())
    throw Error("it is " + to_text(count) + ", and there are " + to_text(world.size()) + " spheres", "count",
                "give hb_size, or the ids of the spheres");
  slots.reserve(count);
  world.for_each_by_id([&](Slot slot) { slots.push_back(slot); });
  return slots;
}

hb_simulation* released(Simulation simulation) {
  return std::make_unique<hb_simulation>(std::move(simulation)).release();
}

void change_velocities(hb_simulation& handle, std::span<const VelocityEdit> edits) {
  if (handle.measures) return handle.simulation.change_velocities(edits, *handle.measures);
  handle.simulation.change_velocities(edits);
}

}  // namespace
}  // namespace hardball::c

using namespace hardball::c;

hb_status hb_start(const hb_world* world, const hb_options* options, hb_simulation** out) {
  return guarded([&] {
    check_given(out, "out");
    *out = released(hardball::Simulation(given(world, "world").world, options_of(options)));
  });
}

hb_status hb_start_scenario(const char* text, const char* name, const char* const* overrides,
                            std::size_t override_count, const hb_options* options, hb_simulation** out,
                            double* until) {
  return guarded([&] {
    check_given(out, "out");
    given_array(overrides, override_count, "overrides");
    std::vector<std::string> changes;
    for (std::size_t k = 0; k < override_count; ++k) changes.emplace_back(&given(overrides[k], "overrides"));
    const auto scenario = std::make_shared<const hardball::Scenario>(
        hardball::parse_scenario(&given(text, "text"), &given(name, "name"), changes));
    *out =
        released(hardball::make_simulation(*scenario, hardball::make_world(*scenario), options_of(options)));
    (*out)->scenario = scenario;
    if (until != nullptr) *until = scenario->run.until.value_or(HUGE_VAL);
  });
}

hb_status hb_copy(const hb_simulation* simulation, hb_simulation** out) {
  return guarded([&] {
    check_given(out, "out");
    auto copy = std::make_unique<hb_simulation>(given(simulation, "simulation").simulation);
    copy->scenario = simulation->scenario;
    // The observer of the original belongs to the original.
    keep_contacts(*copy, simulation->keeps_contacts);
    *out = copy.release();
  });
}

hb_status hb_save(hb_simulation* simulation, const void** bytes, std::size_t* byte_count) {
  return guarded([&] {
    check_given(bytes, "bytes");
    check_given(byte_count, "byte_count");
    std::string saved = given(simulation, "simulation").simulation.save();
    simulation->saved = std::move(saved);
    *bytes = simulation->saved.data();
    *byte_count = simulation->saved.size();
  });
}

hb_status hb_load(const void* bytes, std::size_t byte_count, hb_simulation** out) {
  return guarded([&] {
    check_given(out, "out");
    const auto* characters = given_array(static_cast<const char*>(bytes), byte_count, "bytes");
    *out = released(hardball::Simulation::load(std::string_view(characters, byte_count)));
  });
}

hb_status hb_set_threads(hb_simulation* simulation, std::uint32_t threads) {
  return guarded([&] { given(simulation, "simulation").simulation.set_threads(threads); });
}

void hb_free(hb_simulation* simulation) {
  delete simulation;
}

hb_status hb_run_until(hb_simulation* simulation, double time) {
  return guarded([&] { run(given(simulation, "simulation"), {.until = hardball::Time(time)}); });
}

hb_status hb_run(hb_simulation* simulation, const hb_limits* limits, hb_run_status* out) {
  return guarded([&] {
    const hb_limits defaults = HB_LIMITS_INIT;
    const hardball::RunStatus status =
        run(given(simulation, "simulation"), limits_of(completed(limits, defaults, "limits")));
    if (out != nullptr) *out = static_cast<hb_run_status>(status);
  });
}

hb_status hb_keep_contacts(hb_simulation* simulation, int keep) {
  return guarded([&] { keep_contacts(given(simulation, "simulation"), keep != 0); });
}

const hb_contact* hb_contacts(const hb_simulation* simulation, std::size_t* count) {
  const hb_contact* contacts = nullptr;
  std::size_t found = 0;
  const hb_status status = guarded([&] {
    contacts = given(simulation, "simulation").contacts.data();
    found = simulation->contacts.size();
    check_given(count, "count");
  });
  if (count != nullptr) *count = found;
  return status == HB_OK ? contacts : nullptr;
}

double hb_time(const hb_simulation* simulation) {
  return value_or(std::numeric_limits<double>::quiet_NaN(),
                  [&] { return given(simulation, "simulation").simulation.time(); });
}

std::size_t hb_size(const hb_simulation* simulation) {
  return value_or<std::size_t>(0, [&] { return given(simulation, "simulation").simulation.size(); });
}

hb_status hb_get_box(const hb_simulation* simulation, double size[3], hb_boundary boundary[3]) {
  return guarded([&] {
    const hardball::Box& box = given(simulation, "simulation").simulation.world().box();
    for (std::size_t axis = 0; axis < hardball::kAxes; ++axis) {
      if (size != nullptr) size[axis] = box.is_bounded(axis) ? box.size()[axis] : 0;
      if (boundary != nullptr) boundary[axis] = static_cast<hb_boundary>(box.boundary(axis));
    }
  });
}

std::uint64_t hb_hash(const hb_simulation* simulation) {
  return value_or<std::uint64_t>(0,
                                 [&] { return given(simulation, "simulation").simulation.event_log_hash(); });
}

std::uint64_t hb_collisions(const hb_simulation* simulation) {
  return value_or<std::uint64_t>(
      0, [&] { return given(simulation, "simulation").simulation.tally().collisions(); });
}

std::uint64_t hb_wall_contacts(const hb_simulation* simulation) {
  return value_or<std::uint64_t>(
      0, [&] { return given(simulation, "simulation").simulation.tally().wall_contacts(); });
}

int hb_contains(const hb_simulation* simulation, hb_id id) {
  return value_or(0, [&] { return given(simulation, "simulation").simulation.contains(id) ? 1 : 0; });
}

hb_status hb_read(const hb_simulation* simulation, hb_field field, const hb_id* ids, std::size_t count,
                  hb_array out) {
  return guarded([&] {
    const hardball::Simulation& of = given(simulation, "simulation").simulation;
    const auto [type, columns] = shape_of(field);
    const OutputRows rows(out, type, count, columns, "out");
    const hardball::World& world = of.world();
    const std::vector<hardball::Slot> slots = slots_of(world, ids, count);
    for (std::size_t row = 0; row < count; ++row) write_field(of, world, field, slots[row], row, rows);
  });
}

hb_status hb_extrapolate(const hb_simulation* simulation, double time, const hb_id* ids, std::size_t count,
                         hb_array out) {
  return guarded([&] {
    const hardball::Simulation& of = given(simulation, "simulation").simulation;
    constexpr double kLatest = 1e120;
    if (!(time >= of.time() && time <= kLatest))
      throw hardball::Error(
          "it is " + hardball::to_text(time) + ", and now it is " + hardball::to_text(of.time()), "time",
          "give a time that is not in the past, up to 1e120");
    const OutputRows rows(out, HB_F64, count, hardball::kAxes, "out");
    const hardball::World& world = of.world();
    const std::vector<hardball::Slot> slots = slots_of(world, ids, count);
    for (std::size_t row = 0; row < count; ++row)
      rows.write_vector(row, world.position(slots[row], hardball::Time(time)));
  });
}

hb_status hb_get_sphere(const hb_simulation* simulation, hb_id id, hb_sphere* out) {
  return guarded([&] {
    check_result(out);
    const hardball::Simulation& of = given(simulation, "simulation").simulation;
    const hardball::World& world = of.world();
    const hardball::Slot slot = world.slot_of(id);
    hb_sphere sphere = HB_SPHERE_INIT;
    store(world.position(slot, of.now()), sphere.position);
    store(world.velocity(slot, of.now()), sphere.velocity);
    sphere.radius = world.radius(slot, of.now());
    sphere.mass = world.mass(slot);
    store(world.spin(slot), sphere.spin);
    sphere.inertia_factor = world.inertia_factor(slot);
    sphere.species = world.species(slot);
    write(sphere, out);
  });
}

hb_status hb_get_totals(const hb_simulation* simulation, hb_totals* out) {
  return guarded([&] {
    check_result(out);
    const hardball::Totals sums = given(simulation, "simulation").simulation.totals();
    hb_totals totals = HB_TOTALS_INIT;
    totals.energy = sums.energy.value();
    totals.kinetic_energy = sums.kinetic_energy.value();
    totals.rotational_energy = sums.rotational_energy.value();
    store(sums.total_momentum(), totals.momentum);
    totals.mass = sums.mass.value();
    write(totals, out);
  });
}

hb_status hb_set_user_data(hb_simulation* simulation, hb_id id, std::uint64_t data) {
  return guarded([&] { given(simulation, "simulation").simulation.set_user_data(id, data); });
}

hb_status hb_change_velocity(hb_simulation* simulation, hb_id id, const double velocity[3]) {
  return guarded([&] {
    const hardball::VelocityEdit edit{id, vector_of(&given(velocity, "velocity"))};
    change_velocities(given(simulation, "simulation"), {&edit, 1});
  });
}

hb_status hb_change_velocities(hb_simulation* simulation, std::size_t count, const hb_id* ids,
                               hb_const_array velocities) {
  return guarded([&] {
    hb_simulation& handle = given(simulation, "simulation");
    given_array(ids, count, "ids");
    const Rows rows(velocities, HB_F64, count > 0, "velocities");
    std::vector<hardball::VelocityEdit> edits;
    edits.reserve(count);
    for (std::size_t row = 0; row < count; ++row) edits.push_back({ids[row], rows.vector(row)});
    change_velocities(handle, edits);
  });
}

hb_status hb_add(hb_simulation* simulation, const hb_sphere* sphere, hb_id* id) {
  return guarded([&] {
    check_spheres_may_change(given(simulation, "simulation"));
    const hb_id added = simulation->simulation.add(sphere_of(sphere));
    if (id != nullptr) *id = added;
  });
}

hb_status hb_remove(hb_simulation* simulation, hb_id id) {
  return guarded([&] {
    check_spheres_may_change(given(simulation, "simulation"));
    simulation->simulation.remove(id);
  });
}
