// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/placement/radii.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/standard/number_text.hpp"
#include "hardball/standard/ranges.hpp"

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

// By inversion of the cumulative distribution at a share u of it: with a = exponent + 1, r^a is uniform.
double powerlaw_quantile(const RadiusDistribution& d, double u) {
  const double a = d.exponent + 1;
  const double span = portable_log(d.max / d.min);
  // Close enough to a uniform logarithm that no sample shows the difference.
  constexpr double kFlat = 1e-8;
  double radius = 0;
  if (std::fabs(a * span) < kFlat) {
    radius = d.min * portable_exp(u * span);
  } else if (a < 0) {
    const double left = 1 - u * (1 - portable_exp(a * span));
    radius = left < kSmallestMagnitude ? d.max : d.min * portable_exp(portable_log(left) / a);
  } else {
    // The formula above, arranged so that no power overflows.
    const double least = portable_exp(-a * span);
    const double share = least + u * (1 - least);
    radius = share < kSmallestMagnitude ? d.min : d.max * portable_exp(portable_log(share) / a);
  }
  return std::clamp(radius, d.min, d.max);
}

double uniform_quantile(const RadiusDistribution& d, double u) {
  return std::clamp(d.min + u * (d.max - d.min), d.min, d.max);
}

// (exp(b span) - 1) / b, the integral of exp(b x) up to `span`.
double integral_of_exponential(double b, double span) {
  constexpr double kFlat = 1e-8;
  if (std::fabs(b * span) < kFlat) return span;
  return (portable_exp(b * span) - 1) / b;
}

double mean_of_powerlaw(const RadiusDistribution& d) {
  const double a = d.exponent + 1;
  const double span = portable_log(d.max / d.min);
  if (span == 0) return d.min;
  // From the end at which no power overflows.
  if (a < -0.5) return d.min * integral_of_exponential(a + 1, span) / integral_of_exponential(a, span);
  return d.max * integral_of_exponential(-a - 1, span) / integral_of_exponential(-a, span);
}

double mean_of(const std::vector<double>& radii) {
  ExactSum sum;
  for (const double radius : radii) sum += radius;
  return sum.value() / static_cast<double>(radii.size());
}

void shuffle(std::vector<double>& radii, Random& random) {
  for (std::size_t left = radii.size(); left > 1; --left) {
    const auto chosen = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
    std::swap(radii[chosen], radii[left - 1]);
  }
}

// One radius from each of `count` equal shares of a distribution. Between the least and the most of each they
// are where their mean is that wanted.
std::vector<double> spread(const Function<double(double)>& quantile, double mean, std::size_t count) {
  const auto at = [&](double offset) {
    std::vector<double> radii(count);
    for (std::size_t i = 0; i < count; ++i)
      radii[i] = quantile((static_cast<double>(i) + offset) / static_cast<double>(count));
    return radii;
  };
  std::vector<double> radii = at(0.5);
  const double missing = mean - mean_of(radii);
  const std::vector<double> ends = at(missing > 0 ? 1 : 0);
  const double room = mean_of(ends) - mean_of(radii);
  const double share = room == 0 ? 0 : std::clamp(missing / room, 0.0, 1.0);
  for (std::size_t i = 0; i < count; ++i) radii[i] += share * (ends[i] - radii[i]);
  return radii;
}

std::vector<double> draw_each(const RadiusDistribution& d, std::size_t count, Random& random) {
  std::vector<double> radii(count);
  for (double& radius : radii) {
    if (d.kind == Kind::lognormal) {
      radius = draw_lognormal(d, random);
    } else if (d.kind == Kind::powerlaw) {
      radius = powerlaw_quantile(d, random.uniform());
    } else {
      radius = uniform_quantile(d, random.uniform());
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
  ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
  for (std::size_t i = 0; given < count; ++i, ++given) ++shares[order[i % order.size()]];
  return shares;
}

std::vector<double> draw_discrete(const RadiusDistribution& d, std::size_t count, Random& random) {
  const std::vector<std::size_t> shares = share_out(count, d.weights);
  std::vector<double> radii;
  radii.reserve(count);
  for (std::size_t i = 0; i < shares.size(); ++i) radii.insert(radii.end(), shares[i], d.values[i]);
  shuffle(radii, random);
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

std::vector<double> spread_radii(const RadiusDistribution& distribution, std::size_t count, Random& random) {
  const RadiusDistribution& d = distribution;
  const bool is_uniform = d.kind == Kind::uniform;
  if (!is_uniform && d.kind != Kind::powerlaw) return draw_radii(d, count, random);
  const double mean = is_uniform ? d.min + (d.max - d.min) / 2 : mean_of_powerlaw(d);
  std::vector<double> radii = spread(
      [&](double u) { return is_uniform ? uniform_quantile(d, u) : powerlaw_quantile(d, u); }, mean, count);
  shuffle(radii, random);
  return radii;
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
    const auto [end, status] = from_chars(line.data(), line.data() + line.size(), radius);
    if (status != std::errc() || end != line.data() + line.size()) {
      throw Error("the line is not a number", place, "give one radius on each line, and nothing else");
    }
    check_positive(radius, "radius", place);
    radii.push_back(radius);
  }
  return radii;
}

}  // namespace hardball
