// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "bench/experiment.hpp"
#include "bench/power_law.hpp"

namespace hardball::bench {

/// A fit over a range of numbers of spheres.
struct Exponent {
  std::string method;    ///< As Row::method.
  std::string quantity;  ///< seconds_per_unit_time, seconds_per_event or events_per_unit_time
  std::string box;       ///< fixed, or growing at fixed density
  std::size_t from = 0;  ///< Least and largest number of spheres among the points.
  std::size_t to = 0;
  PowerLaw law = {};
};

/// Power laws in the number of spheres n, of every method. In the paper's box for two ranges: up to 10^4,
/// where most events of the cell grid concern cells, and from 2 * 10^4 to 2 * 10^5, where most are
/// collisions. At fixed density for all n. Omitted where there are fewer than two points.
std::vector<Exponent> fit_exponents(const Results& results);

/// Tables as CSV, preceded by each line of `header` as a comment.
std::string figure_csv(const Results& results, const std::vector<std::string>& header);
std::string steps_csv(const Results& results, const std::vector<std::string>& header);
std::string exponents_csv(const std::vector<Exponent>& exponents, const std::vector<std::string>& header);

/// The exponents as a table for people.
std::string exponents_table(const std::vector<Exponent>& exponents);

/// The figure as SVG.
std::string figure_svg(const Results& results);

}  // namespace hardball::bench
