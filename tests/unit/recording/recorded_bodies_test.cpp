// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Recordings of spheres that spin, merge, pass through each other, or are kinematic.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/recording/recording_header.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/scratch_folder.hpp"
#include "support/true_checksums.hpp"

namespace hardball::recorded_bodies_test {
namespace {

using support::make_gas;
using support::read_text;
using support::ScratchFolder;
using support::with_true_checksums;
using support::write_text;

constexpr recording_format::Layout kLayout{.has_bodies = true};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Drops of species 0 merge, are rough to the mist of species 1, and the mist passes through itself.
ResponseTable every_outcome() {
  ResponseTable table{Merging()};
  table.set(0, 1, Bounce({.tangential_restitution = 0.5}));
  table.set(1, 1, Passing());
  return table;
}

World drops_and_mist(std::size_t count) {
  const World gas = make_gas({.count = count, .packing_fraction = 0.05});
  World world(gas.box());
  for (Slot slot = 0; slot < gas.size(); ++slot) {
    const auto species = static_cast<SpeciesId>(slot < count / 3 ? 0 : 1);
    world.add({.position = gas.position(slot, Time(0)),
               .velocity = gas.velocity(slot, Time(0)),
               .radius = gas.base_radius(slot),
               .mass = slot == 7 ? kInfinity : 1,
               .species = species,
               .inertia_factor = slot % 2 == 0 ? 0.4 : 0.6});
  }
  return world;
}

struct Recorded {
  Simulation simulation;
  std::uint64_t mergers = 0;
};

// Runs to `until`, recording everything; at times `check_every` apart the chunk is closed and `check` called.
template <class Check>
Recorded record(const std::filesystem::path& path, World world, double until, double check_every,
                const Check& check) {
  Recorded run{Simulation(support::interacting(std::move(world), every_outcome()))};
  Simulation& simulation = run.simulation;
  RecordingWriter writer(path, {.has_bodies = true, .until = until, .species_names = {"drop", "mist"}},
                         simulation.world());
  simulation.on_contact([&](const Contact& contact) {
    writer.note(contact, simulation.world());
    run.mergers += contact.outcome == ContactOutcome::merge ? 1U : 0U;
  });
  for (int k = 1; k * check_every <= until; ++k) {
    simulation.run_until(k * check_every);
    check(simulation);
    if (k % 3 == 0) writer.flush();
  }
  writer.close(until);
  simulation.on_contact({});
  return run;
}

Recorded record(const std::filesystem::path& path, World world, double until) {
  return record(path, std::move(world), until, until, [](const Simulation&) {});
}

// What is at `time`, from the recording.
struct Moment {
  std::vector<RecordedPath> paths;
  std::vector<RecordedBody> bodies;
};

Moment moment_of(RecordingReader& reader, double time) {
  std::size_t k = 0;
  while (reader.chunks()[k].end < time) ++k;
  const RecordedChunk chunk = reader.read(k);
  return {chunk.paths_at(time), chunk.bodies_at(time)};
}

// What is at a time, in the simulation.
struct Snapshot {
  double time;
  World world;
};

// Positions differ by what a sphere travels in the part of a time that the recording drops, and by rounding.
void expect_same(const Moment& recorded, const Snapshot& actual) {
  const World& world = actual.world;
  std::size_t present = 0;
  for (SphereId id = 0; id < recorded.bodies.size(); ++id) {
    const RecordedBody& body = recorded.bodies[id];
    ASSERT_EQ(body.exists(), world.contains(id)) << id << " at " << actual.time;
    if (!body.exists()) continue;
    ++present;
    const Slot slot = world.slot_of(id);
    EXPECT_EQ(body.radius, world.base_radius(slot));
    EXPECT_EQ(body.mass, world.mass(slot));
    EXPECT_EQ(body.inertia_factor, world.inertia_factor(slot));
    EXPECT_EQ(body.spin, world.spin(slot));
    EXPECT_EQ(recorded.paths[id].position, world.path(slot).position) << id << " at " << actual.time;
    EXPECT_EQ(recorded.paths[id].velocity, world.path(slot).velocity);
    EXPECT_EQ(recorded.paths[id].time, world.path(slot).time.value());
  }
  EXPECT_EQ(present, world.size());
}

TEST(RecordedBodies, AreThoseOfTheSimulationAtAnyTime) {
  const ScratchFolder folder;
  std::vector<Snapshot> snapshots;
  const Recorded run =
      record(folder / "recording.hbr", drops_and_mist(150), 12, 0.5, [&](const Simulation& simulation) {
        snapshots.push_back({simulation.time(), simulation.world()});
      });
  const Tally& tally = run.simulation.tally();
  ASSERT_GT(tally.mergers(), 10U);
  ASSERT_GT(tally.passes(), 10U);
  EXPECT_EQ(tally.mergers(), run.mergers);
  EXPECT_EQ(run.simulation.size(), 150 - tally.mergers());
  ASSERT_GT(rotational_energy(run.simulation.world()), 0);
  RecordingReader reader(folder / "recording.hbr");
  ASSERT_GT(reader.chunks().size(), 3U);
  for (const Snapshot& snapshot : snapshots) expect_same(moment_of(reader, snapshot.time), snapshot);
}

// Ids are missing: some spheres have become part of others, one has been removed, and so has the last.
TEST(RecordedBodies, MayHaveGapsWhereTheRecordingBeginsMidway) {
  const ScratchFolder folder;
  Simulation simulation(support::interacting(drops_and_mist(150), every_outcome()));
  simulation.run_until(3);
  ASSERT_GT(simulation.tally().mergers(), 0U);
  for (const SphereId id : {60U, 149U}) simulation.remove(id);
  std::vector<Snapshot> snapshots{{simulation.time(), simulation.world()}};
  RecordingWriter writer(folder / "recording.hbr", recording_header(simulation), simulation.world());
  simulation.on_contact([&](const Contact& contact) { writer.note(contact, simulation.world()); });
  const std::uint64_t mergers = simulation.tally().mergers();
  for (int k = 7; k <= 20; ++k) {
    simulation.run_until(0.5 * k);
    snapshots.push_back({simulation.time(), simulation.world()});
    if (k % 5 == 0) writer.flush();
  }
  writer.close(simulation.time());
  ASSERT_GT(simulation.tally().mergers(), mergers);
  RecordingReader reader(folder / "recording.hbr");
  ASSERT_GT(reader.chunks().size(), 1U);
  EXPECT_EQ(reader.header().has_bodies, true);
  EXPECT_EQ(reader.header().spheres, 149U) << "the last id is 148";
  EXPECT_EQ(reader.header().begin, 3);
  EXPECT_EQ(reader.radii()[60], 0);
  EXPECT_EQ(reader.masses()[60], 0);
  for (const Snapshot& snapshot : snapshots) expect_same(moment_of(reader, snapshot.time), snapshot);
}

TEST(RecordedBodies, OfARemovedSphereAreRecorded) {
  const ScratchFolder folder;
  World world = make_gas({.count = 20, .packing_fraction = 0.05});
  world.remove(world.slot_of(3));
  RecordingWriter(folder / "recording.hbr", {}, world).close(1);
  const RecordingReader reader(folder / "recording.hbr");
  EXPECT_EQ(reader.header().has_bodies, true);
  EXPECT_EQ(reader.header().spheres, 20U);
  EXPECT_EQ(reader.radii()[3], 0);
}

TEST(RecordedBodies, AreOfAllSpheresOtherwise) {
  const ScratchFolder folder;
  const World world = make_gas({.count = 20, .packing_fraction = 0.05});
  RecordingWriter(folder / "recording.hbr", {}, world).close(1);
  const RecordingReader reader(folder / "recording.hbr");
  ASSERT_EQ(reader.header().has_bodies, false);
  const std::string whole = read_text(folder / "recording.hbr");
  for (const std::uint64_t number : {3U, 20U + 3U}) {  // a radius, a mass
    std::string bytes = whole;
    bytes.replace(reader.spheres().offset + 8 * number, 8, 8, '\0');
    write_text(folder / "recording.hbr", with_true_checksums(bytes));
    EXPECT_THROW(RecordingReader(folder / "recording.hbr"), Error) << number;
  }
}

TEST(RecordedBodies, GoOnFromChunkToChunk) {
  const ScratchFolder folder;
  record(folder / "recording.hbr", drops_and_mist(150), 12, 1, [](const Simulation&) {});
  RecordingReader reader(folder / "recording.hbr");
  ASSERT_GT(reader.chunks().size(), 2U);
  for (std::size_t k = 1; k < reader.chunks().size(); ++k) {
    const RecordedChunk before = reader.read(k - 1);
    EXPECT_EQ(reader.read(k).keyframe, before.paths_at(before.end)) << k;
    EXPECT_EQ(reader.read(k).bodies, before.bodies_at(before.end)) << k;
  }
}

TEST(RecordedBodies, OutcomesCanBeTold) {
  const ScratchFolder folder;
  const Recorded run = record(folder / "recording.hbr", drops_and_mist(90), 8);
  RecordingReader reader(folder / "recording.hbr");
  std::array<std::uint64_t, 3> outcomes{};
  for (std::size_t k = 0; k < reader.chunks().size(); ++k) {
    for (const RecordedContact& contact : reader.read(k).contacts)
      ++outcomes[static_cast<int>(contact.outcome)];
  }
  const Tally& tally = run.simulation.tally();
  EXPECT_EQ(outcomes, (std::array{tally.collisions() - tally.mergers() - tally.passes(), tally.passes(),
                                  tally.mergers()}));
}

TEST(RecordedBodies, HaveSpecies) {
  const ScratchFolder folder;
  record(folder / "recording.hbr", drops_and_mist(90), 0.1);
  const RecordingReader reader(folder / "recording.hbr");
  EXPECT_EQ(reader.header().has_bodies, true);
  EXPECT_EQ(reader.header().species_names, (std::vector<std::string>{"drop", "mist"}));
  std::vector<SpeciesId> species(30, 0);
  species.resize(90, 1);
  EXPECT_EQ(reader.header().species, species);
  EXPECT_EQ(reader.masses()[7], kInfinity);
  EXPECT_EQ(nlohmann::json::parse(reader.header_text())["species"],
            nlohmann::json::parse(R"({"names": ["drop", "mist"], "runs": [[0, 30], [1, 60]]})"));
}

// A quarter turn about z, then one about x, of a sphere that is sent off in between: what was x points to y,
// and then to z.
TEST(RecordedBodies, TurnAsTheySpin) {
  const ScratchFolder folder;
  constexpr double kQuarter = std::numbers::pi / 2;
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {5, 5, 5}, .spin = {0, 0, kQuarter}});
  RecordingWriter writer(folder / "recording.hbr", {}, world);
  VelocityChange change;
  change.time = Time(1);
  change.position = {5, 5, 5};
  SphereEdit(world, change.time, 0).store_spin(0, {kQuarter, 0, 0});
  writer.note(change, world);
  change.time = Time(3);
  SphereEdit(world, change.time, 0).store_spin(0, {});
  writer.note(change, world);
  writer.close(4);
  RecordingReader reader(folder / "recording.hbr");
  EXPECT_EQ(reader.header().has_bodies, true) << "a sphere spins";
  const RecordedChunk chunk = reader.read(0);
  EXPECT_EQ(chunk.bodies[0].orientation, Orientation());
  const Orientation once = chunk.bodies_at(1)[0].orientation;
  EXPECT_NEAR(once.real, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(once.imaginary.z, std::sqrt(0.5), 1e-15);
  // Half a turn about x: (1/sqrt(2)) i (1 + k) = (i - j) / sqrt(2).
  const Orientation then = chunk.bodies_at(3)[0].orientation;
  EXPECT_NEAR(then.real, 0, 1e-15);
  EXPECT_NEAR(length(then.imaginary - std::sqrt(0.5) * Vec3{1, -1, 0}), 0, 1e-15);
  EXPECT_EQ(chunk.bodies_at(2)[0].orientation, once) << "that at the start of the path";
}

TEST(RecordedBodies, OfSpheresThatDoNotSpinAreUpright) {
  const ScratchFolder folder;
  World world(Box::flat_periodic(10, 10));
  world.add({.position = {2, 2, 0}, .radius = 0.5, .mass = 3});
  RecordingWriter(folder / "recording.hbr", {.restitution = std::nan("")}, world).close(1);
  RecordingReader reader(folder / "recording.hbr");
  EXPECT_EQ(reader.header().has_bodies, false);
  EXPECT_TRUE(read_text(folder / "recording.hbr").starts_with("HBREC003"));
  EXPECT_TRUE(reader.header().box.is_flat());
  EXPECT_TRUE(std::isnan(reader.header().restitution));
  EXPECT_TRUE(nlohmann::json::parse(reader.header_text())["restitution"].is_null());
  EXPECT_FALSE(nlohmann::json::parse(reader.header_text()).contains("species"));
  const RecordingHeader of_walls = parse_recording_header(
      to_json({.restitution = std::nan(""), .surfaces = {{.restitution = std::nan("")}}}), "test");
  EXPECT_TRUE(std::isnan(of_walls.surfaces.at(0).restitution));
  EXPECT_EQ(reader.read(0).bodies.at(0), (RecordedBody{.radius = 0.5, .mass = 3}));
}

bool is_read(const ScratchFolder& folder, const std::string& bytes) {
  write_text(folder / "tried.hbr", bytes);
  try {
    RecordingReader reader(folder / "tried.hbr");
    for (std::size_t k = 0; k < reader.chunks().size(); ++k) {
      const RecordedChunk chunk = reader.read(k);
      EXPECT_EQ(chunk.bodies_at(chunk.end).size(), reader.header().spheres);
    }
    return true;
  } catch (const Error&) {
    return false;
  }
}

// Two spheres merge at time 1.
std::string merger(const ScratchFolder& folder) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {4, 1, 0}, .velocity = {-1, 0, 0}, .radius = 1});
  record(folder / "merger.hbr", std::move(world), 3);
  return read_text(folder / "merger.hbr");
}

