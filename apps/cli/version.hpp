// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hardball::cli {

/// The version of the program, as 1.2.3.
std::string version();
/// The commit that the program was built from.
std::string commit();

/// Name and version in the first line, then what the program was built from and how, and the vector
/// instructions that it has and uses on this machine.
std::string version_text();

}  // namespace hardball::cli
