// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hardball {

/// All bytes of a file. Error: it cannot be read, or is no file.
std::string read_file(const std::filesystem::path& path);

}  // namespace hardball
