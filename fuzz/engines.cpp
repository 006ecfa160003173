// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "fuzz/choices.hpp"
#include "fuzz/target.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"
#include "support/sheared.hpp"
#include "support/stepped.hpp"

namespace hardball::fuzz {
namespace {

constexpr std::array kMakers = {support::make_stepped_world,    support::make_sheared_world,
                                support::make_random_world,     support::make_furnished_world,
                                support::make_responsive_world, support::make_growing_world};

}  // namespace
}  // namespace hardball::fuzz

// The bytes choose a world, an engine and what is changed meanwhile.
void hardball::fuzz::read(std::string_view bytes) {
  Choices choices(bytes);
  const support::RandomWorld made = world_of(choices, kMakers);
  const std::vector<support::EngineVariant> variants = support::engine_variants(made.world);
  Simulation expected(made.world, {.engine = EngineKind::all_pairs});
  Simulation other(made.world, variants[choices.below(variants.size())].options);
  expect_same(expected, other, made.until, choices);
}
