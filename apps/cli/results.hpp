// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/cli/edge_sweep.hpp"
#include "apps/cli/options.hpp"
#include "hardball/memory/function.hpp"

/// What commands find, for those that print it and for the Python package. Errors are those of the commands.
namespace hardball::cli {

/// A row of a table; that of a heading has no text.
struct TableRow {
  std::string name;
  std::string text = {};
  std::string key = {};   ///< The place in the object of --json, as a JSON Pointer; empty if there is none.
  std::string json = {};  ///< The value at that place, as JSON.
};

/// What `check` says of a scenario, row by row.
std::vector<TableRow> check_rows(const CheckOptions& options);

/// What `verify` says of one way to run a scenario.
struct VerifiedWay {
  std::string name;
  std::string skipped = {};  ///< Why it was left out; empty if it was not.
  std::uint64_t hash = 0;
  std::uint64_t collisions = 0;
  double max_overlap = 0;  ///< In diameters [1].
  bool is_same = true;     ///< Whether hash and final state are those of the first way, bit by bit.
  bool is_sound = true;    ///< Whether nothing overlaps, and all numbers are finite.
  double seconds = 0;      ///< Wall time.
};

/// Runs a scenario in all ways, and hands each to `take` as soon as it is done; returns whether all are the
/// same, and sound.
bool verify_ways(const VerifyOptions& options, const Function<void(const VerifiedWay&)>& take);

/// What `tune` finds.
struct Tuning {
  EdgeSweep sweep;
  std::string text;  ///< What the command prints.
};

/// Compares cells of many sizes, and writes the files of `options.out`.
Tuning tune_cells(const TuneOptions& options);

/// Converts a file, and returns how many frames were written.
std::size_t convert_frames(const ConvertOptions& options);

/// What `info` says of a file, or of the directory of a run, in lines.
std::string describe_file(const std::filesystem::path& path);

}  // namespace hardball::cli
