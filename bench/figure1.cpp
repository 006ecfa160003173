// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The program figure1: measures figure 1 of the 1997 paper, and simulation by time steps for comparison.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiment.hpp"
#include "bench/report.hpp"

namespace hardball::bench {
namespace {

struct Options {
  std::filesystem::path folder;
  bool quick = false;
  std::string commit = "unknown";
  std::string date = "unknown";
};

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool has_value = i + 1 < arguments.size();
    if (arguments[i] == "--quick") {
      options.quick = true;
    } else if (arguments[i] == "--commit" && has_value) {
      options.commit = arguments[++i];
    } else if (arguments[i] == "--date" && has_value) {
      options.date = arguments[++i];
    } else if (options.folder.empty() && !arguments[i].starts_with('-')) {
      options.folder = arguments[i];
    } else {
      throw std::runtime_error("usage: figure1 FOLDER [--quick] [--commit COMMIT] [--date DATE]");
    }
  }
  if (options.folder.empty()) throw std::runtime_error("name the folder for the results");
  return options;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::vector<std::string> where_measured(const Options& options) {
  return {fmt::format("processor: {}, one thread", processor()),
          fmt::format("compiler: {}, flags: {}", HARDBALL_COMPILER, HARDBALL_FLAGS),
          "commit: " + options.commit, "date: " + options.date,
          options.quick ? "a quick trial, not a measurement" : "./dev figure1"};
}

std::vector<std::string> joined(std::vector<std::string> lines, const std::vector<std::string>& more) {
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

void run(const Options& options) {
  std::filesystem::create_directories(options.folder);
  const Results results = measure(options.quick ? quick_plan() : full_plan());
  const std::vector<Exponent> exponents = fit_exponents(results);
  const std::vector<std::string> header = where_measured(options);
  const std::vector<std::string> figure_notes = {
      fmt::format("start: up to {} spheres random places and {} collisions per sphere, else a lattice and {}",
                  kMaxPlacedAtRandom, kCollisionsToSettle, kCollisionsToMelt),
      "all methods start from the same state; set-up is excluded",
      "seconds_per_unit_time: median of the repetitions; span: simulated in each of them",
      "events: collisions + walls + enters + leaves; with cells, leaves are not events but cells released",
      "time_stepped: the cost of a step was measured with the shortest and scaled",
      "missed_share: see time_stepped.csv"};
  const std::vector<std::string> steps_notes = {
      "missed: collisions of the exact engine with no check while the two would overlap in straight motion",
      "collisions: of all numbers of spheres below freezing; expected_share: by kinetic theory",
      "resolved: by the time-stepped simulation, which needs a check while they overlap and still approach"};
  const std::vector<std::string> exponents_notes = {
      "y = factor * spheres^exponent by least squares of the logarithms", "time_stepped: of any step"};
  write(options.folder / "figure1.csv", figure_csv(results, joined(header, figure_notes)));
  write(options.folder / "time_stepped.csv", steps_csv(results, joined(header, steps_notes)));
  write(options.folder / "figure1_exponents.csv", exponents_csv(exponents, joined(header, exponents_notes)));
  write(options.folder / "figure1.svg", figure_svg(results));
  fmt::print("{}", exponents_table(exponents));
}

}  // namespace
}  // namespace hardball::bench

int main(int argument_count, char** arguments) {
  try {
    hardball::bench::run(hardball::bench::parse({arguments + 1, arguments + argument_count}));
  } catch (const std::exception& error) {
    std::fputs("figure1: ", stderr);
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
    return 1;
  }
  return 0;
}
