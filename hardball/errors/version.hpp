// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/language.hpp"

// The version of the library, from which the build takes it.
#define HARDBALL_VERSION_MAJOR 0
#define HARDBALL_VERSION_MINOR 2
#define HARDBALL_VERSION_PATCH 0
