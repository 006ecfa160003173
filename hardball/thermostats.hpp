// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// What exchanges energy with the spheres between contacts.
#include "hardball/thermostats/thermostat.hpp"
