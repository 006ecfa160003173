// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The program hardball: finds every collision among moving spheres.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/completion.hpp"
#include "apps/cli/manual.hpp"
#include "apps/cli/options.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/version.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/scenario/nearest_name.hpp"
#include "hardball/scenario/schema.hpp"
#if HARDBALL_MPI
#include "apps/mpi/mpi_processes.hpp"
#include "hardball/distributed/in_all.hpp"
#endif

namespace hardball::cli {
namespace {

CLI::App* add_command(CLI::App& app, Options& options, const std::string& name,
                      const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("SCENARIO", options.scenario, "Scenario file (TOML)")->required();
  command->add_option("--until", options.until, "End time, instead of the scenario's")->type_name("TIME");
  command->add_option("--set", options.overrides, "Replaces or adds a value, as in run.until=5")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--seed", options.seed, "Seed of the random numbers, instead of the scenario's")
      ->type_name("N");
  // Remaining arguments are reported by our own messages.
  command->allow_extras();
  return command;
}

// Types such as auto|paper|LENGTH list the words that shells complete.
void add_unit_costs_option(CLI::App& command, Options& options) {
  command
      .add_option("--unit-costs", options.unit_costs,
                  "Unit costs for choosing the cells: a name, or all four costs")
      ->type_name("auto|measured|standard|COSTS");
}

void add_threads_option(CLI::App& command, Options& options) {
  command
      .add_option("--threads", options.threads,
                  "Threads that share the work, as many as pay by default; affects only the speed")
      ->type_name("auto|NUMBER");
}

void add_engine_options(CLI::App& command, Options& options) {
  command.add_option("--engine", options.engine, "Engine; affects only the speed")
      ->type_name("auto|cells|neighbors|all-pairs|paper");
  command.add_option("--cell-edge", options.cell_edge, "Edge of the cells; affects only the speed")
      ->type_name("auto|paper|LENGTH");
  add_unit_costs_option(command, options);
  command.add_option("--queue", options.queue, "Event queue; affects only the speed")
      ->type_name("calendar|ordered");
  command.add_option("--instructions", options.instructions, "Vector instructions; affects only the speed")
      ->type_name("auto|portable|avx2|avx512");
  add_threads_option(command, options);
}

void add_quiet_flag(CLI::App& command, Options& options) {
  command
      .add_flag("--quiet", options.quiet,
                "Print only the result and errors: no progress, no notes, no warnings")
      ->disable_flag_override();
}

void add_output_flags(CLI::App& command, Options& options) {
  command.add_flag("--json", options.json, "Print one JSON object instead of a table")
      ->disable_flag_override();
  add_quiet_flag(command, options);
}

void add_overwrite_flag(CLI::App& command, Options& options, const std::string& description) {
  command.add_flag("--overwrite", options.overwrite, description)->disable_flag_override();
}

CLI::App* add_pack_command(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand(
      "pack", "Pack spheres: give three of count, diameter, box or container, and density");
  PackingText& packing = options.packing;
  command->add_option("--count", packing.count, "Number of spheres")->type_name("N");
  command->add_option("--diameter", packing.diameter, "Mean diameter, 1 if nothing else has a length")
      ->type_name("LENGTH");
  command
      ->add_option("--sizes", packing.sizes,
                   "Distribution of sizes: lognormal:SIGMA, uniform:MIN,MAX, powerlaw:EXPONENT,MIN,MAX, "
                   "discrete:SIZE=SHARE,SIZE=SHARE, or file:FILE with radii")
      ->type_name("SIZES");
  command->add_option("--box", packing.box, "Edges, as in 10,10,20; or proportions, as in 1:1:2")
      ->type_name("EDGES");
  command->add_option("--walls", packing.walls, "Axes of the box with walls instead of periods, as in z")
      ->type_name("AXES");
  command
      ->add_option("--container", packing.container,
                   "Instead of a box: cylinder:DIAMETER,HEIGHT, sphere:DIAMETER, cone:DIAMETER,HEIGHT or "
                   "slab:X,Y,HEIGHT; with colons between proportions")
      ->type_name("CONTAINER");
  command->add_option("--phi", packing.phi, "Packing fraction, or max for as dense as spheres jam")
      ->type_name("max|FRACTION");
  command
      ->add_option("--pressure", packing.pressure,
                   "Instead of --phi, PV/NkT of the median sphere, to a tenth")
      ->type_name("Z");
  command
      ->add_option("--rate", packing.rate,
                   "Growth of the mean diameter over the thermal speed; chosen by the density if not given")
      ->type_name("RATE");
  command
      ->add_option("--gap", packing.gap,
                   "Fraction by which diameters are reduced in the end, to those wanted")
      ->type_name("FRACTION");
  command->add_option("--dimensions", packing.dimensions, "2 for discs")->type_name("2|3");
  command
      ->add_option("--start", packing.start,
                   "File with spheres that grow where they are, and keep ids, types and masses")
      ->type_name("FILE");
  command->add_option("--seed", packing.seed, "Seed of the random numbers, 1 if not given")->type_name("N");
  command->add_option("--out", options.outs, "File for the spheres; its extension selects the format")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command->add_option("--report", options.report, "File for a page about the packing (HTML)")
      ->type_name("FILE");
#if HARDBALL_VIEWER
  command->add_option("--replay", options.replay, "File for a page that shows spheres and forces (HTML)")
      ->type_name("FILE");
#endif
  command->add_option("--limit", options.limit, "Time after which packing is interrupted")
      ->type_name("SECONDS");
  command
      ->add_option("--resume", options.checkpoint,
                   "Checkpoint of an interrupted packing, instead of all that says what is packed")
      ->type_name("FILE");
  command->add_flag("--polish", options.polish, "Remove the last gaps between spheres that have jammed")
      ->disable_flag_override();
  command->add_flag("--dry-run", options.dry_run, "Only check, and predict collisions and time")
      ->disable_flag_override();
  add_threads_option(*command, options);
  add_output_flags(*command, options);
  add_overwrite_flag(*command, options, "Replace existing files");
  command->allow_extras();
  return command;
}

#if HARDBALL_VIEWER
CLI::App* add_showing_command(CLI::App& app, Options& options, const std::string& name,
                              const std::string& description) {
  CLI::App* command = add_command(app, options, name, description);
  command->get_option("SCENARIO")->description("Scenario file (TOML), or the directory of a recorded run");
  add_threads_option(*command, options);
  add_quiet_flag(*command, options);
  return command;
}
#endif

// Error: something on the command line was not understood. `command` may be missing.
void refuse_leftovers(const CLI::App& app, const CLI::App* command) {
  const std::vector<std::string> leftovers = app.remaining(true);
  if (leftovers.empty()) return;
  const std::string word = leftovers.front().substr(0, leftovers.front().find('='));
  std::vector<std::string> names;
  if (command && !word.starts_with('-')) {
    throw Error("unexpected argument '" + shortened(word) + "'", "command line",
                "see hardball " + command->get_name() + " --help");
  }
  if (command) {
    for (const CLI::Option* option : command->get_options()) {
      if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
    }
  } else {
    for (const CLI::App* each : app.get_subcommands(nullptr)) names.push_back(each->get_name());
  }
  const bool is_known = std::find(names.begin(), names.end(), word) != names.end();
  throw Error(std::string("unknown ") + (command ? "option" : "command") + " '" + shortened(word) + "'",
              "command line",
              is_known ? "write it after the command"
                       : suggestion(word, std::vector<std::string_view>(names.begin(), names.end())));
}

#if !HARDBALL_MPI
// Error: mpirun has started several copies of a program that does not know of each other. Slurm's variables
// are no such sign: a job has them, too, where it runs one program after the other.
void refuse_copies() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* const size = std::getenv(name);
    if (!size || std::atoi(size) <= 1) continue;
    throw Error(
        "mpirun has started " + std::string(size) +
            " copies of a program that is built without MPI, each of which would run all of the system",
        name, "use the program that ./dev mpi builds, build/mpi/hardball, or unset " + std::string(name));
  }
}
#endif

