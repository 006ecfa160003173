// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/sample.hpp"

#include <optional>
#include <string>
#include <vector>

#include "hardball/processes/bytes.hpp"

namespace hardball {

World sample_of(Processes& processes, const World& setting, const Travelers& brought, std::uint64_t spheres) {
  constexpr std::uint64_t kSample = 1 << 14;
  const std::uint64_t every = spheres / kSample + 1;
  std::vector<Traveler> own;
  std::optional<Traveler> smallest;
  std::optional<Traveler> largest;
  brought.for_each([&](const Traveler& traveler) {
    if (traveler.state.id % every == 0) own.push_back(traveler);
    if (!smallest || traveler.state.radius < smallest->state.radius) smallest = traveler;
    if (!largest || traveler.state.radius > largest->state.radius) largest = traveler;
  });
  if (smallest) own.insert(own.end(), {*smallest, *largest});
  std::vector<Traveler> all;
  for (const std::string& part : processes.gather(bytes_of(own))) append_bytes(part, all);
  World sample = setting.without_spheres();
  for (const Traveler& traveler : all) {
    if (!sample.contains(traveler.state.id)) sample.insert(traveler.state);
  }
  return sample;
}

}  // namespace hardball
