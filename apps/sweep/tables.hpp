// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/chart/chart.hpp"
#include "apps/sweep/member_run.hpp"
#include "apps/sweep/study.hpp"

namespace hardball::sweep {

/// A number with its standard error, which is NaN where it is not known.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// What is known of one member.
struct Row {
  const Member* member = nullptr;
  State state = State::fresh;
  std::string hash = {};  ///< The event log hash; empty of results of a function.
  std::optional<std::uint64_t> collisions = {};
  double setup_seconds = 0;  ///< Wall time; NaN of results of a function.
  double run_seconds = 0;
  std::map<std::string, Estimate> quantities = {};
};

/// A quantity at a point, from the replicas that have finished and have it.
struct PointEstimate {
  std::size_t runs = 0;
  double mean = 0;  ///< NaN if there are no such replicas.
  double between =
      0;  ///< The standard error of the mean by the scatter of the replicas; NaN of fewer than two.
  double within = 0;  ///< The standard error by those of the replicas; NaN if one has none.
  double ratio() const { return between / within; }
};

/// What is known of all replicas of one combination of values.
struct Point {
  std::vector<Setting> values;
  std::size_t runs = 0;                   ///< Those that have finished.
  std::vector<PointEstimate> quantities;  ///< In the order of Results::quantities.
};

/// What a study has found so far.
struct Results {
  std::vector<std::string> quantities;
  std::vector<Row> rows;      ///< In the order of Study::members.
  std::vector<Point> points;  ///< In the order of their members.
};

/// The sum of the estimates of independent replicas.
PointEstimate combined(const std::vector<Estimate>& replicas);

/// Reads the results of all members that have finished. Error: a quantity that the study lists is in none of
/// them; a file is damaged.
Results read_results(const Study& study);

/// Each quantity as a function of the first key that has several numbers as values, with a line for each
/// combination of the others; none where no key has.
std::vector<chart::Chart> charts_of(const Study& study, const Results& results);

/// The files of tables, which write_tables writes.
inline constexpr const char* kRuns = "runs.csv";
inline constexpr const char* kPoints = "points.csv";
inline constexpr const char* kTiming = "timing.csv";
inline constexpr const char* kStudyReport = "report.html";

/// Writes runs.csv, points.csv, timing.csv and report.html into the directory of the study. All but
/// timing.csv are the same, byte for byte, however the members were run. Error (RunFailure): they cannot be
/// written.
void write_tables(const Study& study, const Results& results);

}  // namespace hardball::sweep
