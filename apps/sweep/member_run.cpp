// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/sweep/member_run.hpp"

#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/output_paths.hpp"
#include "apps/cli/run_files.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"

namespace hardball::sweep {
namespace {

// By which one process keeps others from the same member.
constexpr const char* kMemberLock = "member.lock";
constexpr const char* kValues = "values.json";

// Whether a summary is that of a run which reached its end: interrupted ones write summaries, too.
bool is_of_whole_run(const std::filesystem::path& summary, double until) {
  if (!std::filesystem::exists(summary)) return false;
  const auto json = nlohmann::json::parse(read_file(summary), nullptr, false);
  return json.is_object() && (json.value("time", -1.0) >= until || json.contains("errors_reached_at"));
}

std::string values_json(const Member& member) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const Setting& each : member.values) json[each.key] = nlohmann::ordered_json::parse(each.value);
  json["replica"] = member.replica;
  json["seed"] = member.seed;
  return json.dump(2) + "\n";
}

Outcome failed(const Member& member, const std::string& message) {
  replace_file(member.directory / kFailed, message + "\n");
  return {Ending::failed, message};
}

}  // namespace

State state_of(const Member& member) {
  const auto has = [&](const char* name) { return std::filesystem::exists(member.directory / name); };
  if (has(kResults) || is_of_whole_run(member.directory / cli::kSummary, member.until))
    return State::finished;
  if (has(kFailed)) return State::failed;
  return has(cli::kCheckpoint) ? State::interrupted : State::fresh;
}

void prepare(const Member& member) {
  cli::make_directory(member.directory);
  const std::filesystem::path path = member.directory / kValues;
  if (!std::filesystem::exists(path)) replace_file(path, values_json(member));
}

void forget_failure(const Member& member) {
  std::filesystem::remove(member.directory / kFailed);
}

std::optional<cli::DirectoryLock> lock_of(const Member& member) {
  cli::make_directory(member.directory);
  return cli::DirectoryLock::if_free(member.directory, kMemberLock);
}

Outcome run_member(const Study& study, const Member& member) {
  const auto lock = lock_of(member);
  if (!lock) return {Ending::busy};
  const State state = state_of(member);
  if (state == State::finished) return {Ending::finished};
  if (state == State::failed) return {Ending::failed, read_file(member.directory / kFailed)};
  try {
    prepare(member);
    const cli::ExitCode code = cli::run_in_process(study.run_of(member));
    return {code == cli::ExitCode::done ? Ending::finished : Ending::interrupted};
  } catch (const std::bad_alloc&) {
    return failed(member, "there is not enough memory");
  } catch (const std::exception& error) {
    if (cli::is_interrupted()) return {Ending::interrupted};
    return failed(member, error.what());
  }
}

}  // namespace hardball::sweep
