// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/recording.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/recording/recording_header.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"
#include "support/true_checksums.hpp"

namespace hardball::recording_test {
namespace {

using namespace support;

World make_mixture() {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {10, 8, 1}));
  world.add({.position = {2, 1, 0}, .velocity = {1, 0.5, 0.25}, .radius = 0.5, .mass = 2});
  world.add({.position = {5, 1, 0.1}, .velocity = {-1, 0, 0.125}, .radius = 0.75, .mass = 3});
  world.add({.position = {8, 7, 0}, .velocity = {-2, 1, 0}, .radius = 0.25, .mass = 1});
  return world;
}

Contact contact_at_time(double time) {
  Contact contact;
  contact.time = Time(time);
  contact.first = 0;
  contact.second = 1;
  return contact;
}

// Runs to `until`, recording everything.
Simulation record(const std::filesystem::path& path, World world, double until) {
  Simulation simulation(std::move(world));
  RecordingWriter writer(path, {.until = until, .name = "test"}, simulation.world());
  simulation.on_contact([&](const Contact& contact) { writer.record(contact, simulation.world()); });
  simulation.run_until(until);
  writer.close(until);
  simulation.on_contact({});
  return simulation;
}

RecordedPath stored_path(const World& world, SphereId id) {
  const Path& path = world.path(world.slot_of(id));
  return {path.position, path.velocity, path.time.value()};
}

class Recording : public testing::Test {
 protected:
  ScratchFolder folder_;
};
using RecordedBodies = Recording;

TEST(RecordingHeader, SaysWhatHoldsPackedSpheres) {
  const std::string json =
      to_json({.spheres = 2,
               .forces = {{.first = 0, .second = 1, .separation = {1, -2, 0}, .force = 1.5},
                          {.first = 1, .second = -6, .force = std::nan("")}}});
  EXPECT_NE(json.find(R"("forces":[[0,1,1.0,-2.0,0.0,1.5],[1,-6,0.0,0.0,0.0,null]])"), std::string::npos)
      << json;
  EXPECT_EQ(parse_recording_header(json, "test").spheres, 2U);
}

TEST(RecordingHeader, SaysWhichSpheresAreBonded) {
  const std::vector<std::array<SphereId, 2>> bonds{{0, 1}, {1, 4}};
  EXPECT_EQ(parse_recording_header(to_json({.spheres = 5, .bonds = bonds}), "test").bonds, bonds);
  EXPECT_EQ(to_json({.spheres = 5}).find("bonds"), std::string::npos);
}

TEST_F(Recording, ContainsTheHeaderAndTheSpheres) {
  const World world = make_mixture();
  const RecordingHeader header{.begin = 0.5,
                               .until = 2.25,
                               .cell_edge = {1, 2, 3},
                               .cell_origin = {-1, 0, 1},
                               .name = "a \"name\"\n \\ of \xc3\xa4",
                               .restitution = 0.9};
  RecordingWriter(folder_ / "recording.hbr", header, world).close(1);
  const RecordingReader reader(folder_ / "recording.hbr");
  EXPECT_EQ(reader.header().spheres, 3U);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(reader.header().box.boundary(axis), world.box().boundary(axis));
    EXPECT_EQ(reader.header().box.size()[axis], world.box().size()[axis]);
  }
  EXPECT_EQ(reader.header().begin, header.begin);
  EXPECT_EQ(reader.header().until, header.until);
  EXPECT_EQ(reader.header().cell_edge, header.cell_edge);
  EXPECT_EQ(reader.header().cell_origin, header.cell_origin);
  EXPECT_EQ(reader.header().name, header.name);
  EXPECT_EQ(reader.header().restitution, header.restitution);
  EXPECT_EQ(reader.radii(), (std::vector<double>{0.5, 0.75, 0.25}));
  EXPECT_EQ(reader.masses(), (std::vector<double>{2, 3, 1}));
  const nlohmann::json json = nlohmann::json::parse(reader.header_text());
  EXPECT_EQ(json["name"], header.name);
  EXPECT_EQ(json["box"]["boundary"], nlohmann::json::parse(R"(["wall", "periodic", "open"])"));
  EXPECT_EQ(json["box"]["size"], nlohmann::json::parse("[10, 8, 0]"));
  EXPECT_EQ(reader.spheres().offset % 8, 0U);
}

TEST_F(Recording, AnUnknownEndIsNull) {
  EXPECT_TRUE(nlohmann::json::parse(to_json({}))["until"].is_null());
  EXPECT_EQ(parse_recording_header(to_json({}), "test").until, std::nullopt);
}

std::vector<Surface> every_surface() {
  return {{OscillatingPlane({0, 0.6, 0.8}, 0.125, 3), {0, 0, 1}, {0, 0.25, 0.5}},
          {Cylinder({0, 0, 1}, 4), {5, 4, 0}, {}, {.temperature = 2.5}},
          {HollowSphere(7), {5, 4, 1}, {}, {.restitution = 0.5}},
          {Cone({0, 0.6, -0.8}, 0.25), {1, 1, 1}},
          {Obstacle(0.1), {1, 2, 3}},
          {Pillar({0, 0.6, 0.8}, 0.5), {1, 0, 0}}};
}

// What a recording says of surfaces, without restitutions.
std::string text_of(const std::vector<Surface>& surfaces) {
  return nlohmann::json::parse(to_json({.restitution = std::nan(""), .surfaces = surfaces}))["surfaces"]
      .dump();
}

TEST_F(Recording, SaysThatRoughSurfacesHaveNoOneRestitution) {
  const auto restitution_of = [](const SurfaceMaterial& material) {
    const RecordingHeader header{.restitution = 1, .surfaces = {{Plane({0, 0, 1}), {}, {}, material}}};
    return nlohmann::json::parse(to_json(header))["surfaces"][0]["restitution"];
  };
  EXPECT_EQ(restitution_of({.restitution = 0.5}), 0.5);
  EXPECT_TRUE(restitution_of({.restitution = 0.5, .tangential_restitution = 0.25}).is_null());
}

TEST_F(Recording, ContainsGravityAndSurfaces) {
  const RecordingHeader header{.gravity = {0, 0.5, -9.81}, .surfaces = every_surface()};
  RecordingWriter(folder_ / "recording.hbr", header, make_mixture()).close(1);
  const RecordingReader reader(folder_ / "recording.hbr");
  EXPECT_EQ(reader.header().gravity, header.gravity);
  EXPECT_EQ(nlohmann::json::parse(to_json(reader.header()))["surfaces"],
            nlohmann::json::parse(to_json(header))["surfaces"]);
  const nlohmann::json json = nlohmann::json::parse(reader.header_text());
  EXPECT_EQ(json["gravity"], nlohmann::json::parse("[0, 0.5, -9.81]"));
  EXPECT_EQ(json["surfaces"][1], nlohmann::json::parse(R"({"shape": "cylinder", "point": [5, 4, 0],
    "direction": [0, 0, 1], "radius": 4, "velocity": [0, 0, 0], "amplitude": 0, "frequency": 0,
    "temperature": 2.5, "restitution": 1})"));
  EXPECT_TRUE(json["surfaces"][0]["temperature"].is_null());
}

