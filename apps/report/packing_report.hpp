// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/packing/packing.hpp"

namespace hardball::report {

/// The report of a packing: how it was packed, what holds it, and its structure, as one self-contained HTML
/// page, without network or script; it is also well-formed XML. `name` is its heading, `program` the name and
/// version of what made it.
std::string to_html(const Packing& packing, const std::string& name, const std::string& program);

}  // namespace hardball::report
