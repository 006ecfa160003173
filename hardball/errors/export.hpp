// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/language.hpp"

/// Marks the classes and functions of the public headers that are defined in the library: all else is hidden
/// where it is shared.
#if defined(__GNUC__)
#define HARDBALL_EXPORT __attribute__((visibility("default")))
#else
#define HARDBALL_EXPORT
#endif
