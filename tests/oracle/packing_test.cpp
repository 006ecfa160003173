// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Random requests: every packing ends, and its files hold numbers that do not overlap, at the density wanted.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "support/effort.hpp"
#include "support/packing.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::packing_test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_quad;

class RandomRequest {
 public:
  explicit RandomRequest(std::uint64_t seed) : random_(seed) { request_.seed = seed; }

  PackingRequest draw() {
    request_.dimensions = pick(4) == 0 ? 2 : 3;
    const double most = pick(10) == 0 ? 150 : 30;
    request_.count = 2 + static_cast<std::size_t>(std::exp(random_.uniform() * std::log(most)) - 1);
    draw_sizes();
    draw_container();
    if (pick(4) == 0 && !request_.is_container_size_free) {
      request_.count.reset();
      request_.diameter =
          (0.2 + 0.2 * random_.uniform()) * root(request_.container->volume(), request_.dimensions);
    }
    const std::size_t goal = pick(6);
    request_.goal = 0.66 * random_.uniform();
    if (goal == 0) request_.goal = PackingRequest::Densest{};
    if (goal == 1) request_.goal = PackingRequest::Pressure{std::exp(1 + 10 * random_.uniform())};
    if (goal == 2) request_.rate = 0.03 + random_.uniform();
    if (pick(9) == 0) request_.gap = 0.01 * random_.uniform();
    return request_;
  }

 private:
  std::size_t pick(std::size_t choices) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(choices));
  }
  void draw_sizes() {
    using Kind = RadiusDistribution::Kind;
    RadiusDistribution sizes;
    const std::size_t kind = pick(5);
    if (kind > 2) return;
    if (kind == 0) sizes = {.kind = Kind::uniform, .min = 0.5, .max = 1.5};
    if (kind == 1) {
      sizes = {
          .kind = Kind::lognormal, .min = 1e-60, .max = 1e60, .mean = 1, .sigma = 0.6 * random_.uniform()};
    }
    if (kind == 2) {
      sizes.kind = Kind::discrete;
      sizes.values = {1, 1 + 9 * random_.uniform()};
      sizes.weights = {1, random_.uniform()};
    }
    request_.distribution = sizes;
  }
  void draw_container() {
    Container container{.dimensions = request_.dimensions};
    const auto edge = [this] { return 1 + 3 * random_.uniform(); };
    container.size = {edge(), edge(), request_.dimensions == 3 ? edge() : 0};
    const std::size_t shape = pick(8);
    if (shape == 0) {
      container.shape = Container::Shape::sphere;
    } else if (shape == 6) {
      container.shape = Container::Shape::shell;
    } else if (shape == 7 && request_.dimensions == 3) {
      container.shape = Container::Shape::truncated_cone;
    } else if (shape == 8 && request_.dimensions == 3) {
      container.shape = Container::Shape::annulus;
    } else if (shape < 3 && request_.dimensions == 3) {
      container.shape = shape == 1 ? Container::Shape::cylinder : Container::Shape::cone;
    } else if (shape < 5) {
      for (std::size_t axis = 0; axis < request_.dimensions; ++axis) container.has_walls[axis] = pick(2) == 0;
    }
    if (container.shape != Container::Shape::box) container.size.y = container.size.x;
    const bool is_round =
        container.shape == Container::Shape::sphere || container.shape == Container::Shape::shell;
    if (is_round && request_.dimensions == 3) container.size.z = container.size.x;
    if (container.shape >= Container::Shape::truncated_cone)
      container.inner = (0.1 + 0.6 * random_.uniform()) * container.size.x;
    request_.container = container;
    request_.is_container_size_free = pick(2) == 0;
  }

  Random random_;
  PackingRequest request_;
};

Exact square(const Exact& x) {
  return x * x;
}

