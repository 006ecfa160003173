// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/packing_cost.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <variant>

#include "apps/cli/seconds_since.hpp"
#include "hardball/packing.hpp"
#include "hardball/packing/jamming.hpp"

namespace hardball::cli {
namespace {

constexpr std::size_t kMostSpheres = 4000;

// A plan for the same packing with fewer spheres.
PackingPlan sample_of(const PackingPlan& plan) {
  PackingPlan sample = plan;
  sample.start.clear();
  sample.labels = {};
  sample.follows = PackingPlan::Follows::diameter;
  if (plan.radii.size() <= kMostSpheres) return sample;
  sample.radii.resize(kMostSpheres);
  for (std::size_t i = 0; i < kMostSpheres; ++i)
    sample.radii[i] = plan.radii[i * (plan.radii.size() / kMostSpheres)];
  const double share = static_cast<double>(kMostSpheres) / static_cast<double>(plan.radii.size());
  sample.container = plan.container.scaled(root(share, plan.container.dimensions));
  return sample;
}

// By how much longer a collision takes among more spheres than caches hold.
double slowdown(std::size_t spheres) {
  constexpr double kPerDecade = 1;
  const double ratio = static_cast<double>(spheres) / kMostSpheres;
  return 1 + kPerDecade * std::max(0.0, std::log10(ratio));
}

}  // namespace

double measured_seconds_per_collision(const PackingPlan& plan) {
  constexpr double kLongest = 0.5;
  Packer packer(sample_of(plan));
  const auto begin = std::chrono::steady_clock::now();
  while (!packer.is_over() && seconds_since(begin) < kLongest) packer.advance();
  const double collisions = std::max(1.0, static_cast<double>(packer.collisions()));
  // Next to jamming all contact times are exact, which a moment does not come to.
  const bool jams = std::holds_alternative<PackingRequest::Densest>(plan.goal);
  constexpr double kOfExactTimes = 1.4;
  return seconds_since(begin) / collisions * slowdown(plan.radii.size()) * (jams ? kOfExactTimes : 1);
}

}  // namespace hardball::cli
