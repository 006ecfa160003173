// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/engine/engine.hpp"

namespace hardball {

template class Engine<CalendarQueue>;

}  // namespace hardball
