// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/settling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

#include "hardball/measure/bonds.hpp"
#include "hardball/measure/reasons.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/statistics/transient.hpp"

namespace hardball {
namespace {

constexpr std::size_t kMostFollowed = 1000;
constexpr std::size_t kMostBonded = 500;

// Bins of the history.
constexpr std::size_t kTemperature = 0;
constexpr std::size_t kOverlap = 1;
constexpr std::size_t kOrders = 2;

// The distance of neighbors in the densest lattice of that many spheres.
double lattice_spacing(const GasStatistics& statistics) {
  const double density = statistics.number_density();
  return statistics.is_flat() ? std::sqrt(2 / (std::numbers::sqrt3 * density))
                              : std::cbrt(std::numbers::sqrt2 / density);
}

// Whether the spheres are a fluid in equilibrium, whatever they started as.
bool is_fluid(const World& world, const GasStatistics& statistics) {
  const double freezing = statistics.is_flat() ? FluidTheory::kFreezingOfDiscs : FluidTheory::kFreezing;
  return world.motion().is_straight() && !world.has_steps() && !world.box().is_sheared() &&
         statistics.packing_fraction() <= freezing;
}

// The bonds of a few hundred spheres, chosen evenly by id.
template <class Bonds>
Bonds bonds_within(const Scene& scene, double reach) {
  const NeighborQuery& surroundings = scene.surroundings();
  const std::size_t centers = std::min(surroundings.size(), kMostBonded);
  Bonds all;
  for (std::size_t k = 0; k < centers; ++k) {
    surroundings.for_each_neighbor(k * surroundings.size() / centers, reach,
                                   [&](std::size_t, const Vec3& separation, double square) {
                                     if (square > 0) all.add(1 / std::sqrt(square) * separation);
                                   });
  }
  return all;
}

struct Order {
  double value = 0;      // the larger invariant of all bonds [1]
  double by_chance = 0;  // of as many independent bonds, and more than in any fluid [1]
};

template <class Bonds>
Order order_of(const Bonds& bonds) {
  constexpr double kDeviations = 4;
  if (bonds.count == 0) return {};
  return {std::max(bonds.invariant_four(), bonds.invariant_six()), kDeviations / std::sqrt(bonds.count / 2)};
}

Order order_in(const Scene& scene, double reach) {
  if (scene.world().box().is_flat()) return order_of(bonds_within<BondsInPlane>(scene, reach));
  return order_of(bonds_within<BondsInSpace>(scene, reach));
}

// When a history that begins at `start` no longer depends on it: where it first comes to its mean in the
// second half, and the last block that lies farther from it than blocks there do by chance has passed. None
// if that is not before the second half.
std::optional<std::size_t> blocks_until_settled(std::span<const double> history, double start) {
  constexpr double kDeviations = 4;
  const std::size_t half = history.size() / 2;
  const std::span<const double> late = history.subspan(half);
  const double mean = std::accumulate(late.begin(), late.end(), 0.0) / static_cast<double>(late.size());
  double squares = 0;
  for (const double value : late) squares += (value - mean) * (value - mean);
  const double deviation = std::sqrt(squares / static_cast<double>(late.size() - 1));
  const auto is_reached = [&](double value) { return start > mean ? value <= mean : value >= mean; };
  const auto reached = ranges::find_if(history, is_reached);
  auto blocks = static_cast<std::size_t>(reached - history.begin());
  for (std::size_t block = 0; block < half; ++block) {
    if (std::fabs(history[block] - mean) > kDeviations * deviation) blocks = std::max(blocks, block + 1);
  }
  if (blocks > half) return std::nullopt;
  return blocks;
}

}  // namespace

Settling::Settling(const Scene& scene, bool is_placed)
    : motion_(scene.thermal_motion()), species_(scene.species()), begin_(scene.now()) {
  // Between the first two shells of the densest lattices.
  constexpr double kReach = 1.25;
  // Near freezing a fluid of discs has up to .2.
  const double least_order = scene.world().box().is_flat() ? 0.25 : 0.1;
  constexpr double kEach = 20;
  const World& world = scene.world();
  const auto spheres = static_cast<double>(world.size());
  sample_cost_ = kEach * spheres;
  if (world.size() < 2 || !std::isfinite(world.box().volume())) {
    history_ = BlockAverage(kOrders);
    return;
  }
  const double spacing = lattice_spacing(scene.statistics());
  // In a box so thin that a sphere is surrounded by its own images there is no crystal to be seen.
  constexpr double kPeriods = 4;
  reach_ = std::min(kReach * spacing, kPeriods * shortest_period(world.box()));
  wave_number_ = 2 * std::numbers::pi / spacing;
  const Order order = order_in(scene, reach_);
  is_crystal_ = order.value > std::max(least_order, order.by_chance);
  must_leave_places_ =
      (is_crystal_ || is_placed) && motion_.energy > 0 && is_fluid(world, scene.statistics());
  if (is_crystal_) {
    // Of each sphere the search takes this, and of each bonded one a dozen bonds.
    constexpr double kSearch = 100;
    constexpr double kBonds = 2000;
    sample_cost_ += kSearch * spheres + kBonds * std::min(spheres, static_cast<double>(kMostBonded));
  }
  if (must_leave_places_) {
    const std::size_t followed = std::min(world.size(), kMostFollowed);
    for (std::size_t k = 0; k < followed; ++k) {
      places_.push_back(scene.unfolded_center(world.slot_of_rank(k * world.size() / followed)));
    }
  }
  // Intensities of independent places are distributed exponentially with a mean of one.
  constexpr double kByChance = 12;
  const bool may_be_even =
      !world.box().is_sheared() && world.box().has_plain_faces() && world.surfaces().empty();
  for (std::uint64_t axis = 0; may_be_even && axis < world.box().dimensions(); ++axis) {
    if (world.motion().gravity()[axis] != 0) continue;
    for (std::uint64_t species = 0; species <= species_.size(); ++species) {
      const Mode mode{axis, species};
      if ((species_.size() > 1 || species == 0) && intensity(scene, mode) > kByChance) modes_.push_back(mode);
    }
  }
  sample_cost_ += kEach * spheres * static_cast<double>(modes_.size());
  starts_ = orders_of(scene);
  history_ = BlockAverage(kOrders + starts_.size());
}

// The part of the spheres' places that they have kept: the mean cosine of their displacements.
double Settling::overlap_with_places(const Scene& scene) const {
  if (places_.empty()) return 0;
  const World& world = scene.world();
  const Vec3 drifted = duration(begin_, scene.now()) * motion_.drift;
  const std::size_t dimensions = world.box().dimensions();
  double sum = 0;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const Slot slot = world.slot_of_rank(k * world.size() / places_.size());
    const Vec3 moved = scene.unfolded_center(slot) - places_[k] - drifted;
    for (std::size_t axis = 0; axis < dimensions; ++axis) sum += std::cos(wave_number_ * moved[axis]);
  }
  return sum / static_cast<double>(places_.size() * dimensions);
}

