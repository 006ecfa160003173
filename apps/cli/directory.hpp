// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace hardball::cli {

/// Creates a directory for output and those above it that are missing; returns what it created, the innermost
/// first. Error: that cannot be done.
std::vector<std::filesystem::path> make_directory(const std::filesystem::path& directory);

}  // namespace hardball::cli
