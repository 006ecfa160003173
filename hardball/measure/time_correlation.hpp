// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/estimate.hpp"
#include "hardball/theory/species_list.hpp"

namespace hardball {

/// Means over spheres and times of products that link vectors of a sphere to the same vectors a lag later:
/// the square of a displacement, or the product of two velocities.
///
/// Samples are taken at multiples of an interval, and may be missing at some: then so are their lags. Lags
/// are 0 to 7 intervals, then 8, 10, 12, 14, then 16, 20,
/// 24, 28 and so on, four for each doubling; those of the k-th doubling start at every 2^k-th sample. So the
/// work for each sample and sphere is bounded, and memory grows with the logarithm of the run: 192 bytes for
/// a vector of a sphere and doubling. Source: Frenkel and Smit, Understanding Molecular Simulation, 2nd
/// edition, section 4.4.2.
///
/// Errors are from the scatter among up to 32 groups of spheres of a species, see error_of_independent: the
/// values of a sphere at different times are not independent, nor are lags that overlap. Their square is
/// doubled for the collective motion of spheres.
class TimeCorrelation {
 public:
  /// The most spheres that are followed; of more, some are chosen evenly by id.
  static constexpr std::size_t kMaxSpheres = 10000;
  /// A product starts at a sample that is a multiple of the k-th power of two up to this many times that
  /// power later: windows of this many samples have lags of nearly their length.
  static constexpr std::size_t kLevelLags = 8;

  /// The vectors of each sphere, and the products of each lag.
  struct Shape {
    std::uint64_t vectors = 1;
    std::uint64_t products = 1;
    friend bool operator==(const Shape&, const Shape&) = default;
    static void persist(auto& archive, auto& self) { archive(self.vectors, self.products); }
  };

  /// Adds, over all spheres, the products that link the earlier vectors to the later ones to `sums`, one for
  /// each product.
  using Link = void (*)(std::span<const Vec3> earlier, std::span<const Vec3> later, double* sums);

  /// A correlation of no spheres.
  TimeCorrelation() = default;
  /// Starts at the time of the scene; `interval` [T] is positive. Cost: O(n).
  TimeCorrelation(const Scene& scene, double interval, std::size_t most_spheres, const Shape& shape);

  /// Adds a sample; `note` writes the vectors of the sphere in a slot to the place it is given. A time that
  /// is not a multiple of the interval, or not later than the last, is ignored. Cost: some 10 links for each
  /// sphere followed.
  template <class Note>
  void sample(const Scene& scene, Link link, const Note& note) {
    if (!is_due(scene.now())) return;
    for (const Followed& one : followed_) {
      note(scene.world().slot_of_rank(one.rank), &vectors_[one.index * shape_.vectors]);
    }
    link_to_earlier(link);
  }

  const SpeciesList& species() const { return species_; }
  bool has(const Shape& shape) const { return shape_ == shape; }
  /// The lags for which there are samples, in ascending order, zero first [T].
  std::vector<double> lags() const;
  /// How many spheres are followed.
  std::size_t followed() const { return followed_.size(); }
  /// A function of the means of one species: shape (lags, products).
  Estimate estimate(std::size_t species, const FunctionOfMeans& quantity) const;
  /// The mean of a product at one of these lags.
  Estimate at(std::size_t species, std::size_t lag, std::size_t product = 0) const {
    return estimate(species, mean_of(lag * shape_.products + product));
  }

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.begin_, self.interval_, self.tick_, self.followed_, self.groups_,
            self.vectors_, self.levels_, self.origins_, self.sums_, self.shape_);
  }
  bool restored() const;

  static constexpr std::size_t kFirstLag =
      4;  // of all levels but the first: the level before has shorter ones
  static constexpr std::size_t kLevels = 32;
  static constexpr std::size_t kMaxGroups = 32;
  static constexpr std::size_t kMaxProducts = 8;

  struct Followed {
    std::size_t rank;   // among all spheres, by id
    std::size_t index;  // among those followed, which are ordered by group
    static void persist(auto& archive, auto& self) { archive(self.rank, self.index); }
  };
  struct Group {
    std::size_t species;
    std::size_t begin;
    std::size_t end;
    static void persist(auto& archive, auto& self) { archive(self.species, self.begin, self.end); }
  };
  // The last kLevelLags samples at multiples of 2^k intervals; sample i is stored as i modulo kLevelLags.
  struct Level {
    std::array<std::int64_t, kLevelLags> index;
    std::vector<Vec3> vectors;
    static void persist(auto& archive, auto& self) { archive(self.index, self.vectors); }
  };

  bool is_due(const Time& now);
  void link_to_earlier(Link link);
  static std::size_t lag_of(std::size_t level, std::size_t steps);

  SpeciesList species_;
  Time begin_;
  double interval_ = 0;
  std::int64_t tick_ = -1;  // the last sample, in intervals since the start
  std::vector<Followed> followed_;
  std::vector<Group> groups_;
  Shape shape_;
  std::vector<Vec3> vectors_;  // of the last sample, shape (spheres, vectors)
  std::vector<Level> levels_;
  std::vector<std::uint64_t> origins_;  // of each lag
  std::vector<double> sums_;            // shape (lags, groups, products)
};

}  // namespace hardball