// Of the longest wave that fits the box: between walls half a wave.
double Settling::intensity(const Scene& scene, const Mode& mode) const {
  const World& world = scene.world();
  const Box& box = world.box();
  const bool is_wall = box.is_wall(mode.axis);
  const double wave_number = (is_wall ? 1 : 2) * std::numbers::pi / box.size()[mode.axis];
  double real = 0;
  double imaginary = 0;
  double count = 0;
  std::size_t rank = 0;
  world.for_each_by_id([&](Slot slot) {
    const double position = scene.centers()[rank++][mode.axis];
    if (mode.species > 0 && species_.of(world.id(slot)) != mode.species - 1) return;
    ++count;
    real += std::cos(wave_number * position);
    if (!is_wall) imaginary += std::sin(wave_number * position);
  });
  return count > 0 ? (real * real + imaginary * imaginary) / count * (is_wall ? 2 : 1) : 0;
}

std::vector<double> Settling::orders_of(const Scene& scene) const {
  std::vector<double> orders;
  if (is_crystal_) orders.push_back(order_in(scene, reach_).value);
  for (const Mode& mode : modes_) orders.push_back(intensity(scene, mode));
  return orders;
}

void Settling::sample(const Scene& scene) {
  history_.put(kTemperature, scene.thermal_motion().temperature());
  history_.put(kOverlap, overlap_with_places(scene));
  const std::vector<double> orders = orders_of(scene);
  for (std::size_t k = 0; k < orders.size(); ++k) history_.put(kOrders + k, orders[k]);
  history_.close_sample(duration(begin_, scene.now()));
}

