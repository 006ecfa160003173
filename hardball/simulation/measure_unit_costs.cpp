// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/measure_unit_costs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "hardball/engine/engine.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/cell_counts.hpp"

namespace hardball {
namespace {

using Steps = std::array<double, 4>;  // contacts, crossings, cells, predictions

// A cubic crystal has 4 k^3. In a smaller box with fewer cells, several images of a sphere would be in reach.
constexpr std::size_t kSpheres = 6912;

World make_gas(double packing_fraction) {
  constexpr double kRadius = 0.5;
  const double edge = std::cbrt(kSpheres * std::numbers::pi / 6 / packing_fraction);
  const Vec3 size{edge, edge, edge};
  World world(Box::periodic(size));
  Random random(1);
  for (const Vec3& center : place_on_lattice(world.box(), {{}, size}, kSpheres, kRadius, "gas")) {
    const Vec3 velocity{random.normal(), random.normal(), random.normal()};
    world.add({.position = center, .velocity = velocity, .radius = kRadius});
  }
  return world;
}

// A gas with cells of one size, and the times measured for its steps of each kind.
class Trial {
 public:
  Trial(World world, double edge)
      : expected_(expected_counts(gas_statistics(world, Time(0)), edge)),
        engine_(std::move(world), {PhaseKind::cells, edge}, Time(0)) {
    sums_.tally.begin(engine_.world(), Time(0));
    run(3 * kSpheres);
  }

  // Runs for `enough` seconds, once its data are in cache again.
  void measure(const Function<double()>& seconds, double enough) {
    constexpr std::uint64_t kStepsPerReading = 100;
    run(kSpheres);
    const Counters before = engine_.counters();
    const double start = seconds();
    double taken = 0;
    // The bound on readings ends the measurement if the clock stands still.
    for (int readings = 0; taken < enough && readings < 100; ++readings) {
      run(kStepsPerReading);
      taken = seconds() - start;
    }
    pieces_.push_back({steps_of(engine_.counters() - before), taken});
  }

  struct Piece {
    Steps steps;
    double taken;
  };

  // Of three pieces or more, one that was probably not interrupted: the one with the median time per contact
  // or crossing.
  Piece typical() const {
    std::vector<Piece> pieces = pieces_;
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
      return a.taken * (b.steps[0] + b.steps[1]) < b.taken * (a.steps[0] + a.steps[1]);
    });
    return pieces[pieces.size() / 2];
  }

 private:
  void run(std::uint64_t steps) { engine_.run({.steps = steps}, sums_, {}); }

  // Cells are not counted; theory gives their mean.
  Steps steps_of(const Counters& done) const {
    const auto contacts = static_cast<double>(done.contacts());
    const auto enters = static_cast<double>(done.enter);
    const double passes = 2 * contacts + static_cast<double>(done.stale);
    return {contacts, enters, passes * expected_.cells + enters * expected_.cells_entered,
            static_cast<double>(done.predictions)};
  }

  CellCounts expected_;
  Engine<CalendarQueue> engine_;
  ContactSums sums_;
  std::vector<Piece> pieces_;
};

// The non-negative costs that minimize the sum over trials of the squared relative error, by coordinate
// descent.
Steps fit(const std::vector<Trial>& trials) {
  std::vector<Steps> shares;  // steps in each second
  for (const Trial& trial : trials) {
    const Trial::Piece piece = trial.typical();
    Steps& share = shares.emplace_back(piece.steps);
    for (double& steps : share) steps /= piece.taken;
  }
  Steps costs{};
  constexpr int kRounds = 2000;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < costs.size(); ++i) {
      double wanted = 0;
      double weight = 0;
      for (const Steps& share : shares) {
        double left = 1;
        for (std::size_t k = 0; k < costs.size(); ++k) left -= k == i ? 0 : share[k] * costs[k];
        wanted += share[i] * left;
        weight += share[i] * share[i];
      }
      costs[i] = weight > 0 ? std::max(0.0, wanted / weight) : 0;
    }
  }
  return costs;
}

}  // namespace

UnitCosts measure_unit_costs(const Function<double()>& seconds) {
  constexpr int kPieces = 3;
  constexpr double kSecondsOfPiece = 0.003;
  std::vector<Trial> trials;
  for (const double packing_fraction : {0.003, 0.05, 0.3}) {
    const double spacing = std::cbrt(std::numbers::pi / 6 / packing_fraction);
    for (const double relative_edge : {0.85, 1.2, 1.7, 2.4}) {
      trials.emplace_back(make_gas(packing_fraction), relative_edge * spacing);
    }
  }
  // One piece of each in turn: whatever slows the machine for a while slows all alike.
  for (int piece = 0; piece < kPieces; ++piece) {
    for (Trial& trial : trials) trial.measure(seconds, kSecondsOfPiece);
  }
  const Steps costs = fit(trials);
  constexpr double kNanoseconds = 1e9;
  UnitCosts result{.contact = kNanoseconds * costs[0],
                   .enter = kNanoseconds * costs[1],
                   .cell = kNanoseconds * costs[2],
                   .prediction = kNanoseconds * costs[3]};
  // Too coarse a clock measures nothing meaningful.
  return are_meaningful(result) ? result : UnitCosts{};
}

}  // namespace hardball
