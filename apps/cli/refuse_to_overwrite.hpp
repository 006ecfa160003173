// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace hardball::cli {

/// Error: the file exists already, and may not be replaced. Devices and
/// pipes may always be written to.
void refuse_to_overwrite(const std::filesystem::path& file, bool may_replace);

}  // namespace hardball::cli
