// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace hardball {

/// Writes a file so that under its own name it is either as before or complete, even if the machine stops.
/// Error (RunFailure): it cannot be written; it is then as before.
void replace_file(const std::filesystem::path& path, std::string_view bytes);

/// The name under which several processes write a file before it replaces the one at `path`.
std::filesystem::path unfinished_name(const std::filesystem::path& path);
/// Writes bytes at an offset of a file, which is created if there is none, and returns when they are on the
/// disk. Error (RunFailure): they cannot be written.
void write_at(const std::filesystem::path& path, std::uint64_t offset, std::string_view bytes);
/// Gives the file written under unfinished_name(path) its own name. Error (RunFailure): that is impossible;
/// then the file of this name is as before.
void put_in_place(const std::filesystem::path& path);

}  // namespace hardball
