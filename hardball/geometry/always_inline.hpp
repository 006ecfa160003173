// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// For small functions that are not to be called: those that are also compiled for wider instructions than
/// the rest of the program, of whose copies the linker would take one for all, and those that are given a
/// function to pass constants to.
#if defined(__GNUC__)
#define HARDBALL_ALWAYS_INLINE [[gnu::always_inline]] inline
#else
#define HARDBALL_ALWAYS_INLINE inline
#endif
