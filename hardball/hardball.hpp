// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Everything that programs need to use the library. A program that compiles often includes just what it
/// uses: hardball/simulation.hpp and the other headers beside this one take half the time.
#include "hardball/checkpoint.hpp"
#include "hardball/contact.hpp"
#include "hardball/error.hpp"
#include "hardball/event_log.hpp"
#include "hardball/measures.hpp"
#include "hardball/motions.hpp"
#include "hardball/packing.hpp"
#include "hardball/placement.hpp"
#include "hardball/processes.hpp"
#include "hardball/random.hpp"
#include "hardball/recording.hpp"
#include "hardball/responses.hpp"
#include "hardball/robots.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"
#include "hardball/surfaces.hpp"
#include "hardball/theory.hpp"
#include "hardball/thermostats.hpp"
#include "hardball/trajectory.hpp"
#include "hardball/version.hpp"
#include "hardball/world.hpp"