const std::string kBox =
    R"("bodies": false, "box": {"size": [1, 1, 1], "boundary": ["wall", "wall", "open"]})";

// The header of two spheres in that box, with more keys.
RecordingHeader header_of_two(const std::string& more) {
  return parse_recording_header(R"({"spheres": 2, )" + kBox + more + "}", "run.hbr");
}

TEST_F(Recording, KeysThatAreAbsentHaveTheUsualMeaning) {
  EXPECT_EQ(header_of_two("").gravity, Vec3{});
  EXPECT_TRUE(header_of_two("").surfaces.empty());
  const RecordingHeader header = header_of_two(R"(, "surfaces": [
         {"shape": "plane", "point": [1, 2, 3], "direction": [0, 0, 1]},
         {"shape": "obstacle", "point": [1, 2, 3], "radius": 2, "more": []}])");
  ASSERT_EQ(header.surfaces.size(), 2U);
  EXPECT_EQ(text_of(header.surfaces), text_of({{Plane({0, 0, 1}), {1, 2, 3}}, {Obstacle(2), {1, 2, 3}}}));
}

TEST_F(Recording, NumbersSurfacesAfterTheFacesOfTheBox) {
  const auto record_contact_with = [&](std::uint32_t surface) {
    RecordingWriter writer(folder_ / "recording.hbr", {.surfaces = every_surface()}, make_mixture());
    Contact contact;
    contact.kind = EventKind::wall;
    contact.time = Time(1);
    contact.first = 1;
    contact.second = surface;
    contact.after.first = {1, 2, 3};
    writer.record(contact, make_mixture());
    writer.close(2);
  };
  record_contact_with(10);
  RecordingReader reader(folder_ / "recording.hbr");
  const RecordedContact contact = reader.read(0).contacts.at(0);
  EXPECT_FALSE(contact.is_collision());
  EXPECT_EQ(contact.second, -11);
  EXPECT_EQ(contact.first_velocity, (Vec3{1, 2, 3}));
  record_contact_with(static_cast<std::uint32_t>(kFaces + every_surface().size()));
  EXPECT_THROW(RecordingReader(folder_ / "recording.hbr").read(0), Error) << "there is no such surface";
}

TEST_F(Recording, PathsAreParabolasUnderGravity) {
  const RecordedPath path{.position = {1, 2, 3}, .velocity = {0.5, 0, 4}, .time = 10};
  EXPECT_EQ(path.center_at(12, {0, 0, -2}), (Vec3{2, 2, 7}));
  EXPECT_EQ(path.velocity_at(12, {0, 0, -2}), (Vec3{0.5, 0, 0}));
  EXPECT_EQ(path.center_at(9, {0, 0, -2}), (Vec3{0.5, 2, -2}));
  EXPECT_EQ(path.center_at(12, {}), (Vec3{2, 2, 11}));
}

// Cut back and continued twice, from a moment at which several contacts were waiting for others at their
// time.
TEST_F(Recording, GoesOnFromWhatWasSaved) {
  const World world = make_gas({.count = 200, .packing_fraction = 0.3});
  const Simulation whole = record(folder_ / "whole.hbr", world, 5);
  Simulation simulation(world);
  std::string state;
  std::string saved;
  const auto go_on = [&](RecordingWriter& writer, double until) {
    simulation.on_contact([&](const Contact& contact) { writer.record(contact, simulation.world()); });
    simulation.run_until(until);
    simulation.on_contact({});
  };
  {
    RecordingWriter writer(folder_ / "parts.hbr", {.until = 5, .name = "test"}, simulation.world());
    go_on(writer, 2);
    state = writer.save();
    saved = simulation.save();
    go_on(writer, 4);
  }
  for (int time = 0; time < 2; ++time) {
    simulation = Simulation::load(saved);
    RecordingWriter writer(folder_ / "parts.hbr", state);
    go_on(writer, 5);
    writer.close(5);
  }
  EXPECT_EQ(read_text(folder_ / "parts.hbr"), read_text(folder_ / "whole.hbr"));
  EXPECT_EQ(simulation.event_log_hash(), whole.event_log_hash());
  std::filesystem::resize_file(folder_ / "parts.hbr", 1000);
  EXPECT_THROW(RecordingWriter(folder_ / "parts.hbr", state), Error) << "it is shorter";
}

TEST_F(Recording, ContainsEveryContactInOrder) {
  Simulation simulation(make_mixture());
  std::vector<Contact> noted;
  {
    RecordingWriter writer(folder_ / "recording.hbr", {}, simulation.world());
    simulation.on_contact([&](const Contact& contact) {
      writer.record(contact, simulation.world());
      noted.push_back(contact);
    });
    simulation.run_until(40);
    writer.close(40);
  }
  RecordingReader reader(folder_ / "recording.hbr");
  ASSERT_EQ(reader.chunks().size(), 1U);
  EXPECT_EQ(reader.reached(), 40);
  const RecordedChunk chunk = reader.read(0);
  ASSERT_EQ(chunk.contacts.size(), noted.size());
  bool has_collision = false;
  bool has_wall = false;
  for (std::size_t k = 0; k < noted.size(); ++k) {
    const RecordedContact& recorded = chunk.contacts[k];
    EXPECT_EQ(recorded.time, noted[k].time.value());
    EXPECT_EQ(recorded.first, noted[k].first);
    EXPECT_EQ(recorded.is_collision(), noted[k].is_collision());
    EXPECT_EQ(recorded.first_position, noted[k].position);
    EXPECT_EQ(recorded.first_velocity, noted[k].after.first);
    if (recorded.is_collision()) {
      EXPECT_EQ(recorded.second, static_cast<std::int32_t>(noted[k].second));
      EXPECT_EQ(recorded.second_position, noted[k].second_position);
      EXPECT_EQ(recorded.second_velocity, noted[k].after.second);
      has_collision = true;
    } else {
      EXPECT_EQ(recorded.second, -static_cast<std::int32_t>(noted[k].second) - 1);
      EXPECT_EQ(recorded.second_position, Vec3{});
      EXPECT_EQ(recorded.second_velocity, Vec3{});
      has_wall = true;
    }
  }
  EXPECT_TRUE(has_collision && has_wall);
}

// Each keyframe is where the previous chunk leads.
void expect_chunks_follow_each_other(RecordingReader& reader) {
  for (std::size_t k = 1; k < reader.chunks().size(); ++k) {
    const RecordedChunk before = reader.read(k - 1);
    EXPECT_EQ(reader.read(k).keyframe, before.paths_at(before.end)) << k;
    EXPECT_EQ(reader.read(k).bodies, before.bodies_at(before.end)) << k;
  }
}

void expect_stored_paths(const std::filesystem::path& path, World world) {
  const Simulation simulation = record(path, std::move(world), 5);
  RecordingReader reader(path);
  ASSERT_GT(reader.chunks().size(), 2U);
  const std::vector<RecordedPath> paths = reader.read(reader.chunks().size() - 1).paths_at(5);
  for (SphereId id = 0; id < simulation.size(); ++id) {
    EXPECT_EQ(paths[id], stored_path(simulation.world(), id)) << id;
  }
  expect_chunks_follow_each_other(reader);
}

