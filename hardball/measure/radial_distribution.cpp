// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/radial_distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/measure/sphere_groups.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr std::size_t kMaxSpecies = 3;

// How far the space about a sphere is known: to half the smallest edge (minimum images); and between walls no
// farther than centers can be apart.
double largest_range(const World& world) {
  const Box& box = world.box();
  double range = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    range = std::min(range, box.size()[axis] / 2);
    if (box.is_wall(axis)) range = std::min(range, box.size()[axis] - 2 * world.largest_radius());
  }
  return range;
}

}  // namespace

RadialDistribution::RadialDistribution(const Scene& scene, double range, double bin_width)
    : motion_(scene.thermal_motion()),
      box_(scene.world().box()),
      species_(scene.species()),
      is_by_species_(species_.size() <= kMaxSpecies && !std::isnan(species_.radius(0))),
      begin_(scene.now()) {
  const World& world = scene.world();
  if (world.size() < 2 || !std::isfinite(box_.volume())) return;
  double mean_diameter = 0;
  low_ = 2 * world.largest_radius();
  world.for_each_by_id([&](Slot slot) {
    mean_diameter += 2 * world.base_radius(slot) / static_cast<double>(world.size());
    low_ = std::min(low_, 2 * world.base_radius(slot));
  });
  const double least_reach = low_;
  const StepTable& steps = world.interactions().steps();
  for (std::size_t number = 0; number < steps.size(); ++number) {
    const StepRules& rules = steps[static_cast<StepTable::Number>(number)].rules();
    low_ = std::min(low_, rules.core * least_reach);
    is_smooth_ &= rules.core >= 1 && rules.steps.front().ratio >= 1 + ContactExtrapolation::kReach;
  }
  const std::size_t species = is_by_species_ ? species_.size() : 1;
  kind_of_.resize(species * species);
  for (std::size_t a = 0; a < species; ++a) {
    for (std::size_t b = a; b < species; ++b) {
      kind_of_[a * species + b] = kind_of_[b * species + a] = kinds_.size();
      const double reach = is_by_species_ ? species_.radius(a) + species_.radius(b) : mean_diameter;
      kinds_.push_back(
          {reach, is_by_species_ ? scene.fluid().contact_value(a, b) : 0,
           species == 1 ? "" : "_" + std::to_string(a + 1) + "_" + std::to_string(b + 1),
           ContactExtrapolation(ContactExtrapolation::kReach * reach, reach, box_.dimensions())});
      // The fit of a cubic adds its own.
      constexpr double kOfFit = 1e-3;
      kinds_.back().tolerance = (scene.fluid().tolerance() + kOfFit) * kinds_.back().theory;
    }
  }
  bin_width_ = mean_diameter * bin_width;
  const double high = std::min(mean_diameter * range, largest_range(world));
  bins_ = high > low_ ? static_cast<std::size_t>((high - low_) / bin_width_) : 0;
  average_ = BlockAverage(pairs_bin(kinds_.size()), kSphereGroups);
  if (has_meaning()) sample_cost_ = NeighborQuery::effort(world, high).cost;
}

// Whether the bins reach far enough beyond contact for the extrapolation to it.
bool RadialDistribution::has_contact() const {
  const double high = low_ + static_cast<double>(bins_) * bin_width_;
  return is_by_species_ && is_smooth_ && std::all_of(kinds_.begin(), kinds_.end(), [&](const Kind& kind) {
           return kind.reach * (1 + ContactExtrapolation::kReach) <= high;
         });
}

// How much space, as a fraction of that in which centers can be, lies within this distance of a center,
// averaged over all its positions. A displacement u from a position leads out of that space if it is less
// than |u_x| from one wall along x: hence the mean over all directions of the product over axes of 1 - |u_x|
// / L.
double RadialDistribution::ideal_share(double distance, double reach) const {
  double volume = 1;
  double ones = 0;    // the sum over walls of 1 / L,
  double pairs = 0;   // over pairs of them,
  double triple = 1;  // and the product of all three
  for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
    const double free = box_.size()[axis] - (box_.is_wall(axis) ? reach : 0);
    volume *= free;
    const double inverse = box_.is_wall(axis) ? 1 / free : 0;
    pairs += inverse * ones;
    ones += inverse;
    triple *= inverse;
  }
  const double r = distance;
  // Over directions, |u_x| has the mean 1/2, |u_x u_y| 2/(3 pi) and |u_x u_y u_z| 1/(4 pi); in the plane,
  // |u_x| 2/pi and |u_x u_y| 1/pi.
  if (box_.is_flat()) return r * r * (std::numbers::pi - r * 4 / 3 * ones + r * r / 2 * pairs) / volume;
  const double inside = 4 * std::numbers::pi / 3 - r * std::numbers::pi / 2 * ones + r * r * 8 / 15 * pairs -
                        r * r * r / 6 * triple;
  return r * r * r * inside / volume;
}

