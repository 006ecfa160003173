// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/placement/radii.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
namespace {

using Kind = RadiusDistribution::Kind;

double draw_lognormal(const RadiusDistribution& d, Random& random) {
  constexpr int kMaxDraws = 100000;
  for (int i = 0; i < kMaxDraws; ++i) {
    const double radius = d.mean * portable_exp(d.sigma * random.normal() - d.sigma * d.sigma / 2);
    if (radius >= d.min && radius <= d.max) return radius;
  }
  throw Error("of " + to_text(kMaxDraws) + " radii none is between min and max", d.where,
              "give min and max on either side of the mean");
}

// By inversion of the cumulative distribution: with a = exponent + 1, r^a is uniform.
double draw_powerlaw(const RadiusDistribution& d, Random& random) {
  const double u = random.uniform();
  const double a = d.exponent + 1;
  const double span = portable_log(d.max / d.min);
  // So near to a uniform logarithm that no sample shows the difference.
  constexpr double kFlat = 1e-8;
  double radius = 0;
  if (std::fabs(a * span) < kFlat) {
    radius = d.min * portable_exp(u * span);
  } else if (a < 0) {
    radius = d.min * portable_exp(portable_log(1 - u * (1 - portable_exp(a * span))) / a);
  } else {
    // The same, with no power that overflows.
    const double least = portable_exp(-a * span);
    const double share = least + u * (1 - least);
    radius = share < kSmallestMagnitude ? d.min : d.max * portable_exp(portable_log(share) / a);
  }
  return std::clamp(radius, d.min, d.max);
}

std::vector<double> draw_each(const RadiusDistribution& d, std::size_t count, Random& random) {
  std::vector<double> radii(count);
  for (double& radius : radii) {
    if (d.kind == Kind::lognormal) {
      radius = draw_lognormal(d, random);
    } else if (d.kind == Kind::powerlaw) {
      radius = draw_powerlaw(d, random);
    } else {
      radius = std::clamp(d.min + random.uniform() * (d.max - d.min), d.min, d.max);
    }
  }
  return radii;
}

// How many spheres each weight stands for: by the largest remainder, of equal ones the first.
std::vector<std::size_t> share_out(std::size_t count, const std::vector<double>& weights) {
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<std::size_t> shares;
  std::vector<double> remainders;
  std::size_t given = 0;
  for (const double weight : weights) {
    const double share = static_cast<double>(count) * (weight / all);
    const auto whole = std::min(static_cast<std::size_t>(share), count - given);
    shares.push_back(whole);
    remainders.push_back(share - std::floor(share));
    given += whole;
  }
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
  for (std::size_t i = 0; given < count; ++i, ++given) ++shares[order[i % order.size()]];
  return shares;
}

std::vector<double> draw_discrete(const RadiusDistribution& d, std::size_t count, Random& random) {
  const std::vector<std::size_t> shares = share_out(count, d.weights);
  std::vector<double> radii;
  radii.reserve(count);
  for (std::size_t i = 0; i < shares.size(); ++i) radii.insert(radii.end(), shares[i], d.values[i]);
  for (std::size_t left = count; left > 1; --left) {
    const auto chosen = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
    std::swap(radii[chosen], radii[left - 1]);
  }
  return radii;
}

std::vector<double> read_as_many(const RadiusDistribution& d, std::size_t count) {
  std::vector<double> radii = read_radii(d.file, d.where, count);
  if (radii.size() != count) {
    throw Error(
        "the file holds " +
            std::string(radii.size() > count ? "more than " + to_text(count) : to_text(radii.size())) +
            " radii",
        d.file.string(), "give one for each of the " + to_text(count) + " spheres");
  }
  return radii;
}

}  // namespace

std::vector<double> draw_radii(const RadiusDistribution& distribution, std::size_t count, Random& random) {
  if (distribution.kind == Kind::discrete) return draw_discrete(distribution, count, random);
  if (distribution.kind == Kind::file) return read_as_many(distribution, count);
  return draw_each(distribution, count, random);
}

std::vector<double> read_radii(const std::filesystem::path& file, const std::string& where,
                               std::size_t most) {
  std::ifstream in(file);
  if (!in || !std::filesystem::is_regular_file(file)) {
    throw Error("the file " + file.string() + " cannot be read", where, "name a text file of radii");
  }
  std::vector<double> radii;
  for (std::string line; radii.size() <= most && std::getline(in, line);) {
    const std::string place = file.string() + ":" + to_text(radii.size() + 1);
    if (line.ends_with('\r')) line.pop_back();
    double radius = 0;
    const auto [end, status] = std::from_chars(line.data(), line.data() + line.size(), radius);
    if (status != std::errc() || end != line.data() + line.size()) {
      throw Error("the line is not a number", place, "give one radius on each line, and nothing else");
    }
    check_positive(radius, "radius", place);
    radii.push_back(radius);
  }
  return radii;
}

}  // namespace hardball
