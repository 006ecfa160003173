// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>

namespace hardball {

/// All bytes of a file. Error: it cannot be read, or is not a file.
std::string read_file(const std::filesystem::path& path);

/// The bytes of an open file from `offset` on, fewer than `length` where it ends before.
std::string read_part(std::istream& file, std::uint64_t offset, std::uint64_t length);

}  // namespace hardball
