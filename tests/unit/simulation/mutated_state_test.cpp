// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Saved states that have been changed, which no checksum protects here: each is refused, or gives a
// simulation that can be run on.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/random_world.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::mutated_state_test {
namespace {

using namespace support;

constexpr std::uint64_t kMutations = 1000;
// The places in bytes that do not lie behind many zeros, of which the averages mostly consist.
std::vector<std::size_t> places_in(const std::string& bytes) {
  constexpr std::size_t kMany = 16;
  std::vector<std::size_t> places;
  std::size_t last = 0;  // that is not zero
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (bytes[at] != 0) last = at;
    if (at < last + kMany) places.push_back(at);
  }
  return places;
}

// Changes a few bytes or a whole word, or cuts the state off.
std::string mutated(std::string bytes, const std::vector<std::size_t>& places, Random& random) {
  const auto below = [&](std::size_t most) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(most));
  };
  const double kind = random.uniform();
  if (kind < 0.1) return bytes.substr(0, below(bytes.size()));
  const std::size_t at = places[below(places.size())];
  if (kind < 0.6) {
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
  } else {
    static const std::vector<std::string> words{std::string(8, '\0'), std::string(8, '\xff'),
                                                std::string("\1\0\0\0\0\0\0\0", 8),
                                                std::string("\0\0\0\0\0\0\xf0\x7f", 8)};
    const std::string& word = words[below(words.size())];
    bytes.replace(at, std::min(word.size(), bytes.size() - at), word, 0,
                  std::min(word.size(), bytes.size() - at));
  }
  return bytes;
}

// How many of them were accepted.
template <class Use>
std::uint64_t accepted_of(std::uint64_t mutations, const std::string& bytes, std::uint64_t seed,
                          const Use& use) {
  Random random(seed);
  const std::vector<std::size_t> places = places_in(bytes);
  std::uint64_t accepted = 0;
  for (std::uint64_t i = 0; i < mutations; ++i) {
    SCOPED_TRACE("mutation " + std::to_string(i));
    try {
      use(mutated(bytes, places, random));
      ++accepted;
    } catch (const Error&) {
    } catch (const RunFailure&) {
    } catch (const BrokenInvariant&) {
      // Of a state that no run reaches.
    }
  }
  return accepted;
}

TEST(MutatedState, OfASimulation) {
  constexpr std::uint64_t kWorlds = 10;
  std::uint64_t accepted = 0;
  for (std::uint64_t seed = 1; seed <= kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const RandomWorld made = seed % 2 == 0 ? make_furnished_world(seed) : make_responsive_flat_world(seed);
    Simulation simulation(made.world);
    simulation.set_thermostat(Thermostat(Andersen(1, 5 / made.until), seed));
    simulation.run({.until = Time(made.until), .contacts = 20, .steps = 1000});
    accepted += accepted_of(cases(kMutations) / kWorlds, simulation.save(), seed,
                            [](const std::string& bytes) { Simulation::load(bytes).run({.steps = 100}); });
  }
  EXPECT_GT(accepted, cases(kMutations) / 20);
  EXPECT_LT(accepted, cases(kMutations));
}

TEST(MutatedState, OfMeasures) {
  std::uint64_t accepted = 0;
  const std::uint64_t each = cases(kMutations) / measure_names().size();
  for (const std::string_view name : measure_names()) {
    SCOPED_TRACE(name);
    Simulation simulation(make_gas({.count = 8, .packing_fraction = 0.2, .boundary = Boundary::wall}));
    Measures measures({.names = {std::string(name)}, .every = 0.05});
    simulation.run({.until = Time(1), .contacts = 40}, measures);
    accepted += accepted_of(each, archived(measures), 1, [&](const std::string& bytes) {
      Measures restored;
      restore(bytes, "measures", restored);
      Simulation copy = simulation;
      copy.run({.steps = 60}, restored);
      restored.sample_the_rest(copy.world(), copy.now());
      restored.results(copy.world(), copy.now());
    });
  }
  EXPECT_GT(accepted, each);
  EXPECT_LT(accepted, each * measure_names().size());
}

TEST(MutatedState, OfARecording) {
  const ScratchFolder folder;
  Simulation simulation(make_gas({.count = 8, .packing_fraction = 0.2}));
  RecordingWriter writer(folder / "recording.hbr", {.has_bodies = true}, simulation.world());
  simulation.on_contact([&](const Contact& contact) { writer.record(contact, simulation.world()); });
  simulation.run_contacts(20);
  const std::string state = writer.save();
  writer.close(simulation.time());
  const std::string recording = read_text(folder / "recording.hbr");
  const std::uint64_t accepted = accepted_of(cases(kMutations), state, 1, [&](const std::string& bytes) {
    write_text(folder / "again.hbr", recording);
    RecordingWriter(folder / "again.hbr", bytes).close(simulation.time());
  });
  EXPECT_GT(accepted, cases(kMutations) / 20);
  EXPECT_LT(accepted, cases(kMutations));
}

}  // namespace
}  // namespace hardball::mutated_state_test
