// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hardball::cli {

/// Writes data to the standard output, all of it. Error (RunFailure): it cannot be written.
void write_output(std::string_view text);

/// Writes a one-line message to the standard error, replacing line breaks by blanks.
void write_message(std::string message);

/// Writes messages about what is right, but perhaps not what was meant; nothing if `is_quiet`.
void write_notes(const std::vector<std::string>& notes, bool is_quiet);

/// A line "name   value" of a table.
std::string table_line(std::string_view name, const std::string& value);

}  // namespace hardball::cli
