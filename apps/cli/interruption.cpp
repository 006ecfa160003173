// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/interruption.hpp"

#include <atomic>
#include <csignal>
#include <utility>

namespace hardball::cli {
namespace {

std::atomic<bool> is_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a handler of signals sets it");
Function<bool()> ask;

extern "C" void note_signal(int) {
  is_requested = true;
}

}  // namespace

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool is_interrupted() {
  return is_requested || (ask && ask());
}

void request_interruption(bool is_wanted) {
  is_requested = is_wanted;
}

void ask_for_interruption(Function<bool()> whether) {
  ask = std::move(whether);
}

}  // namespace hardball::cli
