// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Recordings of spheres that grow: at each contact, spheres of the sizes that the recording has touch each
// other.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "hardball/recording/recording_header.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::recorded_growth_test {
namespace {

using support::ScratchFolder;

// Writes in two sittings, each with a part of the chunks.
Simulation record(const std::filesystem::path& path, Boundary boundary) {
  Simulation simulation(support::make_gas({.count = 200, .packing_fraction = 0.2, .boundary = boundary}));
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
    const Simulation simulation = record(folder / "run.hbr", boundary);
    RecordingReader reader(folder / "run.hbr");
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
    std::filesystem::remove(folder / "run.hbr");
  }
}

// Spheres that do not grow are recorded in the version that earlier readers know.
TEST(RecordedGrowth, IsNotInOtherRecordings) {
  const ScratchFolder folder;
  Simulation simulation(support::make_gas({.count = 20, .packing_fraction = 0.2}));
  RecordingWriter(folder / "run.hbr", recording_header(simulation), simulation.world()).close(0);
  EXPECT_EQ(RecordingReader(folder / "run.hbr").header().layout().version(), 3);
}

}  // namespace
}  // namespace hardball::recorded_growth_test
