// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace hardball::cli {

/// Creates a directory for output and its missing parents; returns what it created, innermost first. Error:
/// that is impossible.
std::vector<std::filesystem::path> make_directory(const std::filesystem::path& directory);

/// Error: the file exists already, and may not be replaced. Devices and pipes may always be written to.
void refuse_to_overwrite(const std::filesystem::path& file, bool may_replace);

}  // namespace hardball::cli
