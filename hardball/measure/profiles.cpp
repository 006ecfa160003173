// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/units.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

constexpr double kMaxBins = 2000;

// Volume of a ball of this radius below a plane this far from its center, which cuts it; area of a disc below
// a line.
double volume_below_inside(double plane, double radius, bool is_disc) {
  if (is_disc) {
    const double ratio = std::clamp(-plane / radius, -1.0, 1.0);
    const double half_chord = std::sqrt(std::max(radius * radius - plane * plane, 0.0));
    return radius * radius * std::acos(ratio) + plane * half_chord;
  }
  const double h = plane + radius;
  return std::numbers::pi / 3 * h * h * (3 * radius - h);
}

// Volume of a ball below a plane that need not cut it.
double volume_below(double plane, double radius, bool is_disc) {
  return volume_below_inside(std::clamp(plane, -radius, radius), radius, is_disc);
}

double walled_axes(const Box& box) {
  double axes = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes += box.is_wall(axis) ? 1 : 0;
  return axes;
}

// kT of the motion toward walls [M L^2 T^-2]: along other axes the spheres may stream.
double temperature_between_walls(const World& world, const Time& moment) {
  double sum = 0;
  world.for_each_by_id([&](Slot slot) {
    const Vec3 velocity = world.velocity(slot, moment);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (world.box().is_wall(axis)) sum += world.mass(slot) * velocity[axis] * velocity[axis];
    }
  });
  return sum / (walled_axes(world.box()) * static_cast<double>(world.size()));
}

constexpr std::size_t kMaxSlabs = 100;

bool drives(const FaceProperties& face) {
  return face.material.temperature || face.velocity != Vec3{};
}

bool is_driven(const Box& box, std::size_t axis) {
  if (axis == 1 && box.shear().rate != 0) return true;
  return box.is_wall(axis) &&
         (drives(box.face(face_of(axis, false))) || drives(box.face(face_of(axis, true))));
}

// Whether a face across `across` moves along `along`.
bool moves_along(const Box& box, std::size_t across, std::size_t along) {
  return box.face(face_of(across, false)).velocity[along] != 0 ||
         box.face(face_of(across, true)).velocity[along] != 0;
}

}  // namespace

DensityProfiles::DensityProfiles(const Scene& scene, double bin_width)
    : box_(scene.world().box()),
      begin_(scene.now()),
      contact_(2 * ContactExtrapolation::kReach * mean_radius(scene.world()),
               std::numeric_limits<double>::infinity(), box_.dimensions()) {
  const World& world = scene.world();
  if (world.size() == 0 || !std::isfinite(box_.volume())) return;
  const double longest = std::max({box_.size().x, box_.size().y, box_.size().z});
  const double wanted = std::ceil(longest / (bin_width * mean_radius(world)) * (1 - 1e-12));
  bin_width_ = longest / std::min(wanted, kMaxBins);
  most_bins_ = static_cast<std::size_t>(std::min(wanted, kMaxBins));
  for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
    bins_[axis] = static_cast<std::size_t>(std::ceil(box_.size()[axis] / bin_width_ * (1 - 1e-12)));
  }
  average_ = BlockAverage(first_at_walls() + kAtWalls);
  const double bins_across = 2 + 2 * mean_radius(world) / bin_width_;
  sample_cost_ = static_cast<double>(world.size()) * (50 + 5 * kAxes * bins_across);
}

double DensityProfiles::slab_width(std::size_t axis, std::size_t bin) const {
  return std::min(bin_width_, box_.size()[axis] - static_cast<double>(bin) * bin_width_);
}

// Adds the volumes of a sphere within the slabs across an axis.
void DensityProfiles::add_slices(double center, double radius, std::size_t axis,
                                 std::vector<double>& filled) const {
  const double size = box_.size()[axis];
  const auto count = static_cast<std::ptrdiff_t>(bins_[axis]);
  const auto bin_of = [&](double coordinate) {
    return std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(coordinate / bin_width_), 0, count - 1);
  };
  // A sphere that crosses a periodic boundary extends into the box a second time, as its image.
  for (const double boxes : {-1.0, 0.0, 1.0}) {
    const double coordinate = center + boxes * size;
    if (coordinate + radius <= 0 || coordinate - radius >= size || (boxes != 0 && !box_.is_periodic(axis)))
      continue;
    const std::ptrdiff_t first = bin_of(coordinate - radius);
    const std::ptrdiff_t last = bin_of(coordinate + radius);
    const auto end_of = [&](std::ptrdiff_t bin) {
      return static_cast<double>(bin + 1) * bin_width_ - coordinate;
    };
    double* const of_bin = &filled[axis * most_bins_];
    const bool is_disc = box_.is_flat();
    double below = volume_below(end_of(first - 1), radius, is_disc);
    for (std::ptrdiff_t bin = first; bin < last; ++bin) {
      const double below_end = volume_below_inside(end_of(bin), radius, is_disc);
      of_bin[bin] += below_end - below;
      below = below_end;
    }
    of_bin[last] += volume_below(std::min(end_of(last), size - coordinate), radius, is_disc) - below;
  }
}

