// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/interruption.hpp"

#include <utility>

#include "hardball/platform/program.hpp"

namespace hardball::cli {
namespace {

Function<bool()> ask;

}  // namespace

void catch_signals() {
  platform::catch_interruption();
}

bool is_interrupted() {
  return platform::was_interrupted() || (ask && ask());
}

void ask_for_interruption(Function<bool()> whether) {
  ask = std::move(whether);
}

}  // namespace hardball::cli