// `processes`: if there are several.
ExitCode parse_and_run(int argument_count, char** arguments, Processes* processes) {
  Options options;
  CLI::App app("Finds every collision among moving spheres, exactly and in order.", "hardball");
  app.set_version_flag("--version", version_text);
  app.require_subcommand(0, 1);
  app.allow_extras();
  CLI::App* run_command = add_command(app, options, "run", "Run a scenario");
  add_engine_options(*run_command, options);
  run_command->add_option("--out", options.out, "Directory for the files of the run")->type_name("DIRECTORY");
  add_output_flags(*run_command, options);
  add_overwrite_flag(*run_command, options, "Replace the files of an earlier run in the directory");
  CLI::App* resume_command = app.add_subcommand("resume", "Resume a run from its last checkpoint");
  resume_command->add_option("DIRECTORY", options.scenario, "Output directory of the run")->required();
  resume_command->add_option("--until", options.until, "End time, instead of the previous one")
      ->type_name("TIME");
  resume_command
      ->add_option("--from", options.checkpoint, "Checkpoint in the directory, instead of the last one")
      ->type_name("FILE");
  add_threads_option(*resume_command, options);
  add_output_flags(*resume_command, options);
  resume_command->allow_extras();
  CLI::App* verify_command =
      add_command(app, options, "verify", "Run a scenario with every engine and compare bit by bit");
  add_quiet_flag(*verify_command, options);
  CLI::App* check_command = add_command(app, options, "check", "Validate a scenario and predict its cost");
  add_engine_options(*check_command, options);
  add_quiet_flag(*check_command, options);
  // Ends the program, like --help, so that no scenario is needed.
  check_command
      ->add_flag_callback(
          "--schema",
          [] {
            write_output(scenario_schema());
            throw CLI::Success();
          },
          "Print a JSON Schema of scenarios, for editors")
      ->disable_flag_override();
  CLI::App* tune_command =
      add_command(app, options, "tune", "Compare cell sizes: predicted and measured cost");
  add_unit_costs_option(*tune_command, options);
  tune_command->add_option("--budget", options.budget, "Time limit in seconds, 10 if not given")
      ->type_name("SECONDS");
  tune_command->add_option("--out", options.out, "Directory for the table and its figure")
      ->type_name("DIRECTORY");
  add_quiet_flag(*tune_command, options);
  CLI::App* pack_command = add_pack_command(app, options);
  CLI::App* convert_command = app.add_subcommand("convert", "Convert the frames of a file to another format");
  convert_command->add_option("IN", options.in, "Input file; its extension selects the format")
      ->required()
      ->type_name("FILE");
  convert_command->add_option("OUT", options.out, "Output file; its extension selects the format")
      ->required()
      ->type_name("FILE");
  convert_command->add_option("--frame", options.frame, "Write only this frame, counted from 0")
      ->type_name("NUMBER");
  add_quiet_flag(*convert_command, options);
  add_overwrite_flag(*convert_command, options, "Replace an existing file");
  convert_command->allow_extras();
  CLI::App* info_command = app.add_subcommand("info", "Describe files");
  info_command
      ->add_option("FILE", options.files,
                   "Files of runs, files with frames, scenarios, or directories of runs")
      ->required()
      ->type_name("FILE");
  info_command->allow_extras();
#if HARDBALL_VIEWER
  CLI::App* view_command =
      add_showing_command(app, options, "view", "Show a run in the browser, live or recorded");
  view_command->add_option("--port", options.port, "Port of the server, any free one if not given")
      ->type_name("PORT");
  view_command->add_flag("--no-open", options.no_open, "Only print the address, do not open a browser")
      ->disable_flag_override();
  view_command
      ->add_option("--recording-limit", options.recording_limit,
                   "Size of the recording at which a live run stops, 4e9 bytes if not given")
      ->type_name("BYTES");
  CLI::App* replay_command =
      add_showing_command(app, options, "replay", "Write a run as a single HTML file for offline viewing");
  replay_command->add_option("--out", options.out, "The HTML file")->type_name("FILE");
  add_overwrite_flag(*replay_command, options, "Replace an existing file");
#endif
  CLI::App* manual_command = app.add_subcommand("manual", "Print the manual page, for man -l -");
  manual_command->allow_extras();
  CLI::App* completion_command = app.add_subcommand("completion", "Print a completion script for a shell");
  completion_command->add_option("SHELL", options.shell, "The shell")->required()->type_name("bash|zsh|fish");
  completion_command->allow_extras();
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    // Requests for help are "errors" with exit status 0.
    if (error.get_exit_code() == 0) return app.exit(error) == 0 ? ExitCode::done : ExitCode::failed;
    throw Error(error.what(), "command line", "see hardball --help");
  }
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  refuse_leftovers(app, chosen.empty() ? nullptr : chosen.front());
  if (processes) {
    if (*run_command) return run_distributed(options, *processes);
    if (*resume_command) return resume_distributed(options, *processes);
    throw Error("several processes have only the commands run and resume", "command line",
                "start it without mpirun");
  }
