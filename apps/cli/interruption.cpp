// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/interruption.hpp"

#include <csignal>
#include <utility>

namespace hardball::cli {
namespace {

volatile std::sig_atomic_t signal_came = 0;
Function<bool()> ask;

extern "C" void note_signal(int) {
  signal_came = 1;
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
  return signal_came != 0 || (ask && ask());
}

void ask_for_interruption(Function<bool()> whether) {
  ask = std::move(whether);
}

}  // namespace hardball::cli
