// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/structure_factor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include "hardball/measure/fluid_structure.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr std::size_t kShells = 64;

constexpr const char* kNoPeak = "no peak is statistically significant";

// The powers of a phase are stored, this many along the longest axis.
constexpr double kMaxPeriods = 4096;

// Two numbers at a time by the compilers' generic vectors, and this many pairs of spheres at once.
using Pair = double __attribute__((vector_size(16)));
constexpr std::size_t kPairs = 4;
constexpr std::size_t kLanes = 2 * kPairs;

// One complex number per lane.
struct Phases {
  std::array<Pair, kPairs> real;
  std::array<Pair, kPairs> imaginary;
};

void set_to_product(Phases& product, const Phases& a, const Phases& b) {
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Pair real = a.real[k] * b.real[k] - a.imaginary[k] * b.imaginary[k];
    product.imaginary[k] = a.real[k] * b.imaginary[k] + a.imaginary[k] * b.real[k];
    product.real[k] = real;
  }
}

// Adds x y z, y and z conjugated if their signs say so.
void add_product(Phases& sum, const Phases& x, const Phases& y, double sign_y, const Phases& z,
                 double sign_z) {
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Pair y_imaginary = sign_y * y.imaginary[k];
    const Pair z_imaginary = sign_z * z.imaginary[k];
    const Pair real = x.real[k] * y.real[k] - x.imaginary[k] * y_imaginary;
    const Pair imaginary = x.real[k] * y_imaginary + x.imaginary[k] * y.real[k];
    sum.real[k] += real * z.real[k] - imaginary * z_imaginary;
    sum.imaginary[k] += real * z_imaginary + imaginary * z.real[k];
  }
}

double total(const std::array<Pair, kPairs>& lanes) {
  double sum = 0;
  for (const Pair& pair : lanes) sum += pair[0] + pair[1];
  return sum;
}

// Directions that fill the sphere ever more evenly. Source: Roberts, The unreasonable effectiveness of
// quasirandom sequences (2018), the sequence R2.
Vec3 direction(std::size_t index) {
  constexpr double kPlastic = 1.32471795724474602596;
  const double along = static_cast<double>(index) / kPlastic;
  const double around = static_cast<double>(index) / (kPlastic * kPlastic);
  const double z = 2 * (along - std::floor(along)) - 1;
  const double angle = 2 * std::numbers::pi * (around - std::floor(around));
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

}  // namespace

StructureFactor::StructureFactor(const Scene& scene, double longest,
                                 std::optional<std::size_t> vectors_in_shell)
    : packing_fraction_(scene.world().box().is_flat() ? std::numeric_limits<double>::quiet_NaN()
                                                      : fluid_packing_fraction(scene)),
      begin_(scene.now()) {
  const World& world = scene.world();
  if (world.size() == 0) return;
  unit_ = 2 * std::numbers::pi * world.box().inverse_period();
  diameter_ = 2 * mean_radius(world);
  constexpr std::size_t kMaxInShell = 6;
  constexpr std::size_t kMaxProducts = 150000;  // of spheres and vectors of a shell
  const std::size_t affordable = std::clamp<std::size_t>(kMaxProducts / world.size(), 1, kMaxInShell);
  double least_unit = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (unit_[axis] > 0) least_unit = std::min(least_unit, unit_[axis]);
  }
  const double thickness = std::min(longest / diameter_, kMaxPeriods * least_unit) / kShells;
  for (std::size_t shell = 0; shell < kShells; ++shell) {
    choose_waves(shell, static_cast<double>(shell) * thickness, static_cast<double>(shell + 1) * thickness,
                 vectors_in_shell.value_or(affordable));
    const std::size_t before = shell_ends_.empty() ? 0 : shell_ends_.back();
    if (waves_.size() > before) shell_ends_.push_back(waves_.size());
  }
  shells_ = BlockAverage(shell_ends_.size());
  if (waves_.empty()) return;
  // Besides the wave vectors, the powers along each axis, and the first of them.
  const double powers = longest_[0] + longest_[1] + longest_[2];
  sample_cost_ =
      static_cast<double>(world.size()) * (100 + 3 * (static_cast<double>(waves_.size()) + powers));
}

// Tries directions until enough of the nearest wave vectors lie within the shell.
void StructureFactor::choose_waves(std::size_t shell, double low, double high, std::size_t most) {
  const std::size_t first = waves_.size();
  const auto is_chosen = [&](const Wave& wave) {
    return std::find(waves_.begin() + static_cast<std::ptrdiff_t>(first), waves_.end(), wave) != waves_.end();
  };
  const std::size_t attempts = 50 * most;
  for (std::size_t attempt = 0; attempt < attempts && waves_.size() < first + most; ++attempt) {
    Vec3 toward = direction(shell * attempts + attempt);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (unit_[axis] == 0) toward[axis] = 0;
    }
    // Shells may be thinner than the spacing of wave vectors: aim at several depths.
    const double aim = low + (high - low) * (0.125 + 0.25 * static_cast<double>(attempt % 4));
    Wave wave{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (toward[axis] == 0) continue;
      wave[axis] = static_cast<int>(std::lround(aim * toward[axis] / (length(toward) * unit_[axis])));
    }
    // Opposite vectors give the same value.
    if (wave < Wave{}) wave = {-wave[0], -wave[1], -wave[2]};
    const double reached = length_of(wave);
    if (wave == Wave{} || reached < low || reached >= high || is_chosen(wave)) continue;
    waves_.push_back(wave);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      longest_[axis] = std::max(longest_[axis], std::abs(wave[axis]));
    }
  }
}

