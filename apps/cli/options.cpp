// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/options.hpp"

#include "apps/cli/command_line.hpp"
#include "hardball/scenario.hpp"

namespace hardball::cli {
namespace {

void add_unit_costs(Arguments arguments, std::string& unit_costs) {
  arguments.add("--unit-costs", unit_costs, "auto|measured|standard|COSTS",
                "Unit costs for choosing the cells: a name, or all four costs");
}

void add_threads(Arguments arguments, std::string& threads) {
  arguments.add("--threads", threads, "auto|NUMBER",
                "Threads that share the work, as many as pay by default; affects only the speed");
}

void add_quiet(Arguments arguments, bool& quiet) {
  arguments.add_flag("--quiet", quiet,
                     "Print only the result and errors: no progress, no notes, no warnings");
}

void declare(Arguments arguments, ScenarioChoice& scenario,
             const char* description = "Scenario file (TOML)") {
  arguments.add("SCENARIO", scenario.path, "TEXT", description);
  arguments.add("--until", scenario.until, "TIME", "End time, instead of the scenario's");
  arguments.add("--set", scenario.overrides, "KEY=VALUE", "Replaces or adds a value, as in run.until=5");
  arguments.add("--seed", scenario.seed, "N", "Seed of the random numbers, instead of the scenario's");
}

void declare(Arguments arguments, EngineChoice& engine) {
  arguments.add("--engine", engine.engine, "auto|cells|neighbors|all-pairs|paper",
                "Engine; affects only the speed");
  arguments.add("--cell-edge", engine.cell_edge, "auto|paper|LENGTH",
                "Edge of the cells; affects only the speed");
  add_unit_costs(arguments, engine.unit_costs);
  arguments.add("--instructions", engine.instructions, "auto|portable|avx2|avx512",
                "Vector instructions; affects only the speed");
  add_threads(arguments, engine.threads);
}

void declare(Arguments arguments, OutputStyle& output) {
  arguments.add_flag("--json", output.json, "Print one JSON object instead of a table");
  add_quiet(arguments, output.quiet);
}

void declare(Arguments arguments, ShownRunChoice& run) {
  declare(arguments, run.scenario, "Scenario file (TOML), or the directory of a recorded run");
  add_threads(arguments, run.threads);
  add_quiet(arguments, run.quiet);
}

void declare(Arguments arguments, PackingText& packing) {
  arguments.add("--count", packing.count, "N", "Number of spheres");
  arguments.add("--diameter", packing.diameter, "LENGTH", "Mean diameter, 1 if nothing else has a length");
  arguments.add("--sizes", packing.sizes, "SIZES",
                "Distribution of sizes: lognormal:SIGMA, uniform:MIN,MAX, powerlaw:EXPONENT,MIN,MAX, "
                "discrete:SIZE=SHARE,SIZE=SHARE, or file:FILE with radii");
  arguments.add("--box", packing.box, "EDGES", "Edges, as in 10,10,20; or proportions, as in 1:1:2");
  arguments.add("--walls", packing.walls, "AXES", "Axes of the box with walls instead of periods, as in z");
  arguments.add(
      "--container", packing.container, "CONTAINER",
      "Instead of a box: cylinder:DIAMETER,HEIGHT, sphere:DIAMETER, shell:INNER,OUTER, "
      "annulus:INNER,OUTER,HEIGHT, "
      "cone:DIAMETER,HEIGHT, truncated_cone:BOTTOM,TOP,HEIGHT or slab:X,Y,HEIGHT, with colons between "
      "proportions; or mesh:FILE, a closed mesh, or mesh:FILE,SCALE");
  arguments.add("--phi", packing.phi, "max|FRACTION", "Packing fraction, or max for as dense as spheres jam");
  arguments.add("--pressure", packing.pressure, "Z",
                "Instead of --phi, PV/NkT of the median sphere, to a tenth");
  arguments.add("--rate", packing.rate, "RATE",
                "Growth of the mean diameter over the thermal speed; chosen by the density if not given");
  arguments.add("--gap", packing.gap, "FRACTION",
                "Fraction by which diameters are reduced in the end, to those wanted");
  arguments.add("--dimensions", packing.dimensions, "2|3", "2 for discs");
  arguments.add("--start", packing.start, "FILE",
                "File with spheres that grow where they are, and keep ids, types and masses");
  arguments.add("--seed", packing.seed, "N", "Seed of the random numbers, 1 if not given");
}

}  // namespace

void declare(Arguments arguments, RunOptions& options) {
  declare(arguments, options.scenario);
  declare(arguments, options.engine);
  arguments.add("--out", options.out, "DIRECTORY", "Directory for the files of the run");
  declare(arguments, options.output);
  arguments.add_flag("--overwrite", options.overwrite,
                     "Replace the files of an earlier run in the directory");
  arguments.add_flag("--resume", options.resume,
                     "Resume the run from its checkpoint in the directory; start it if there is none");
}

void declare(Arguments arguments, ResumeOptions& options) {
  arguments.add("DIRECTORY", options.directory, "TEXT", "Output directory of the run");
  arguments.add("--until", options.until, "TIME", "End time, instead of the previous one");
  arguments.add("--from", options.checkpoint, "FILE", "Checkpoint in the directory, instead of the last one");
  add_threads(arguments, options.threads);
  declare(arguments, options.output);
}

void declare(Arguments arguments, VerifyOptions& options) {
  declare(arguments, options.scenario);
  add_quiet(arguments, options.quiet);
}

void declare(Arguments arguments, CheckOptions& options) {
  declare(arguments, options.scenario);
  declare(arguments, options.engine);
  declare(arguments, options.output);
  arguments.add_answer("--schema", scenario_schema, "Print a JSON Schema of scenarios, for editors");
}

void declare(Arguments arguments, TuneOptions& options) {
  declare(arguments, options.scenario);
  add_unit_costs(arguments, options.unit_costs);
  arguments.add("--budget", options.budget, "SECONDS", "Time limit in seconds, 10 if not given");
  arguments.add("--out", options.out, "DIRECTORY", "Directory for the table and its figure");
  add_quiet(arguments, options.quiet);
}

void declare(Arguments arguments, PackOptions& options) {
  declare(arguments, options.packing);
  arguments.add("--out", options.outs, "FILE", "File for the spheres; its extension selects the format");
  arguments.add("--report", options.report, "FILE", "File for a page about the packing (HTML)");
  arguments.add("--replay", options.replay, "FILE", "File for a page that shows spheres and forces (HTML)");
  arguments.add("--limit", options.limit, "SECONDS", "Time after which packing is interrupted");
  arguments.add("--resume", options.checkpoint, "FILE",
                "Checkpoint of an interrupted packing, instead of all that says what is packed");
  arguments.add_flag("--polish", options.polish, "Remove the last gaps between spheres that have jammed");
  arguments.add_flag("--dry-run", options.dry_run, "Only check, and predict collisions and time");
  add_threads(arguments, options.threads);
  declare(arguments, options.output);
  arguments.add_flag("--overwrite", options.overwrite, "Replace existing files");
}

void declare(Arguments arguments, ConvertOptions& options) {
  arguments.add("IN", options.in, "FILE", "Input file; its extension selects the format");
  arguments.add("OUT", options.out, "FILE", "Output file; its extension selects the format");
  arguments.add("--frame", options.frame, "NUMBER", "Write only this frame, counted from 0");
  add_quiet(arguments, options.quiet);
  arguments.add_flag("--overwrite", options.overwrite, "Replace an existing file");
}

void declare(Arguments arguments, InfoOptions& options) {
  arguments.add("FILE", options.files, "FILE",
                "Files of runs, files with frames, scenarios, or directories of runs");
}

void declare(Arguments arguments, ViewOptions& options) {
  declare(arguments, options.run);
  arguments.add("--port", options.port, "PORT", "Port of the server, any free one if not given");
  arguments.add_flag("--no-open", options.no_open, "Only print the address, do not open a browser");
  arguments.add("--recording-limit", options.recording_limit, "BYTES",
                "Size of the recording at which a live run stops, 4e9 bytes if not given");
}

void declare(Arguments arguments, ReplayOptions& options) {
  declare(arguments, options.run);
  arguments.add("--out", options.out, "FILE", "The HTML file");
  arguments.add("--most", options.most, "SIZE",
                "Most that the file may have, as in 5MB; what does not fit is left out");
  arguments.add("--thin", options.thin, "motion|end",
                "What is left out then: the motion between moments, or the end of the run");
  arguments.add_flag("--overwrite", options.overwrite, "Replace an existing file");
}

void declare(Arguments arguments, FilmOptions& options) {
  arguments.add("OUT", options.out, "TEXT", "The film: a file .webm or .mp4");
  declare(arguments, options.run);
  arguments.add("--from", options.from, "TIME", "Time of the first frame, the start of the run if not given");
  arguments.add("--to", options.to, "TIME", "Time of the last frame, the end of the run if not given");
  arguments.add("--speed", options.speed, "TIME",
                "Simulated time in a second of the film, as in the viewer if not given");
  arguments.add("--fps", options.fps, "NUMBER", "Frames in a second, 30 if not given");
  arguments.add("--size", options.size, "WIDTHxHEIGHT", "Pixels, 1280x720 if not given");
  arguments.add("--spin", options.spin, "DEGREES", "Turn the camera by this angle during the film");
  arguments.add("--view", options.view, "LINK",
                "What the viewer is to show: a link copied from it, or what is after its #");
  arguments.add("--quality", options.quality, "full|points",
                "Shaded spheres, or points, which are drawn faster");
  arguments.add("--frames", options.frames, "DIRECTORY", "Write each frame as a picture (PNG), too");
  arguments.add_flag("--overwrite", options.overwrite, "Replace an existing file");
}

void declare(Arguments arguments, SweepOptions& options) {
  arguments.add("STUDY", options.study, "TEXT", "Study file (TOML)");
  arguments.add("--out", options.out, "DIRECTORY",
                "Directory of the members and tables, instead of the study without .toml");
  arguments.add(
      "--workers", options.workers, "NUMBER",
      "How many members run at once, each in one thread; somewhat more than there are cores if not given");
  arguments.add("--member", options.member, "NUMBER",
                "Run only this part of the members, from 1, and write no tables; for arrays of jobs");
  arguments.add("--of", options.of, "NUMBER", "How many parts there are");
  arguments.add_flag("--retry", options.retry, "Run members again that have failed");
  arguments.add_flag("--table", options.table, "Only write the tables of what has finished");
  arguments.add_flag("--prepare", options.prepare,
                     "Only make the directories of members, each with values.json");
  arguments.add_flag("--dry-run", options.dry_run, "Only check, and list what would run, the longest first");
  declare(arguments, options.output);
}

void declare(Arguments arguments, CompletionOptions& options) {
  arguments.add("SHELL", options.shell, "bash|zsh|fish", "The shell");
}

}  // namespace hardball::cli
