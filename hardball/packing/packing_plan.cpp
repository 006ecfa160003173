// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packing_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/packing/jamming.hpp"
#include "hardball/packing/protocol.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

using Densest = PackingRequest::Densest;
using Pressure = PackingRequest::Pressure;
using Follows = PackingPlan::Follows;

// At most this many spheres are packed: ids have 32 bits.
constexpr double kMostSpheres = 4e9;

// The volume of spheres of radius 1, of discs the area.
double unit_volume(std::size_t dimensions) {
  return dimensions == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
}

std::string rounded(double number, int digits) {
  const double scale = digits == 1 ? 10 : digits == 2 ? 100 : 1000;
  return to_text(std::round(scale * number) / scale);
}

// To six digits, for messages.
std::string shown(double number) {
  const double digits = std::pow(10, 5 - std::floor(std::log10(number)));
  return to_text(std::round(number * digits) / digits);
}

// Radii whose mean is one.
std::vector<double> draw_radii(const std::optional<RadiusDistribution>& distribution, std::size_t count,
                               std::uint64_t seed, std::size_t dimensions) {
  if (!distribution) return std::vector<double>(count, 1.0);
  Random random(seed);
  std::vector<double> radii = spread_radii(*distribution, count, random);
  const double mean = statistics_of(radii, dimensions).mean;
  for (double& radius : radii) radius /= mean;
  return radii;
}

void multiply(std::vector<double>& radii, double factor) {
  for (double& radius : radii) radius *= factor;
}

const double* fraction_of(const PackingRequest::Goal& goal) {
  return std::get_if<double>(&goal);
}

// What is given is counted, so that messages can name what is missing.
struct Given {
  bool count;
  bool diameter;
  bool size;
  bool goal;
};

Given given_in(const PackingRequest& request) {
  Given given{request.count || !request.radii.empty(), request.diameter || !request.radii.empty(),
              request.container && !request.is_container_size_free, request.goal.has_value()};
  // A mesh keeps its size unless the others say how large it is to be.
  const bool is_mesh = request.container && request.container->mesh;
  if (is_mesh && !(given.count && given.diameter && given.goal)) given.size = true;
  return given;
}

[[noreturn]] void refuse(std::string what, std::string remedy) {
  throw Error(std::move(what), "packing", std::move(remedy));
}

void check_numbers(const PackingRequest& request) {
  if (request.dimensions != 2 && request.dimensions != 3)
    refuse("there are " + to_text(request.dimensions) + " dimensions", "give 2 or 3");
  if (request.count && !request.radii.empty() && *request.count != request.radii.size()) {
    refuse(
        "there are " + to_text(request.radii.size()) + " radii for " + to_text(*request.count) + " spheres",
        "leave the count out");
  }
  if (request.count == 0) refuse("the count is zero", "give at least two spheres");
  if (request.diameter) check_positive(*request.diameter, "diameter", "packing");
  for (const double radius : request.radii) check_positive(radius, "radius", "packing");
  if (request.container) {
    Container container = *request.container;
    container.dimensions = request.dimensions;
    check(container, "packing");
  }
  if (request.rate) check_positive(*request.rate, "rate", "packing");
  if (!(request.gap >= 0 && request.gap < 1)) {
    refuse("the gap is " + to_text(request.gap), "give a fraction of the diameter from 0 to below 1");
  }
  if (!request.goal) return;
  if (const double* fraction = fraction_of(*request.goal))
    check_positive(*fraction, "packing fraction", "packing");
  if (const auto* pressure = std::get_if<Pressure>(&*request.goal);
      pressure && !(pressure->compressibility > 1)) {
    refuse("the pressure PV/NkT is " + to_text(pressure->compressibility), "give a number above one");
  }
}

// Error: not three of the four are given, where the goal is a packing fraction; or not two of the other
// three, where the goal says how dense spheres become by themselves. All four are refused elsewhere.
Follows what_follows(const Given& given) {
  if (!given.goal) {
    if (given.count && given.diameter && given.size) return Follows::packing_fraction;
    refuse("nothing says how dense the packing is to be", "give a packing fraction, max or a pressure");
  }
  const int others = int{given.count} + int{given.diameter} + int{given.size};
  if (others == 3) return Follows::packing_fraction;
  if (!given.count) {
    if (given.diameter && given.size) return Follows::count;
    refuse("the count is not given, and does not follow from what is", "give a count, or diameter and box");
  }
  return given.size ? Follows::diameter : Follows::size;
}

