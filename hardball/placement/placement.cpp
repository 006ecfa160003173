// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/placement/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/geometry/spacing.hpp"
#include "hardball/placement/free_space.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/static_hash_grid.hpp"

namespace hardball {
namespace {

// How densely equal spheres or discs can be packed.
struct Packing {
  const char* name;  // of the lattice, in messages and in a scenario
  const char* keyword;
  double closest;      // on it
  double saturation;   // of random sequential addition, which slows down long before
  double most_random;  // placed at random
};

// Source: Zhang and Torquato, Phys. Rev. E 88 (2013) 053312, for saturation.
const Packing& packing_in(const Box& box) {
  static constexpr Packing kSpheres{"face-centered cubic", "fcc", kClosePacking, 0.385, 0.36};
  static constexpr Packing kDiscs{"hexagonal", "hexagonal", kClosePackingOfDiscs, 0.547, 0.54};
  return box.is_flat() ? kDiscs : kSpheres;
}

void check_fits(const Box& box, const Region& region, double radius, const std::string& where) {
  constexpr double kRounding = 1e-12;
  const Vec3 size = region.high - region.low;
  const double narrowest = box.is_flat() ? std::min(size.x, size.y) : std::min({size.x, size.y, size.z});
  if (2 * radius <= narrowest * (1 + kRounding)) return;
  throw Error(
      "diameter " + to_text(2 * radius) + " exceeds the length " + to_text(narrowest) + " of the region",
      where, "enlarge the region or shrink the spheres");
}

void check_region(const Box& box, const Region& region, const std::string& where) {
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    check_finite(region.low[axis], "an end of the region", where);
    check_finite(region.high[axis], "an end of the region", where);
    check_positive(region.high[axis] - region.low[axis], "a length of the region", where);
  }
}

// The interval along an axis in which a center may lie.
struct Span {
  double low;
  double high;
};

Span span_for_centers(const Box& box, const Region& region, double radius, std::size_t axis) {
  if (box.boundary(axis) == Boundary::flat) return {0, 0};
  const double inset = box.is_periodic(axis) ? 0 : radius;
  return {region.low[axis] + inset, region.high[axis] - inset};
}

// The part of the region in which a center may lie.
Region region_for_centers(const Box& box, const Region& region, double radius) {
  Region centers;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Span span = span_for_centers(box, region, radius, axis);
    centers.low[axis] = span.low;
    centers.high[axis] = std::max(span.low, span.high);
  }
  return centers;
}

// The high end of a periodic axis is the low end of the next box.
bool contains(const Box& box, const Region& region, const Vec3& place) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (place[axis] < region.low[axis] || place[axis] > region.high[axis]) return false;
    if (box.is_periodic(axis) && place[axis] == region.high[axis]) return false;
  }
  return true;
}

double largest_of(std::span<const double> radii, std::span<const PlacedSphere> placed) {
  double largest = ranges::max(radii);
  for (const PlacedSphere& sphere : placed) largest = std::max(largest, sphere.radius);
  return largest;
}

// Places spheres at random, one after another, none larger than the one before.
class SequentialAddition {
 public:
  SequentialAddition(const Box& box, const Region& region, std::span<const double> radii, Random& random,
                     const IsAllowed& is_allowed, std::span<const PlacedSphere> placed)
      : box_(box),
        region_(region),
        count_(radii.size()),
        smallest_(ranges::min(radii)),
        random_(random),
        is_allowed_(is_allowed),
        placed_(box, radii.size() + placed.size(), largest_of(radii, placed)) {
    for (const PlacedSphere& sphere : placed) placed_.insert(sphere.center, sphere.radius);
  }

  // The center of the next sphere, uniform among those with room; none if there is none, or hardly any.
  std::optional<Vec3> place(double radius) {
    if (space_ && radius < space_->least_radius()) space_.reset();
    std::optional<Vec3> center;
    if (!space_ || !space_->is_listed()) center = draw_anywhere(radius);
    if (!center) {
      if (!space_ || !space_->is_listed()) {
        make_space(radius, kFineVoxels);
        space_->list();
      }
      center = draw_listed(radius);
    }
    if (!center) return center;
    placed_.insert(*center, radius);
    if (space_ && !space_->is_listed()) space_->exclude(*center, radius);
    return center;
  }

