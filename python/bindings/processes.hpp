// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "hardball/processes/processes.hpp"

namespace hardball::python {

/// What an argument `processes` means: None, which is null here, is this process alone.
inline Processes& processes_or_one(Processes* processes) {
  return processes == nullptr ? one_process() : *processes;
}

/// Called with what a function in Python has raised in the middle of a run of several processes: returns if
/// all of them have failed, within some seconds. Otherwise prints the exception and ends all, as the others
/// would wait for this one, or mistake its next messages for others.
void require_in_all(pybind11::error_already_set& error);

}  // namespace hardball::python
