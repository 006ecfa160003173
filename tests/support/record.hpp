// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "hardball/errors/error.hpp"

namespace hardball::support {

/// Adds a measured number to the report written by --gtest_output=xml, which shows by what margin a test has
/// passed.
inline void record(const std::string& name, double value) {
  ::testing::Test::RecordProperty(name, to_text(value));
}

}  // namespace hardball::support
