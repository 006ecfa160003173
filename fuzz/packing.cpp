// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What people ask to be packed: parts of a request, one on each line, as in box=1:1:2.
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "fuzz/target.hpp"
#include "hardball/packing/packing_plan.hpp"
#include "hardball/packing/request_text.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  PackingText text;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    const std::size_t equals = std::min(line.find('='), line.size());
    const std::string_view name = line.substr(0, equals);
    const std::string value(line.substr(std::min(equals + 1, line.size())));
    if (name == "count") text.count = value;
    if (name == "diameter") text.diameter = value;
    // No file is read.
    if (name == "sizes" && !value.starts_with("file")) text.sizes = value;
    if (name == "box") text.box = value;
    if (name == "walls") text.walls = value;
    if (name == "container" && !value.starts_with("mesh")) text.container = value;
    if (name == "phi") text.phi = value;
    if (name == "pressure") text.pressure = value;
    if (name == "rate") text.rate = value;
    if (name == "gap") text.gap = value;
    if (name == "dimensions") text.dimensions = value;
    if (name == "seed") text.seed = value;
  }
  const PackingRequest request = parse_request(text, "--");
  // Larger ones take memory, and no other path.
  constexpr std::size_t kMost = 10000;
  if (request.count.value_or(kMost + 1) > kMost) return;
  static_cast<void>(plan(request).expected_collisions());
}