// Error: no arrangement of such spheres is so dense.
void refuse_beyond_closest(double fraction, const SizeStatistics& sizes, const PackingPlan& plan) {
  constexpr double kEqual = 1e-9;
  const bool is_equal = sizes.deviation < kEqual;
  const bool is_flat = plan.container.dimensions == 2;
  const double closest = !is_equal ? 1 : is_flat ? kClosePackingOfDiscs : kClosePacking;
  if (fraction < closest) return;
  const double left = power(1 - plan.gap, plan.container.dimensions);
  std::string what = "no " + std::string(is_equal ? "equal " : "") + (is_flat ? "discs" : "spheres") +
                     " fill " + (plan.gap > 0 ? shown(left * fraction) : to_text(fraction)) +
                     " of the volume";
  if (plan.gap > 0) {
    what += " with gaps of " + to_text(plan.gap) + ": without them they would fill " + shown(fraction);
  }
  refuse(what, "give a packing fraction below " + to_text(std::floor(left * closest * 1e5) / 1e5));
}

void warn(PackingPlan& plan, const SizeStatistics& sizes) {
  const double* fraction = fraction_of(plan.goal);
  constexpr double kTooDense = 1.02;
  const bool has_walls = plan.container.wall_area() > 0;
  if (fraction && *fraction > kTooDense * plan.plausible && !plan.is_narrow()) {
    std::string warning = "a packing fraction of " + to_text(*fraction) + " is beyond the " +
                          rounded(plan.plausible, 3) +
                          " at which such spheres jam; only crystals may be so dense";
    if (has_walls) warning += ", and the layers next to walls are looser";
    if (plan.gap > 0) warning += "; that is before diameters are reduced by the gap";
    plan.warnings.push_back(warning);
  }
  constexpr std::size_t kFew = 10;
  if (sizes.half_of_volume < kFew && plan.radii.size() > 2 * kFew) {
    plan.warnings.push_back(
        "the largest " + to_text(sizes.half_of_volume) + " of " + to_text(plan.radii.size()) +
        " spheres make up half of the volume, so the result depends on them and differs from seed to seed");
  }
  if (plan.is_narrow()) {
    plan.warnings.push_back(
        "the container is only " + rounded(plan.container.largest_radius() / sizes.largest, 1) +
        " diameters of the largest sphere wide; how dense spheres become depends on that " +
        "width, and may be far from the " + rounded(plan.plausible, 2) + " expected");
  }
}

// Error: the largest sphere does not fit.
void check_fits(const PackingPlan& plan, const SizeStatistics& sizes) {
  constexpr double kRounding = 1e-12;
  const double room = plan.container.largest_radius();
  if (sizes.largest <= room * (1 + kRounding)) return;
  refuse("the largest diameter would be " + to_text(2 * sizes.largest) + " in a container " +
             to_text(2 * room) + " wide",
         "give more or smaller spheres, or a larger container");
}

// Whether the spheres of a start are discs: their box says so, or they were asked for, or they lie in one
// plane in a box that leaves them no room across it, as LAMMPS has them in two dimensions. Error: discs were
// asked for, and the spheres do not lie in one plane.
bool are_discs(const PackingRequest& request) {
  const Snapshot& start = *request.start;
  if (start.box->is_flat) return true;
  const double plane = start.spheres.front().position.z;
  double largest = 0;
  bool are_in_plane = true;
  for (const Sphere& sphere : start.spheres) {
    are_in_plane = are_in_plane && sphere.position.z == plane;
    largest = std::max(largest, sphere.radius);
  }
  if (request.dimensions == 2 && !are_in_plane)
    refuse("the spheres of the start do not lie in one plane",
           "give a file with discs, or leave dimensions out");
  constexpr double kRounding = 1e-12;
  return are_in_plane && (request.dimensions == 2 || start.box->size.z <= 2 * largest * (1 + kRounding));
}

// The goal of spheres that are as dense as wanted when they are reduced by the gap.
PackingRequest::Goal before_gap(PackingRequest::Goal goal, double gap, std::size_t dimensions) {
  if (auto* fraction = std::get_if<double>(&goal)) *fraction /= power(1 - gap, dimensions);
  return goal;
}

