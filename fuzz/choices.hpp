// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/random_world.hpp"

namespace hardball::fuzz {

/// Takes numbers from the bytes, and zero where they end.
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

/// One of the worlds that these make.
template <class Makers>
support::RandomWorld world_of(Choices& choices, const Makers& makers) {
  const auto make = makers[choices.below(makers.size())];
  const std::uint64_t high = choices.next();
  return make(high << 8 | choices.next());
}

/// Removes a sphere, or changes its velocity.
inline void change(Simulation& simulation, Choices& choices) {
  if (simulation.size() < 2) return;
  const std::size_t place = choices.below(simulation.size());
  std::vector<Slot> slots;
  simulation.world().for_each_by_id([&](Slot slot) { slots.push_back(slot); });
  const Slot slot = slots[place];
  const SphereId sphere = simulation.world().id(slot);
  if (choices.below(4) == 0) return simulation.remove(sphere);
  simulation.change_velocity(sphere, choices.between(0.01, 100) * simulation.velocity(sphere));
}

/// The record of a contact, and of the world then, if it is queried.
struct Told {
  Time time;
  SphereId first = 0;
  std::uint32_t second = 0;
  Vec3 velocity;
  Vec3 position;

  friend bool operator==(const Told&, const Told&) = default;
};

/// Runs in pieces, with changes between them, and returns the contacts that a log or a listener has received;
/// nothing if there is neither.
inline std::vector<Told> run_pieces(Simulation& simulation, double until, Choices choices) {
  constexpr std::size_t kPieces = 4;
  std::vector<Told> told;
  const auto tell = [&](const Contact& contact, const Vec3& position) {
    told.push_back({contact.time, contact.first, contact.second, contact.after.first, position});
  };
  const std::size_t observer = choices.below(3);
  if (observer == 1) simulation.observe({.contact = [&](const Contact& contact) { tell(contact, {}); }});
  if (observer == 2) {
    simulation.on_contact([&](const Contact& contact) { tell(contact, simulation.position(contact.first)); });
  }
  for (std::size_t piece = 0; piece < kPieces; ++piece) {
    simulation.run({.until = Time(until), .contacts = choices.below(64)});
    if (choices.below(2) == 0) change(simulation, choices);
  }
  simulation.run({.until = Time(until), .contacts = 30});
  simulation.observe({});
  simulation.on_contact(nullptr);
  return told;
}

/// Runs two simulations of one world alike. That they have not the same history is the fault.
inline void expect_same(Simulation& expected, Simulation& other, double until, const Choices& choices) {
  const std::vector<Told> expected_told = run_pieces(expected, until, choices);
  HARDBALL_CHECK(run_pieces(other, until, choices) == expected_told);
  HARDBALL_CHECK(other.event_log_hash() == expected.event_log_hash());
  HARDBALL_CHECK(other.now() == expected.now());
  HARDBALL_CHECK(other.positions() == expected.positions());
  HARDBALL_CHECK(other.tally().virial() == expected.tally().virial());
  other.validate();
}

}  // namespace hardball::fuzz
