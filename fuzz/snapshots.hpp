// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/target.hpp"
#include "hardball/trajectory/text_snapshot_reader.hpp"

namespace hardball::fuzz {

/// Reads the first frames and the last one, and runs the spheres of that.
inline void read_frames(SnapshotReader& reader) {
  constexpr std::size_t kFrames = 3;
  for (std::size_t frame = 0; frame < std::min(kFrames, reader.frames()); ++frame) reader.read(frame);
  const Snapshot last = reader.read(reader.frames() - 1);
  if (last.spheres.size() > kMaxSpheres) return;
  World world(Box::open());
  for (const Sphere& sphere : last.spheres) world.add(sphere);
  Simulation simulation(std::move(world));
  run_a_little(simulation);
}

/// Reads all frames of a text, and runs a simulation from the last one.
inline void read_frames(std::string_view bytes, const TextFormat& format) {
  const auto open = [bytes] { return std::make_unique<std::istringstream>(std::string(bytes)); };
  TextSnapshotReader reader(open, "start", format);
  read_frames(reader);
}

}  // namespace hardball::fuzz
