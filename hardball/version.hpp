// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// The version of the library: HARDBALL_VERSION_MAJOR, HARDBALL_VERSION_MINOR and HARDBALL_VERSION_PATCH.
#include "hardball/errors/version.hpp"