TEST_F(Recording, ItsPathsAreTheStoredPathsBitForBit) {
  expect_stored_paths(folder_ / "recording.hbr", make_gas({.count = 200, .packing_fraction = 0.3}));
}

TEST_F(Recording, ItsPathsAreTheStoredPathsAlsoOfSpheresThatMetSlidingImages) {
  const World gas = make_gas({.count = 200, .packing_fraction = 0.3});
  Box box = gas.box();
  box.set_shear({.rate = 0.5});
  World sheared(box);
  for (const Path& path : gas.paths()) sheared.add({path.position, path.velocity, kDiameter / 2});
  expect_stored_paths(folder_ / "recording.hbr", std::move(sheared));
}

// The recording drops the low part of a time t, up to 2^-53 t: at each end of a path, a sphere is displaced
// by no more than it moves in that time, and by rounding.
TEST_F(Recording, CentersAreThoseOfTheSimulation) {
  constexpr double kMoment = 4.75;
  constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;
  const Simulation simulation =
      record(folder_ / "recording.hbr", make_gas({.count = 200, .packing_fraction = 0.3}), kMoment);
  RecordingReader reader(folder_ / "recording.hbr");
  const std::vector<RecordedPath> paths = reader.read(reader.chunks().size() - 1).paths_at(kMoment);
  const std::vector<Vec3> centers = simulation.positions();
  const Vec3 size = simulation.world().box().size();
  for (SphereId id = 0; id < simulation.size(); ++id) {
    Vec3 center = paths[id].center_at(kMoment, {});
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      center[axis] -= size[axis] * std::floor(center[axis] / size[axis]);
      const double flown = kHalfUlp * kMoment * std::fabs(paths[id].velocity[axis]);
      EXPECT_NEAR(center[axis], centers[id][axis], 2 * flown + 4 * kHalfUlp * size[axis]) << id;
    }
  }
}

TEST_F(Recording, DoesNotAlterTheMotion) {
  const World world = make_gas({.count = 100, .packing_fraction = 0.2});
  Simulation alone(world);
  alone.run_until(5);
  EXPECT_EQ(record(folder_ / "recording.hbr", world, 5).event_log_hash(), alone.event_log_hash());
}

TEST_F(Recording, ContactsAtOneTimeAreNotSplit) {
  {
    RecordingWriter writer(folder_ / "recording.hbr", {}, make_mixture());
    for (int k = 0; k < 1500; ++k) writer.record(contact_at_time(1), make_mixture());
    for (int k = 0; k < 10; ++k) writer.record(contact_at_time(2), make_mixture());
    writer.close(3);
  }
  const RecordingReader reader(folder_ / "recording.hbr");
  ASSERT_EQ(reader.chunks().size(), 2U);
  EXPECT_EQ(reader.chunks()[0].contacts, 1500U);
  EXPECT_EQ(reader.chunks()[0].end, 1);
  EXPECT_EQ(reader.chunks()[1].begin, 1);
  EXPECT_EQ(reader.chunks()[1].contacts, 10U);
  EXPECT_EQ(reader.chunks()[1].end, 3);
}

TEST_F(Recording, FlushLetsReadersSeeWhatIsSurelyComplete) {
  RecordingWriter writer(folder_ / "recording.hbr", {}, make_mixture());
  RecordingReader reader(folder_ / "recording.hbr");
  EXPECT_TRUE(reader.chunks().empty());
  EXPECT_EQ(reader.reached(), 0);
  for (const double time : {1.0, 2.0, 3.0, 3.0}) writer.record(contact_at_time(time), make_mixture());
  reader.refresh();
  EXPECT_TRUE(reader.chunks().empty());
  writer.flush();
  reader.refresh();
  ASSERT_EQ(reader.chunks().size(), 1U);
  EXPECT_EQ(reader.chunks()[0].contacts, 2U);
  EXPECT_EQ(reader.reached(), 2);
  writer.flush();
  reader.refresh();
  EXPECT_EQ(reader.chunks().size(), 1U);
  writer.record(contact_at_time(3), make_mixture());
  writer.close(3.5);
  reader.refresh();
  ASSERT_EQ(reader.chunks().size(), 2U);
  EXPECT_EQ(reader.chunks()[1].contacts, 3U);
  EXPECT_EQ(reader.reached(), 3.5);
  EXPECT_EQ(reader.length(), std::filesystem::file_size(folder_ / "recording.hbr"));
}

TEST_F(Recording, FlushWritesNothingThatTakesNoTime) {
  RecordingWriter writer(folder_ / "recording.hbr", {}, make_mixture());
  RecordingReader reader(folder_ / "recording.hbr");
  const auto chunks_after = [&](double time) {
    writer.record(contact_at_time(time), make_mixture());
    writer.flush();
    reader.refresh();
    return reader.chunks().size();
  };
  EXPECT_EQ(chunks_after(0), 0U);
  EXPECT_EQ(chunks_after(1), 0U) << "of the time 0 alone";
  ASSERT_EQ(chunks_after(2), 1U);
  EXPECT_EQ(reader.chunks()[0].contacts, 2U);
}

TEST_F(Recording, PredictsItsLength) {
  RecordingWriter writer(folder_ / "recording.hbr", {}, make_mixture());
  for (const double time : {1.0, 2.0, 3.0}) writer.record(contact_at_time(time), make_mixture());
  const std::uint64_t bytes = writer.bytes();
  writer.close(4);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "recording.hbr"), bytes);
}

TEST_F(Recording, WhatWasNotClosedEndsAtTheLastContact) {
  {
    RecordingWriter writer(folder_ / "recording.hbr", {}, make_mixture());
    for (const double time : {1.0, 2.0, 3.0}) writer.record(contact_at_time(time), make_mixture());
  }
  const RecordingReader reader(folder_ / "recording.hbr");
  EXPECT_EQ(reader.reached(), 3);
}

TEST_F(Recording, ARunWithoutContactsHasOneChunk) {
  RecordingWriter(folder_ / "recording.hbr", {}, World()).close(0);
  RecordingReader reader(folder_ / "recording.hbr");
  ASSERT_EQ(reader.chunks().size(), 1U);
  EXPECT_TRUE(reader.read(0).keyframe.empty());
  EXPECT_THROW(reader.read(1), Error);
}

