// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "apps/viewer/page.hpp"

namespace hardball::viewer {

/// The page of apps/viewer/page, embedded in the program.
Page built_page();

}  // namespace hardball::viewer