PackingPlan plan_from_start(const PackingRequest& request) {
  const Snapshot& start = *request.start;
  if (request.count || request.diameter || request.distribution || !request.radii.empty() ||
      request.container) {
    refuse("spheres start from a file, which says how many there are, their sizes and their box",
           "leave count, diameter, sizes and box out");
  }
  if (!request.goal)
    refuse("nothing says how dense the packing is to be", "give a packing fraction, max or a pressure");
  if (start.spheres.empty()) refuse("there are no spheres at the start", "give a file with spheres");
  if (!start.box || start.box->is_unbounded)
    refuse("the spheres of the start have no box", "give a file with a box");
  if (start.box->tilt != 0) {
    refuse("the box of the start is tilted by " + to_text(start.box->tilt),
           "give a file whose box has edges along the axes");
  }
  PackingPlan plan;
  plan.gap = request.gap;
  plan.follows = Follows::diameter;
  const bool is_flat = are_discs(request);
  plan.container.dimensions = is_flat ? 2 : 3;
  plan.goal = before_gap(*request.goal, request.gap, plan.container.dimensions);
  plan.container.size = start.box->size;
  plan.labels.low = start.box->low;
  if (is_flat) plan.container.size.z = plan.labels.low.z = 0;
  for (std::size_t axis = 0; axis < plan.container.dimensions; ++axis)
    plan.container.has_walls[axis] = !start.box->is_periodic[axis];
  for (std::size_t i = 0; i < start.spheres.size(); ++i) {
    const Sphere& sphere = start.spheres[i];
    plan.radii.push_back(sphere.radius);
    plan.start.push_back(sphere.position - start.box->low);
    if (is_flat) plan.start.back().z = 0;
    plan.labels.ids.push_back(start.id(i));
    plan.labels.species.push_back(sphere.species);
    plan.labels.masses.push_back(sphere.mass);
  }
  const SizeStatistics sizes = statistics_of(plan.radii, plan.container.dimensions);
  const double volume = plan.container.volume();
  plan.start_fraction = unit_volume(plan.container.dimensions) * sizes.mean_volume *
                        static_cast<double>(plan.radii.size()) / volume;
  if (const double* fraction = fraction_of(plan.goal); fraction && *fraction < plan.start_fraction) {
    refuse("the spheres of the start fill " + to_text(plan.start_fraction) +
               " of the volume already, and are to fill " + to_text(*fraction),
           "give a higher packing fraction");
  }
  plan.plausible = plausible_packing_fraction(jamming_in_bulk(plan.radii, plan.container.dimensions), sizes,
                                              plan.container);
  return plan;
}

// How many spheres of mean radius 1 fill a volume.
std::size_t count_for(const PackingRequest& request, double volume) {
  const auto whole = [](double count) {
    return static_cast<std::size_t>(std::clamp(std::round(count), 1.0, kMostSpheres));
  };
  const double count = volume / unit_volume(request.dimensions);
  if (!request.distribution) return whole(count);
  // The mean volume depends on the sizes drawn, and these on how many they are.
  const auto mean_volume = [&](std::size_t spheres) {
    return statistics_of(draw_radii(request.distribution, spheres, request.seed, request.dimensions),
                         request.dimensions)
        .mean_volume;
  };
  constexpr int kRounds = 4;
  constexpr double kPilot = 1e4;
  double next = std::min(count, kPilot);
  for (int round = 0; round < kRounds; ++round) next = count / mean_volume(whole(next));
  // Of few, a single large one changes it much: all numbers are tried.
  constexpr std::size_t kFew = 500;
  std::size_t best = whole(next);
  if (best > kFew) return best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t spheres = 1, most = 2 * best + 2; spheres <= most; ++spheres) {
    const double off = std::fabs(static_cast<double>(spheres) * mean_volume(spheres) - count);
    if (off >= least) continue;
    least = off;
    best = spheres;
  }
  return best;
}

// The count that follows from the volume and the density, for spheres that jam the one at which they can be
// expected to.
std::size_t following_count(const PackingRequest& request) {
  const Container container = request.container->scaled(2 / *request.diameter);
  constexpr std::size_t kPilot = 10000;
  const std::vector<double> radii =
      draw_radii(request.distribution, kPilot, request.seed, request.dimensions);
  const double plausible = plausible_packing_fraction(jamming_in_bulk(radii, request.dimensions),
                                                      statistics_of(radii, request.dimensions), container);
  const double* fraction = fraction_of(*request.goal);
  return count_for(request, (fraction ? *fraction : plausible) * container.volume());
}

