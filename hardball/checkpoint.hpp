// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// Saved simulations and measures in files of which nothing can be damaged unnoticed.
#include "hardball/errors/compilation.hpp"
#include "hardball/io/checkpoint_file.hpp"
