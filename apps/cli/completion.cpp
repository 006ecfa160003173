// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/terminal.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {
namespace {

using Argument = Command::Argument;

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::string with_backslashes(std::string_view text, std::string_view special) {
  std::string result;
  for (const char each : text) {
    if (special.find(each) != std::string_view::npos) result += '\\';
    result += each;
  }
  return result;
}

std::vector<std::string> names_of(const std::vector<Argument>& options) {
  std::vector<std::string> names;
  for (const Argument& option : options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

// --- bash: a function that knows the words before the cursor. ---

// A clause of a case command. With no words the shell gives names of files.
std::string bash_clause(const std::vector<std::string>& patterns, const std::vector<std::string>& words) {
  if (patterns.empty()) return "";
  const std::string action = words.empty() ? "" : fmt::format("words='{}' ", joined(words));
  return fmt::format("    {}) {};;\n", fmt::join(patterns, " | "), action);
}

std::string bash_script(const Command& program) {
  std::string values;
  std::string words;
  for (const Command& command : program.commands) {
    std::vector<std::string> free;
    for (const Argument& option : command.options) {
      if (option.value.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) patterns.push_back("'" + command.name + " " + name + "'");
      if (option.choices.empty()) {
        free.insert(free.end(), patterns.begin(), patterns.end());
      } else {
        values += bash_clause(patterns, option.choices);
      }
    }
    values += bash_clause(free, {});
    words += bash_clause({"'" + command.name + " -'*"}, names_of(command.options));
    for (const Argument& positional : command.positionals) {
      if (!positional.choices.empty()) words += bash_clause({"'" + command.name + " '*"}, positional.choices);
    }
  }
  words += bash_clause({"' -'*"}, names_of(program.options));
  words += bash_clause({"' '*"}, names_of(program.commands));

  constexpr std::string_view kScript =
      R"(# Completes the command lines of hardball in bash, which gives names of files where there are no words.
_hardball() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD - 1]}} command= words= each
  # --option=value is three words.
  [[ $word == '=' ]] && word=
  [[ $option == '=' ]] && option=${{COMP_WORDS[COMP_CWORD - 2]}}
  for each in "${{COMP_WORDS[@]:1:COMP_CWORD - 1}}"; do
    case $each in
    {commands}) command=$each && break ;;
    esac
  done
  case "$command $option" in
{values}    *)
    case "$command $word" in
{words}    esac ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -o default -F _hardball hardball
)";
  return fmt::format(kScript, fmt::arg("commands", fmt::join(names_of(program.commands), " | ")),
                     fmt::arg("values", values), fmt::arg("words", words));
}

// --- zsh: specifications for its function _arguments. ---

// Within single quotes.
std::string zsh_text(std::string_view text) {
  std::string result;
  for (const char each : with_backslashes(text, "[]:\\")) {
    if (each == '\'') {
      result += "'\\''";
    } else {
      result += each;
    }
  }
  return result;
}

std::string zsh_action(const Argument& argument) {
  return argument.choices.empty() ? "_files" : "(" + joined(argument.choices) + ")";
}

std::string zsh_option(const Argument& option) {
  std::string text;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    text += fmt::format(" \\\n        '{}{}{}[{}]", option.is_repeatable ? "*" : "", name,
                        option.value.empty() ? "" : (is_long ? "=" : "+"), zsh_text(option.description));
    if (!option.value.empty()) text += fmt::format(":{}:{}", zsh_text(option.value), zsh_action(option));
    text += "'";
  }
  return text;
}

std::string zsh_script(const Command& program) {
  std::string commands;
  std::string cases;
  for (const Command& command : program.commands) {
    commands += fmt::format(" \\\n        '{}:{}'", command.name, zsh_text(command.description));
    cases += fmt::format("      {})\n        _arguments", command.name);
    for (const Argument& option : command.options) cases += zsh_option(option);
    for (const Argument& positional : command.positionals) {
      cases += fmt::format(" \\\n        '{}:{}:{}'", positional.is_repeatable ? "*" : "",
                           zsh_text(positional.value), zsh_action(positional));
    }
    cases += " ;;\n";
  }
  std::string options;
  for (const Argument& option : program.options) options += zsh_option(option);

  constexpr std::string_view kScript = R"(#compdef hardball
# Completes the command lines of hardball in zsh.
_hardball() {{
  local state line
  local -a commands
  _arguments -C{options} \
        '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      commands=({commands})
      _describe command commands ;;
    argument)
      case $line[1] in
{cases}      esac ;;
  esac
}}
if [[ $funcstack[1] == _hardball ]]; then
  _hardball "$@"
else
  compdef _hardball hardball
fi
)";
  return fmt::format(kScript, fmt::arg("options", options), fmt::arg("commands", commands),
                     fmt::arg("cases", cases));
}

// --- fish: a line for each command and each option. ---

std::string fish_text(std::string_view text) {
  return "'" + with_backslashes(text, "'\\") + "'";
}

std::string fish_choices(const Argument& argument) {
  return argument.choices.empty() ? "" : " -a " + fish_text(joined(argument.choices));
}

std::string fish_option(const std::string& condition, const Argument& option) {
  std::string line = "complete -c hardball -n " + fish_text(condition);
  for (const std::string& name : option.names) {
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.value.empty()) line += option.choices.empty() ? " -r" : " -x";
  return line + fish_choices(option) + " -d " + fish_text(option.description) + "\n";
}

std::string fish_script(const Command& program) {
  std::string text = "# Completes the command lines of hardball in fish.\n";
  const std::string no_command = "__fish_use_subcommand";
  for (const Argument& option : program.options) text += fish_option(no_command, option);
  for (const Command& command : program.commands) {
    text += fmt::format("complete -c hardball -n {} -f -a {} -d {}\n", no_command, command.name,
                        fish_text(command.description));
    const std::string condition = "__fish_seen_subcommand_from " + command.name;
    for (const Argument& option : command.options) text += fish_option(condition, option);
    for (const Argument& positional : command.positionals) {
      if (positional.choices.empty()) continue;
      text +=
          fmt::format("complete -c hardball -n {} -f{}\n", fish_text(condition), fish_choices(positional));
    }
  }
  return text;
}

}  // namespace

ExitCode print_completion(const std::string& shell, const Command& program) {
  if (shell == "bash") {
    write_output(bash_script(program));
  } else if (shell == "zsh") {
    write_output(zsh_script(program));
  } else if (shell == "fish") {
    write_output(fish_script(program));
  } else {
    throw Error("there is no completion for '" + shortened(shell) + "'", "command line",
                "choose one of bash, zsh, fish");
  }
  return ExitCode::done;
}

}  // namespace hardball::cli
