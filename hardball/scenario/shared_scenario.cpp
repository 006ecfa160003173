// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/shared_scenario.hpp"

#include <filesystem>
#include <string>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/domains/sphere_transfer.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/processes/in_all.hpp"

namespace hardball {
namespace {

// The contents of the files that a scenario names.
std::string named_files(const Scenario& scenario) {
  std::string contents;
  const auto add = [&](const std::filesystem::path& file) { contents += archived(read_file(file)); };
  if (scenario.start_file) add(*scenario.start_file);
  for (const SphereGroup& group : scenario.spheres) {
    if (group.distribution && !group.distribution->file.empty()) add(group.distribution->file);
  }
  for (const MotionDescription& motion : scenario.motions) {
    if (motion.file) add(*motion.file);
  }
  for (const auto& bond : scenario.bonds) {
    if (bond.file) add(*bond.file);
  }
  return contents;
}

}  // namespace

void require_same_scenario(const Scenario& scenario, Processes& processes) {
  if (processes.size() == 1) return;
  require_same(processes, scenario.text, "scenario");
  std::string files;
  in_all(processes, [&] { files = named_files(scenario); });
  require_same(processes, files, "start file, or other file that the scenario names,");
}

World make_share(const Scenario& scenario, const Processes& processes, const OnProgress& on_progress,
                 const OnNote& on_note) {
  if (processes.size() == 1) return make_world(scenario, on_progress, on_note);
  SphereTransfers brought;
  World part = make_part(
      scenario, [&](SphereId id) { return id % processes.size() == processes.rank(); },
      [&](const SphereState& state) { brought.push_back({state}); }, on_progress, on_note);
  insert(std::move(brought), part, [](const SphereTransfer&) {});
  return part;
}

}  // namespace hardball