void DensityProfiles::sample(const Scene& scene) {
  const World& world = scene.world();
  if (most_bins_ == 0 || world.size() == 0) return;
  std::vector<double> centers(kAxes * most_bins_);
  std::vector<double> filled(kAxes * most_bins_);
  ContactExtrapolation::Bins near_walls{};
  auto next = scene.centers().begin();
  world.for_each_by_id([&](Slot slot) {
    const Vec3& center = *next++;
    const double radius = world.base_radius(slot);
    for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
      const auto bin = static_cast<std::size_t>(std::max(center[axis] / bin_width_, 0.0));
      ++centers[axis * most_bins_ + std::min(bin, bins_[axis] - 1)];
      add_slices(center[axis], radius, axis, filled);
      if (!box_.is_wall(axis)) continue;
      for (const double gap : {center[axis] - radius, box_.size()[axis] - center[axis] - radius}) {
        const std::size_t near = contact_.bin(gap);
        if (near < near_walls.size()) ++near_walls[near];
      }
    }
  });
  double wall_area = 0;
  for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
    const double area = box_.face_area(axis);
    if (box_.is_wall(axis)) wall_area += 2 * area;
    for (std::size_t bin = 0; bin < bins_[axis]; ++bin) {
      const double volume = area * slab_width(axis, bin);
      const std::size_t index = axis * most_bins_ + bin;
      average_.put(index, centers[index]);
      average_.put(first_fraction() + index, filled[index] / volume);
    }
  }
  if (wall_area > 0) {
    for (double& count : near_walls) count /= wall_area * contact_.bin_width();
    const double density = contact_.at_contact(near_walls);
    average_.put(first_at_walls(), density);
    average_.put(first_at_walls() + 1, density * temperature_between_walls(world, scene.now()));
  }
  average_.close_sample(duration(begin_, scene.now()));
}

void DensityProfiles::add_results(const Scene& scene, Measurement& found) const {
  if (most_bins_ == 0) return;
  const bool has_walls = walled_axes(box_) > 0;
  const BlockAverage average =
      has_walls ? without_transient(average_, std::array{mean_of(first_at_walls())}, scene, found) : average_;
  const auto add_at_walls = [&](const char* name, const char* unit, std::size_t bin) {
    require_not_negative(found.add(name, unit, average.ratio(first_at_walls() + bin)));
  };
  if (has_walls) add_at_walls("density_at_walls", number_density_unit(box_), 0);
  // Between other faces the spheres at a wall may have another temperature than the rest.
  if (has_walls && box_.has_plain_faces()) add_at_walls("pressure_at_walls", pressure_unit(box_), 1);
  found.add_argument("position", "L", bin_middles(0, bin_width_, most_bins_));
  for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
    const auto add = [&](const std::string& name, const char* unit, const auto& in_slab) {
      found.add(name + kAxisNames[axis], unit, tabulated(most_bins_, [&](std::size_t bin) {
                  return bin < bins_[axis] ? in_slab(bin) : Estimate();
                }));
    };
    const std::vector<Estimate> counts = average.histogram(axis * most_bins_, bins_[axis]);
    add("number_density_", number_density_unit(box_),
        [&](std::size_t bin) { return 1 / (box_.face_area(axis) * slab_width(axis, bin)) * counts[bin]; });
    add("packing_fraction_", "1",
        [&](std::size_t bin) { return average.ratio(first_fraction() + axis * most_bins_ + bin); });
  }
}

bool DensityProfiles::restored() const {
  if (most_bins_ == 0) return true;
  const auto is_within = [this](std::size_t bins) { return bins <= most_bins_; };
  const std::span<const std::size_t> used = std::span(bins_).first(box_.dimensions());
  return most_bins_ <= static_cast<std::size_t>(kMaxBins) && average_.has(first_at_walls() + kAtWalls) &&
         ranges::all_of(bins_, is_within) && ranges::find(used, 0U) == used.end() &&
         bin_width_ * kMaxBins >= std::max({box_.size().x, box_.size().y, box_.size().z});
}

FlowProfiles::FlowProfiles(const Scene& scene) : box_(scene.world().box()), begin_(scene.now()) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  least_radius_ = std::numeric_limits<double>::infinity();
  world.for_each_by_id([&](Slot slot) { least_radius_ = std::min(least_radius_, world.base_radius(slot)); });
  constexpr double kCostPerSphere = 15;
  for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
    const double room = box_.size()[axis] - 2 * margin(axis);
    if (!is_driven(box_, axis) || !(room > 0)) continue;
    const double wanted = std::ceil(room / mean_radius(world) * (1 - 1e-12));
    slabs_[axis] = wanted < kMaxSlabs ? static_cast<std::size_t>(std::max(wanted, 1.0)) : kMaxSlabs;
    sample_cost_ += kCostPerSphere * static_cast<double>(world.size());
  }
  average_ = BlockAverage(bins());
}

