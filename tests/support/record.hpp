// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "hardball/errors/error.hpp"

namespace hardball::support {

/// Keeps a measured number in the report that --gtest_output=xml writes, so that one sees how far from its
/// limit a test has passed.
inline void record(const std::string& name, double value) {
  ::testing::Test::RecordProperty(name, to_text(value));
}

}  // namespace hardball::support
