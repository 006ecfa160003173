// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace hardball {

/// Writes a file so that under its own name it is either as before or complete, even if the machine stops.
/// Error (RunFailure): it cannot be written; it is then as before.
void replace_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace hardball
