// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// The library for HTTP, which includes the headers of the system for sockets. Those of Windows make macros of
// names.
#include <httplib.h>

#undef near
#undef far
