// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/engine/engine_base.hpp"
#include "hardball/measure/contact_sums.hpp"

namespace hardball::support {

/// Runs any engine, and calls observe(contact) after every contact.
RunStatus run(EngineBase& engine, const RunLimits& limits, const auto& observe) {
  ContactSums sums;
  sums.tally.begin(engine.world(), engine.now());
  return engine.run(limits, sums,
                    {.on_contact = [&](const Contact& contact) { return notify(observe, contact); }});
}

}  // namespace hardball::support
