// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/interruption.hpp"

#include <atomic>
#include <utility>

#include "hardball/platform/program.hpp"

namespace hardball::cli {
namespace {

std::atomic<bool> is_requested = false;
Function<bool()> ask;

}  // namespace

void catch_signals() {
  platform::catch_interruption();
}

bool is_interrupted() {
  return is_requested || platform::was_interrupted() || (ask && ask());
}

void request_interruption(bool is_wanted) {
  is_requested = is_wanted;
}

void ask_for_interruption(Function<bool()> whether) {
  ask = std::move(whether);
}

}  // namespace hardball::cli