// Makes what follows as large as the expected packing fraction asks for. Walls make it depend on the size how
// dense that is.
void fit(PackingPlan& plan) {
  const std::size_t dimensions = plan.container.dimensions;
  const double in_bulk = jamming_in_bulk(plan.radii, dimensions);
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    const SizeStatistics sizes = statistics_of(plan.radii, dimensions);
    plan.plausible = plausible_packing_fraction(in_bulk, sizes, plan.container);
    const double volume =
        unit_volume(dimensions) * sizes.mean_volume * static_cast<double>(plan.radii.size());
    const double factor = root(plan.expected_fraction() * plan.container.volume() / volume, dimensions);
    if (plan.follows == Follows::size) plan.container = plan.container.scaled(1 / factor);
    if (plan.follows == Follows::diameter) multiply(plan.radii, factor);
  }
}

// The count follows from a packing fraction, and is a whole number.
void warn_of_whole_number(PackingPlan& plan, double wanted, double fraction) {
  constexpr double kNoticed = 0.01;
  if (std::fabs(fraction - wanted) <= kNoticed * wanted) return;
  const double of_volume = power(1 - plan.gap, plan.container.dimensions);
  plan.warnings.push_back("the nearest to a packing fraction of " + shown(of_volume * wanted) + " is " +
                          shown(of_volume * fraction) + ", with " + to_text(plan.radii.size()) +
                          " spheres of this diameter");
}

// Error: count, diameter, container and density are all given, and do not agree.
void check_agreement(const PackingRequest& request, const PackingPlan& plan, double fraction) {
  if (!request.goal) return;
  const double left = 1 - request.gap;
  const double of_volume = power(left, plan.container.dimensions);
  const std::string these = to_text(plan.radii.size()) +
                            (plan.container.dimensions == 2 ? " discs" : " spheres") + " of mean diameter " +
                            shown(left * plan.diameter) + " fill " + shown(of_volume * fraction) +
                            " of this container";
  const double* wanted = fraction_of(*request.goal);
  if (!wanted) refuse(these + ", and are to become as dense as they can", "leave one of the four out");
  constexpr double kRounding = 1e-9;
  if (std::fabs(fraction - *wanted) <= kRounding * *wanted) return;
  const double factor = root(fraction / *wanted, plan.container.dimensions);
  refuse(these + ", not " + shown(of_volume * *wanted) + ": for that all its edges would have to be " +
             shown(factor) + " times as long, or the mean diameter " + shown(left * plan.diameter / factor),
         "leave one of the four out");
}

PackingPlan plan_from_numbers(const PackingRequest& wanted) {
  // Of spheres before they are reduced by the gap.
  PackingRequest request = wanted;
  const double factor = 1 / (1 - wanted.gap);
  if (request.diameter) *request.diameter *= factor;
  multiply(request.radii, factor);
  if (request.goal) request.goal = before_gap(*request.goal, request.gap, request.dimensions);
  PackingPlan plan;
  plan.gap = request.gap;
  plan.follows = what_follows(given_in(request));
  const std::size_t dimensions = request.dimensions;
  plan.container = request.container.value_or(Container::periodic({1, 1, dimensions == 2 ? 0.0 : 1.0}));
  plan.container.dimensions = dimensions;
  plan.radii = request.radii;
  if (plan.radii.empty()) {
    plan.distribution = request.distribution;
    const std::size_t count = plan.follows == Follows::count ? following_count(request) : *request.count;
    plan.radii = draw_radii(request.distribution, count, request.seed, dimensions);
    multiply(plan.radii, 0.5);
  }
  plan.diameter = 2 * statistics_of(plan.radii, dimensions).mean;
  if (request.diameter) {
    multiply(plan.radii, *request.diameter / plan.diameter);
    plan.diameter = *request.diameter;
  }
  const SizeStatistics sizes = statistics_of(plan.radii, dimensions);
  plan.plausible = plausible_packing_fraction(jamming_in_bulk(plan.radii, dimensions), sizes, plan.container);
  if (plan.follows == Follows::packing_fraction ||
      (plan.follows == Follows::count && fraction_of(*request.goal))) {
    const double fraction = unit_volume(dimensions) * sizes.mean_volume *
                            static_cast<double>(plan.radii.size()) / plan.container.volume();
    if (plan.follows == Follows::packing_fraction) check_agreement(request, plan, fraction);
    if (plan.follows == Follows::count) warn_of_whole_number(plan, *fraction_of(*request.goal), fraction);
    plan.goal = fraction;
  } else {
    plan.goal = *request.goal;
    fit(plan);
  }
  const double dilute = dimensions == 2 ? protocol::kStartOfDiscs : protocol::kStart;
  plan.start_fraction = std::min(dilute, 0.9 * plan.expected_fraction());
  return plan;
}