std::size_t FlowProfiles::bin(std::size_t axis, std::size_t slab) const {
  for (std::size_t before = 0; before < axis; ++before) slab += slabs_[before];
  return kSums * slab;
}

void FlowProfiles::sample(const Scene& scene) {
  if (average_.bins() == 0) return;
  const World& world = scene.world();
  auto next = scene.centers().begin();
  world.for_each_by_id([&](Slot slot) {
    const Vec3& center = *next++;
    const double mass = world.mass(slot);
    // Relative to the flow of the box, which grows within a slab.
    const Vec3 velocity = peculiar_velocity(world, slot, scene.now());
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (slabs_[axis] == 0) continue;
      const double slabs_below = std::max((center[axis] - margin(axis)) / slab_width(axis), 0.0);
      const std::size_t slab = std::min(static_cast<std::size_t>(slabs_below), slabs_[axis] - 1);
      double* const sums = average_.open_bins(bin(axis, slab));
      ++sums[kCount];
      sums[kMass] += mass;
      for (std::size_t k = 0; k < kAxes; ++k) sums[kMomentum + k] += mass * velocity[k];
      sums[kSquare] += mass * dot(velocity, velocity);
    }
  });
  average_.close_sample(duration(begin_, scene.now()));
}

void FlowProfiles::add_profiles(Measurement& found, const BlockAverage& average, std::size_t axis) const {
  const std::string at = std::string("_at_") + kAxisNames[axis];
  const double width = slab_width(axis);
  const std::size_t rows = *ranges::max_element(slabs_);
  std::vector<double> positions = bin_middles(margin(axis), width, slabs_[axis]);
  positions.resize(rows, kNoNumber);
  found.add_argument(kAxisNames[axis], "L", std::move(positions));
  const auto add = [&](const std::string& name, const std::string& unit, const auto& in_slab) {
    found.add(name + at, unit, tabulated(rows, [&](std::size_t slab) {
                return slab < slabs_[axis] ? in_slab(bin(axis, slab)) : Estimate();
              }));
  };
  const double volume = box_.face_area(axis) * width;
  if (std::isfinite(volume)) {
    add("number_density", number_density_unit(box_),
        [&](std::size_t first) { return average.ratio(first + kCount) / volume; });
  }
  const auto dimensions = static_cast<double>(box_.dimensions());
  add("temperature", "M L^2 T^-2", [&](std::size_t first) {
    return average.estimate([&](Means means) {
      const Vec3 momentum{means[first + kMomentum], means[first + kMomentum + 1],
                          means[first + kMomentum + 2]};
      const double of_flow = dot(momentum, momentum) / means[first + kMass];
      return (means[first + kSquare] - of_flow) / (dimensions * means[first + kCount]);
    });
  });
  for (std::size_t k = 0; k < box_.dimensions(); ++k) {
    if (k == axis) continue;
    add(std::string("flow_velocity_") + kAxisNames[k], "L T^-1", [&](std::size_t first) {
      Estimate velocity = average.estimate(ratio_of(first + kMomentum + k, first + kMass));
      if (k == 0 && box_.is_sheared()) {
        const auto slab = static_cast<double>((first - bin(axis, 0)) / kSums);
        velocity.value += box_.flow_speed((slab + 0.5) * width);
      }
      return velocity;
    });
  }
}

void FlowProfiles::add_results(const Scene& scene, Measurement& found) const {
  if (box_.is_sheared()) found.title = kTitleAcrossShear;
  if (average_.bins() == 0) return;
  // The energy of each half of the box, and its momentum along moving faces, settle last.
  std::vector<FunctionOfMeans> carried;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::size_t middle = slabs_[axis] / 2;
    const auto add = [&](std::size_t begin, std::size_t end, std::size_t sum) {
      carried.emplace_back([this, axis, begin, end, sum](Means means) {
        double total = 0;
        for (std::size_t slab = begin; slab < end; ++slab) total += means[bin(axis, slab) + sum];
        return total;
      });
    };
    for (std::size_t sum = kMomentum; sum <= kSquare && middle > 0; ++sum) {
      if (sum < kSquare && !moves_along(box_, axis, sum - kMomentum)) continue;
      add(0, middle, sum);
      add(middle, slabs_[axis], sum);
    }
  }
  const BlockAverage average = without_transient(average_, carried, scene, found);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (slabs_[axis] > 0) add_profiles(found, average, axis);
  }
}

bool FlowProfiles::restored() const {
  const auto is_possible = [](std::size_t slabs) { return slabs <= kMaxSlabs; };
  if (!ranges::all_of(slabs_, is_possible) || !average_.has(bins())) return false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const bool is_measured = is_driven(box_, axis) && least_radius_ >= 0 && slab_width(axis) > 0;
    if (slabs_[axis] > 0 && !is_measured) return false;
  }
  return true;
}

}  // namespace hardball
