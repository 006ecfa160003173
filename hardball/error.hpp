// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// The exceptions: bad input, a run that cannot continue, a fault of the library itself.
#include "hardball/errors/compilation.hpp"
#include "hardball/errors/error.hpp"