void RadialDistribution::sample(const Scene& scene) {
  if (!has_meaning()) return;
  const double high = low_ + static_cast<double>(bins_) * bin_width_;
  const World& world = scene.world();
  const NeighborQuery& surroundings = scene.surroundings();
  const std::size_t many = is_by_species_ ? species_.size() : 1;
  std::vector<std::size_t> species;  // of each sphere
  std::vector<double> spheres(many);
  world.for_each_by_id([&](Slot slot) {
    species.push_back(species_of(world.id(slot)));
    ++spheres[species.back()];
  });
  std::vector<double> centers(kSphereGroups * many);
  std::vector<ContactExtrapolation::Bins> near_contact(kSphereGroups * kinds_.size());
  surroundings.for_each_center(high, [&](std::size_t center) {
    ++centers[group_of(center) * many + species[center]];
    const std::size_t* const kind_with = &kind_of_[species[center] * many];
    surroundings.for_each_neighbor(center, high, [&](std::size_t neighbor, const Vec3&, double square) {
      const std::size_t index = kind_with[species[neighbor]];
      const Kind& kind = kinds_[index];
      const double distance = std::sqrt(square);
      // Spheres in contact may overlap by rounding.
      const double bins_below = (distance - low_) / bin_width_;
      if (bins_below <= -ContactExtrapolation::kRounding) return;
      const auto bin = static_cast<std::size_t>(std::max(bins_below, 0.0));
      const std::size_t group = group_of_pair(center, neighbor);
      if (bin < bins_) average_.put(index * bins_ + bin, 1, group);
      const std::size_t near = kind.contact.bin(distance - kind.reach);
      if (near < ContactExtrapolation::kBins) ++near_contact[group * kinds_.size() + index][near];
    });
  });

  for (std::size_t a = 0; a < many; ++a) {
    for (std::size_t b = a; b < many; ++b) {
      const std::size_t index = kind_of_[a * many + b];
      const Kind& kind = kinds_[index];
      ContactExtrapolation::Bins shares;
      for (std::size_t bin = 0; bin < shares.size(); ++bin) {
        const double width = kind.contact.bin_width();
        const double begin = kind.reach + static_cast<double>(bin) * width;
        shares[bin] = ideal_share(begin + width, kind.reach) - ideal_share(begin, kind.reach);
      }
      for (std::size_t group = 0; group < kSphereGroups; ++group) {
        const double* const of_group = &centers[group * many];
        average_.put(pairs_bin(index), of_group[a] * spheres[b] + (a == b ? 0 : of_group[b] * spheres[a]),
                     group);
        ContactExtrapolation::Bins& near = near_contact[group * kinds_.size() + index];
        for (std::size_t bin = 0; bin < near.size(); ++bin) {
          average_.put(near_bin(index), near[bin], group);
          near[bin] /= shares[bin];
        }
        average_.put(contact_bin(index), kind.contact.at_contact(near), group);
      }
    }
  }
  average_.close_sample(duration(begin_, scene.now()));
}

void RadialDistribution::add_results(const Scene& scene, Measurement& found) const {
  if (!has_meaning()) return;
  const BlockAverage average = without_transient(average_, std::array{ratio_of(contact_bin(0), pairs_bin(0))},
                                                 scene, found, BlockAverage::Groups::separate);
  const bool is_equilibrium = scene.has_equilibrium(motion_);
  found.add_argument("distance", "L", bin_middles(low_, bin_width_, bins_));
  for (std::size_t index = 0; index < kinds_.size(); ++index) {
    const Kind& kind = kinds_[index];
    if (has_contact()) {
      Estimate contact = average.ratio(contact_bin(index), pairs_bin(index));
      // From fewer pairs the error of the cubic fit cannot be estimated.
      constexpr double kMinNear = 100;
      if (average.total(near_bin(index)) < kMinNear) contact.error = kNoNumber;
      require_not_negative(found.add("contact_value" + kind.suffix, "1", contact, kind.theory,
                                     is_equilibrium ? kind.tolerance : kForComparison));
    }
    const std::vector<Estimate> counts = average.histogram(index * bins_, bins_, pairs_bin(index));
    found.add("g" + kind.suffix, "1", tabulated(bins_, [&](std::size_t bin) {
                const double begin = low_ + static_cast<double>(bin) * bin_width_;
                return counts[bin] /
                       (ideal_share(begin + bin_width_, kind.reach) - ideal_share(begin, kind.reach));
              }));
  }
}

bool RadialDistribution::restored() const {
  if (!has_meaning()) return true;
  const std::size_t species = is_by_species_ ? species_.size() : 1;
  const auto is_kind = [this](std::size_t kind) { return kind < kinds_.size(); };
  return species <= kMaxSpecies && kinds_.size() <= kMaxSpecies * kMaxSpecies &&
         kind_of_.size() == species * species && ranges::all_of(kind_of_, is_kind) &&
         bins_ <= average_.bins() && average_.has(pairs_bin(kinds_.size()), kSphereGroups) && low_ >= 0 &&
         bin_width_ > 0;
}

bool RadialDistribution::matches(const World& world) const {
  const double range = low_ + static_cast<double>(bins_) * bin_width_;
  return !has_meaning() || (species_.matches(world) && is_same_box(box_, world.box()) &&
                            range <= largest_range(world) * (1 + 1e-12));
}

}  // namespace hardball
