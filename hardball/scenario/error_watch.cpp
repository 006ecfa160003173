// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/error_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/nearest_name.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

ErrorWatch::ErrorWatch(const Scenario& scenario) : wanted_(scenario.run.until_error), where_(scenario.name) {
  if (wanted_.empty()) return;
  constexpr double kGrowth = 1.2;
  constexpr double kFirst = 1e-3;
  const double begin = scenario.measures.from;
  const double span = *scenario.run.until - begin;
  for (double part = 1; part > kFirst && span > 0; part /= kGrowth) looks_.push_back(begin + part * span);
  ranges::reverse(looks_);
}

double ErrorWatch::next_look(double now) const {
  const auto next = ranges::upper_bound(looks_, now);
  return next == looks_.end() || reached_ ? std::numeric_limits<double>::infinity() : *next;
}

bool ErrorWatch::is_time_to_look(double now) const {
  return !reached_ && ranges::binary_search(looks_, now);
}

void ErrorWatch::look(double now, std::span<const Measurement> measurements) {
  if (failures(measurements).empty()) reached_ = now;
}

std::vector<std::string> ErrorWatch::failures(std::span<const Measurement> measurements) const {
  std::vector<std::string_view> names;
  for (const Measurement& measurement : measurements)
    for (const Quantity& quantity : measurement.quantities) names.push_back(quantity.name);
  std::vector<std::string> failures;
  for (const auto& [name, most] : wanted_) {
    if (ranges::find(names, name) == names.end()) {
      throw Error("run.until_error names \"" + name + "\", which is not measured", where_,
                  names.empty() ? "measure something" : suggestion(name, names, '"'));
    }
    for (const Measurement& measurement : measurements) {
      for (const Quantity& quantity : measurement.quantities) {
        if (quantity.name != name || quantity.error < most) continue;
        const std::string error =
            std::isnan(quantity.error) ? "is not known" : "is " + to_text(quantity.error);
        failures.push_back("the error of " + measurement.name + "." + name + " " + error +
                           ", not below the " + to_text(most) + " of run.until_error");
      }
    }
  }
  return failures;
}

}  // namespace hardball
