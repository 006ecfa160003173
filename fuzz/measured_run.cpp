// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fuzz/target.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/platform/little_endian.hpp"
#include "support/gas.hpp"

namespace hardball::fuzz {
namespace {

constexpr std::size_t kBoxes = 3;

struct Saved {
  std::string simulation;
  std::string measures;
  std::vector<std::size_t> places;  // in the measures, but for those after many zeros
};

// A gas with one measure, chosen by `which`, as a checkpoint holds it.
Saved make_saved(std::size_t which) {
  const std::size_t kind = which / kBoxes % measure_names().size();
  Simulation simulation(support::make_gas(
      {.count = 8, .packing_fraction = 0.2, .boundary = static_cast<Boundary>(which % kBoxes)}));
  Measures measures({.names = {std::string(measure_names()[kind])}, .every = 0.05});
  simulation.run({.until = Time(1), .contacts = 40}, measures);
  Saved saved{simulation.save(), archived(measures), {}};
  constexpr std::size_t kNear = 8;
  const std::string& bytes = saved.measures;
  std::size_t last = 0;  // that is not zero
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (bytes[at] != 0) last = at;
    if (at < last + kNear) saved.places.push_back(at);
  }
  return saved;
}

}  // namespace
}  // namespace hardball::fuzz

// The bytes are changes to the state of measures, most of which is zeros: the first chooses the measure, then
// each ten are a place, two bytes, and what is written there.
void hardball::fuzz::read(std::string_view bytes) {
  constexpr std::size_t kChange = 10;
  static std::map<std::size_t, Saved> all;
  if (bytes.empty()) return;
  const auto which = static_cast<unsigned char>(bytes.front());
  auto found = all.find(which);
  if (found == all.end()) found = all.emplace(which, make_saved(which)).first;
  const Saved& saved = found->second;
  std::string measured = saved.measures;
  for (std::size_t at = 1; at + kChange <= bytes.size(); at += kChange) {
    const std::size_t location =
        saved.places[read_little_endian<std::uint16_t>(&bytes[at]) % saved.places.size()];
    const std::string_view change = bytes.substr(at + 2, std::min(kChange - 2, measured.size() - location));
    measured.replace(location, change.size(), change);
  }
  Measures measures;
  restore(measured, "measures", measures);
  Simulation simulation = Simulation::load(saved.simulation);
  run_saved(simulation, measures);
}