 private:
  // How finely the region is divided: at most this many voxels to a radius, and to a sphere.
  struct Voxels {
    double per_radius;
    std::size_t per_sphere;
  };
  // Fine ones cost more, which is worth it where there is little room.
  static constexpr Voxels kCoarseVoxels{2.5, 256};
  static constexpr Voxels kFineVoxels{3, 512};
  // Centers tried anywhere before voxels with room are listed, and then among these.
  static constexpr int kTriesAnywhere = 20000;
  static constexpr int kTriesListed = 100000;

  std::optional<Vec3> draw_anywhere(double radius) {
    const Region centers = region_for_centers(box_, region_, radius);
    for (int i = 0; i < kTriesAnywhere; ++i) {
      look_ahead(centers);
      const Vec3 center = draw_in(centers, random_);
      if (space_ && space_->is_excluded(center)) continue;
      const bool overlaps =
          placed_.is_any_near(center, radius, [](std::uint32_t, const Vec3& separation, double reach) {
            return dot(separation, separation) < reach * reach;
          });
      // Asked last: it may cost most.
      if (!overlaps && (!is_allowed_ || is_allowed_(center, radius))) return center;
      if (!overlaps) continue;
      // To know where there is no room pays once that many tries have failed.
      if (!space_ && ++failed_tries_ > placed_.size()) make_space(radius, kCoarseVoxels);
    }
    return std::nullopt;
  }

  Vec3 draw_in(const Region& centers, Random& random) const {
    Vec3 center;
    for (std::size_t axis = 0; axis < box_.dimensions(); ++axis) {
      center[axis] = centers.low[axis] + random.uniform() * (centers.high[axis] - centers.low[axis]);
    }
    return center;
  }

  // Fetches from memory what is known of the centers drawn next. Their numbers are drawn once more when it is
  // their turn.
  void look_ahead(const Region& centers) {
    for (; looked_ahead_ < kAhead; ++looked_ahead_) {
      const Vec3 center = draw_in(centers, ahead_);
      if (space_) space_->prefetch(center);
    }
    --looked_ahead_;
  }

  std::optional<Vec3> draw_listed(double radius) {
    const Region centers = region_for_centers(box_, region_, radius);
    for (int i = 0; i < kTriesListed && !space_->is_empty(); ++i) {
      const FreeSpace::Draw draw = space_->draw(random_);
      if (!contains(box_, centers, draw.center) || (is_allowed_ && !is_allowed_(draw.center, radius)))
        continue;
      // The sphere that reaches farthest beyond the center, but one that leaves no room in the voxel if there
      // is any.
      std::optional<FreeSpace::Overlap> found;
      double deepest = 0;
      placed_.is_any_near(draw.center, radius, [&](std::uint32_t, const Vec3& separation, double reach) {
        const double depth = reach * reach - dot(separation, separation);
        if (!(depth > 0)) return false;
        const FreeSpace::Overlap overlap{separation, reach - radius};
        const bool is_last = space_->covers(draw, overlap);
        if (is_last || depth > deepest) {
          found = overlap;
          deepest = depth;
        }
        return is_last;
      });
      if (!found) return draw.center;
      space_->refine(draw, *found);
    }
    return std::nullopt;
  }

  void make_space(double radius, const Voxels& voxels) {
    // Good for the next spheres, too, until they are a tenth smaller.
    const double least_radius = std::max(smallest_, 0.9 * radius);
    space_.emplace(box_, region_for_centers(box_, region_, least_radius), least_radius,
                   least_radius / voxels.per_radius, count_ * voxels.per_sphere);
    placed_.for_each([&](const Vec3& center, double other) { space_->exclude(center, other); });
    failed_tries_ = 0;
  }

  const Box& box_;
  const Region& region_;
  std::size_t count_;
  double smallest_;
  Random& random_;
  const IsAllowed& is_allowed_;
  StaticHashGrid placed_;
  std::optional<FreeSpace> space_;  // once tries have failed
  std::size_t failed_tries_ = 0;    // since then
  static constexpr int kAhead = 32;
  int looked_ahead_ = 0;    // by this many centers
  Random ahead_ = random_;  // as it will be then, as long as centers are drawn anywhere
};

// Reports the progress of placement by the work done: the nearer to saturation, the longer a sphere takes.
class PlacementProgress {
 public:
  // `filled` is the part of saturation at which equal spheres will be; zero if they are not equal.
  PlacementProgress(const Progress& progress, std::size_t count, double filled, std::size_t dimensions)
      : progress_(progress),
        count_(static_cast<double>(count)),
        filled_(filled),
        dimensions_(static_cast<double>(dimensions)),
        all_(work_until(1)) {}

