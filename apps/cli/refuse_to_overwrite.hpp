// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "apps/cli/options.hpp"

namespace hardball::cli {

/// Error: the file exists already, and the command line does not say that it is to be replaced. Devices and
/// pipes may always be written to.
void refuse_to_overwrite(const std::filesystem::path& file, const Options& options);

}  // namespace hardball::cli
