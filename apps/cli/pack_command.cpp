// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/output_paths.hpp"
#include "apps/cli/packing_cost.hpp"
#include "apps/cli/packing_replay.hpp"
#include "apps/cli/packing_summary.hpp"
#include "apps/cli/parse_number.hpp"
#include "apps/cli/progress.hpp"
#include "apps/cli/seconds_since.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/version.hpp"
#include "apps/cli/written.hpp"
#include "apps/report/packing_report.hpp"
#include "hardball/checkpoint.hpp"
#include "hardball/error.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/packing.hpp"
#include "hardball/trajectory.hpp"
#if HARDBALL_POLISH
#include "apps/polish/polish.hpp"
#endif

namespace hardball::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kSection = "packing";

// Error: a file has an unknown extension, or exists already.
void check_outputs(const PackOptions& options) {
  for (const std::string& out : options.outs) {
    format_of(out);
    refuse_to_overwrite(out, options.overwrite);
  }
  for (const auto& page : {options.report, options.replay})
    if (page) refuse_to_overwrite(*page, options.overwrite);
}

Precision precision_of(const PackOptions& options) {
  for (const std::string& out : options.outs)
    if (format_of(out) == SnapshotFormat::gsd) return Precision::singles;
  return Precision::doubles;
}

void refuse_request_with_resume(const PackingText& text) {
  const std::array<const std::optional<std::string>*, 13> parts{
      &text.count,    &text.diameter, &text.sizes, &text.box,        &text.walls, &text.container, &text.phi,
      &text.pressure, &text.rate,     &text.gap,   &text.dimensions, &text.seed,  &text.start};
  for (const auto* part : parts) {
    if (!part->has_value()) continue;
    throw Error("the checkpoint says what is packed", "--resume", "leave the other options out");
  }
}

void write_warnings(std::span<const std::string> warnings, const PackOptions& options) {
  std::vector<std::string> notes;
  for (const std::string& warning : warnings) notes.push_back("warning: " + warning);
  write_notes(notes, options.output.quiet);
}

Packer resumed(const PackOptions& options) {
  refuse_request_with_resume(options.packing);
  const std::map<std::string, std::string> sections = read_checkpoint_file(*options.checkpoint);
  const auto found = sections.find(kSection);
  if (found == sections.end())
    throw Error("the checkpoint is not that of a packing", *options.checkpoint,
                "name one that pack has written");
  Packer packer = Packer::load(found->second, *options.checkpoint);
  packer.set_threads(read_threads(options.threads));
  return packer;
}

Packer begun(const PackOptions& options, const PackingPlan& plan) {
  SetUpProgress progress(!options.output.quiet);
  return Packer(plan, {.threads = read_threads(options.threads)}, progress.part(0, 1));
}

std::filesystem::path checkpoint_of(const PackOptions& options) {
  if (options.checkpoint) return *options.checkpoint;
  return options.outs.front() + ".checkpoint";
}

void save(const Packer& packer, const std::filesystem::path& file) {
  const CheckpointSection section{kSection, packer.save()};
  write_checkpoint_file(file, {&section, 1});
}

void write(const PackedSpheres& spheres, const std::filesystem::path& file) {
  Trajectory trajectory(file);
  trajectory.append(snapshot_of(spheres));
  trajectory.close();
}

// The number of spheres or discs, in words.
std::string spheres_text(const PackedSpheres& spheres) {
  return count_of(spheres.size(), spheres.container.dimensions == 2 ? "disc" : "sphere");
}

void write_pages(const Packing& packing, const PackOptions& options) {
  const std::string name = spheres_text(packing.spheres);
  if (options.report) replace_file(*options.report, report::to_html(packing, name, "Hardball " + version()));
  if (options.replay) write_replay(packing, name, *options.replay);
}

std::string written_files(const PackedSpheres& spheres, const PackOptions& options) {
  std::string text;
  for (const std::string& out : options.outs) text += written_line(out, spheres_text(spheres));
  for (const auto& page : {options.report, options.replay})
    if (page) text += written_line(*page, spheres_text(spheres));
  return text;
}

