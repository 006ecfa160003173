// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/parse_number.hpp"
#include "apps/cli/status_line.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/written.hpp"
#include "apps/sweep/tables.hpp"
#include "apps/sweep/workers.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {
namespace {

using Json = nlohmann::ordered_json;
using sweep::Member;
using sweep::State;
using sweep::Study;
using sweep::Task;

std::size_t read_count(const std::string& text, const char* option) {
  constexpr const char* kRemedy = "give a positive number";
  const auto number = parse_number<std::size_t>(text, option, kRemedy);
  if (number == 0) throw Error("'0' is not accepted", option, kRemedy);
  return number;
}

// A part of several; the whole is the first of one.
struct Part {
  std::size_t number = 1;
  std::size_t parts = 1;
};

Part read_part(const SweepOptions& options) {
  if (!options.member && !options.of) return {};
  if (!options.member || !options.of)
    throw Error("--member and --of go together", "command line", "give both, as in --member 1 --of 8");
  const Part part{read_count(*options.member, "--member"), read_count(*options.of, "--of")};
  if (part.number > part.parts) {
    throw Error("the part is " + to_text(part.number) + " of " + to_text(part.parts), "--member",
                "give a number from 1 to " + to_text(part.parts));
  }
  return part;
}

void refuse_several_modes(const SweepOptions& options) {
  if (int{options.table} + int{options.prepare} + int{options.dry_run} > 1) {
    throw Error("--table, --prepare and --dry-run exclude each other", "command line", "give one of them");
  }
  if (options.table && options.member)
    throw Error("--table is for all members", "command line", "leave out --member and --of");
}

std::string seconds_of(double seconds) {
  return fmt::format("{:.3g} s", seconds);
}

Json json_of(const Task& task) {
  Json values = Json::object();
  for (const sweep::Setting& each : task.member->values) values[each.key] = Json::parse(each.value);
  return {{"name", task.member->name()},
          {"values", values},
          {"replica", task.member->replica},
          {"seed", task.member->seed},
          {"status", name_of(sweep::state_of(*task.member))},
          {"seconds", task.seconds},
          {"memory_bytes", task.bytes}};
}

void list_tasks(const std::vector<Task>& tasks, std::size_t members, const OutputStyle& output) {
  double seconds = 0;
  for (const Task& task : tasks) seconds += task.seconds;
  if (output.json) {
    Json json{{"members", members}, {"seconds", seconds}, {"to_run", Json::array()}};
    for (const Task& task : tasks) json["to_run"].push_back(json_of(task));
    write_output(json.dump(2) + "\n");
    return;
  }
  std::string text;
  for (const Task& task : tasks)
    text +=
        fmt::format("{}  {:>8}  {}\n", task.member->name(), seconds_of(task.seconds), describe(*task.member));
  write_output(text + fmt::format("{} of {} members to run, about {} on one core\n", tasks.size(), members,
                                  seconds_of(seconds)));
}

// How many of the members are in each state.
struct Counts {
  std::size_t members = 0;
  std::size_t finished = 0;
  std::size_t failed = 0;

  bool are_all_finished() const { return finished == members; }
};

Counts counts_of(const std::vector<const Member*>& members) {
  Counts counts{.members = members.size()};
  for (const Member* member : members) {
    const State state = sweep::state_of(*member);
    counts.finished += state == State::finished ? 1U : 0U;
    counts.failed += state == State::failed ? 1U : 0U;
  }
  return counts;
}

// Says what there is now, and what was done for it.
void print(const Study& study, const Counts& counts, const sweep::Tally& tally, bool has_tables,
           const OutputStyle& output) {
  if (output.json) {
    write_output(Json{{"directory", study.directory.string()},
                      {"members", counts.members},
                      {"finished", counts.finished},
                      {"failed", counts.failed},
                      {"seconds", tally.seconds},
                      {"busy", tally.busy}}
                     .dump(2) +
                 "\n");
    return;
  }
  std::string text =
      table_line("members", to_text(counts.members)) + table_line("finished", to_text(counts.finished));
  if (counts.failed > 0) text += table_line("failed", to_text(counts.failed));
  if (tally.finished + tally.failed + tally.interrupted > 0) {
    text += table_line("time", seconds_of(tally.seconds));
    text += table_line("cores busy", fmt::format("{:.1f}%", 100 * tally.busy));
  }
  for (const char* name : {sweep::kRuns, sweep::kPoints, sweep::kTiming, sweep::kStudyReport}) {
    if (has_tables) text += written_line(study.directory / name);
  }
  write_output(text);
}

sweep::Tally run_all(const Study& study, const std::vector<Task>& tasks, std::size_t workers, bool is_quiet) {
  StatusLine line(!is_quiet);
  const auto on_end = [](const Member& member, const sweep::Outcome& outcome) {
    if (outcome.ending == sweep::Ending::failed)
      write_message("member " + member.name() + " has failed: " + outcome.message);
  };
  return sweep::run(study, tasks, workers, on_end, [&](const sweep::Progress& progress) {
    if (line.is_due())
      line.show(progress.share, fmt::format("{} of {} members", progress.ended, tasks.size()));
  });
}

}  // namespace

ExitCode sweep(const SweepOptions& options) {
  catch_signals();
  refuse_several_modes(options);
  const Part part = read_part(options);
  const std::size_t wanted = options.workers ? read_count(*options.workers, "--workers") : 0;
  Study study = sweep::read_study({.path = options.study, .directory = options.out});
  const std::vector<const Member*> members = part_of(study, part.number, part.parts);
  const bool has_tables = !options.member;
  if (options.table) {
    begin(study);
    write_tables(study, read_results(study));
    print(study, counts_of(members), {}, has_tables, options.output);
    return ExitCode::done;
  }
  if (options.retry && !options.dry_run) {
    for (const Member* member : members) forget_failure(*member);
  }
  const std::vector<Task> tasks = check(study, sweep::unfinished(members));
  if (options.dry_run) {
    list_tasks(tasks, members.size(), options.output);
    return ExitCode::done;
  }
  begin(study);
  if (options.prepare) {
    for (const Member* member : members) prepare(*member);
    print(study, counts_of(members), {}, false, options.output);
    return ExitCode::done;
  }
  const std::size_t workers = wanted > 0 ? wanted : sweep::usual_workers(tasks);
  const sweep::Tally tally = run_all(study, tasks, workers, options.output.quiet);
  if (has_tables) write_tables(study, read_results(study));
  const Counts counts = counts_of(members);
  print(study, counts, tally, has_tables, options.output);
  if (is_interrupted()) write_message("interrupted; the same command resumes it");
  return counts.are_all_finished() ? ExitCode::done : ExitCode::failed;
}

}  // namespace hardball::cli
