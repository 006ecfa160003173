// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/interaction/response_table.hpp"
#include "hardball/scenario/scenario.hpp"

namespace hardball {

/// The responses that a scenario describes.
ResponseTable make_responses(const Scenario& scenario);

}  // namespace hardball