TEST(RecordedBodies, AreReadOrRefusedWhateverTheFileContains) {
  const ScratchFolder folder;
  const std::string bytes = merger(folder);
  const std::uint64_t chunk = RecordingReader(folder / "merger.hbr").chunks().at(0).bytes.offset;
  EXPECT_EQ(bytes.size() - chunk, kLayout.chunk_bytes(2, 1));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_EQ(is_read(folder, bytes.substr(0, length)), length >= chunk) << length;
  }
  std::size_t refused = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const unsigned flip : {0x01U, 0xffU}) {
      std::string flipped = bytes;
      flipped[at] = static_cast<char>(static_cast<unsigned char>(flipped[at]) ^ flip);
      if (!is_read(folder, with_true_checksums(flipped))) ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
}

TEST(RecordedBodies, ThatNoRunCanProduceAreRefused) {
  const ScratchFolder folder;
  const std::string bytes = merger(folder);
  const std::size_t chunk = RecordingReader(folder / "merger.hbr").chunks().at(0).bytes.offset;
  const std::size_t body =
      chunk + recording_format::Layout::kSummedHeadBytes + 2 * recording_format::Layout::kPathBytes;
  const std::size_t contact =
      bytes.size() - recording_format::Layout::kChecksumBytes - kLayout.contact_bytes();
  const auto with = [&](std::size_t at, const std::string& replacement) {
    std::string changed = bytes;
    changed.replace(at, replacement.size(), replacement);
    return with_true_checksums(changed);
  };
  const std::string nan = "\xff\xff\xff\xff\xff\xff\xff\xff";
  const std::string zero(8, '\0');
  ASSERT_TRUE(is_read(folder, bytes));
  EXPECT_FALSE(is_read(folder, with(0, "HBREC002"))) << "which has no checksums";
  EXPECT_FALSE(is_read(folder, with(body, nan))) << "spin";
  EXPECT_FALSE(is_read(folder, with(body + 48, zero))) << "orientation";
  EXPECT_FALSE(is_read(folder, with(body + 56, zero))) << "radius of what has a mass";
  EXPECT_FALSE(is_read(folder, with(body + 64, zero))) << "mass";
  EXPECT_FALSE(is_read(folder, with(body + 72, nan))) << "moment";
  EXPECT_FALSE(is_read(folder, with(contact + 16, std::string(1, '\3') + std::string(7, '\0')))) << "outcome";
  EXPECT_FALSE(is_read(folder, with(contact + 12, "\xff\xff\xff\xff"))) << "a wall merges with nothing";
  EXPECT_FALSE(is_read(folder, with(contact + 72, nan))) << "spin";
  EXPECT_FALSE(is_read(folder, with(contact + 120, zero))) << "radius of the merged sphere";
}

TEST(RecordedBodies, NeedRunsOfSpeciesThatNameAllSpheres) {
  const auto species_in = [](const std::string& species) {
    return parse_recording_header(
               R"({"spheres": 3, "bodies": true, "box": {"size": [1, 1, 1], "boundary": ["wall", "wall", "wall"]},
                   "species": )" +
                   species + "}",
               "test")
        .species;
  };
  EXPECT_EQ(species_in(R"({"runs": [[4, 1], [2, 2]]})"), (std::vector<SpeciesId>{4, 2, 2}));
  EXPECT_TRUE(species_in(R"({"names": ["one"]})").empty());
  for (const char* const nonsense :
       {R"({"runs": [[0, 2]]})", R"({"runs": [[0, 4]]})", R"({"runs": [[256, 3]]})", R"({"runs": [[0, -3]]})",
        R"({"runs": [0, 3]})", R"({"runs": 3})", R"({"names": [3]})", R"({"names": "one"})",
        R"({"runs": [[0, 1e300]]})"}) {
    EXPECT_THROW(species_in(nonsense), Error) << nonsense;
  }
}

}  // namespace
}  // namespace hardball::recorded_bodies_test
