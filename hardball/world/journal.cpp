// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/journal.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

void World::begin_journal() {
  journal_.clear();
  has_journal_ = true;
}

void World::end_journal() {
  journal_.clear();
  has_journal_ = false;
}

void World::undo() {
  HARDBALL_CHECK(!journal_.empty());
  const Journal::Change change = journal_.back();
  switch (change.kind) {
    case Journal::Kind::path:
      set_path(change.slot, journal_.path());
      set_folded(change.slot, folded(change.slot) - journal_.folded());
      break;
    case Journal::Kind::state:
      set_state(change.slot, journal_.state());
      break;
    case Journal::Kind::passage:
      last_passage_ = journal_.passage();
      break;
    case Journal::Kind::level:
      levels_.set(change.slot, journal_.level().partner, journal_.level().potential, journal_.level().level);
      break;
    case Journal::Kind::birth:
      return undo_add();
    case Journal::Kind::death:
      // The sphere that took its place goes back to the last slot.
      if (change.slot < size()) levels_.give_back(change.slot, static_cast<Slot>(size()));
      unerase(change.slot, journal_.state());
  }
  journal_.pop();
}

}  // namespace hardball
