// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/errors/export.hpp"

namespace hardball {

/// A JSON Schema (draft 7) of scenario files, with which editors complete keys, describe them and mark
/// mistakes.
HARDBALL_EXPORT std::string scenario_schema();

}  // namespace hardball
