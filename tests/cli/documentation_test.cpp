// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What the program says of itself: its version, its manual, and its completions for bash.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace hardball::documentation_test {
namespace {

using namespace support;

class Documentation : public ProgramTest {
 protected:
  std::string output(const Arguments& arguments) { return succeed(arguments).output; }

  // The commands that --help lists.
  std::vector<std::string> commands() {
    const std::string help = output({"--help"});
    std::istringstream lines(help.substr(help.find("Subcommands:\n")));
    std::vector<std::string> names;
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line) && line.starts_with("  ");) {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    return names;
  }

  // The options that --help lists of a command, each with the type of its value, or nothing.
  std::map<std::string, std::string> options(const std::string& command) {
    const std::string help = output({command, "--help"});
    const std::regex pattern("\n  (?:-[a-z],)?(--[a-z-]+) ?([^ \n]*)");
    std::map<std::string, std::string> found;
    for (std::sregex_iterator each(help.begin(), help.end(), pattern), end; each != end; ++each) {
      found[(*each)[1]] = (*each)[2];
    }
    return found;
  }

  // What bash offers for the last word of a command line.
  std::string completed(const std::string& words) {
    write_text(folder_ / "completion.bash", output({"completion", "bash"}));
    write_text(folder_ / "complete.bash",
               "set -u; . ./completion.bash; COMP_WORDS=(" + words +
                   ") COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _hardball; echo \"${COMPREPLY[*]}\"");
    const ProgramOutcome outcome = Program(folder_, {"complete.bash"}, "/bin/bash").wait();
    EXPECT_EQ(outcome.messages, "") << words;
    return outcome.output.substr(0, outcome.output.find('\n'));
  }
};

TEST_F(Documentation, VersionTellsHowTheProgramWasBuilt) {
  const std::string number = R"([0-9]+\.[0-9]+\.[0-9]+)";
  const std::regex pattern("hardball " + number +
                           "\n"
                           "commit +([0-9a-f]{12}(-dirty)?|unknown)\n"
                           "compiler +.*" +
                           number +
                           ".*\n"
                           "build type +\\w+" +
                           (HARDBALL_VALIDATE ? ", with all checks" : "") +
                           "\n"
                           "instructions +portable.*; (portable|avx2|avx512) on this machine\n");
  const std::string version = output({"--version"});
  EXPECT_TRUE(std::regex_match(version, pattern)) << version;
}

TEST_F(Documentation, ManualHasEveryCommandAndOption) {
  const std::string manual = output({"manual"});
  ASSERT_GE(commands().size(), 6U);
  for (const std::string& command : commands()) {
    const std::size_t begin = manual.find(".SS \\fBhardball " + command + "\\fR");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string section = manual.substr(begin, manual.find("\n.S", begin) - begin);
    EXPECT_FALSE(options(command).empty());
    for (const auto& [option, type] : options(command)) {
      const std::string entry =
          "\\fB" + option + "\\fR" + (type.empty() ? "" : " \\fI" + type + "\\fR") + "\n";
      // A mere - is a hyphen, which no shell understands.
      EXPECT_NE(section.find(std::regex_replace(entry, std::regex("-"), "\\-")), std::string::npos)
          << command << ' ' << entry;
    }
  }
}

TEST_F(Documentation, CompletionsHaveEveryCommandAndOption) {
  const std::string zsh = output({"completion", "zsh"});
  const std::string fish = output({"completion", "fish"});
  const std::string offered = " " + completed("hardball ''") + " ";
  for (const std::string& command : commands()) {
    EXPECT_NE(offered.find(" " + command + " "), std::string::npos) << command;
    EXPECT_NE(zsh.find("'" + command + ":"), std::string::npos) << command;
    EXPECT_NE(fish.find(" -a " + command + " "), std::string::npos) << command;
    const std::string words = " " + completed("hardball " + command + " -") + " ";
    const std::size_t begin = zsh.find("\n      " + command + ")\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string zsh_case = zsh.substr(begin, zsh.find(";;", begin) - begin);
    for (const auto& [option, type] : options(command)) {
      EXPECT_NE(words.find(" " + option + " "), std::string::npos) << command << ' ' << option;
      EXPECT_NE(zsh_case.find(option + (type.empty() ? "[" : "=[")), std::string::npos)
          << command << ' ' << option;
      const std::regex line("__fish_seen_subcommand_from " + command + "' (-s [a-z] )?-l " +
                            option.substr(2) + (type.empty() ? " -d" : " -[rx]"));
      EXPECT_TRUE(std::regex_search(fish, line)) << command << ' ' << option;
    }
  }
}

TEST_F(Documentation, BashCompletesTheWordAtTheCursor) {
  EXPECT_EQ(completed("hardball ver"), "verify");
  EXPECT_EQ(completed("hardball --v"), "--version");
  EXPECT_EQ(completed("hardball run --un"), "--until --unit-costs");
  EXPECT_EQ(completed("hardball run gas.toml --engine ''"), "auto cells neighbors all-pairs paper");
  EXPECT_EQ(completed("hardball run --engine = c"), "cells");
  EXPECT_EQ(completed("hardball run --engine ="), "auto cells neighbors all-pairs paper");
  EXPECT_EQ(completed("hardball run --cell-edge ''"), "auto paper") << "a length is none of the words";
  EXPECT_EQ(completed("hardball completion ''"), "bash zsh fish");
  // No words: bash gives names of files.
  EXPECT_EQ(completed("hardball run ''"), "");
  EXPECT_EQ(completed("hardball run --out ''"), "");
}

TEST_F(Documentation, TheWordsToChooseFromAreThoseThatTheProgramTakes) {
  write_text(folder_ / "gas.toml", kSmallGas);
  for (const std::string option : {"--engine", "--instructions"}) {
    const std::string message = run_program(folder_, {"check", "gas.toml", option, "nonsense"}).messages;
    std::smatch choices;
    ASSERT_TRUE(std::regex_search(message, choices, std::regex("choose one of ([^\n]*)"))) << message;
    EXPECT_EQ(std::regex_replace(options("check")[option], std::regex(R"(\|)"), ", "), choices[1]);
  }
}

}  // namespace
}  // namespace hardball::documentation_test
