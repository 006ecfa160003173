// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/snapshot_format.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr std::string_view kZstd = ".zst";
constexpr std::string_view kGzip = ".gz";

struct Ending {
  std::string_view text;
  SnapshotFormat format;
};

// The first for each format is the usual one.
constexpr std::array<Ending, 13> kEndings{{{".xyz", SnapshotFormat::extended_xyz},
                                           {".extxyz", SnapshotFormat::extended_xyz},
                                           {".gsd", SnapshotFormat::gsd},
                                           {".lammpstrj", SnapshotFormat::lammps},
                                           {".dump", SnapshotFormat::lammps},
                                           {".liggghts", SnapshotFormat::lammps},
                                           {".data", SnapshotFormat::lammps_data},
                                           {".lmp", SnapshotFormat::lammps_data},
                                           {".pvd", SnapshotFormat::vtp},
                                           {".csv", SnapshotFormat::csv},
                                           {".txt", SnapshotFormat::csv},
                                           {".npy", SnapshotFormat::npy},
                                           {".sph", SnapshotFormat::sph}}};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Whether a name begins with this word, and not with one that is longer.
bool begins_with_word(std::string_view name, std::string_view word) {
  return name.starts_with(word) && name.size() > word.size() && !is_letter(name[word.size()]);
}

std::optional<SnapshotFormat> format_of_plain(std::string_view name) {
  const auto of_ending = [&]() -> std::optional<SnapshotFormat> {
    for (const Ending& ending : kEndings) {
      if (name.ends_with(ending.text)) return ending.format;
    }
    return std::nullopt;
  };
  if (const auto format = of_ending()) return format;
  // As LAMMPS users name them, without an ending.
  if (begins_with_word(name, "dump")) return SnapshotFormat::lammps;
  if (name.starts_with("data.")) return SnapshotFormat::lammps_data;
  std::string_view rest = name;
  while (!rest.empty() && is_digit(rest.back())) rest.remove_suffix(1);
  if (rest.size() == name.size() || !rest.ends_with('.')) return std::nullopt;
  rest.remove_suffix(1);
  name = rest;
  return of_ending();
}

bool is_text(SnapshotFormat format) {
  return format != SnapshotFormat::gsd && format != SnapshotFormat::npy && format != SnapshotFormat::vtp;
}

}  // namespace

bool is_compressed(const std::filesystem::path& path) {
  return path.filename().string().ends_with(kZstd);
}

SnapshotFormat format_of(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  if (name.ends_with(kGzip)) {
    throw Error("files compressed by gzip are neither read nor written", path.string(),
                "decompress it with gunzip, or name a file compressed by zstd, as in a.lammpstrj.zst");
  }
  if (is_compressed(path)) name.resize(name.size() - kZstd.size());
  const std::optional<SnapshotFormat> format = format_of_plain(name);
  if (!format) {
    std::string known;
    for (const Ending& ending : kEndings) known += (known.empty() ? "" : ", ") + std::string(ending.text);
    throw Error("unknown file extension", path.string(),
                "use one of " + known + ", or names such as dump.100 and data.grains");
  }
  if (!is_compressed(path)) return *format;
  if (!is_text(*format)) {
    throw Error("only text formats can be compressed, and this is " + std::string(name_of(*format)),
                path.string(), "decompress it with zstd -d");
  }
  return *format == SnapshotFormat::extended_xyz ? SnapshotFormat::extended_xyz_zst : *format;
}

bool has_single_frame(SnapshotFormat format) {
  return format == SnapshotFormat::csv || format == SnapshotFormat::npy ||
         format == SnapshotFormat::lammps_data;
}

}  // namespace hardball