TEST_F(Recording, OfBeforeTheFirstReleaseIsRefused) {
  write_text(folder_ / "old.hbr", "HBREC002" + std::string(100, '\0'));
  const std::string refusal = refusal_of([&] { RecordingReader(folder_ / "old.hbr"); });
  EXPECT_NE(refusal.find("before the first release"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("record the run again"), std::string::npos) << refusal;
}

TEST_F(Recording, InvalidHeadersAreRefused) {
  const std::string& box = kBox;
  EXPECT_EQ(parse_recording_header(R"({"more": {"a": [1, {}, null, "x"]}, "spheres": 2, )" + box + "} ", "x")
                .spheres,
            2U);
  const std::vector<std::string> nonsense{
      "",
      "{",
      "[]",
      "{}",
      R"({"spheres": 2})",
      "{" + box + "}",
      R"({"spheres": -1, )" + box + "}",
      R"({"spheres": 1.5, )" + box + "}",
      R"({"spheres": 1e300, )" + box + "}",
      R"({"spheres": nan, )" + box + "}",
      R"({"spheres": "2", )" + box + "}",
      R"({"spheres": 2, )" + box + "} more",
      R"({"spheres": 2, "name": "x)",
      R"({"spheres": 2, "name": "\u12)",
      R"({"spheres": 2, "name": "\ux000", )" + box + "}",
      R"({"spheres": 2, "cell_edge": [1, 2], )" + box + "}",
      R"({"spheres": 2, "cell_edge": [1, 2, 3, 4], )" + box + "}",
      R"({"spheres": 2, "gravity": 9.81, )" + box + "}",
      R"({"spheres": 2, "gravity": [0, 0], )" + box + "}",
      R"({"spheres": 2, "gravity": [0, 0, null], )" + box + "}",
      R"({"spheres": 2, "gravity": [0, 0, 1e400], )" + box + "}",
      R"({"spheres": 2, "bonds": {}, )" + box + "}",
      R"({"spheres": 2, "bonds": [0, 1], )" + box + "}",
      R"({"spheres": 2, "bonds": [[0]], )" + box + "}",
      R"({"spheres": 2, "bonds": [[0, 1, 1]], )" + box + "}",
      R"({"spheres": 2, "bonds": [[0, 2]], )" + box + "}",
      R"({"spheres": 2, "bonds": [[-1, 0]], )" + box + "}",
      R"({"spheres": 2, "bonds": [[1, 1]], )" + box + "}",
      R"({"spheres": 0, "bonds": [[0, 0]], )" + box + "}",
      R"({"spheres": 2, "bodies": false, "box": {"size": [0, 1, 1], "boundary": ["wall", "wall", "wall"]}})",
      R"({"spheres": 2, "bodies": false, "box": {"size": [1, 1, 1], "boundary": ["wall", "wall"]}})",
      R"({"spheres": 2, "bodies": false, "box": {"size": [1, 1, 1], "boundary": ["wall", "wall", "wall", "wall"]}})",
      R"({"spheres": 2, "bodies": false, "box": {"size": [1, 1, 1], "boundary": ["wall", "wall", "door"]}})",
      R"({"deep": )" + std::string(100000, '['),
  };
  for (const std::string& json : nonsense) {
    EXPECT_THROW(parse_recording_header(json, "test"), Error) << json.substr(0, 80);
  }
}

TEST_F(Recording, WhateverAHeaderContainsIsReadOrRefused) {
  const std::string json = to_json({.name = "small", .gravity = {0, 0, -9.81}, .surfaces = every_surface()});
  std::size_t refused = 0;
  std::size_t read = 0;
  const auto attempt = [&](const std::string& changed) {
    try {
      const RecordingHeader header = parse_recording_header(changed, "test");
      for (const Surface& surface : header.surfaces) {
        EXPECT_TRUE(surface.normal() || surface.largest_sphere() > 0) << changed;
        EXPECT_TRUE(std::isfinite(dot(surface.point(), surface.velocity()))) << changed;
      }
      ++read;
    } catch (const Error&) {
      ++refused;
    }
  };
  for (std::size_t at = 0; at < json.size(); ++at) {
    attempt(json.substr(0, at));
    for (const char letter : {'0', '9', '-', '"', ',', ':', '[', '}', 'x', '\0', '\xff'}) {
      std::string changed = json;
      changed[at] = letter;
      attempt(changed);
    }
  }
  EXPECT_GT(refused, json.size());
  EXPECT_GT(read, json.size()) << "most digits can be others";
}

// The message with which a header with these surfaces is refused; empty if it is read.
std::string refusal_of_surfaces(const std::string& surfaces) {
  return refusal_of([&] { header_of_two(R"(, "surfaces": )" + surfaces); });
}

TEST_F(Recording, InvalidSurfacesAreRefusedByNumber) {
  const std::string plane = R"({"shape": "plane", "point": [0, 0, 0], "direction": [0, 0, 1]})";
  ASSERT_EQ(refusal_of_surfaces("[" + plane + "]"), "");
  ASSERT_EQ(refusal_of_surfaces("[]"), "");
  const auto expect_refused = [&](const std::string& surface, const std::string& problem) {
    const std::string message = refusal_of_surfaces("[" + plane + ", " + surface + "]");
    EXPECT_NE(message.find("surface 1: " + problem), std::string::npos) << surface << ": " << message;
    EXPECT_NE(message.find("run.hbr"), std::string::npos) << message;
  };
  expect_refused("3", "is not an object");
  expect_refused("{}", "key 'shape' is missing");
  expect_refused(R"({"shape": "torus", "point": [0, 0, 0]})", "a shape is unknown");
  const std::string cone = R"({"shape": "cone", "point": [0, 0, 0], "direction": [0, 0, 1], "slope": )";
  ASSERT_EQ(refusal_of_surfaces("[" + cone + "0.5}]"), "");
  expect_refused(cone + "0}", "the slope of a surface is 0");
  expect_refused(R"({"shape": 1, "point": [0, 0, 0]})", "a shape is unknown");
  expect_refused(R"({"shape": "plane", "direction": [0, 0, 1]})", "key 'point' is missing");
  expect_refused(R"({"shape": "plane", "point": [0, 0, 0]})", "key 'direction' is missing");
  expect_refused(R"({"shape": "plane", "point": [0, 0], "direction": [0, 0, 1]})",
                 "there are not three entries");
  expect_refused(R"({"shape": "plane", "point": [0, 0, null], "direction": [0, 0, 1]})",
                 "a number is missing");
  expect_refused(R"({"shape": "plane", "point": [0, 0, 0], "direction": [0, 0, 2]})",
                 "the normal of a surface has the length 2");
  expect_refused(R"({"shape": "cylinder", "point": [0, 0, 0], "direction": [0, 0, 0], "radius": 1})",
                 "the axis of a surface has the length 0");
  expect_refused(R"({"shape": "cylinder", "point": [0, 0, 0], "direction": [0, 0, 1]})",
                 "key 'radius' is missing");
  expect_refused(R"({"shape": "sphere", "point": [0, 0, 0], "radius": 0})", "the radius of a surface is 0");
  expect_refused(R"({"shape": "obstacle", "point": [0, 0, 0], "radius": -1})",
                 "the radius of a surface is -1");
  expect_refused(R"({"shape": "obstacle", "point": [0, 0, 0], "radius": 1, "velocity": 2})",
                 "there are not three entries");
  expect_refused(R"({"shape": "obstacle", "point": [0, 0, 0], "radius": 1, "amplitude": 2})",
                 "a surface oscillates that is not a plane");
  expect_refused(R"({"shape": "sphere", "point": [0, 0, 0], "radius": 1, "frequency": -1})",
                 "a surface oscillates that is not a plane");
  expect_refused(R"({"shape": "sphere", "point": [0, 0, 0], "radius": 1, "temperature": -1})",
                 "the temperature of a surface is -1");
  expect_refused(R"({"shape": "sphere", "point": [0, 0, 0], "radius": 1, "temperature": "hot"})",
                 "a number is missing");
  expect_refused(R"({"shape": "sphere", "point": [0, 0, 0], "radius": 1, "restitution": -1})",
                 "the restitution of a surface is -1");
  for (const std::string surfaces : {"{}", "null", "3", "\"plane\""}) {
    EXPECT_NE(refusal_of_surfaces(surfaces).find("the surfaces are not a list"), std::string::npos)
        << surfaces;
  }
}

