// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/execution/collapse_guard.hpp"
#include "hardball/execution/merged_spheres.hpp"

namespace hardball {

/// What contacts leave behind besides new paths: kept when one engine replaces another, and saved.
struct PostContactState {
  MergedSpheres merged;
  CollapseGuard collapse;
};

}  // namespace hardball
