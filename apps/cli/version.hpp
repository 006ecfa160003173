// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hardball::cli {

/// Name and version in the first line, then what the program was built from and how, and the vector
/// instructions that it has and uses on this machine.
std::string version_text();

}  // namespace hardball::cli
