// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Scenario files: read, checked, and made into a world and a simulation; and their JSON Schema.
#include "hardball/scenario/make_simulation.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/schema.hpp"
#include "hardball/scenario/shared_scenario.hpp"
