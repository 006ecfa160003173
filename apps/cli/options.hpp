// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hardball/packing/request_text.hpp"

namespace hardball::cli {

/// The command line as written; not every command has every option.
struct Options {
  std::string scenario;                ///< Or the output directory of a run.
  std::string in;                      ///< A file with frames.
  std::vector<std::string> files;      ///< Of runs, with snapshots, scenarios; or directories.
  std::vector<std::string> overrides;  ///< Of the form key=value.
  std::optional<std::string> until;
  std::optional<std::string> seed;
  std::string engine = "auto";
  std::string cell_edge = "auto";
  std::string unit_costs = "auto";
  std::string queue = "calendar";
  std::string instructions = "auto";
  std::string threads = "auto";
  std::optional<std::string> budget;  ///< Seconds.
  std::optional<std::string> out;
  std::optional<std::string> checkpoint;  ///< Relative to the output directory.
  std::optional<std::string> frame;
  std::optional<std::string> port;
  std::optional<std::string> recording_limit;
  std::string shell;
  PackingText packing;                ///< What is to be packed.
  std::vector<std::string> outs;      ///< Files for a packing.
  std::optional<std::string> report;  ///< A file for the report of a packing.
  std::optional<std::string> replay;  ///< A file that shows a packing in the viewer.
  std::optional<std::string> limit;   ///< Seconds.
  bool dry_run = false;
  bool polish = false;
  bool json = false;
  bool quiet = false;
  bool no_open = false;
  bool overwrite = false;

  /// What decides how a run continues.
  static void persist(auto& archive, auto& self) {
    archive(self.scenario, self.overrides, self.until, self.seed);
  }
};

}  // namespace hardball::cli
