// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Random numbers that are the same on every machine.
#include "hardball/errors/compilation.hpp"
#include "hardball/numbers/random.hpp"
