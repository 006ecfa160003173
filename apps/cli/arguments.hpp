// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace hardball::cli {

/// A command of the program as its manual and its completions describe it.
struct Command {
  /// An argument of a command.
  struct Argument {
    std::vector<std::string> names;  ///< Short ones first, with their dashes; none of a positional argument.
    std::string value;               ///< What is given for it; empty for a flag.
    std::vector<std::string> choices;  ///< The words that may be given for it; empty if it can be anything.
    std::string description;
    bool is_required = false;
    bool is_repeatable = false;
  };

  std::string name;
  std::string description;
  std::vector<Argument> options;
  std::vector<Argument> positionals;
};

/// How the command line describes `app`, a command or the whole program. A type of values such as
/// auto|paper|LENGTH lists the words that may be given; a word in capitals stands for something else.
Command describe(const CLI::App& app);

/// The commands of the program, in order.
std::vector<Command> describe_commands(const CLI::App& program);

}  // namespace hardball::cli
