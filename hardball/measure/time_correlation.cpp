// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/time_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

TimeCorrelation::TimeCorrelation(const Scene& scene, double interval, std::size_t most_spheres,
                                 const Shape& shape)
    : species_(scene.species()), begin_(scene.now()), interval_(interval), shape_(shape) {
  HARDBALL_CHECK(interval > 0);
  const World& world = scene.world();
  const std::size_t count = std::min(world.size(), most_spheres);
  // The species of the spheres followed, in the order of ids.
  std::vector<std::size_t> kinds;
  std::size_t rank = 0;
  world.for_each_by_id([&](Slot slot) {
    // The k-th to follow is the first whose rank is at least k n / count.
    if (rank * count >= followed_.size() * world.size() && followed_.size() < count) {
      followed_.push_back({rank, 0});
      kinds.push_back(species_.of(world.id(slot)));
    }
    ++rank;
  });
  std::size_t index = 0;
  for (std::size_t kind = 0; kind < species_.size(); ++kind) {
    const std::size_t begin = index;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (kinds[i] == kind) followed_[i].index = index++;
    }
    const std::size_t spheres = index - begin;
    const std::size_t groups = std::min(spheres, kMaxGroups);
    for (std::size_t g = 0; g < groups; ++g) {
      groups_.push_back({kind, begin + g * spheres / groups, begin + (g + 1) * spheres / groups});
    }
  }
  vectors_.resize(count * shape_.vectors);
}

bool TimeCorrelation::is_due(const Time& now) {
  constexpr double kRounding = 1e-6;
  if (followed_.empty()) return false;
  const double ticks = duration(begin_, now) / interval_;
  const std::int64_t tick = std::llround(ticks);
  if (std::fabs(ticks - static_cast<double>(tick)) > kRounding || tick <= tick_) return false;
  tick_ = tick;
  return true;
}

std::size_t TimeCorrelation::lag_of(std::size_t level, std::size_t steps) {
  return level == 0 ? steps : kLevelLags + (level - 1) * (kLevelLags - kFirstLag) + steps - kFirstLag;
}

void TimeCorrelation::link_to_earlier(Link link) {
  for (std::size_t k = 0; k < kLevels; ++k) {
    const std::int64_t index = tick_ >> k;
    // Only multiples of 2^k belong to level k, and the start belongs to the first level alone.
    if (index << k != tick_ || (k > 0 && index == 0)) return;
    if (k == levels_.size()) {
      levels_.emplace_back();
      levels_.back().index.fill(std::numeric_limits<std::int64_t>::min());
      levels_.back().vectors.resize(kLevelLags * vectors_.size());
      origins_.resize(lag_of(k, kLevelLags - 1) + 1);
      sums_.resize(origins_.size() * groups_.size() * shape_.products);
    }
    Level& level = levels_[k];
    const std::size_t newest = static_cast<std::size_t>(index) % kLevelLags;
    level.index[newest] = index;
    std::copy(vectors_.begin(), vectors_.end(),
              level.vectors.begin() + static_cast<std::ptrdiff_t>(newest * vectors_.size()));
    for (std::size_t steps = k == 0 ? 0 : kFirstLag; steps < kLevelLags; ++steps) {
      const std::size_t earlier = (newest + kLevelLags - steps) % kLevelLags;
      if (level.index[earlier] != index - static_cast<std::int64_t>(steps)) continue;
      const std::size_t lag = lag_of(k, steps);
      ++origins_[lag];
      const std::span<const Vec3> before(&level.vectors[earlier * vectors_.size()], vectors_.size());
      const std::span<const Vec3> now(vectors_);
      for (std::size_t g = 0; g < groups_.size(); ++g) {
        const std::size_t begin = groups_[g].begin * shape_.vectors;
        const std::size_t size = groups_[g].end * shape_.vectors - begin;
        link(before.subspan(begin, size), now.subspan(begin, size),
             &sums_[(lag * groups_.size() + g) * shape_.products]);
      }
    }
  }
}

std::vector<double> TimeCorrelation::lags() const {
  std::vector<double> lags;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    for (std::size_t steps = k == 0 ? 0 : kFirstLag; steps < kLevelLags; ++steps) {
      if (origins_[lag_of(k, steps)] > 0)
        lags.push_back(std::ldexp(static_cast<double>(steps), static_cast<int>(k)) * interval_);
    }
  }
  return lags;
}

Estimate TimeCorrelation::estimate(std::size_t species, const FunctionOfMeans& quantity) const {
  std::vector<double> sums;
  std::vector<double> spheres;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (groups_[g].species != species) continue;
    spheres.push_back(static_cast<double>(groups_[g].end - groups_[g].begin));
    for (std::size_t lag = 0; lag < origins_.size(); ++lag) {
      if (origins_[lag] == 0) continue;
      for (std::size_t product = 0; product < shape_.products; ++product) {
        const double sum = sums_[(lag * groups_.size() + g) * shape_.products + product];
        sums.push_back(sum / static_cast<double>(origins_[lag]));
      }
    }
  }
  const Parts found = jackknife(sums, spheres, quantity);
  // Neighbors move collectively and exchange energy: the variance of the mean over all is up to twice as
  // large as for independent spheres, the most in a dense fluid.
  return {found.value, std::numbers::sqrt2 * error_of_independent(found.shares)};
}

bool TimeCorrelation::restored() const {
  const std::size_t spheres = followed_.size();
  const std::size_t lags = levels_.empty() ? 0 : lag_of(levels_.size() - 1, kLevelLags - 1) + 1;
  const auto is_index = [&](const Followed& one) { return one.index < spheres; };
  const auto is_group = [&](const Group& group) {
    return group.species < species_.size() && group.begin < group.end && group.end <= spheres;
  };
  const auto is_level = [&](const Level& level) {
    return level.vectors.size() == kLevelLags * vectors_.size();
  };
  return (interval_ > 0 || spheres == 0) && tick_ >= -1 && levels_.size() <= kLevels && shape_.products > 0 &&
         shape_.products <= kMaxProducts && vectors_.size() == spheres * shape_.vectors &&
         groups_.size() <= kMaxGroups * SpeciesList::kMaxSpecies && ranges::all_of(followed_, is_index) &&
         ranges::all_of(groups_, is_group) && ranges::all_of(levels_, is_level) && origins_.size() == lags &&
         sums_.size() == lags * groups_.size() * shape_.products;
}

bool TimeCorrelation::matches(const World& world) const {
  if (followed_.empty()) return true;
  return species_.matches(world) &&
         ranges::all_of(followed_, [&](const Followed& one) { return one.rank < world.size(); });
}

}  // namespace hardball
