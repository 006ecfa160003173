// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/results.hpp"
#include "apps/cli/run_files.hpp"
#include "apps/cli/started_run.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/archive/archive.hpp"
#include "hardball/checkpoint.hpp"
#include "hardball/error.hpp"
#include "hardball/event_log.hpp"
#include "hardball/io/npy_header.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/recording.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"
#include "hardball/trajectory.hpp"

namespace hardball::cli {
namespace {

std::string line(const std::string& name, const std::string& value) {
  std::string text = "  " + name;
  constexpr std::size_t kWidth = 12;
  text.resize(kWidth, ' ');
  return text + value + "\n";
}

std::string range(const std::string& first, const std::string& last) {
  return first == last ? first : first + " to " + last;
}

std::string heading(const std::filesystem::path& path, std::string_view what) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return path.string() + ": " + std::string(what) + (unknown ? "" : ", " + to_text(bytes) + " bytes") + "\n";
}

std::string about_snapshots(const std::filesystem::path& path) {
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(path);
  const Snapshot first = reader->read(0);
  const Snapshot last = reader->read(reader->frames() - 1);
  std::string text = heading(path, name_of(format_of(path)));
  text += line("frames", to_text(reader->frames()));
  text += line("spheres", range(to_text(first.spheres.size()), to_text(last.spheres.size())));
  if (first.time && last.time) text += line("time", range(to_text(*first.time), to_text(*last.time)));
  if (last.box) text += line("box", text_of(*last.box));
  std::string contents = "positions, radii";
  if (last.has_velocities) contents += ", velocities";
  if (last.has_spins) contents += ", spins";
  if (!last.ids.empty()) contents += ", ids";
  if (!last.images.empty()) contents += ", images";
  return text + line("contents", contents);
}

std::string about_collection(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  std::size_t frames = 0;
  constexpr std::string_view kEntry = "<DataSet ";
  for (std::size_t at = 0; (at = text.find(kEntry, at)) != std::string::npos; at += kEntry.size()) ++frames;
  return heading(path, name_of(SnapshotFormat::vtp)) + line("frames", to_text(frames));
}

std::string about_recording(const std::filesystem::path& path) {
  RecordingReader reader(path, OnDamage::keep_what_comes_before);
  reader.verify();
  std::uint64_t contacts = 0;
  for (const ChunkExtent& chunk : reader.chunks()) contacts += chunk.contacts;
  std::string text = heading(path, "recording of " + reader.header().name);
  text += line("version", to_text(reader.header().layout().version()));
  text += line("spheres", to_text(reader.header().spheres));
  text += line("contacts", to_text(contacts));
  text += line("time", range(to_text(reader.header().begin), to_text(reader.reached())));
  if (!reader.damage()) return text;
  write_output(text);
  throw Error(*reader.damage(), path.string(), "hardball view and replay show the part before");
}

// As far as a simulation goes.
std::string about_simulation(const Simulation& simulation) {
  return line("time", to_text(simulation.time())) + line("spheres", to_text(simulation.size())) +
         line("contacts", to_text(simulation.counters().contacts())) +
         line("log hash", hash_text(simulation.event_log_hash()));
}

std::string about_checkpoint(const std::filesystem::path& path) {
  std::map<std::string, std::string> sections = read_checkpoint_file(path);
  std::string what = "checkpoint";
  RunState run;
  if (sections.contains("run")) {
    restore(sections["run"], path.string(), run);
    what += " of " + run.name;
  }
  std::string text = heading(path, what);
  if (sections.contains("simulation")) {
    text += about_simulation(Simulation::load(sections["simulation"], path.string()));
  }
  std::string names;
  for (const auto& [name, bytes] : sections) names += (names.empty() ? "" : ", ") + name;
  return text + line("contents", names);
}

std::string about_scenario(const std::filesystem::path& path) {
  const Scenario scenario = load_scenario(path);
  std::size_t spheres = 0;
  for (const SphereGroup& group : scenario.spheres) spheres += group.count;
  std::string box;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const auto& [boundary, size] = scenario.box[axis];
    box += (axis == 0 ? "" : " x ") + (size ? to_text(*size) + " " : "") + std::string(name_of(boundary));
  }
  std::string text = heading(path, "scenario");
  text +=
      line("spheres", scenario.start_file ? "those of " + scenario.start_file->string() : to_text(spheres));
  text += line("box", box);
  text += line("until", scenario.run.until ? to_text(*scenario.run.until) : "as the command line says");
  return text + line("seed", to_text(scenario.run.seed));
}