  void record(std::size_t placed) {
    const auto step =
        static_cast<std::size_t>(kSteps * work_until(static_cast<double>(placed) / count_) / all_);
    for (; next_ <= step; ++next_) progress_.record(next_, kSteps);
  }

 private:
  // The work for this fraction of the spheres, if a try costs a tenth of placing a sphere where there is
  // room. Of the volume, about (1 - packing / saturation)^4 has room, of an area the third power; where it is
  // little, tries are made in listed voxels.
  double work_until(double fraction) const {
    constexpr double kLeastRoom = 0.15;  // its root
    if (filled_ == 0) return fraction;
    const double most = std::min(fraction, (1 - kLeastRoom) / filled_);
    const double room = 1 - most * filled_;
    const double tries = (std::pow(room, -dimensions_) - 1) / dimensions_ / filled_ +
                         (fraction - most) * std::pow(room, -dimensions_ - 1);
    return fraction + 0.1 * tries;
  }

  // Few enough that each is reported.
  static constexpr std::size_t kSteps = 127;

  const Progress& progress_;
  double count_;
  double filled_;
  double dimensions_;
  double all_;
  std::size_t next_ = 0;
};

// A face-centered cubic or hexagonal lattice. Its sites are every second point, as on a chessboard, of a grid
// with half the edges of its cube, or of a rectangle with a site in the middle.
struct Lattice {
  std::array<std::size_t, kAxes> points{};  // of the grid, along each axis
  Vec3 half_edge;
  Vec3 origin;
  double nearest = 0;

  std::size_t sites() const { return points[0] * points[1] * points[2] / 2; }
};

Lattice make_lattice(const Box& box, const Region& region, double radius,
                     const std::array<std::size_t, kAxes>& cubes) {
  Lattice lattice{{1, 1, 1}, {}, {}, 0};
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    const Span span = span_for_centers(box, region, radius, axis);
    lattice.points[axis] = 2 * cubes[axis];
    const auto points = static_cast<double>(lattice.points[axis]);
    const bool periodic = box.is_periodic(axis);
    lattice.half_edge[axis] = (span.high - span.low) / (periodic ? points : points - 1);
    lattice.origin[axis] = span.low + (periodic ? lattice.half_edge[axis] / 2 : 0);
  }
  const Vec3& h = lattice.half_edge;
  lattice.nearest = std::min({length({h.x, h.y, 0}), 2 * h.x, 2 * h.y});
  if (box.is_flat()) return lattice;
  lattice.nearest = std::min(
      {length({h.x, h.y, 0}), length({0, h.y, h.z}), length({h.x, 0, h.z}), 2 * h.x, 2 * h.y, 2 * h.z});
  return lattice;
}

// The lattice with room for `count` spheres whose nearest sites are farthest
// apart.
Lattice widest_lattice(const Box& box, const Region& region, std::size_t count, double radius) {
  Lattice widest;
  if (box.is_flat()) {
    const std::size_t pairs = (count + 1) / 2;
    for (std::size_t a = 1; a <= pairs; ++a) {
      const Lattice lattice = make_lattice(box, region, radius, {a, (pairs + a - 1) / a, 1});
      if (lattice.nearest > widest.nearest) widest = lattice;
    }
    return widest;
  }
  const Vec3 size = region.high - region.low;
  const double edge = spacing(size, static_cast<double>(count) / 4);
  std::array<std::size_t, kAxes> low{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    low[axis] = static_cast<std::size_t>(std::max(1.0, std::floor(size[axis] / edge) - 2));
  }
  constexpr std::size_t kTries = 6;
  for (std::size_t a = low[0]; a < low[0] + kTries; ++a) {
    for (std::size_t b = low[1]; b < low[1] + kTries; ++b) {
      const std::size_t c = (count + 4 * a * b - 1) / (4 * a * b);
      const Lattice lattice = make_lattice(box, region, radius, {a, b, c});
      if (lattice.nearest > widest.nearest) widest = lattice;
    }
  }
  return widest;
}

// How densely the region is to be filled, by spheres of one size or of several.
struct Filling {
  double fraction = 0;  // [1]
  bool is_equal = true;
};

