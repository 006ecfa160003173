// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/commands.hpp"

namespace CLI {
class App;
}

namespace hardball::cli {

/// A command of the program, or the program itself, as manual and completions describe it.
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
  std::vector<Command> commands;  ///< The program's commands, in order; a command has none.
};

/// The arguments of a command: adding one binds it to a variable, which parsing the command line sets.
///
/// A name with dashes is that of an option, any other that of a positional argument, which is required.
class Arguments {
 public:
  explicit Arguments(CLI::App& command) : command_(command) {}

  /// Adds an argument with a text. `value` describes it, as in auto|paper|LENGTH: the words that may be
  /// given, and a word in capitals that stands for anything else.
  void add(const char* name, std::string& text, const char* value, const char* description);
  /// Adds an option that stays empty if it is not given.
  void add(const char* name, std::optional<std::string>& text, const char* value, const char* description);
  /// Adds an option that may be repeated, or a positional argument that may be several words.
  void add(const char* name, std::vector<std::string>& texts, const char* value, const char* description);
  /// Adds an option without a value.
  void add_flag(const char* name, bool& flag, const char* description);
  /// Adds an option that, like --help, prints a text and ends the program, whichever arguments are missing.
  void add_answer(const char* name, std::string (*text)(), const char* description);

 private:
  CLI::App& command_;
};

/// The command line of the program.
///
/// CLI11 reads it. Its header takes seconds to compile, so only command_line.cpp includes it.
class CommandLine {
 public:
  CommandLine(const char* program, const char* description, std::string (*version)());
  ~CommandLine();

  /// Adds a command without arguments.
  Arguments add(const char* name, const char* description, std::function<ExitCode()> execute);

  /// Adds a command with the arguments that `declare` binds to its options.
  template <typename Options>
  void add(const char* name, const char* description, std::function<ExitCode(const Options&)> execute) {
    const auto options = std::make_shared<Options>();
    declare(add(name, description, [=] { return execute(*options); }), *options);
  }

  /// Sets the options of the command that is named, and returns its name, which is empty if there is none.
  /// Returns nothing if a text was asked for, such as help, and has been printed. Error: an argument is
  /// unknown, missing or invalid.
  std::optional<std::string> parse(int argument_count, char** arguments);

  /// Executes a command after its options have been set; prints help if the name is empty. Error, RunFailure:
  /// the command fails.
  ExitCode execute(const std::string& command) const;

  /// The program with its commands and their arguments.
  Command describe() const;

 private:
  std::unique_ptr<CLI::App> program_;
  std::map<std::string, std::function<ExitCode()>> actions_;
};

}  // namespace hardball::cli
