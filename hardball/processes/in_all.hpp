// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/processes/processes.hpp"

namespace hardball {

/// Does what may fail in some of several processes, and returns when it has succeeded in all. Error: in all
/// processes that of the first, by rank, in which it has failed; only of the types Error and RunFailure.
HARDBALL_EXPORT void in_all(Processes& processes, const Function<void()>& work);

/// Does what only the first process is to do, and returns when it has succeeded. Error: in all processes that
/// of the first.
HARDBALL_EXPORT void in_first(Processes& processes, const Function<void()>& work);

/// Error, in all processes: one of them has other bytes than the first. `what` names them in the message, as
/// in "another scenario"; the remedy is to give all processes the same.
HARDBALL_EXPORT void require_same(
    Processes& processes, const std::string& bytes, const std::string& what,
    const std::string& remedy = "give all processes the same, on a common file system, say");

}  // namespace hardball