// The deepest overlap in a file's numbers, from all pairs and images, and all walls. `single`: of a GSD file,
// whose readers see positions from the center, diameters and edges in 32 bits.
double overlap_in(const Snapshot& snapshot, const Container& container, bool single) {
  const std::size_t size = snapshot.spheres.size();
  const std::size_t dimensions = container.dimensions;
  const auto stored = [&](double number) {
    return single ? Exact(static_cast<float>(number)) : Exact(number);
  };
  std::vector<std::array<Exact, 3>> centers(size);
  std::vector<Exact> radii(size);
  std::array<Exact, 3> edges;
  for (std::size_t axis = 0; axis < 3; ++axis) edges[axis] = stored(snapshot.box->size[axis]);
  for (std::size_t i = 0; i < size; ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    radii[i] = stored(2 * sphere.radius) / 2;
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
      const double center = snapshot.box->low[axis] + snapshot.box->size[axis] / 2;
      centers[i][axis] = single ? edges[axis] / 2 + Exact(static_cast<float>(sphere.position[axis] - center))
                                : Exact(sphere.position[axis]);
    }
  }
  Exact deepest = 0;
  const auto note = [&](const Exact& distance, const Exact& reach) {
    const Exact overlap = 1 - distance / reach;
    if (overlap > deepest) deepest = overlap;
  };
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i; j < size; ++j) {
      std::array<int, 3> most{};
      for (std::size_t axis = 0; axis < dimensions; ++axis) most[axis] = container.is_periodic(axis) ? 1 : 0;
      for (int x = -most[0]; x <= most[0]; ++x) {
        for (int y = -most[1]; y <= most[1]; ++y) {
          for (int z = -most[2]; z <= most[2]; ++z) {
            if (i == j && x == 0 && y == 0 && z == 0) continue;
            const std::array<int, 3> boxes{x, y, z};
            Exact sum = 0;
            for (std::size_t axis = 0; axis < dimensions; ++axis)
              sum += square(centers[j][axis] + boxes[axis] * edges[axis] - centers[i][axis]);
            note(sqrt(sum), radii[i] + radii[j]);
          }
        }
      }
    }
    using enum Container::Shape;
    const std::array<Exact, 3>& at = centers[i];
    Exact from_axis = square(at[0] - edges[0] / 2) + square(at[1] - edges[1] / 2);
    const bool is_round = container.shape == sphere || container.shape == shell;
    if (is_round && dimensions == 3) from_axis += square(at[2] - edges[2] / 2);
    from_axis = sqrt(from_axis);
    const Exact radius = edges[0] / 2;
    if (container.shape == shell || container.shape == annulus)
      note(from_axis - Exact(container.inner) / 2, radii[i]);
    if (container.shape == truncated_cone) {
      const Exact narrow = Exact(container.inner) / 2;
      note((at[2] * (radius - narrow) + edges[2] * (narrow - from_axis)) /
               sqrt(square(radius - narrow) + square(edges[2])),
           radii[i]);
    }
    if (is_round || container.shape == cylinder || container.shape == annulus)
      note(radius - from_axis, radii[i]);
    if (container.shape == cone)
      note((at[2] * radius - edges[2] * from_axis) / sqrt(square(radius) + square(edges[2])), radii[i]);
    const Box ends = container.box();
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
      if (!ends.is_wall(axis)) continue;
      note(at[axis], radii[i]);
      note(edges[axis] - at[axis], radii[i]);
    }
  }
  return static_cast<double>(deepest);
}

constexpr std::uint64_t kRequests = 300;
constexpr std::uint64_t kParts = 6;

class Requests : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Requests, EndInFilesWithoutOverlapAtTheDensityWanted) {
  const support::ScratchFolder folder;
  std::uint64_t packed = 0;
  for (std::uint64_t seed = GetParam(); seed < support::cases(kRequests); seed += kParts) {
    const PackingRequest request = RandomRequest(seed).draw();
    std::optional<Packer> packer;
    try {
      packer.emplace(plan(request));
    } catch (const Error&) {
      continue;  // in one clear sentence
    }
    while (!packer->is_over()) packer->advance();
    const bool single = seed % 2 == 0;
    Packing packing = packing_of(*packer);
    finish(packing, packer->plan(), single ? Precision::singles : Precision::doubles);
    const std::filesystem::path file = folder / (single ? "packing.gsd" : "packing.xyz");
    {
      Trajectory trajectory(file);
      trajectory.append(snapshot_of(packing.spheres));
      trajectory.close();
    }
    const Snapshot written = read_snapshot(file);
    EXPECT_EQ(overlap_in(written, packing.spheres.container, single), 0) << "seed " << seed;
    EXPECT_EQ(packing.largest_overlap, 0);
    if (const double* goal = std::get_if<double>(&packer->plan().goal);
        goal && packer->state() == Packer::State::reached) {
      const double least = *goal * power(1 - request.gap, request.dimensions);
      EXPECT_NEAR(packing.packing_fraction(), least, single ? 3e-6 : 1e-11) << "seed " << seed;
    }
    if (request.diameter && packing.status != Packing::Status::not_reached) {
      EXPECT_NEAR(packing.spheres.mean_diameter(), *request.diameter, 1e-6) << "seed " << seed;
    }
    ++packed;
  }
  EXPECT_GT(packed, support::cases(kRequests) / kParts / 2);
}

INSTANTIATE_TEST_SUITE_P(Parts, Requests, testing::Range<std::uint64_t>(0, kParts));

}  // namespace
}  // namespace hardball::packing_test
