// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "hardball/errors/export.hpp"
#include "hardball/platform/files.hpp"

namespace hardball {

/// Error: the path is a symbolic link, which may lead to a file of something else. Links to devices are none
/// of these.
HARDBALL_EXPORT void refuse_link(const std::filesystem::path& path);

/// Opens a file to be written from its beginning; it is not open, and errno says why, if that is impossible.
/// No file that has other names is changed under these: a symbolic link to it is not followed, and a hard
/// link becomes a file of its own.
platform::File open_output(const std::filesystem::path& path);

}  // namespace hardball
