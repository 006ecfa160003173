// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Several processes that share one simulation: what they need of each other, and work that only one of them
/// does or that may fail in some.
#include "hardball/errors/compilation.hpp"
#include "hardball/processes/in_all.hpp"
#include "hardball/processes/processes.hpp"
