// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "apps/sweep/study.hpp"
#include "hardball/describe/names.hpp"

namespace hardball {

namespace sweep {

/// What the directory of a member says of it: nothing else is known of a sweep.
enum class State {
  fresh,        ///< Not begun.
  interrupted,  ///< There is a checkpoint, from which it is resumed.
  finished,     ///< There is the summary of a whole run, or there are results of a function.
  failed,       ///< There is failed.txt, with the message.
};

/// What a function in Python has found of a member.
inline constexpr const char* kResults = "results.json";
/// Why a member has failed.
inline constexpr const char* kFailed = "failed.txt";

State state_of(const Member& member);

/// Makes the directory of a member, and values.json in it: its values, replica and seed, as other programs
/// want them. Error: the directory cannot be written to.
void prepare(const Member& member);

/// Has a member that has failed be run again.
void forget_failure(const Member& member);

/// Keeps other sweeps from a member while it exists; none if another one has it. Makes its directory. Error:
/// that cannot be written to.
std::optional<cli::DirectoryLock> lock_of(const Member& member);

/// How a run of a member ended.
enum class Ending {
  finished,
  failed,
  interrupted,  ///< By a signal, or by request; it has a checkpoint.
  busy,         ///< Not begun: another process runs it.
};

/// An ending, and the message of a failure.
struct Outcome {
  Ending ending = Ending::finished;
  std::string message = {};
};

/// Starts or resumes the run of a member, in this thread; does nothing if it has finished or failed before.
/// Members may run in several threads and processes at once. Error: its directory cannot be written to.
Outcome run_member(const Study& study, const Member& member);

}  // namespace sweep

/// As in tables.
template <>
inline constexpr std::array<std::string_view, 4> kNames<sweep::State>{"new", "interrupted", "finished",
                                                                      "failed"};

/// As in Python.
template <>
inline constexpr std::array<std::string_view, 4> kNames<sweep::Ending>{"finished", "failed", "interrupted",
                                                                       "busy"};

}  // namespace hardball