double StructureFactor::length_of(const Wave& wave) const {
  return length({wave[0] * unit_.x, wave[1] * unit_.y, wave[2] * unit_.z});
}

void StructureFactor::sample(const Scene& scene) {
  if (waves_.empty() || scene.world().size() == 0) return;
  const std::vector<Vec3>& centers = scene.centers();

  std::array<std::vector<Phases>, kAxes> powers;  // of exp(i unit x), by axis
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    powers[axis].resize(static_cast<std::size_t>(longest_[axis]) + 1);
  }
  std::vector<Phases> sums(waves_.size(), Phases{});
  for (std::size_t begin = 0; begin < centers.size(); begin += kLanes) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      Phases phase{};
      powers[axis][0] = Phases{};
      for (std::size_t lane = 0; lane < std::min(kLanes, centers.size() - begin); ++lane) {
        const double angle = unit_[axis] * centers[begin + lane][axis];
        phase.real[lane / 2][lane % 2] = std::cos(angle);
        phase.imaginary[lane / 2][lane % 2] = std::sin(angle);
        powers[axis][0].real[lane / 2][lane % 2] = 1;
      }
      for (std::size_t m = 1; m < powers[axis].size(); ++m) {
        set_to_product(powers[axis][m], powers[axis][m - 1], phase);
      }
    }
    for (std::size_t k = 0; k < waves_.size(); ++k) {
      const auto power = [&](std::size_t axis) -> const Phases& {
        return powers[axis][static_cast<std::size_t>(std::abs(waves_[k][axis]))];
      };
      add_product(sums[k], power(0), power(1), waves_[k][1] < 0 ? -1 : 1, power(2),
                  waves_[k][2] < 0 ? -1 : 1);
    }
  }

  std::size_t k = 0;
  for (std::size_t shell = 0; shell < shell_ends_.size(); ++shell) {
    const auto vectors = static_cast<double>(shell_ends_[shell] - k);
    for (; k < shell_ends_[shell]; ++k) {
      const double real = total(sums[k].real);
      const double imaginary = total(sums[k].imaginary);
      const double intensity = real * real + imaginary * imaginary;
      shells_.put(shell, intensity / static_cast<double>(centers.size()) / vectors);
    }
  }
  shells_.close_sample(duration(begin_, scene.now()));
}

void StructureFactor::add_results(const Scene& scene, Measurement& found) const {
  if (waves_.empty()) return;
  const FunctionOfMeans mean_of_shells = [](Means means) {
    return std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
  };
  const BlockAverage shells = without_transient(shells_, std::array{mean_of_shells}, scene, found);
  const std::size_t rows = shell_ends_.size();
  // The mean of a function of the length over the wave vectors of a shell.
  const auto mean_in = [&](std::size_t shell, const auto& of_length) {
    const std::size_t begin = shell == 0 ? 0 : shell_ends_[shell - 1];
    const auto vectors = static_cast<double>(shell_ends_[shell] - begin);
    double mean = 0;
    for (std::size_t k = begin; k < shell_ends_[shell]; ++k)
      mean += of_length(length_of(waves_[k])) / vectors;
    return mean;
  };
  const std::vector<double> wave_numbers =
      tabulated(rows, [&](std::size_t shell) { return mean_in(shell, std::identity()); });
  const std::vector<Estimate> factors =
      tabulated(rows, [&](std::size_t shell) { return shells.ratio(shell); });
  if (shells_.samples() > 0) {
    const auto highest = ranges::max_element(factors, {}, &Estimate::value);
    // Without structure the largest of many values is one, within errors; and where these are not known, the
    // intensity of a single vector is distributed exponentially.
    constexpr double kErrors = 4;
    constexpr double kIntensity = 10;
    const double by_chance = std::isnan(highest->error) ? kIntensity : 1 + kErrors * highest->error;
    const bool is_peak = highest->value > by_chance;
    const double wave_number = wave_numbers[static_cast<std::size_t>(highest - factors.begin())];
    Quantity& peak = found.add("highest_peak", "1", is_peak ? *highest : Estimate());
    if (!is_peak) peak.reason = kNoPeak;
    found.add("highest_peak_wave_number", "L^-1", is_peak ? Estimate{wave_number} : Estimate()).reason =
        is_peak ? "it is known to the width of a shell of wave numbers" : kNoPeak;
  }
  found.add_argument("wave_number", "L^-1", wave_numbers);
  const auto theory = [&](std::size_t shell) {
    return mean_in(shell, [&](double wave_number) {
      return percus_yevick_structure_factor(packing_fraction_, wave_number * diameter_);
    });
  };
  found.add("structure_factor", "1", factors,
            std::isfinite(packing_fraction_) ? std::optional(tabulated(rows, theory)) : std::nullopt);
}

bool StructureFactor::restored() const {
  const auto is_within = [this](const Wave& wave) {
    bool is_short = true;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      is_short &= wave[axis] >= -longest_[axis] && wave[axis] <= longest_[axis];
    }
    return is_short;
  };
  const bool is_bounded =
      ranges::all_of(longest_, [](int most) { return most >= 0 && most <= 2 * kMaxPeriods; });
  return is_bounded && ranges::all_of(waves_, is_within) && ranges::is_sorted(shell_ends_) &&
         waves_.size() == (shell_ends_.empty() ? 0 : shell_ends_.back()) &&
         ranges::adjacent_find(shell_ends_) == shell_ends_.end() &&
         (shell_ends_.empty() || shell_ends_.front() > 0) && shells_.has(shell_ends_.size());
}

}  // namespace hardball
