// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "apps/cli/terminal.hpp"
#include "hardball/error.hpp"
#include "hardball/scenario/nearest_name.hpp"

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

Command::Argument described(const CLI::Option& option) {
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

Command described(const CLI::App& app) {
  Command command;
  command.name = app.get_name();
  command.description = app.get_description();
  for (const CLI::Option* option : app.get_options({})) {
    auto& kind = option->get_positional() ? command.positionals : command.options;
    kind.push_back(described(*option));
  }
  for (const CLI::App* each : app.get_subcommands({})) command.commands.push_back(described(*each));
  return command;
}

// Error: something on the command line was not understood. `command`: the chosen one, or the program.
void refuse_leftovers(const std::vector<std::string>& leftovers, const Command& command) {
  if (leftovers.empty()) return;
  const std::string word = leftovers.front().substr(0, leftovers.front().find('='));
  const bool is_program = !command.commands.empty();
  if (!is_program && !word.starts_with('-')) {
    throw Error("unexpected argument '" + shortened(word) + "'", "command line",
                "see hardball " + command.name + " --help");
  }
  std::vector<std::string_view> names;
  for (const Command& each : command.commands) names.push_back(each.name);
  if (!is_program) {
    for (const Command::Argument& option : command.options) names.push_back(option.names.back());
  }
  const bool is_known = std::ranges::find(names, word) != names.end();
  throw Error(std::string("unknown ") + (is_program ? "command" : "option") + " '" + shortened(word) + "'",
              "command line", is_known ? "write it after the command" : suggestion(word, names));
}

CLI::Option& with_value(CLI::Option& option, const char* value) {
  return *option.type_name(value)->required(option.get_positional());
}

}  // namespace

void Arguments::add(const char* name, std::string& text, const char* value, const char* description) {
  with_value(*command_.add_option(name, text, description), value);
}

void Arguments::add(const char* name, std::optional<std::string>& text, const char* value,
                    const char* description) {
  with_value(*command_.add_option(name, text, description), value);
}

void Arguments::add(const char* name, std::vector<std::string>& texts, const char* value,
                    const char* description) {
  CLI::Option& option = with_value(*command_.add_option(name, texts, description), value);
  // An option takes one word each time, a positional argument all that follow.
  option.allow_extra_args(option.get_positional());
}

void Arguments::add_flag(const char* name, bool& flag, const char* description) {
  command_.add_flag(name, flag, description)->disable_flag_override();
}

void Arguments::add_answer(const char* name, std::string (*text)(), const char* description) {
  const auto answer = [text] {
    write_output(text());
    throw CLI::Success();
  };
  command_.add_flag_callback(name, answer, description)->disable_flag_override();
}

CommandLine::CommandLine(const char* program, const char* description, std::string (*version)())
    : program_(std::make_unique<CLI::App>(description, program)) {
  program_->set_version_flag("--version", version);
  program_->require_subcommand(0, 1);
  program_->allow_extras();  // which our own messages report
  // On all systems what begins with a slash may be a path.
  program_->allow_windows_style_options(false);
}

CommandLine::~CommandLine() = default;

Arguments CommandLine::add(const char* name, const char* description, std::function<ExitCode()> execute) {
  CLI::App& command = *program_->add_subcommand(name, description)->allow_extras();
  actions_[name] = std::move(execute);
  return Arguments(command);
}

std::optional<std::string> CommandLine::parse(int argument_count, char** arguments) {
  try {
    program_->parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    // Requests for help are "errors" with exit status 0.
    if (error.get_exit_code() != 0) throw Error(error.what(), "command line", "see hardball --help");
    program_->exit(error);
    return std::nullopt;
  }
  const std::vector<CLI::App*> chosen = program_->get_subcommands();
  refuse_leftovers(program_->remaining(true), described(chosen.empty() ? *program_ : *chosen.front()));
  return chosen.empty() ? "" : chosen.front()->get_name();
}

ExitCode CommandLine::execute(const std::string& command) const {
  if (!command.empty()) return actions_.at(command)();
  write_output(program_->help());
  return ExitCode::done;
}

Command CommandLine::describe() const {
  return described(*program_);
}

}  // namespace hardball::cli