// Runs to the end, or until the time is spent or a signal comes; from time to time a checkpoint is written.
void carry_out(const PackOptions& options, Packer& packer, Clock::time_point begin) {
  const double limit = options.limit
                           ? parse_number<double>(*options.limit, "--limit", "give a number of seconds")
                           : std::numeric_limits<double>::infinity();
  const bool has_checkpoint = !options.outs.empty();
  constexpr double kCheckpointEvery = 60;
  PackingProgress progress(!options.output.quiet);
  auto saved = Clock::now();
  while (!packer.is_over() && !is_interrupted() && seconds_since(begin) < limit) {
    packer.advance();
    progress.show(packer);
    if (!has_checkpoint || seconds_since(saved) < kCheckpointEvery) continue;
    save(packer, checkpoint_of(options));
    saved = Clock::now();
  }
  if (!has_checkpoint) return;
  if (!packer.is_over()) return save(packer, checkpoint_of(options));
  std::error_code unknown;
  std::filesystem::remove(checkpoint_of(options), unknown);
}

void polish_if_wanted(const PackOptions& options, Packing& packing) {
  if (!options.polish) return;
  if (!(packing.network.tolerance > 0)) {
    packing.warnings.emplace_back("the spheres have not jammed, and were not polished");
    return;
  }
#if HARDBALL_POLISH
  try {
    polish::polish(packing, [](int /*rounds*/) {
      if (is_interrupted()) throw RunFailure("interrupted while the last gaps were removed");
    });
  } catch (const RunFailure& interruption) {
    packing.warnings.emplace_back(interruption.what());
  }
#else
  static_cast<void>(packing);
#endif
}

// Error: there is no library for linear programs; or spheres will not jam.
void check_polish(const PackOptions& options, const PackingPlan& plan) {
  if (!options.polish) return;
#if !HARDBALL_POLISH
  throw Error(
      "this program was built without COIN-OR CLP", "--polish",
      "install it (coinor-libclp-dev in Debian) and build Hardball from source, with HARDBALL_POLISH=ON");
#endif
  const auto* pressure = std::get_if<PackingRequest::Pressure>(&plan.goal);
  constexpr double kLeast = 1e3;
  if (std::holds_alternative<double>(plan.goal) || (pressure && pressure->compressibility < kLeast))
    throw Error("only spheres that have jammed can be polished", "--polish",
                "give --phi max, or a --pressure of at least 1000");
}

}  // namespace

ExitCode pack(const PackOptions& options) {
  const auto begin = Clock::now();
  catch_signals();
  check_outputs(options);
  std::optional<Packer> packer;
  if (options.checkpoint) {
    packer = resumed(options);
    check_polish(options, packer->plan());
  } else {
    const PackingPlan made = plan(parse_request(options.packing, "--"));
    write_warnings(made.warnings, options);
    if (options.dry_run) {
      const double seconds = measured_seconds_per_collision(made);
      write_output(options.output.json ? plan_json(made, seconds) : plan_table(made, seconds));
      return ExitCode::done;
    }
    check_polish(options, made);
    packer = begun(options, made);
  }
  carry_out(options, *packer, begin);
  Packing packing = packing_of(*packer);
  if (packer->is_over()) polish_if_wanted(options, packing);
  write_warnings(std::span(packing.warnings).subspan(packer->plan().warnings.size()), options);
  finish(packing, packer->plan(), precision_of(options));
  for (const std::string& out : options.outs) write(packing.spheres, out);
  write_pages(packing, options);
  const PackingSummary summary{packing, seconds_since(begin), packer->plan().seed, options.outs};
  write_output(options.output.json ? summary.json()
                                   : summary.table() + written_files(packing.spheres, options));
  if (!packer->is_over() && !options.outs.empty()) {
    write_message("interrupted; continue with: hardball pack --resume " + checkpoint_of(options).string() +
                  " --out " + options.outs.front());
  }
  return packing.status == Packing::Status::not_reached ? ExitCode::failed : ExitCode::done;
}

}  // namespace hardball::cli
