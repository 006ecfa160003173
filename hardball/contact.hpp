// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

/// What listeners and responses receive of a collision or a wall contact, and what a response returns.
#include "hardball/errors/compilation.hpp"
#include "hardball/interaction/contact.hpp"
