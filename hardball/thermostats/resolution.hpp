// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball {

/// Error: at `time` [T] doubles do not resolve intervals of this length [T].
void refuse_unresolved(double interval, double time);

}  // namespace hardball