Settled Settling::found(const Scene& scene) const {
  constexpr std::size_t kLeastBlocks = 8;
  constexpr double kForgotten = 0.05;
  const std::span<const double> ends = history_.ends();
  Settled found;
  if (scene.now() == begin_) return found;
  const auto end_after = [&](std::optional<std::size_t> blocks, const char* reason) {
    if (blocks && *blocks > 0) found.end = std::max(found.end, ends[*blocks - 1]);
    if (blocks && 2 * *blocks <= ends.size()) return;
    if (found.is_over) found.reason = reason;
    found.is_over = false;
  };
  const auto settled = [&](std::size_t order) -> std::optional<std::size_t> {
    if (ends.size() < kLeastBlocks) return std::nullopt;
    return blocks_until_settled(history_.history(mean_of(kOrders + order)), starts_[order]);
  };
  if (must_leave_places_) {
    const std::vector<double> overlap = history_.history(mean_of(kOverlap));
    const auto left = ranges::find_if(overlap, [](double value) { return value < kForgotten; });
    const std::size_t blocks = static_cast<std::size_t>(left - overlap.begin()) + 1;
    end_after(left == overlap.end() ? std::nullopt : std::optional(blocks),
              is_crystal_ ? kStillCrystal : kStillInPlace);
  }
  if (is_crystal_) end_after(settled(0), kStillCrystal);
  for (std::size_t k = is_crystal_ ? 1 : 0; k < starts_.size(); ++k) end_after(settled(k), kStillSpreading);

  if (!is_energy_conserved(motion_, scene.thermal_motion())) judge_temperature(scene, found);
  return found;
}

// Says whether the temperature settles, and when.
void Settling::judge_temperature(const Scene& scene, Settled& found) const {
  constexpr double kFarFromStart = 4;
  const FunctionOfMeans temperature = mean_of(kTemperature);
  const Transient transient = find_transient(history_, std::array{temperature});
  found.is_steady = transient.is_over && !is_drifting(temperature, scene.thermal_motion());
  // A transient that may be chance is left to each measure.
  const BlockAverage rest = transient.left_out_of(history_);
  const Estimate settled_to = rest.estimate(temperature);
  const double changed = std::fabs(motion_.temperature() - settled_to.value);
  const double by_chance = settled_to.value * std::sqrt(2 / motion_.degrees_of_freedom);
  if (found.is_steady && changed > kFarFromStart * by_chance) {
    found.end = std::max(found.end, transient.end.value_or(0));
  }
}

// Whether the temperature changes in the second half of the run by more than chance allows; where that is not
// known, by at least a tenth. Of few samples the whole run counts.
bool Settling::is_drifting(const FunctionOfMeans& temperature, const ThermalMotion& now) const {
  constexpr std::size_t kFew = 8;
  constexpr double kMuch = 0.1;
  constexpr double kErrors = 4;
  const std::vector<double> history = history_.history(temperature);
  if (history.size() < kFew) return std::fabs(now.energy - motion_.energy) > kMuch * motion_.energy;
  BlockAverage second_half = history_;
  second_half.leave_out_until(history_.ends()[history.size() / 2 - 1]);
  const Estimate mean = second_half.estimate(temperature);
  const std::size_t quarter = history.size() / 4;
  const auto mean_of = [](std::span<const double> part) {
    return std::accumulate(part.begin(), part.end(), 0.0) / static_cast<double>(part.size());
  };
  const double last = mean_of(std::span(history).last(quarter));
  const double before = mean_of(std::span(history).last(2 * quarter).first(quarter));
  // The difference of two halves has twice the error of their mean. Where that is not known it is no less
  // than for independent samples of an equilibrium.
  const double by_samples =
      mean.value * std::sqrt(2 / motion_.degrees_of_freedom / static_cast<double>(second_half.blocks()));
  const double allowed = std::isnan(mean.error) ? std::max(kMuch * mean.value, kErrors * 2 * by_samples)
                                                : kErrors * 2 * mean.error;
  return std::fabs(last - before) > allowed;
}

bool Settling::restored() const {
  const auto is_mode = [&](const Mode& mode) { return mode.axis < kAxes && mode.species <= species_.size(); };
  return places_.size() <= kMostFollowed && ranges::all_of(modes_, is_mode) &&
         starts_.size() == modes_.size() + (is_crystal_ ? 1 : 0) && history_.has(kOrders + starts_.size()) &&
         reach_ >= 0 && std::isfinite(reach_) && sample_cost_ >= 0;
}

}  // namespace hardball
