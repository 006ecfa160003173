// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// For small functions that must be inlined: those also compiled for wider instructions than the rest of the
/// program, since the linker would take one copy for all; and those that pass constants to a function they
/// are given.
#if defined(__GNUC__)
#define HARDBALL_ALWAYS_INLINE [[gnu::always_inline]] inline
#else
#define HARDBALL_ALWAYS_INLINE inline
#endif

/// For what is rarely called from where time matters, and would keep the rest from being inlined.
#if defined(__GNUC__)
#define HARDBALL_NEVER_INLINE [[gnu::noinline]]
#else
#define HARDBALL_NEVER_INLINE
#endif