std::string about_summary(const std::filesystem::path& path) {
  const auto json = nlohmann::json::parse(read_file(path), nullptr, false);
  if (!json.is_object() || !json.contains("event_log_hash")) {
    throw Error("it is not the summary of a run", path.string(), "name a file that hardball run has written");
  }
  std::string text = heading(path, "summary of a run");
  const auto add = [&](const std::string& name, const nlohmann::json& value) {
    if (value.is_string()) text += line(name, value.get<std::string>());
    if (value.is_number_float()) text += line(name, to_text(value.get<double>()));
    if (value.is_number_integer()) text += line(name, value.dump());
  };
  const auto get = [](const nlohmann::json& object, const char* key) {
    return object.is_object() ? object.value(key, nlohmann::json()) : nlohmann::json();
  };
  for (const char* key : {"time", "spheres"}) add(key, get(json, key));
  for (const char* kind : {"collision", "wall"}) add(kind, get(get(json, "events"), kind));
  add("log hash", get(json, "event_log_hash"));
  add("scenario", get(get(json, "scenario"), "file"));
  for (const char* key : {"seed", "version", "commit"}) add(key, get(json, key));
  return text;
}

// The time of a contact in the event log.
double contact_time(std::ifstream& file, const NpyHeader& header, std::uint64_t contact) {
  std::array<char, 8> bytes{};
  const std::uint64_t offset = time_in_event_log(header)->offset;
  file.seekg(static_cast<std::streamoff>(header.offset + contact * header.item_bytes + offset));
  file.read(bytes.data(), bytes.size());
  return read_little_endian<double>(bytes.data());
}

std::string about_event_log(const std::filesystem::path& path, const NpyHeader& header) {
  const std::uint64_t contacts = header.shape[0];
  std::string text = heading(path, "event log");
  text += line("contacts", to_text(contacts));
  if (contacts == 0) return text;
  std::ifstream file(path, std::ios::binary);
  return text + line("time", range(to_text(contact_time(file, header, 0)),
                                   to_text(contact_time(file, header, contacts - 1))));
}

}  // namespace

std::string describe_file(const std::filesystem::path& path) {
  if (path.extension() == ".hbr") return about_recording(path);
  if (path.extension() == kCheckpointEnding) return about_checkpoint(path);
  if (path.extension() == ".toml") return about_scenario(path);
  if (path.extension() == ".json") return about_summary(path);
  const SnapshotFormat format = format_of(path);
  if (format == SnapshotFormat::vtp) return about_collection(path);
  if (format == SnapshotFormat::npy) {
    const NpyHeader header = read_npy_header(path);
    if (time_in_event_log(header)) return about_event_log(path, header);
  }
  return about_snapshots(path);
}

ExitCode info(const InfoOptions& options) {
  ExitCode code = ExitCode::done;
  const auto tell = [&](const auto& action) {
    try {
      action();
    } catch (const Error& error) {
      write_message(error.what());
      code = ExitCode::bad_input;
    }
  };
  for (const std::filesystem::path file : options.files) {
    if (!std::filesystem::is_directory(file)) {
      tell([&] { write_output(describe_file(file)); });
      continue;
    }
    const std::vector<std::filesystem::path> names = files_of_run(file);
    tell([&] {
      if (names.empty())
        throw Error("it holds no files of a run", file.string(), "name the output directory of one");
      write_output(file.string() + ": output of a run that has " + (is_finished(file) ? "" : "not ") +
                   "ended\n");
    });
    for (const std::filesystem::path& name : names) tell([&] { write_output(describe_file(file / name)); });
  }
  return code;
}

}  // namespace hardball::cli
