// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <array>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>

#include "apps/cli/commands.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/little_endian.hpp"
#include "hardball/io/npy_event_log.hpp"
#include "hardball/io/npy_header.hpp"
#include "hardball/io/recording_reader.hpp"
#include "hardball/io/snapshot_format.hpp"

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

std::string box_text(const SnapshotBox& box) {
  const std::size_t dimensions = box.is_flat ? kAxes - 1 : kAxes;
  std::string size;
  std::string periodic;
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    size += (axis == 0 ? "" : " x ") + to_text(box.size[axis]);
    if (box.is_periodic[axis]) periodic += (periodic.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
  }
  return size + (periodic.empty() ? ", not periodic" : ", periodic along " + periodic) +
         (box.is_unbounded ? ", unbounded: it spans the spheres" : "");
}

std::string about_snapshots(const std::filesystem::path& path) {
  const std::unique_ptr<SnapshotReader> reader = open_snapshots(path);
  const Snapshot first = reader->read(0);
  const Snapshot last = reader->read(reader->frames() - 1);
  std::string text = heading(path, name_of(format_of(path)));
  text += line("frames", to_text(reader->frames()));
  text += line("spheres", range(to_text(first.spheres.size()), to_text(last.spheres.size())));
  if (first.time && last.time) text += line("time", range(to_text(*first.time), to_text(*last.time)));
  if (last.box) text += line("box", box_text(*last.box));
  std::string contents = "positions, radii";
  if (last.has_velocities) contents += ", velocities";
  if (last.has_spins) contents += ", spins";
  if (!last.ids.empty()) contents += ", ids";
  if (!last.images.empty()) contents += ", images";
  return text + line("contents", contents);
}

std::string about_recording(const std::filesystem::path& path) {
  const RecordingReader reader(path);
  std::uint64_t contacts = 0;
  for (const ChunkExtent& chunk : reader.chunks()) contacts += chunk.contacts;
  std::string text = heading(path, "recording of " + reader.header().name);
  text += line("version", to_text(reader.header().version));
  text += line("spheres", to_text(reader.header().spheres));
  text += line("contacts", to_text(contacts));
  return text + line("time", range(to_text(reader.header().begin), to_text(reader.reached())));
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

std::string about(const std::filesystem::path& path) {
  if (path.extension() == ".hbr") return about_recording(path);
  if (format_of(path) == SnapshotFormat::npy) {
    const NpyHeader header = read_npy_header(path);
    if (time_in_event_log(header)) return about_event_log(path, header);
  }
  return about_snapshots(path);
}

}  // namespace

ExitCode info(const Options& options) {
  for (const std::string& file : options.files) write_output(about(file));
  return ExitCode::done;
}

}  // namespace hardball::cli
