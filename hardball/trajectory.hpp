// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// The spheres at moments of a run, in files of several formats: written, and read as start states.
#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/snapshot_format.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/snapshot_schedule.hpp"
#include "hardball/trajectory/trajectory.hpp"
