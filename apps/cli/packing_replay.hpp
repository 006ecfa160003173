// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "hardball/packing.hpp"

namespace hardball::cli {

/// Writes a page that shows a packing in the viewer, with what holds it: one HTML file. Error: it is too
/// large for that; a file cannot be written.
void write_replay(const Packing& packing, const std::string& name, const std::filesystem::path& path);

}  // namespace hardball::cli
