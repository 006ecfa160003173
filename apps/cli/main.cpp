// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The program hardball: finds every collision among moving spheres.
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/command_line.hpp"
#include "apps/cli/commands.hpp"
#include "apps/cli/completion.hpp"
#include "apps/cli/manual.hpp"
#include "apps/cli/options.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/version.hpp"
#include "apps/mpi/mpi_processes.hpp"
#include "hardball/error.hpp"
#include "hardball/platform/program.hpp"
#include "hardball/processes.hpp"

namespace hardball::cli {
namespace {

// What mpirun has made of this process.
struct Launch {
  Processes& processes = one_process();
  std::optional<Error> refusal = {};  // if there are several that do not find each other
};

ExitCode parse_and_run(int argument_count, char** arguments, const Launch& launch) {
  Processes& processes = launch.processes;
  CommandLine line("hardball", "Finds every collision among moving spheres, exactly and in order.",
                   version_text);
  line.add<RunOptions>("run", "Run a scenario",
                       [&](const RunOptions& options) { return run(options, processes); });
  line.add<ResumeOptions>("resume", "Resume a run from its last checkpoint",
                          [&](const ResumeOptions& options) { return resume(options, processes); });
  line.add<VerifyOptions>("verify", "Run a scenario with every engine and compare bit by bit", verify);
  line.add<CheckOptions>("check", "Validate a scenario and predict its cost", check);
  line.add<TuneOptions>("tune", "Compare cell sizes: predicted and measured cost", tune);
  line.add<PackOptions>("pack", "Pack spheres: give three of count, diameter, box or container, and density",
                        pack);
  line.add<ConvertOptions>("convert", "Convert the frames of a file to another format", convert);
  line.add<InfoOptions>("info", "Describe files", info);
  line.add<ViewOptions>("view", "Show a run in the browser, live or recorded", view);
  line.add<ReplayOptions>("replay", "Write a run as a single HTML file for offline viewing", replay);
  line.add<FilmOptions>("film", "Write a run as a film, every frame at its exact time", film);
  line.add<SweepOptions>("sweep", "Run a scenario with many values, and tabulate what comes out", sweep);
  line.add("manual", "Print the manual page, for man -l -", [&] { return print_manual(line.describe()); });
  line.add<CompletionOptions>(
      "completion", "Print a completion script for a shell",
      [&](const CompletionOptions& options) { return print_completion(options.shell, line.describe()); });
  const std::optional<std::string> command = line.parse(argument_count, arguments);
  if (!command) return ExitCode::done;
  const bool is_run = *command == "run" || *command == "resume";
  if (launch.refusal && is_run) throw Error(*launch.refusal);
  if (processes.size() > 1 && !is_run) {
    throw Error("several processes have only the commands run and resume", "command line",
                "start it without mpirun");
  }
  return line.execute(*command);
}

// How the program ends: its exit code and, if it has failed, the message.
struct End {
  ExitCode code = ExitCode::done;
  std::string message = {};
};

End run_program(int argument_count, char** arguments, const Launch& launch) {
  try {
    return {parse_and_run(argument_count, arguments, launch)};
  } catch (const Error& error) {
    return {ExitCode::bad_input, error.what()};
  } catch (const RunFailure& failure) {
    return {ExitCode::failed, failure.what()};
  } catch (const std::bad_alloc&) {
    return {ExitCode::failed, "there is not enough memory"};
  } catch (const std::exception& error) {
    return {ExitCode::failed, error.what()};
  }
}

ExitCode run_alone(int argument_count, char** arguments, const std::optional<Error>& refusal) {
  const End end = run_program(argument_count, arguments, {.refusal = refusal});
  if (!end.message.empty()) write_message(end.message);
  return end.code;
}

ExitCode run_in_processes(int argument_count, char** arguments, MpiProcesses& processes) {
  std::string line;
  for (int i = 1; i < argument_count; ++i) line += std::string(arguments[i]) + '\0';
  End end;
  try {
    require_same(processes, line, "command line");
    end = run_program(argument_count, arguments, {.processes = processes});
  } catch (const Error& error) {
    end = {ExitCode::bad_input, error.what()};
  }
  // Where one process fails alone, the others would wait for it forever.
  const bool is_alike = end.message.empty() || processes.do_all_end();
  if (is_alike && processes.is_first() && !end.message.empty()) write_message(end.message);
  if (is_alike) return end.code;
  write_message("process " + to_text(processes.rank()) + ": " + end.message);
  processes.abort(static_cast<int>(end.code));
}

// Where the plug-in for MPI may be: beside the program in a build folder, among the libraries where it is
// installed.
std::vector<std::filesystem::path> plugin_folders() {
  const std::filesystem::path program = platform::program_file();
  if (program.empty()) return {};
  return {program.parent_path(), program.parent_path() / HARDBALL_PLUGIN_FOLDER};
}

ExitCode run_as_launched(int argument_count, char** arguments) {
  std::unique_ptr<MpiProcesses> processes;
  std::optional<Error> refusal;
  try {
    processes = MpiProcesses::join_others(plugin_folders(), "./dev mpi");
  } catch (const Error& error) {
    refusal = error;
  }
  return processes ? run_in_processes(argument_count, arguments, *processes)
                   : run_alone(argument_count, arguments, refusal);
}

}  // namespace
}  // namespace hardball::cli

int main(int argument_count, char** arguments) {
  using namespace hardball;
  platform::secure_streams();
  try {
    arguments = platform::unicode_arguments(argument_count, arguments);
    return static_cast<int>(cli::run_as_launched(argument_count, arguments));
  } catch (const std::exception& error) {
    cli::write_message(error.what());
    return static_cast<int>(cli::ExitCode::failed);
  }
}
