// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Packings on request: spheres of a given number, size and density that do not overlap.
#include "hardball/packing/packing.hpp"
#include "hardball/packing/request_text.hpp"
#include "hardball/packing/wall_profile.hpp"
