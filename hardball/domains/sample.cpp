// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/sample.hpp"

#include <optional>
#include <string>
#include <vector>

#include "hardball/processes/bytes.hpp"

namespace hardball {

World sample_of(Processes& processes, const World& setting, const SphereTransfers& brought,
                std::uint64_t spheres) {
  constexpr std::uint64_t kSample = 1 << 14;
  const std::uint64_t every = spheres / kSample + 1;
  std::vector<SphereTransfer> own;
  std::optional<SphereTransfer> smallest;
  std::optional<SphereTransfer> largest;
  brought.for_each([&](const SphereTransfer& transfer) {
    if (transfer.state.id % every == 0) own.push_back(transfer);
    if (!smallest || transfer.state.radius < smallest->state.radius) smallest = transfer;
    if (!largest || transfer.state.radius > largest->state.radius) largest = transfer;
  });
  if (smallest) own.insert(own.end(), {*smallest, *largest});
  std::vector<SphereTransfer> all;
  for (const std::string& part : processes.gather(bytes_of(own))) append_bytes(part, all);
  World sample = setting.without_spheres();
  for (const SphereTransfer& transfer : all) {
    if (!sample.contains(transfer.state.id)) sample.insert(transfer.state);
  }
  return sample;
}

}  // namespace hardball