Filling filling_of(const Box& box, const Region& region, std::span<const double> radii,
                   std::span<const PlacedSphere> placed) {
  Filling filling;
  double volume = 0;
  const auto add = [&](double radius) {
    volume += box.sphere_volume(radius);
    filling.is_equal = filling.is_equal && radius == radii.front();
  };
  for (const double radius : radii) add(radius);
  for (const PlacedSphere& sphere : placed) add(sphere.radius);
  filling.fraction = volume / box.volume_of(region.high - region.low);
  return filling;
}

}  // namespace

std::optional<std::vector<Vec3>> find_random_places(const Box& box, const Region& region,
                                                    std::span<const double> radii, Random& random,
                                                    const std::string& where, const Progress& progress,
                                                    const IsAllowed& is_allowed,
                                                    std::span<const PlacedSphere> placed) {
  std::vector<Vec3> centers(radii.size());
  if (radii.empty()) return centers;
  check_region(box, region, where);
  for (const double radius : radii) check_positive(radius, "radius", where);
  check_fits(box, region, ranges::max(radii), where);
  const Packing& densest = packing_in(box);
  const auto [packing, are_equal] = filling_of(box, region, radii, placed);
  if (packing > densest.closest && are_equal) {
    throw Error("a packing fraction of " + to_text(packing) + " cannot exist", where,
                "equal " + std::string(box.is_flat() ? "discs" : "spheres") + " fill at most " +
                    to_text(std::floor(1e4 * densest.closest + 0.5) / 1e4) +
                    "; enlarge the box, or use fewer or smaller ones");
  }
  if (packing > densest.most_random && are_equal) return std::nullopt;
  std::vector<std::size_t> by_size(radii.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  if (ranges::min(radii) != ranges::max(radii)) {
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  }
  PlacementProgress progress_by_work(progress, radii.size(), are_equal ? packing / densest.saturation : 0,
                                     box.dimensions());
  SequentialAddition addition(box, region, radii, random, is_allowed, placed);
  std::size_t done = 0;
  for (const std::size_t i : by_size) {
    progress_by_work.record(done);
    const std::optional<Vec3> center = addition.place(radii[i]);
    if (!center) return std::nullopt;
    centers[i] = *center;
    ++done;
  }
  return centers;
}

std::vector<Vec3> place_randomly(const Box& box, const Region& region, std::span<const double> radii,
                                 Random& random, const std::string& where, const Progress& progress,
                                 const IsAllowed& is_allowed, std::span<const PlacedSphere> placed) {
  auto centers = find_random_places(box, region, radii, random, where, progress, is_allowed, placed);
  if (centers) return *std::move(centers);
  throw Error("random placement cannot reach a packing fraction of " +
                  to_text(filling_of(box, region, radii, placed).fraction),
              where,
              "use placement = \"" + std::string(packing_in(box).keyword) +
                  "\", a larger box, or fewer or smaller spheres");
}

std::vector<Vec3> place_on_lattice(const Box& box, const Region& region, std::size_t count, double radius,
                                   const std::string& where) {
  std::vector<Vec3> centers;
  centers.reserve(count);
  place_on_lattice(box, region, count, radius, where, [&](const Vec3& center) { centers.push_back(center); });
  return centers;
}

void place_on_lattice(const Box& box, const Region& region, std::size_t count, double radius,
                      const std::string& where, const Function<void(const Vec3&)>& take) {
  if (count == 0) return;
  check_region(box, region, where);
  check_positive(radius, "radius", where);
  check_fits(box, region, radius, where);
  const Lattice lattice = widest_lattice(box, region, count, radius);
  if (lattice.nearest < 2 * radius) {
    throw Error("no " + std::string(packing_in(box).name) + " lattice holds " + to_text(count) +
                    " spheres of radius " + to_text(radius) + " in this box",
                where, "with this count and box the radius can be at most " + to_text(lattice.nearest / 2));
  }
  const std::size_t sites = lattice.sites();
  std::size_t site = 0;
  for (std::size_t x = 0; x < lattice.points[0]; ++x) {
    for (std::size_t y = 0; y < lattice.points[1]; ++y) {
      for (std::size_t z = (x + y) % 2; z < lattice.points[2]; z += 2) {
        // Site k is taken where k * count / sites increases: at `count` sites, evenly spread.
        const bool taken = (site + 1) * count / sites > site * count / sites;
        ++site;
        if (!taken) continue;
        take({lattice.origin.x + static_cast<double>(x) * lattice.half_edge.x,
              lattice.origin.y + static_cast<double>(y) * lattice.half_edge.y,
              lattice.origin.z + static_cast<double>(z) * lattice.half_edge.z});
      }
    }
  }
}

}  // namespace hardball