// Error: no such packing exists, or it cannot be resolved.
void check_existence(const PackingPlan& plan, const SizeStatistics& sizes) {
  if (plan.radii.size() == 1 && plan.container.wall_area() == 0)
    refuse("one sphere in a periodic box has nothing to touch", "give at least two spheres, or walls");
  const double* fraction = fraction_of(plan.goal);
  if (fraction) refuse_beyond_closest(*fraction, sizes, plan);
  // Where the size follows from how dense spheres become, it is not known yet.
  if (plan.start.empty() && (fraction || plan.follows == Follows::count)) check_fits(plan, sizes);
  const auto* pressure = std::get_if<Pressure>(&plan.goal);
  if (!pressure) return;
  // The resolution of coordinates.
  const Vec3& low = plan.container.low;
  const Vec3 high = low + plan.container.size;
  const double most = 8e13 * 2 * sizes.mean / std::max({high.x, high.y, high.z, -low.x, -low.y, -low.z});
  if (pressure->compressibility < most) return;
  refuse(
      "at a pressure of " + to_text(pressure->compressibility) + " gaps are smaller than coordinates resolve",
      "give at most " + to_text(std::floor(most)));
}

}  // namespace

double PackingPlan::expected_fraction() const {
  if (const double* fraction = fraction_of(goal)) return *fraction;
  const auto* pressure = std::get_if<Pressure>(&goal);
  if (!pressure) return plausible;
  double low = 0;
  double high = plausible;
  constexpr int kHalvings = 40;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    const bool is_below =
        expected_compressibility(middle, plausible, container.dimensions) < pressure->compressibility;
    (is_below ? low : high) = middle;
  }
  return low;
}

double PackingPlan::expected_collisions() const {
  const std::size_t dimensions = container.dimensions;
  const double end = expected_fraction();
  double begin = start_fraction;
  double collisions = 0;
  if (rate < protocol::kFillingRate) {
    const double filled = std::min(end, dimensions == 2 ? 0.65 : 0.5);
    collisions += hardball::expected_collisions(begin, filled, protocol::kFillingRate, plausible, dimensions);
    begin = std::max(begin, filled);
  }
  collisions += hardball::expected_collisions(begin, end, rate, plausible, dimensions);
  double last = 0;
  if (std::holds_alternative<Densest>(goal)) last = protocol::kJammed;
  if (const auto* pressure = std::get_if<Pressure>(&goal)) {
    last = pressure->compressibility;
    collisions += protocol::kApproach;
  }
  // About as many again are spent on other numbers of spheres.
  const double attempts = follows == Follows::count && !fraction_of(goal) ? 2 : 1;
  if (!(last > protocol::kRelaxedFrom)) return attempts * collisions;
  const double steps = std::log(last / protocol::kRelaxedFrom) / -std::log1p(-protocol::kStep);
  const double heating = std::sqrt(std::numbers::pi) / 3 * 2 * rate;
  return attempts * (collisions + protocol::kWeighing +
                     steps * (2 * protocol::kStep / heating + protocol::kRelaxation + protocol::kWindow));
}

double PackingPlan::final_fraction() const {
  return expected_fraction() * power(1 - gap, container.dimensions);
}

bool PackingPlan::is_narrow() const {
  constexpr double kNarrow = 5;
  return container.wall_area() > 0 && container.largest_radius() < kNarrow * ranges::max(radii);
}

PackingPlan plan(const PackingRequest& request) {
  check_numbers(request);
  PackingPlan plan = request.start ? plan_from_start(request) : plan_from_numbers(request);
  plan.seed = request.seed;
  const std::size_t dimensions = plan.container.dimensions;
  const SizeStatistics sizes = statistics_of(plan.radii, dimensions);
  check_existence(plan, sizes);
  constexpr double kRate = 0.01;
  const double* fraction = fraction_of(plan.goal);
  plan.is_rate_given = request.rate.has_value();
  plan.rate = request.rate.value_or(fraction ? rate_for(*fraction, plan.plausible) : kRate);
  warn(plan, sizes);
  return plan;
}

PackingPlan with_count(const PackingPlan& plan, std::size_t count) {
  PackingPlan changed = plan;
  changed.radii = draw_radii(plan.distribution, count, plan.seed, plan.container.dimensions);
  multiply(changed.radii, plan.diameter / 2);
  return changed;
}

}  // namespace hardball