TEST_F(Recording, MissingFilesAndDirectoriesAreRefused) {
  EXPECT_THROW(RecordingReader(folder_ / "missing.hbr"), Error);
  EXPECT_THROW(RecordingReader(folder_.path()), Error);
}

RecordingHeader header_with(const Interactions& interactions) {
  return recording_header(
      Simulation(interacting(make_gas({.count = 20, .packing_fraction = 0.05}), interactions)));
}

TEST(RecordingHeader, BeginsNow) {
  Simulation simulation(make_gas({.count = 20, .packing_fraction = 0.05}), {.engine = EngineKind::cells});
  simulation.run_until(2.5);
  const RecordingHeader header = recording_header(simulation);
  EXPECT_EQ(header.begin, 2.5);
  EXPECT_FALSE(header.until);
  EXPECT_EQ(header.cell_edge, simulation.cell_edges());
  EXPECT_NE(header.cell_edge, Vec3{});
}

TEST(RecordingHeader, HasTheRestitutionIfItIsOneNumber) {
  EXPECT_EQ(header_with({}).restitution, 1);
  EXPECT_EQ(header_with(Restitution(0.75)).restitution, 0.75);
  const auto bounce = [](double restitution) {
    return Bounce({.restitution = ConstantRestitution{restitution}, .contact_duration = 1e-3});
  };
  ResponseTable table(bounce(0.5), bounce(0.25));
  EXPECT_EQ(header_with(table).restitution, 0.5) << "walls are not asked";
  table.set(0, 1, bounce(0.5));
  EXPECT_EQ(header_with(table).restitution, 0.5);
  table.set(1, 2, bounce(0.625));
  EXPECT_TRUE(std::isnan(header_with(table).restitution));
  EXPECT_TRUE(std::isnan(header_with(ResponseTable(Merging())).restitution));
  const Bounce rough({.tangential_restitution = 0});
  EXPECT_TRUE(std::isnan(header_with(ResponseTable(rough)).restitution));
  Simulation simulation(make_gas({.count = 20, .packing_fraction = 0.05}));
  simulation.respond_with([](const Contact& contact) { return contact.before; });
  EXPECT_TRUE(std::isnan(recording_header(simulation).restitution));
  simulation.respond_with(nullptr);
  EXPECT_EQ(recording_header(simulation).restitution, 1);
}

TEST(RecordingHeader, HasBodiesWhereContactsMayChangeThem) {
  EXPECT_EQ(header_with({}).has_bodies, false);
  EXPECT_EQ(header_with(ResponseTable(Bounce(), Bounce())).has_bodies, false);
  ResponseTable table;
  table.set(0, 3, Merging());
  EXPECT_EQ(header_with(table).has_bodies, true);
  EXPECT_EQ(header_with(ResponseTable(Bounce(), Bounce({.tangential_restitution = -0.5}))).has_bodies, true)
      << "walls may be rough";
  Simulation simulation(make_gas({.count = 20, .packing_fraction = 0.05}));
  simulation.respond_with([](const Contact& contact) { return contact.before; });
  EXPECT_EQ(recording_header(simulation).has_bodies, true);
}

TEST(RecordingHeader, HasBonds) {
  StepTable steps;
  const StepTable::Number tether = steps.add_bond(StepPotential({.steps = {{2, 0}}, .is_tether = true}));
  World world(Box::open());
  for (const double x : {0.0, 3.0, 6.0}) world.add({.position = {x, 0, 0}, .radius = 1});
  Interactions interactions;
  interactions.set_steps(steps);
  world.set_interactions(interactions);
  add_bond(world, 2, 1, tether);
  add_bond(world, 0, 1, tether);
  const RecordingHeader header = recording_header(Simulation(world));
  const std::vector<std::array<SphereId, 2>> bonds{{0, 1}, {1, 2}};
  EXPECT_EQ(header.bonds, bonds);
}

TEST(RecordingHeader, HasGravityAndSurfaces) {
  const std::vector<Surface> surfaces{
      {Plane({0, 0, 1}), {1, 2, 3}, {0, 0, 0.25}, {.restitution = 0.5}},
      {OscillatingPlane({1, 0, 0}, 0.125, 2), {-20, 0, 0}},
      {Cylinder({0, 0, 1}, 30), {5, 5, 0}, {}, {.temperature = 2}},
      {HollowSphere(40), {5, 5, 5}},
      {Obstacle(1.5), {9, 9, 9}},
  };
  World world(Box::open(), {0, 0, -2}, surfaces);
  world.add({.position = {5, 5, 5}});
  const RecordingHeader header = recording_header(Simulation(interacting(world, Restitution(0.75))));
  EXPECT_EQ(header.gravity, (Vec3{0, 0, -2}));
  EXPECT_EQ(text_of(header.surfaces), text_of(surfaces));
  const nlohmann::json json = nlohmann::json::parse(to_json(header))["surfaces"];
  EXPECT_EQ(json[0]["restitution"], 0.5);
  EXPECT_EQ(json[1], nlohmann::json::parse(R"({"shape": "plane", "point": [-20, 0, 0], "direction": [1, 0, 0],
    "radius": 0, "velocity": [0, 0, 0], "amplitude": 0.125, "frequency": 2, "temperature": null,
    "restitution": 0.75})"));
}

