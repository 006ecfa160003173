// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "hardball/errors/export.hpp"
#include "hardball/packing/packing_request.hpp"

namespace hardball {

/// A request as people write it: see docs/packing.md.
struct PackingText {
  std::optional<std::string> count = {};
  std::optional<std::string> diameter = {};
  std::optional<std::string> sizes = {};      ///< As in "lognormal:0.3", or "file:radii.txt".
  std::optional<std::string> box = {};        ///< As in "10,10,20", or "1:1:2" for proportions.
  std::optional<std::string> walls = {};      ///< The axes of the box with walls, as in "z".
  std::optional<std::string> container = {};  ///< As in "cylinder:7,50", or "mesh:hopper.stl".
  std::optional<std::string> phi = {};        ///< A packing fraction, or "max".
  std::optional<std::string> pressure = {};
  std::optional<std::string> rate = {};
  std::optional<std::string> gap = {};
  std::optional<std::string> dimensions = {};
  std::optional<std::string> seed = {};
  std::optional<std::string> start = {};  ///< A file with snapshots.
};

/// The request that a text stands for; files that it names are read. Error, with `prefix` and the name of the
/// part as its place, as in "--box": a part is not what it should be.
HARDBALL_EXPORT PackingRequest parse_request(const PackingText& text, const std::string& prefix);

}  // namespace hardball
