// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fuzz/target.hpp"
#include "hardball/io/little_endian.hpp"
#include "tests/support/random_world.hpp"

namespace hardball::fuzz {
namespace {

// Takes numbers from the bytes, and zero where they end.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }
  std::size_t below(std::size_t count) { return next() % count; }
  /// From `low` to `high`, evenly by their logarithms.
  double between(double low, double high) {
    constexpr double kMost = 255;
    return low * std::pow(high / low, next() / kMost);
  }

 private:
  std::string_view bytes_;
};

support::RandomWorld world_of(Choices& choices) {
  constexpr std::array kMakers = {support::make_random_world, support::make_furnished_world,
                                  support::make_flat_world, support::make_responsive_world,
                                  support::make_responsive_flat_world};
  const auto make = kMakers[choices.below(kMakers.size())];
  const std::uint64_t high = choices.next();
  return make(high << 8 | choices.next());
}

Division division_of(Choices& choices) {
  constexpr std::size_t kMostDomains = 16;
  Division division;
  division.domains = 2 + choices.below(kMostDomains - 1);
  division.threads = 1 + choices.below(3);
  division.halo = choices.between(1.05, 4);
  division.window = choices.between(0.001, 1);
  division.first_window = choices.between(1e-4, 10);
  return division;
}

// Removes a sphere, or changes its velocity.
void change(Simulation& simulation, Choices& choices) {
  if (simulation.size() < 2) return;
  const std::size_t place = choices.below(simulation.size());
  std::vector<Slot> slots;
  simulation.world().for_each_by_id([&](Slot slot) { slots.push_back(slot); });
  const Slot slot = slots[place];
  const SphereId sphere = simulation.world().id(slot);
  if (choices.below(4) == 0) return simulation.remove(sphere);
  simulation.change_velocity(sphere, choices.between(0.01, 100) * simulation.velocity(sphere));
}

// Runs in pieces, with changes between them.
void run_pieces(Simulation& simulation, double until, Choices choices) {
  constexpr std::size_t kPieces = 4;
  for (std::size_t piece = 0; piece < kPieces; ++piece) {
    simulation.run({.until = Time(until), .contacts = choices.below(64)});
    if (choices.below(2) == 0) change(simulation, choices);
  }
  simulation.run({.until = Time(until), .contacts = 30});
}

}  // namespace
}  // namespace hardball::fuzz

// The bytes choose a world, a division and what is changed meanwhile. One engine has the same history; that
// it has another one is the fault.
void hardball::fuzz::read(std::string_view bytes) {
  Choices choices(bytes);
  const support::RandomWorld made = world_of(choices);
  const Division division = division_of(choices);
  Simulation expected(made.world, {.engine = EngineKind::all_pairs});
  Simulation divided(made.world, {.division = division});
  run_pieces(expected, made.until, choices);
  run_pieces(divided, made.until, choices);
  HARDBALL_CHECK(divided.event_log_hash() == expected.event_log_hash());
  HARDBALL_CHECK(divided.now() == expected.now());
  HARDBALL_CHECK(divided.positions() == expected.positions());
  HARDBALL_CHECK(divided.tally().virial() == expected.tally().virial());
  divided.validate();
}
