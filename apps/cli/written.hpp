// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace hardball::cli {

/// A number of things in words: "1 frame", "301 frames".
std::string count_of(std::uint64_t number, std::string_view thing);

/// The line by which every command says what it has written: "wrote replay.html, 1.2 MB, 301 frames". A
/// collection of frames counts with the files that it lists. `contents`: what the file holds, in words; may
/// be empty.
std::string written_line(const std::filesystem::path& file, const std::string& contents = {});

}  // namespace hardball::cli