#if !HARDBALL_MPI
  if (*run_command || *resume_command) refuse_copies();
#endif
  if (*resume_command) return resume(options);
  if (*verify_command) return verify(options);
  if (*check_command) return check(options);
  if (*tune_command) return tune(options);
  if (*pack_command) return pack(options);
  if (*convert_command) return convert(options);
  if (*info_command) return info(options);
#if HARDBALL_VIEWER
  if (*view_command) return view(options);
  if (*replay_command) return replay(options);
#endif
  if (*manual_command) return print_manual(app);
  if (*completion_command) return print_completion(options, app);
  if (*run_command) return run(options);
  write_output(app.help());
  return ExitCode::done;
}

// How the program ends: its exit code and, if it has failed, the message.
struct End {
  ExitCode code = ExitCode::done;
  std::string message = {};
};

End run_program(int argument_count, char** arguments, Processes* processes) {
  try {
    return {parse_and_run(argument_count, arguments, processes)};
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

ExitCode run_alone(int argument_count, char** arguments) {
  const End end = run_program(argument_count, arguments, nullptr);
  if (!end.message.empty()) write_message(end.message);
  return end.code;
}

#if HARDBALL_MPI
ExitCode run_in_processes(int argument_count, char** arguments) {
  MpiProcesses processes;
  if (processes.size() == 1) return run_alone(argument_count, arguments);
  std::string line;
  for (int i = 1; i < argument_count; ++i) line += std::string(arguments[i]) + '\0';
  End end;
  try {
    require_same(processes, line, "command line");
    end = run_program(argument_count, arguments, &processes);
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
#endif

}  // namespace
}  // namespace hardball::cli

int main(int argument_count, char** arguments) {
  using namespace hardball;
  cli::secure_streams();
#if HARDBALL_MPI
  if (MpiProcesses::may_be_several()) {
    try {
      return static_cast<int>(cli::run_in_processes(argument_count, arguments));
    } catch (const std::exception& error) {
      cli::write_message(error.what());
      return static_cast<int>(cli::ExitCode::failed);
    }
  }
#endif
  return static_cast<int>(cli::run_alone(argument_count, arguments));
}
