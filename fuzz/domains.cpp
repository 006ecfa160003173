// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <array>

#include "fuzz/choices.hpp"
#include "fuzz/target.hpp"
#include "support/random_world.hpp"

namespace hardball::fuzz {
namespace {

constexpr std::array kMakers = {support::make_random_world, support::make_furnished_world,
                                support::make_flat_world, support::make_responsive_world,
                                support::make_responsive_flat_world};

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

}  // namespace
}  // namespace hardball::fuzz

// The bytes choose a world, a division and what is changed meanwhile.
void hardball::fuzz::read(std::string_view bytes) {
  Choices choices(bytes);
  const support::RandomWorld made = world_of(choices, kMakers);
  const Division division = division_of(choices);
  Simulation expected(made.world, {.engine = EngineKind::all_pairs});
  Simulation divided(made.world, {.division = division});
  expect_same(expected, divided, made.until, choices);
}
