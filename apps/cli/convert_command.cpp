// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>

#include "apps/cli/commands.hpp"
#include "apps/cli/output_paths.hpp"
#include "apps/cli/parse_number.hpp"
#include "apps/cli/results.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/written.hpp"
#include "hardball/error.hpp"
#include "hardball/trajectory.hpp"

namespace hardball::cli {
namespace {

// The frames to write, from the first to before the second.
struct Frames {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Frames chosen_frames(const ConvertOptions& options, std::size_t count, SnapshotFormat format) {
  if (options.frame) {
    const auto frame = parse_number<std::size_t>(*options.frame, "--frame", "give a number from 0 on");
    if (frame < count) return {frame, frame + 1};
    throw Error("there is no frame " + to_text(frame), "--frame",
                "give a number from 0 to " + to_text(count - 1));
  }
  return has_single_frame(format) ? Frames{count - 1, count} : Frames{0, count};
}

}  // namespace

std::size_t convert_frames(const ConvertOptions& options) {
  const std::filesystem::path in = options.in;
  const std::filesystem::path out = options.out;
  const SnapshotFormat format = format_of(out);
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(in);
  std::error_code missing;
  if (std::filesystem::equivalent(in, out, missing)) {
    throw Error("the file would overwrite the one it is made from", out.string(), "name another file");
  }
  refuse_to_overwrite(out, options.overwrite);
  const Frames frames = chosen_frames(options, reader->frames(), format);
  Snapshot snapshot = reader->read(frames.begin);
  if (!snapshot.has_velocities)
    write_notes({in.string() + " has no velocities; those written are zero"}, options.quiet);
  Trajectory trajectory(out);
  try {
    for (std::size_t frame = frames.begin;;) {
      trajectory.append(snapshot);
      if (++frame == frames.end) break;
      snapshot = reader->read(frame);
    }
    trajectory.close();
  } catch (...) {
    Trajectory::remove(out);
    throw;
  }
  return frames.end - frames.begin;
}

ExitCode convert(const ConvertOptions& options) {
  const std::size_t frames = convert_frames(options);
  if (!options.quiet) write_output(written_line(options.out, count_of(frames, "frame")));
  return ExitCode::done;
}

}  // namespace hardball::cli
