// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "hardball/packing.hpp"

namespace hardball::cli {

/// What `hardball pack` prints about a packing besides its files.
struct PackingSummary {
  const Packing& packing;
  double seconds = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> files;

  /// As a table for people.
  std::string table() const;
  /// As one JSON object.
  std::string json() const;
};

/// What `hardball pack --dry-run` prints about a plan whose collisions take this long each [s].
std::string plan_table(const PackingPlan& plan, double seconds_per_collision);
std::string plan_json(const PackingPlan& plan, double seconds_per_collision);

}  // namespace hardball::cli