// Recordings of spheres that spin, merge, pass through each other, or are kinematic.

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
Recorded record_bodies(const std::filesystem::path& path, World world, double until, double check_every,
                       const Check& check) {
  Recorded run{Simulation(interacting(std::move(world), every_outcome()))};
  Simulation& simulation = run.simulation;
  RecordingWriter writer(path, {.has_bodies = true, .until = until, .species_names = {"drop", "mist"}},
                         simulation.world());
  simulation.on_contact([&](const Contact& contact) {
    writer.record(contact, simulation.world());
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

Recorded record_bodies(const std::filesystem::path& path, World world, double until) {
  return record_bodies(path, std::move(world), until, until, [](const Simulation&) {});
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

TEST_F(RecordedBodies, AreThoseOfTheSimulationAtAnyTime) {
  std::vector<Snapshot> snapshots;
  const Recorded run = record_bodies(folder_ / "recording.hbr", drops_and_mist(150), 12, 0.5,
                                     [&](const Simulation& simulation) {
                                       snapshots.push_back({simulation.time(), simulation.world()});
                                     });
  const Tally& tally = run.simulation.tally();
  ASSERT_GT(tally.mergers(), 10U);
  ASSERT_GT(tally.passes(), 10U);
  EXPECT_EQ(tally.mergers(), run.mergers);
  EXPECT_EQ(run.simulation.size(), 150 - tally.mergers());
  ASSERT_GT(rotational_energy(run.simulation.world()), 0);
  RecordingReader reader(folder_ / "recording.hbr");
  ASSERT_GT(reader.chunks().size(), 3U);
  for (const Snapshot& snapshot : snapshots) expect_same(moment_of(reader, snapshot.time), snapshot);
  expect_chunks_follow_each_other(reader);
  std::array<std::uint64_t, 3> outcomes{};
  reader.verify([&](const RecordedChunk& chunk) {
    for (const RecordedContact& contact : chunk.contacts) ++outcomes[static_cast<int>(contact.outcome)];
  });
  EXPECT_EQ(outcomes, (std::array{tally.collisions() - tally.mergers() - tally.passes(), tally.passes(),
                                  tally.mergers()}));
}

// Ids are missing: some spheres have become part of others, one has been removed, and so has the last.
TEST_F(RecordedBodies, MayHaveGapsWhereTheRecordingBeginsMidway) {
  Simulation simulation(interacting(drops_and_mist(150), every_outcome()));
  simulation.run_until(3);
  ASSERT_GT(simulation.tally().mergers(), 0U);
  for (const SphereId id : {60U, 149U}) simulation.remove(id);
  std::vector<Snapshot> snapshots{{simulation.time(), simulation.world()}};
  RecordingWriter writer(folder_ / "recording.hbr", recording_header(simulation), simulation.world());
  simulation.on_contact([&](const Contact& contact) { writer.record(contact, simulation.world()); });
  const std::uint64_t mergers = simulation.tally().mergers();
  for (int k = 7; k <= 20; ++k) {
    simulation.run_until(0.5 * k);
    snapshots.push_back({simulation.time(), simulation.world()});
    if (k % 5 == 0) writer.flush();
  }
  writer.close(simulation.time());
  ASSERT_GT(simulation.tally().mergers(), mergers);
  RecordingReader reader(folder_ / "recording.hbr");
  ASSERT_GT(reader.chunks().size(), 1U);
  EXPECT_EQ(reader.header().has_bodies, true);
  EXPECT_EQ(reader.header().spheres, 149U) << "the last id is 148";
  EXPECT_EQ(reader.header().begin, 3);
  EXPECT_EQ(reader.radii()[60], 0);
  EXPECT_EQ(reader.masses()[60], 0);
  for (const Snapshot& snapshot : snapshots) expect_same(moment_of(reader, snapshot.time), snapshot);
}

TEST_F(RecordedBodies, OfARemovedSphereAreRecorded) {
  World world = make_gas({.count = 20, .packing_fraction = 0.05});
  world.remove(world.slot_of(3));
  RecordingWriter(folder_ / "recording.hbr", {}, world).close(1);
  const RecordingReader reader(folder_ / "recording.hbr");
  EXPECT_EQ(reader.header().has_bodies, true);
  EXPECT_EQ(reader.header().spheres, 20U);
  EXPECT_EQ(reader.radii()[3], 0);
}

TEST_F(RecordedBodies, AreOfAllSpheresOtherwise) {
  const World world = make_gas({.count = 20, .packing_fraction = 0.05});
  RecordingWriter(folder_ / "recording.hbr", {}, world).close(1);
  const RecordingReader reader(folder_ / "recording.hbr");
  ASSERT_EQ(reader.header().has_bodies, false);
  const std::string whole = read_text(folder_ / "recording.hbr");
  for (const std::uint64_t number : {3U, 20U + 3U}) {  // a radius, a mass
    std::string bytes = whole;
    bytes.replace(reader.spheres().offset + 8 * number, 8, 8, '\0');
    write_text(folder_ / "recording.hbr", with_true_checksums(bytes));
    EXPECT_THROW(RecordingReader(folder_ / "recording.hbr"), Error) << number;
  }
}

TEST_F(RecordedBodies, HaveSpecies) {
  record_bodies(folder_ / "recording.hbr", drops_and_mist(90), 0.1);
  const RecordingReader reader(folder_ / "recording.hbr");
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
TEST_F(RecordedBodies, TurnAsTheySpin) {
  constexpr double kQuarter = std::numbers::pi / 2;
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {5, 5, 5}, .spin = {0, 0, kQuarter}});
  RecordingWriter writer(folder_ / "recording.hbr", {}, world);
  VelocityChange change;
  change.time = Time(1);
  change.position = {5, 5, 5};
  SphereEdit(world, change.time, 0).store_spin(0, {kQuarter, 0, 0});
  writer.record(change, world);
  change.time = Time(3);
  SphereEdit(world, change.time, 0).store_spin(0, {});
  writer.record(change, world);
  writer.close(4);
  RecordingReader reader(folder_ / "recording.hbr");
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

TEST(Orientations, HaveTheSameBitsOnAllMachines) {
  std::uint64_t bits = 0;
  for (int k = -40; k <= 40; ++k) {
    const double angle = 0.37 * k;
    const Orientation turned = Orientation().turned({0, 0, 2}, angle);
    EXPECT_NEAR(turned.imaginary.z, std::sin(angle), 1e-15);
    EXPECT_NEAR(turned.real, std::cos(angle), 1e-15);
    bits = std::rotl(bits, 7) ^ std::bit_cast<std::uint64_t>(turned.imaginary.z) ^
           std::rotl(std::bit_cast<std::uint64_t>(turned.real), 32);
  }
  EXPECT_EQ(bits, 0x229ded6a13e56f6bU);
}

TEST_F(RecordedBodies, OfSpheresThatDoNotSpinAreUpright) {
  World world(Box::flat_periodic(10, 10));
  world.add({.position = {2, 2, 0}, .radius = 0.5, .mass = 3});
  RecordingWriter(folder_ / "recording.hbr", {.restitution = std::nan("")}, world).close(1);
  RecordingReader reader(folder_ / "recording.hbr");
  EXPECT_EQ(reader.header().has_bodies, false);
  EXPECT_TRUE(read_text(folder_ / "recording.hbr").starts_with("HBREC003"));
  EXPECT_TRUE(reader.header().box.is_flat());
  EXPECT_TRUE(std::isnan(reader.header().restitution));
  EXPECT_TRUE(nlohmann::json::parse(reader.header_text())["restitution"].is_null());
  EXPECT_FALSE(nlohmann::json::parse(reader.header_text()).contains("species"));
  const RecordingHeader of_walls = parse_recording_header(
      to_json({.restitution = std::nan(""), .surfaces = {{Plane({0, 0, 1}), {}}}}), "test");
  EXPECT_FALSE(of_walls.surfaces.at(0).material().restitution);
  EXPECT_EQ(reader.read(0).bodies.at(0), (RecordedBody{.radius = 0.5, .mass = 3}));
}

TEST_F(RecordedBodies, NeedRunsOfSpeciesThatNameAllSpheres) {
  const auto species_in = [](const std::string& species) {
    return parse_recording_header(R"({"spheres": 3, )" + kBox + R"(, "species": )" + species + "}", "test")
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

// Recordings of spheres that grow: at each contact, spheres of the sizes that the recording has touch each
// other.

// Writes in two sittings, each with a part of the chunks.
Simulation record(const std::filesystem::path& path, Boundary boundary) {
  Simulation simulation(make_gas({.count = 200, .packing_fraction = 0.2, .boundary = boundary}));
  simulation.grow({.rate = 0.1, .until_packing_fraction = 0.5});
  std::optional<RecordingWriter> writer;
  writer.emplace(path, recording_header(simulation), simulation.world());
  simulation.observe(recording_observer(*writer, simulation));
  simulation.run_contacts(1000);
  const std::string saved = writer->save();
  writer.reset();
  writer.emplace(path, saved);
  while (!simulation.growth()->is_over()) simulation.run_until(simulation.growth()->next());
  simulation.run_until(simulation.time() + 0.1);
  writer->close(simulation.time());
  simulation.observe({});
  return simulation;
}

TEST(RecordedGrowth, HasSpheresTouchAtTheirContacts) {
  const ScratchFolder folder;
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    const std::filesystem::path path = folder / (boundary == Boundary::wall ? "walls.hbr" : "periodic.hbr");
    const Simulation simulation = record(path, boundary);
    RecordingReader reader(path);
    EXPECT_EQ(reader.header().layout().version(), 4);
    EXPECT_TRUE(reader.header().has_growth);
    const Box& box = reader.header().box;
    std::uint64_t contacts = 0;
    std::uint64_t epochs = 0;
    ASSERT_GT(reader.chunks().size(), 2U);
    reader.verify([&](const RecordedChunk& chunk) {
      for (const RecordedContact& contact : chunk.contacts) {
        epochs += contact.is_epoch() ? 1U : 0U;
        if (!contact.is_collision() && !contact.is_wall()) continue;
        ++contacts;
        const double scale = chunk.scale_at(contact.time);
        if (contact.is_wall()) continue;
        Vec3 apart = contact.second_position - contact.first_position;
        apart -= box.shift(box.nearest_image(apart));
        const double reach = scale * (reader.radii()[contact.first] +
                                      reader.radii()[static_cast<std::size_t>(contact.second)]);
        // Contact times are recorded as doubles.
        ASSERT_NEAR(length(apart), reach, 1e-12);
      }
    });
    EXPECT_EQ(contacts, simulation.counters().contacts());
    // The first had begun before the recording.
    EXPECT_EQ(epochs + 1, simulation.growth()->epochs());
    const RecordedChunk last = reader.read(reader.chunks().size() - 1);
    EXPECT_NEAR(last.scale_at(last.end) * reader.radii()[3], simulation.world().radius(3, simulation.now()),
                1e-15);
  }
}

// Spheres that do not grow are recorded in the version that earlier readers know.
// Spheres under a lid that moves, in two sittings: at each contact with it, spheres touch it where it is.
TEST(RecordedMotions, HaveSpheresTouchTheirWalls) {
  const ScratchFolder folder;
  const Surface floor(Plane({0, 0, 1}), {});
  const Surface lid(Plane({0, 0, -1}), {0, 0, 10});
  World world(Box({Boundary::periodic, Boundary::periodic, Boundary::open}, {10, 10, 10}), {}, {floor, lid});
  for (SphereId k = 0; k < 50; ++k) {
    const double x = 1 + 2 * (k % 5);
    const double y = 1 + 2 * (k / 5 % 5);
    world.add({.position = {x, y, 2.5 + 2 * (k / 25)}, .velocity = {0.1 * x, 0.2, 1}, .radius = 0.5});
  }
  Simulation simulation(world);
  const auto motion = PrescribedMotion::oscillation({0, 0, 1}, 2, 0.1, 0.2);
  simulation.drive(DrivenMotion("lid", motion, {}, {kFaces + 1}));
  simulation.run_until(1);
  std::optional<RecordingWriter> writer;
  writer.emplace(folder / "lid.hbr", recording_header(simulation), simulation.world());
  simulation.observe(recording_observer(*writer, simulation));
  simulation.run_until(30);
  const std::string saved = writer->save();
  writer.reset();
  writer.emplace(folder / "lid.hbr", saved);
  std::vector<Surface> middle;
  simulation.run_until(33);
  middle.assign(simulation.world().surfaces().begin(), simulation.world().surfaces().end());
  simulation.run_until(120);
  writer->close(simulation.time());
  simulation.observe({});
  RecordingReader reader(folder / "lid.hbr");
  EXPECT_EQ(reader.header().layout().version(), 5);
  ASSERT_GT(reader.chunks().size(), 2U);
  std::size_t touches = 0;
  std::size_t changes = 0;
  reader.verify([&](const RecordedChunk& chunk) {
    for (const RecordedContact& contact : chunk.contacts) {
      changes += contact.is_surface() ? 1U : 0U;
      if (!contact.is_wall()) continue;
      const auto number = static_cast<std::size_t>(~contact.second) - kFaces;
      const Surface surface = chunk.surfaces_at(contact.time, reader.header().surfaces)[number];
      ASSERT_NEAR(surface.distance(contact.first_position, Time(contact.time)), 0.5, 1e-12);
      ++touches;
    }
    if (!(chunk.begin <= 33 && 33 <= chunk.end)) return;
    const Surface recorded = chunk.surfaces_at(33, reader.header().surfaces)[1];
    EXPECT_NEAR(recorded.at_rest(Time(33)).point().z, middle[1].at_rest(Time(33)).point().z, 1e-12);
  });
  EXPECT_GT(touches, 500U);
  EXPECT_GT(changes, 50U);
}

TEST(RecordedGrowth, IsNotInOtherRecordings) {
  const ScratchFolder folder;
  Simulation simulation(make_gas({.count = 20, .packing_fraction = 0.2}));
  RecordingWriter(folder / "run.hbr", recording_header(simulation), simulation.world()).close(0);
  EXPECT_EQ(RecordingReader(folder / "run.hbr").header().layout().version(), 3);
}

// Files that are cut off, damaged, or made up.

// A file of three spheres in two chunks.
std::string small_recording(const ScratchFolder& folder) {
  Simulation simulation(make_mixture());
  RecordingWriter writer(folder / "small.hbr", {.until = 30, .name = "small"}, simulation.world());
  simulation.on_contact([&](const Contact& contact) { writer.record(contact, simulation.world()); });
  simulation.run_until(2);
  writer.flush();
  simulation.run_until(4);
  writer.close(4);
  return read_text(folder / "small.hbr");
}

// Two spheres merge at time 1.
std::string merger(const ScratchFolder& folder) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {4, 1, 0}, .velocity = {-1, 0, 0}, .radius = 1});
  record_bodies(folder / "merger.hbr", std::move(world), 3);
  return read_text(folder / "merger.hbr");
}

// Reads everything in the bytes; false if they are refused by an Error.
bool is_read(const ScratchFolder& folder, const std::string& bytes) {
  write_text(folder / "tried.hbr", bytes);
  try {
    RecordingReader reader(folder / "tried.hbr");
    for (std::size_t chunk = 0; chunk < reader.chunks().size(); ++chunk) {
      const RecordedChunk recorded = reader.read(chunk);
      EXPECT_EQ(recorded.paths_at(recorded.end).size(), reader.header().spheres);
      EXPECT_EQ(recorded.bodies_at(recorded.end).size(), reader.header().spheres);
    }
    EXPECT_LE(reader.length(), bytes.size());
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST_F(Recording, TruncatedAnywhereItShowsTheCompleteChunks) {
  for (const auto& make : {small_recording, merger}) {
    const std::string bytes = make(folder_);
    write_text(folder_ / "whole.hbr", bytes);
    const std::vector<ChunkExtent> chunks = RecordingReader(folder_ / "whole.hbr").chunks();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      ASSERT_EQ(is_read(folder_, bytes.substr(0, length)), length >= chunks[0].bytes.offset) << length;
      if (length < chunks[0].bytes.offset) continue;
      const bool has_first = chunks.size() > 1 && length >= chunks[1].bytes.offset;
      ASSERT_EQ(RecordingReader(folder_ / "tried.hbr").chunks().size(), has_first ? 1U : 0U) << length;
    }
  }
}

TEST_F(Recording, WhateverItContainsIsReadOrRefused) {
  for (const std::string& bytes : {small_recording(folder_), merger(folder_)}) {
    std::size_t refused = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      for (const unsigned flip : {0x01U, 0xffU}) {
        std::string flipped = bytes;
        flipped[at] = static_cast<char>(static_cast<unsigned char>(flipped[at]) ^ flip);
        if (!is_read(folder_, with_true_checksums(flipped))) ++refused;
      }
    }
    EXPECT_GT(refused, 0U);
  }
}

TEST_F(Recording, NoFlippedBitPasses) {
  for (const std::string& bytes : {small_recording(folder_), merger(folder_)}) {
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      for (int bit = 0; bit < 8; ++bit) {
        std::string flipped = bytes;
        flipped[at] = static_cast<char>(flipped[at] ^ (1 << bit));
        ASSERT_FALSE(is_read(folder_, flipped)) << "byte " << at << ", bit " << bit;
      }
    }
  }
}

TEST_F(Recording, TellsWhereItIsDamagedAndShowsWhatComesBefore) {
  const std::string bytes = small_recording(folder_);
  RecordingReader whole(folder_ / "small.hbr");
  const ChunkExtent second = whole.chunks().at(1);
  const RecordedChunk first = whole.read(0);
  const auto damaged_at = [&](std::uint64_t at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    write_text(folder_ / "damaged.hbr", changed);
  };
  const std::string where = "damaged after time " + to_text(second.begin) + ": chunk 1, at byte " +
                            to_text(second.bytes.offset) + ", ";
  for (const auto& [at, what] : {std::pair<std::uint64_t, std::string>{
                                     second.bytes.offset + 9, "has a head that does not match its checksum"},
                                 {second.bytes.offset + 100, "does not match its checksum"},
                                 {bytes.size() - 1, "does not match its checksum"}}) {
    damaged_at(at);
    RecordingReader reader(folder_ / "damaged.hbr", OnDamage::keep_what_comes_before);
    std::size_t taken = 0;
    reader.verify([&](const RecordedChunk& chunk) {
      ++taken;
      EXPECT_EQ(chunk.contacts, first.contacts);
    });
    EXPECT_EQ(taken, 1U);
    EXPECT_EQ(reader.chunks().size(), 1U);
    EXPECT_EQ(reader.reached(), first.end);
    EXPECT_EQ(reader.length(), second.bytes.offset);
    ASSERT_TRUE(reader.damage());
    EXPECT_NE(reader.damage()->find(where + what), std::string::npos) << *reader.damage();
    reader.refresh();
    EXPECT_EQ(reader.chunks().size(), 1U);
  }
  EXPECT_EQ(RecordingReader(folder_ / "damaged.hbr").read(0).contacts, first.contacts);
  EXPECT_THROW(RecordingReader(folder_ / "damaged.hbr").read(1), Error);
  EXPECT_THROW(RecordingReader(folder_ / "damaged.hbr").verify(), Error);
  whole.verify();
  EXPECT_FALSE(whole.damage());
  damaged_at(whole.spheres().offset);
  EXPECT_THROW(RecordingReader(folder_ / "damaged.hbr", OnDamage::keep_what_comes_before), Error);
}

struct Forgery {
  std::size_t at;
  std::string replacement;
  std::string what;
};

const std::string kNan = "\xff\xff\xff\xff\xff\xff\xff\xff";
const std::string kZero(8, '\0');

void expect_refused(const ScratchFolder& folder, const std::string& bytes,
                    const std::vector<Forgery>& forgeries) {
  ASSERT_TRUE(is_read(folder, bytes));
  for (const Forgery& forgery : forgeries) {
    std::string changed = bytes;
    changed.replace(forgery.at, forgery.replacement.size(), forgery.replacement);
    EXPECT_FALSE(is_read(folder, with_true_checksums(changed))) << forgery.what;
  }
}

TEST_F(Recording, RefusesWhatNoRunCanProduce) {
  const std::string bytes = small_recording(folder_);
  const RecordingReader whole(folder_ / "small.hbr");
  const std::size_t chunk = whole.chunks()[0].bytes.offset;
  const std::size_t path = chunk + recording_format::Layout::kSummedHeadBytes;
  const std::size_t contact =
      bytes.size() - recording_format::Layout::kChecksumBytes - whole.header().layout().contact_bytes();
  const std::string three("\x03\x00\x00\x00", 4);
  const std::string most = "\xff\xff\xff\xff";
  expect_refused(folder_, bytes,
                 {{0, "HBREC004", "version"},
                  {8, most, "length of the header"},
                  {whole.spheres().offset, kNan, "radius"},
                  {chunk, "CHUM", "begin of a chunk"},
                  {chunk + 4, most, "number of contacts"},
                  {chunk + 8, kNan, "length of a chunk"},
                  {chunk + 16, kNan, "begin"},
                  {chunk + 24, kNan, "end"},
                  {path, kNan, "position"},
                  {path + 48, kNan, "start of a path"},
                  {contact, kNan, "time"},
                  {contact, kZero, "time"},
                  {contact + 8, three, "first"},
                  {contact + 12, three, "second"},
                  {contact + 12, "\xf9\xff\xff\xff", "surface"},
                  {contact + 16, kNan, "position"}});
}

TEST_F(RecordedBodies, ThatNoRunCanProduceAreRefused) {
  const std::string bytes = merger(folder_);
  const std::size_t chunk = RecordingReader(folder_ / "merger.hbr").chunks().at(0).bytes.offset;
  EXPECT_EQ(bytes.size() - chunk, kLayout.chunk_bytes(2, 1));
  const std::size_t body =
      chunk + recording_format::Layout::kSummedHeadBytes + 2 * recording_format::Layout::kPathBytes;
  const std::size_t contact =
      bytes.size() - recording_format::Layout::kChecksumBytes - kLayout.contact_bytes();
  expect_refused(folder_, bytes,
                 {{0, "HBREC002", "version"},
                  {body, kNan, "spin"},
                  {body + 48, kZero, "orientation"},
                  {body + 56, kZero, "radius of what has a mass"},
                  {body + 64, kZero, "mass"},
                  {body + 72, kNan, "moment"},
                  {contact + 16, std::string(1, '\3') + std::string(7, '\0'), "outcome"},
                  {contact + 12, "\xff\xff\xff\xff", "a wall merges with nothing"},
                  {contact + 72, kNan, "spin"},
                  {contact + 120, kZero, "radius of the merged sphere"}});
}

// Its header announces more than any memory holds.
TEST_F(Recording, AllocatesNoMoreMemoryThanTheFileJustifies) {
  const std::string json = R"({"spheres": 4000000000, )" + kBox + "}";
  const std::string length{static_cast<char>(json.size()), '\0', '\0', '\0'};
  EXPECT_FALSE(is_read(folder_, "HBREC003" + length + json + std::string(1000, '\0')));
}

}  // namespace
}  // namespace hardball::recording_test
