// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/cli/directory_lock.hpp"
#include "apps/cli/options.hpp"
#include "hardball/scenario/keys.hpp"

/// Sweeps: one scenario run with many values, several times each, in ordinary directories of runs.
namespace hardball::sweep {

/// A value that a member of a sweep gives to a key of the scenario.
struct Setting {
  std::string key;    ///< As for --set.
  std::string value;  ///< In JSON, which is also TOML; a whole number without a point.

  friend bool operator==(const Setting&, const Setting&) = default;
};

/// A run of a sweep.
struct Member {
  std::size_t number = 0;                ///< From 1, in the order in which members came into the directory.
  std::filesystem::path directory = {};  ///< Such as STUDY/0001.
  std::size_t point = 0;                 ///< The index of its combination of values.
  std::vector<Setting> values = {};
  std::size_t replica = 1;  ///< From 1.
  std::uint64_t seed = 0;   ///< Below 2^48.
  double until = 0;         ///< When its run ends [T]; NaN if its scenario does not say so, or is refused.

  /// The name of its directory.
  std::string name() const { return directory.filename().string(); }
};

/// Where a study comes from.
struct StudyChoice {
  std::string path;                           ///< The file; only its name where there is a text.
  std::optional<std::string> text = {};       ///< The study itself.
  std::optional<std::string> scenario = {};   ///< The text of its scenario, instead of a file.
  std::optional<std::string> directory = {};  ///< Otherwise the path without its extension.
};

/// A scenario and the values with which it is run.
struct Study {
  std::string name;
  std::filesystem::path directory;
  cli::ScenarioChoice scenario;
  std::uint64_t seed = 1;
  std::size_t replicas = 1;
  std::vector<std::string> quantities;  ///< Those that tables list; all if there are none.
  std::vector<std::string> keys;        ///< Those that get values, in the order of the file.
  std::set<std::string> logarithmic;    ///< Those whose values are evenly spaced in their logarithm.
  std::vector<Member> members;          ///< In the order of points, with the replicas of one together.

  /// How hardball run runs a member.
  cli::RunOptions run_of(const Member& member) const;
};

/// The keys of a study, the one source of what the reader accepts and of docs/sweeps.md.
const TableDescription& study_keys();

/// The keys of a range of values, which stands in place of their list.
const TableDescription& range_keys();

/// Reads a study, and numbers its members as its directory says, if there is one. The seed of a member is a
/// hash of the seed of the study, its values and its replica, so that adding values changes no other. Error:
/// the file is no study; values are given twice; the directory belongs to a study that has another seed,
/// another scenario, or members that this one lacks.
Study read_study(const StudyChoice& choice);

/// Makes the directory of a study, and writes its members.json, by which read_study knows it. Several
/// processes may do so at once. Error: as for read_study; the directory cannot be written to.
void begin(Study& study);

/// Keeps other processes from writing the files of a study itself, and waits until no other does so. Error:
/// its directory cannot be written to.
cli::DirectoryLock lock_of(const Study& study);

/// The members of one of several parts of a study, which get them in turn. `number`: from 1 to `parts`.
std::vector<const Member*> part_of(const Study& study, std::size_t number, std::size_t parts);

/// "spheres.0.radius = 0.4, replica 2", for messages.
std::string describe(const Member& member);

}  // namespace hardball::sweep
