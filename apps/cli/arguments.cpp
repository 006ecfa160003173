// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/arguments.hpp"

#include <algorithm>
#include <sstream>

namespace hardball::cli {
namespace {

bool is_placeholder(const std::string& word) {
  return std::any_of(word.begin(), word.end(), [](char each) { return each >= 'A' && each <= 'Z'; });
}

std::vector<std::string> choices_of(const std::string& value) {
  std::vector<std::string> choices;
  std::istringstream words(value);
  for (std::string word; std::getline(words, word, '|');) {
    if (!is_placeholder(word)) choices.push_back(word);
  }
  return choices;
}

Command::Argument describe(const CLI::Option& option) {
  Command::Argument argument;
  for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  if (option.get_positional()) argument.value = option.get_name(true);
  if (!option.get_positional() && option.get_items_expected_max() > 0)
    argument.value = option.get_type_name();
  argument.choices = choices_of(option.get_type_name());
  argument.description = option.get_description();
  argument.is_required = option.get_required();
  argument.is_repeatable = option.get_items_expected_max() > 1;
  return argument;
}

}  // namespace

Command describe(const CLI::App& app) {
  Command command;
  command.name = app.get_name();
  command.description = app.get_description();
  for (const CLI::Option* option : app.get_options({})) {
    auto& kind = option->get_positional() ? command.positionals : command.options;
    kind.push_back(describe(*option));
  }
  return command;
}

std::vector<Command> describe_commands(const CLI::App& program) {
  std::vector<Command> commands;
  for (const CLI::App* app : program.get_subcommands({})) commands.push_back(describe(*app));
  return commands;
}

}  // namespace hardball::cli
