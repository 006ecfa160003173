// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/manual.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/terminal.hpp"
#include "apps/cli/version.hpp"

namespace hardball::cli {
namespace {

// In the language of man(7). The sections before and after those of the commands.
constexpr std::string_view kHead = R"(.TH HARDBALL 1 "" "hardball {version}" "User Commands"
.SH NAME
hardball \- {purpose}
.SH SYNOPSIS
.B hardball
.I COMMAND
.RI [ OPTION ...]
.RI [ ARGUMENT ]
.SH DESCRIPTION
A scenario, a TOML file, describes a box, the spheres in it, and how long they move.
Hardball finds all their collisions, in order, by going from event to event; no time step can miss one.
Options that affect only the speed do not change the history. Runs can be compared by its hash, which is printed.
.PP
Scenarios to start from are in
.IR share/doc/hardball/examples ,
pages on their keys and on the files of a run in
.IR share/doc/hardball ,
below the folder where Hardball is installed, such as
.IR /usr .
)";
constexpr std::string_view kTail = R"(.SH EXIT STATUS
.TP
0
Done.
.TP
1
A run did not reach its end, or runs that should be equal differ.
.TP
2
The scenario or the command line is wrong. One line says what is wrong, where, and what to write instead.
.SH EXAMPLES
Print a table of results; write snapshots, measures and a report into a directory:
.PP
.in +4n
.EX
cd /usr/share/doc/hardball/examples
hardball run paper.toml
hardball run dense_gas.toml \-\-out /tmp/out \-\-set output.snapshots_every=0.5
.EE
.in
)";

// Text as it is to be read: without meaning for man(7).
std::string literal(std::string_view text) {
  std::string result;
  for (const char each : text) {
    if (each == '\\') {
      result += "\\e";
    } else if (each == '-') {
      result += "\\-";
    } else {
      result += each;
    }
  }
  return (result.starts_with('.') || result.starts_with('\'') ? "\\&" : "") + result;
}

std::string bold(std::string_view text) {
  return "\\fB" + literal(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + literal(text) + "\\fR";
}

std::string entry(const Command::Argument& argument) {
  std::string names;
  for (const std::string& name : argument.names) names += (names.empty() ? "" : ", ") + bold(name);
  if (!names.empty() && !argument.value.empty()) names += ' ';
  std::string description = literal(argument.description);
  if (argument.is_repeatable) description += "; may be repeated";
  return fmt::format(".TP\n{}{}\n{}.\n", names, argument.value.empty() ? "" : italic(argument.value),
                     description);
}

std::string section(const Command& command) {
  std::string usage = bold("hardball " + command.name) + " [" + italic("OPTION") + "...]";
  for (const Command::Argument& positional : command.positionals) {
    const std::string value = italic(positional.value) + (positional.is_repeatable ? "..." : "");
    usage += positional.is_required ? " " + value : " [" + value + "]";
  }
  std::string text = fmt::format(".SS {}\n{}.\n", usage, literal(command.description));
  for (const Command::Argument& positional : command.positionals) text += entry(positional);
  for (const Command::Argument& option : command.options) text += entry(option);
  return text;
}

// The description of the program as a part of a sentence.
std::string purpose(std::string text) {
  if (!text.empty() && text.front() >= 'A' && text.front() <= 'Z') text.front() += 'a' - 'A';
  if (text.ends_with('.')) text.pop_back();
  return literal(text);
}

}  // namespace

ExitCode print_manual(const Command& program) {
  std::string text =
      fmt::format(kHead, fmt::arg("version", version()), fmt::arg("purpose", purpose(program.description)));
  text += ".SH OPTIONS\n";
  for (const Command::Argument& option : program.options) text += entry(option);
  text += ".SH COMMANDS\n";
  for (const Command& command : program.commands) text += section(command);
  text += kTail;
  write_output(text);
  return ExitCode::done;
}

}  // namespace hardball::cli
