// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/flow_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "hardball/measure/same_box.hpp"
#include "hardball/measure/units.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/statistics/transient.hpp"
#include "hardball/world/images.hpp"

namespace hardball {
namespace {

using Means = std::span<const double>;

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

FlowProfiles::FlowProfiles(const Scene& scene) : box_(scene.world().box()), begin_(scene.now()) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  double sum = 0;
  least_radius_ = std::numeric_limits<double>::infinity();
  world.for_each_by_id([&](Slot slot) {
    sum += world.base_radius(slot);
    least_radius_ = std::min(least_radius_, world.base_radius(slot));
  });
  const double mean_radius = sum / static_cast<double>(world.size());
  constexpr double kCostPerSphere = 15;
  for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
    const double room = box_.size()[axis] - 2 * margin(axis);
    if (!is_driven(box_, axis) || !(room > 0)) continue;
    const double wanted = std::ceil(room / mean_radius * (1 - 1e-12));
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
  const std::size_t rows = *std::ranges::max_element(slabs_);
  std::vector<double> positions = bin_middles(margin(axis), width, slabs_[axis]);
  positions.resize(rows, kNoNumber);
  found.add_argument(kAxisNames[axis], "L", std::move(positions));
  const auto add = [&](const std::string& name, const std::string& unit, const auto& in_slab) {
    std::vector<Estimate> slabs;
    for (std::size_t slab = 0; slab < slabs_[axis]; ++slab) slabs.push_back(in_slab(bin(axis, slab)));
    slabs.resize(rows);
    found.add_estimates(name + at, unit, slabs);
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

Measurement FlowProfiles::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = box_.is_sheared() ? "Profiles across the shear" : "Profiles between driven faces",
      .formula =
          R"(number density: centers in a slab over its volume; flow velocity $\mathbf{u} = \sum m )"
          R"(\mathbf{v} / \sum m$ in a slab; $kT = \frac{1}{d N} \sum m (\mathbf{v} - \mathbf{u})^2$ of $N$ )"
          R"(spheres in $d$ dimensions)",
      .source = "sums over the spheres in each slab"};
  if (average_.bins() == 0) return found;
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
  const Transient transient = find_transient(average_, carried, scene.settled());
  const BlockAverage average = transient.left_out_of(average_);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (slabs_[axis] > 0) add_profiles(found, average, axis);
  }
  transient.note_in(found);
  return found;
}

bool FlowProfiles::restored() const {
  const auto is_possible = [](std::size_t slabs) { return slabs <= kMaxSlabs; };
  if (!std::ranges::all_of(slabs_, is_possible) || !average_.has(bins())) return false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const bool is_measured = is_driven(box_, axis) && least_radius_ >= 0 && slab_width(axis) > 0;
    if (slabs_[axis] > 0 && !is_measured) return false;
  }
  return true;
}

bool FlowProfiles::matches(const World& world) const {
  return is_same_box(box_, world.box());
}

}  // namespace hardball
