// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Every contact of a run in a NumPy file.
#include "hardball/errors/compilation.hpp"
#include "hardball/recording/npy_event_log.hpp"
