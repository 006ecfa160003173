// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_responses.hpp"

namespace hardball {

ResponseTable make_responses(const Scenario& scenario) {
  const Bounce common(scenario.bounce);
  ResponseTable table(scenario.merges ? Rule(Merging()) : Rule(common), common);
  for (const PairDescription& pair : scenario.pairs) {
    if (!pair.second) {
      table.set_wall(pair.first, Bounce(pair.bounce));
    } else if (pair.outcome == ContactOutcome::merge) {
      table.set(pair.first, *pair.second, Merging());
    } else if (pair.outcome == ContactOutcome::pass) {
      table.set(pair.first, *pair.second, Passing());
    } else {
      table.set(pair.first, *pair.second, Bounce(pair.bounce));
    }
  }
  return table;
}

}  // namespace hardball
