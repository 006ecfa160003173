// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace hardball::cli {

/// Creates a directory for output and its missing parents; returns what it created, innermost first. Error:
/// that is impossible.
std::vector<std::filesystem::path> make_directory(const std::filesystem::path& directory);

}  // namespace hardball::cli
