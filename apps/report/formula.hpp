// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hardball::report {

/// A text as HTML, with the formulas between its dollar signs as MathML. They are in the part of LaTeX's
/// notation that measures use: letters, digits and operators, ^ and _, groups in braces, \frac, \sqrt, \text,
/// \mathrm, \mathbf, \left and \right, sums, functions, Greek letters. Any text gives well-formed markup: an
/// unknown command is shown by its name, an unpaired dollar sign as itself.
std::string with_formulas(std::string_view text);

}  // namespace hardball::report
