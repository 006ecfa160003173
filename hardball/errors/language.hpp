// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Refuses older languages than C++20. Headers that need it and include no other header of the library
/// include this one, so that compilers say nothing else before.
#ifdef _MSVC_LANG
#define HARDBALL_LANGUAGE _MSVC_LANG
#else
#define HARDBALL_LANGUAGE __cplusplus
#endif
#if HARDBALL_LANGUAGE <= 201703L
#error "Hardball needs C++20: compile with -std=c++20 (with MSVC, /std:c++20)"
#endif
#undef HARDBALL_LANGUAGE
