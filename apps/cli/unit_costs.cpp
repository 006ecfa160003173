// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/unit_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <sstream>
#include <string_view>

#include "apps/cli/parse_number.hpp"
#include "hardball/error.hpp"
#include "hardball/simulation.hpp"

namespace hardball::cli {
namespace {

constexpr const char* kOption = "--unit-costs";

struct NamedCost {
  std::string_view name;
  double UnitCosts::*cost;
};
constexpr std::array<NamedCost, 4> kCosts{{{"contact", &UnitCosts::contact},
                                           {"enter", &UnitCosts::enter},
                                           {"cell", &UnitCosts::cell},
                                           {"prediction", &UnitCosts::prediction}}};

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string remedy() {
  return "give auto, measured, standard, or all of them, such as " + to_option(UnitCosts{});
}

[[noreturn]] void refuse(const std::string& problem) {
  throw Error(problem, kOption, remedy());
}

}  // namespace

UnitCosts read_unit_costs(const std::string& text) {
  if (text == "standard") return UnitCosts{};
  if (text == "measured") return measure_unit_costs(clock_seconds);
  UnitCosts costs;
  std::array<bool, kCosts.size()> given{};
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');) {
    const std::size_t equals = std::min(item.find('='), item.size());
    const auto named = std::find_if(kCosts.begin(), kCosts.end(), [&](const NamedCost& each) {
      return each.name == item.substr(0, equals);
    });
    if (named == kCosts.end() || equals == item.size())
      refuse("'" + shortened(item) + "' is not a unit cost");
    const double cost = parse_number<double>(item.substr(equals + 1), kOption, remedy());
    if (!(cost >= 0) || !std::isfinite(cost)) refuse("'" + shortened(item) + "' is negative or infinite");
    costs.*named->cost = cost;
    given[static_cast<std::size_t>(named - kCosts.begin())] = true;
  }
  if (std::find(given.begin(), given.end(), false) != given.end())
    refuse("'" + shortened(text) + "' are not all unit costs");
  if (costs.enter + costs.cell <= 0 || costs.prediction <= 0)
    refuse("if crossings or predictions cost nothing, there is no best cell edge");
  return costs;
}

std::string to_option(const UnitCosts& costs) {
  std::string text;
  for (const NamedCost& each : kCosts)
    text += fmt::format("{}{}={:.4g}", text.empty() ? "" : ",", each.name, costs.*each.cost);
  return text;
}

}  // namespace hardball::cli
