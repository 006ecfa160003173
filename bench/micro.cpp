// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The cost of the parts of an event in isolation, in L1 and L2: contact times with each instruction set, the
// calendar, and crossings of the broad phases. Also the cost of births and deaths among many spheres, of
// drops that merge, of queries, of robots on trajectories, and of whole frames of a game.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/engine/predictor.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/interaction/response_table.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/robots/robot_queries.hpp"
#include "hardball/simulation/simulation.hpp"

namespace {

using namespace hardball;

constexpr std::size_t kSpheres = 2048;
constexpr double kRadius = 0.5;

World make_gas(double packing_fraction, std::size_t spheres = kSpheres) {
  const double edge = std::cbrt(static_cast<double>(spheres) * std::numbers::pi / 6 / packing_fraction);
  const Vec3 size{edge, edge, edge};
  World world(Box::periodic(size));
  Random random(1);
  for (const Vec3& center : place_on_lattice(world.box(), {{}, size}, spheres, kRadius, "gas")) {
    const Vec3 velocity{random.normal(), random.normal(), random.normal()};
    world.add({.position = center, .velocity = velocity, .radius = kRadius});
  }
  return world;
}

// Bounds of the contacts with as many candidates as the argument says, or the earliest computed exactly;
// different candidates each time.
void predict(benchmark::State& state, InstructionSet instructions, bool exactly) {
  if (!is_available(instructions)) {
    state.SkipWithError("this machine does not support these instructions");
    return;
  }
  const World world = make_gas(0.3);
  const Time now(0.01);
  CompactPaths copies;
  copies.reset(world, 2 * kRadius * kSpheres, now);
  const auto count = static_cast<std::size_t>(state.range(0));
  constexpr std::size_t kQueries = 2000;
  Random random(2);
  std::vector<Candidates> queries(kQueries);
  for (Candidates& query : queries) {
    const auto slot = static_cast<Slot>(random.bits() % kSpheres);
    query.begin(slot, true);
    // Neighbors along the lattice.
    for (std::size_t i = 1; i <= count; ++i) query.add(static_cast<Slot>((slot + i) % kSpheres));
    query.end();
  }
  const Predictor predictor(instructions);
  std::size_t next = 0;
  for (auto _ : state) {
    if (exactly) {
      benchmark::DoNotOptimize(predictor.earliest(world, queries[next], now));
    } else {
      benchmark::DoNotOptimize(predictor.bound(copies, queries[next], now));
    }
    next = next + 1 < kQueries ? next + 1 : 0;
  }
  state.counters["pairs"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

// Each owner's next event, as in a gas: the least is taken and rescheduled after a random wait.
struct EventTable {
  std::vector<Event> events;
  Event event(Owner owner) const { return events[owner]; }
  double time(Owner owner) const { return events[owner].time.high; }
};

template <class Queue>
void take_and_schedule(benchmark::State& state) {
  const auto owners = static_cast<Owner>(state.range(0));
  Random random(3);
  EventTable table{std::vector<Event>(owners)};
  Queue queue;
  queue.reset(owners, Time(0));
  const auto schedule = [&](Owner owner, const Time& now) {
    table.events[owner] = {after(now, -std::log(1 - random.uniform())), EventKind::wall, owner, 0, {}};
    queue.schedule(owner, table);
  };
  for (Owner owner = 0; owner < owners; ++owner) schedule(owner, Time(0));
  benchmark::DoNotOptimize(queue.least(table));  // sizes the buckets
  for (auto _ : state) {
    const Owner least = queue.least(table);
    const Time now = table.events[least].time;
    queue.pop();
    schedule(least, now);
    // A collision gives another sphere a new event, too.
    schedule(static_cast<Owner>(random.bits() % owners), now);
  }
}

template <class Phase>
void cross_and_collect(benchmark::State& state, double packing_fraction, double length) {
  const World world = make_gas(packing_fraction);
  Phase phase(length);
  CompactPaths copies;
  phase.build(world, Time(0), copies);
  Candidates candidates;
  std::vector<double> crossings(kSpheres);
  for (Slot slot = 0; slot < kSpheres; ++slot) {
    crossings[slot] = phase.next_crossing(world, slot, Time(0), copies);
  }
  // Spheres move on without colliding, each crossing in turn; the state is reset before they are far apart.
  const Phase start = phase;
  const std::vector<double> first_crossings = crossings;
  Slot slot = 0;
  for (auto _ : state) {
    const Time now(crossings[slot]);
    copies.copy(world, slot, now);
    phase.cross(world, slot, now, copies, candidates);
    crossings[slot] = phase.next_crossing(world, slot, now, copies);
    benchmark::DoNotOptimize(candidates.size());
    if (++slot < kSpheres) continue;
    slot = 0;
    state.PauseTiming();
    phase = start;
    crossings = first_crossings;
    state.ResumeTiming();
  }
}

// A sphere dies somewhere and is born again, among as many as the argument says.
void remove_and_add(benchmark::State& state, double packing_fraction) {
  Simulation simulation(make_gas(packing_fraction, static_cast<std::size_t>(state.range(0))));
  simulation.run_contacts(simulation.size() / 2);
  Random random(2);
  for (auto _ : state) {
    state.PauseTiming();
    const World& world = simulation.world();
    const Slot slot = static_cast<Slot>(random.bits() % world.size());
    const SphereId id = world.id(slot);
    const Sphere sphere{
        .position = simulation.position(id), .velocity = simulation.velocity(id), .radius = kRadius};
    state.ResumeTiming();
    simulation.remove(id);
    simulation.add(sphere);
  }
}

// As many drops as the argument says merge to a few: the last may never meet in a periodic box.
void merge_drops(benchmark::State& state) {
  constexpr std::size_t kFew = 10;
  World world = make_gas(0.1, static_cast<std::size_t>(state.range(0)));
  world.set_interactions(ResponseTable(Merging()));
  for (auto _ : state) {
    Simulation simulation(world);
    while (simulation.size() > kFew) simulation.run_contacts(1);
    benchmark::DoNotOptimize(simulation.size());
  }
}

enum class Question { ray, clearance, overlap, first_contact };
constexpr std::array kQuestions{std::pair{Question::ray, "ray"}, std::pair{Question::clearance, "clearance"},
                                std::pair{Question::overlap, "overlap"},
                                std::pair{Question::first_contact, "first_contact"}};

// A gas some collisions after it was a lattice, the last one that was asked for.
Simulation& gas_in_motion(double packing_fraction, std::size_t spheres) {
  static std::optional<Simulation> simulation;
  static std::pair<double, std::size_t> made;
  if (!simulation || made != std::pair(packing_fraction, spheres)) {
    simulation.emplace(make_gas(packing_fraction, spheres));
    made = {packing_fraction, spheres};
    simulation->run_contacts(2 * spheres);
  }
  return *simulation;
}

// A query of a gas of as many spheres as the argument says, each from another place. Rays are
// 20 mean free paths long, balls have twice the radius of the spheres, and first contacts are those within so
// many mean free times. Between queries of first contacts nothing moves, so that speeds are computed once.
void ask(benchmark::State& state, Question question, double packing_fraction, double free_times) {
  const Simulation& simulation = gas_in_motion(packing_fraction, static_cast<std::size_t>(state.range(0)));
  const Vec3 size = simulation.setting().box().size();
  const double density = packing_fraction * 6 / std::numbers::pi;
  const double mean_free_path = 1 / (std::sqrt(2.0) * std::numbers::pi * density);
  const double mean_speed = std::sqrt(8 / std::numbers::pi);
  const double end = simulation.time() + free_times * mean_free_path / mean_speed;
  constexpr std::size_t kQueries = 1 << 12;
  Random random(3);
  std::vector<Vec3> points;
  std::vector<Vec3> directions;
  std::vector<SphereId> ids;
  for (std::size_t i = 0; i < kQueries; ++i) {
    points.push_back({size.x * random.uniform(), size.y * random.uniform(), size.z * random.uniform()});
    directions.push_back(random.direction());
    ids.push_back(static_cast<SphereId>(random.bits() % simulation.size()));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    switch (question) {
      case Question::ray:
        benchmark::DoNotOptimize(simulation.ray(points[next], directions[next], 20 * mean_free_path));
        break;
      case Question::clearance:
        benchmark::DoNotOptimize(simulation.clearance(points[next]));
        break;
      case Question::overlap:
        benchmark::DoNotOptimize(simulation.overlap(points[next], 2 * kRadius));
        break;
      case Question::first_contact:
        benchmark::DoNotOptimize(simulation.first_contact(ids[next], mean_speed * directions[next], end));
        break;
    }
    next = (next + 1) % kQueries;
  }
}

void register_queries() {
  for (const std::int64_t spheres : {1000, 20000, 1000000}) {
    for (const double packing_fraction : {0.01, 0.1, 0.49}) {
      for (const auto& [question, name] : kQuestions) {
        for (const double free_times : {1.0, 5.0}) {
          const bool looks_ahead = question == Question::first_contact;
          if (!looks_ahead && free_times > 1) continue;
          const std::string title = "query/" + std::string(name) + "/" + to_text(packing_fraction) +
                                    (looks_ahead ? "/" + to_text(free_times) : "");
          benchmark::RegisterBenchmark(title.c_str(), ask, question, packing_fraction, free_times)
              ->Unit(benchmark::kMicrosecond)
              ->Arg(spheres);
        }
      }
    }
  }
}

// 10,000 frames of a game at 60 frames a second, in a box of 24 m: 19,800 rocks, and 200 ships. In each frame
// every ship gets another velocity and casts a ray of 10 m, and 40 of them look half a second ahead.
void play(benchmark::State& state) {
  constexpr double kEdge = 24;
  constexpr std::size_t kBodies = 20000;
  constexpr std::size_t kRocksPerShip = 100;
  constexpr std::size_t kLooks = 40;
  World world(Box::walls({kEdge, kEdge, kEdge}));
  Random random(1997);
  std::vector<SphereId> ships;
  for (const Vec3& center :
       place_on_lattice(world.box(), {{}, {kEdge, kEdge, kEdge}}, kBodies, 0.15, "field")) {
    const bool is_ship = world.size() % kRocksPerShip == 0;
    const Vec3 velocity = 4 * Vec3{random.normal(), random.normal(), random.normal()};
    const SphereId id = world.add({.position = center,
                                   .velocity = is_ship ? Vec3{} : velocity,
                                   .radius = is_ship ? 0.15 : 0.05,
                                   .mass = is_ship ? 20.0 : 1.0});
    if (is_ship) ships.push_back(id);
  }
  Simulation simulation(world);
  std::vector<VelocityEdit> edits(ships.size());
  std::vector<Vec3> origins(ships.size());
  std::vector<Vec3> directions(ships.size());
  std::vector<double> milliseconds;
  std::size_t next = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < ships.size(); ++i) {
      origins[i] = simulation.position(ships[i]);
      directions[i] = random.direction();
      edits[i] = {ships[i], 6 * random.direction()};
    }
    benchmark::DoNotOptimize(simulation.rays(origins, directions, 10));
    for (std::size_t i = 0; i < kLooks; ++i, next = (next + 1) % ships.size()) {
      benchmark::DoNotOptimize(
          simulation.first_contact(ships[next], edits[next].velocity, simulation.time() + 0.5));
    }
    simulation.change_velocities(edits);
    simulation.run_until(static_cast<double>(milliseconds.size() + 1) / 60);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(took.count());
  }
  std::ranges::sort(milliseconds);
  state.counters["median_ms"] = milliseconds[milliseconds.size() / 2];
  state.counters["longest_ms"] = milliseconds.back();
}

double within(Random& random, double most) {
  return most * (2 * random.uniform() - 1);
}

// An arm of seven joints that turn, about 1.2 m long, with 200 spheres of 2 to 5 cm. It may meet itself where
// three links or more lie between.
Robot make_arm(Random& random) {
  constexpr std::array kLengths{0.33, 0.1, 0.3, 0.1, 0.3, 0.1, 0.2};
  constexpr std::size_t kOfArm = 200;
  std::vector<Link> links{{"base"}};
  std::vector<Joint> joints;
  std::vector<std::pair<std::string, std::string>> ignored;
  for (std::size_t k = 0; k < kLengths.size(); ++k) {
    Link link{"link " + std::to_string(k)};
    const std::size_t count = kOfArm * (k + 1) / kLengths.size() - kOfArm * k / kLengths.size();
    for (std::size_t i = 0; i < count; ++i) {
      link.spheres.push_back({{within(random, 0.04), within(random, 0.04), kLengths[k] * random.uniform()},
                              0.02 + 0.03 * random.uniform()});
    }
    joints.push_back({.name = "joint " + std::to_string(k),
                      .parent = links.back().name,
                      .child = link.name,
                      .origin = {0, 0, k > 0 ? kLengths[k - 1] : 0.1},
                      .axis = k % 2 == 0 ? Vec3{0, 0, 1} : Vec3{0, 1, 0}});
    for (std::size_t before = links.size() < 3 ? 0 : links.size() - 3; before < links.size(); ++before)
      ignored.emplace_back(links[before].name, link.name);
    links.push_back(std::move(link));
  }
  return Robot::from_spheres(links, joints, ignored);
}

// The first contact of an arm of 200 spheres in seven seconds of splines through eight knots, among 40
// obstacles of 10 cm that are at least as far away as the argument says, in centimeters: near ones are
// touched soon. Or its least clearance.
void follow_trajectory(benchmark::State& state, bool least) {
  constexpr std::size_t kTrajectories = 100;
  constexpr std::size_t kObstacles = 40;
  Random random(6);
  const Robot robot = make_arm(random);
  const double nearest = static_cast<double>(state.range(0)) / 100;
  std::vector<Obstacles> obstacles(kTrajectories);
  std::vector<JointTrajectory> trajectories;
  for (std::size_t k = 0; k < kTrajectories; ++k) {
    for (std::size_t i = 0; i < kObstacles; ++i) {
      const Vec3 center = (nearest + 0.8 * random.uniform()) * random.direction();
      if (i % 2 == 0) {
        obstacles[k].add_sphere(center, 0.05);
      } else {
        obstacles[k].add_box(
            center, {0.1, 0.1, 0.1},
            RotationMatrix::from_angles(within(random, 3), within(random, 3), within(random, 3)));
      }
    }
    std::vector<double> times;
    std::vector<JointTrajectory::Row> rows;
    for (std::size_t knot = 0; knot < 8; ++knot) {
      times.push_back(static_cast<double>(knot));
      rows.emplace_back();
      for (std::size_t joint = 0; joint < robot.joint_count(); ++joint)
        rows.back().push_back(within(random, 1.5));
    }
    trajectories.push_back(JointTrajectory::cubic(times, rows));
  }
  std::size_t next = 0;
  std::size_t contacts = 0;
  for (auto _ : state) {
    const auto found = least ? least_clearance(robot, trajectories[next], obstacles[next])
                             : first_contact(robot, trajectories[next], obstacles[next]);
    if (found && found->distance < 1e-12) ++contacts;
    next = next + 1 < kTrajectories ? next + 1 : 0;
  }
  state.counters["contacts"] =
      benchmark::Counter(static_cast<double>(contacts), benchmark::Counter::kAvgIterations);
}

void register_all() {
  const std::array sets{std::pair{InstructionSet::portable, "portable"},
                        std::pair{InstructionSet::avx2, "avx2"}, std::pair{InstructionSet::avx512, "avx512"}};
  for (const auto& [instructions, name] : sets) {
    for (const bool exactly : {false, true}) {
      const std::string title = std::string("predict/") + name + (exactly ? "/exactly" : "/bounds");
      benchmark::RegisterBenchmark(title.c_str(), predict, instructions, exactly)->Arg(8)->Arg(13)->Arg(32);
    }
  }
  benchmark::RegisterBenchmark("queue/calendar", take_and_schedule<CalendarQueue>)->Arg(4000)->Arg(1000000);
  benchmark::RegisterBenchmark("cross/cells/dilute", cross_and_collect<CellGrid>, 0.02, 4.5);
  benchmark::RegisterBenchmark("cross/cells/dense", cross_and_collect<CellGrid>, 0.25, 1.4);
  benchmark::RegisterBenchmark("cross/neighbors/dense", cross_and_collect<NeighborList>, 0.49, 0.25);
  for (const double packing_fraction : {0.02, 0.25, 0.49}) {
    const std::string title = "remove_and_add/" + to_text(packing_fraction);
    benchmark::RegisterBenchmark(title.c_str(), remove_and_add, packing_fraction)->Arg(1000000);
  }
  benchmark::RegisterBenchmark("merge_drops", merge_drops)->Arg(10000);
  register_queries();
  for (const bool least : {false, true}) {
    benchmark::RegisterBenchmark(least ? "robot/least_clearance" : "robot/first_contact", follow_trajectory,
                                 least)
        ->Unit(benchmark::kMillisecond)
        ->Arg(50)
        ->Arg(100)
        ->Arg(200)
        ->Iterations(400);
  }
  benchmark::RegisterBenchmark("frame", play)->Unit(benchmark::kMillisecond)->Iterations(10000);
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
