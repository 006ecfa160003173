// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/version.hpp"

#include <fmt/format.h>

#include <string_view>

#include "apps/cli/terminal.hpp"
#include "commit.hpp"
#include "hardball/simulation.hpp"

namespace hardball::cli {
namespace {

#if defined(__clang__)
constexpr std::string_view kCompiler = __VERSION__;
#elif defined(__GNUC__)
constexpr std::string_view kCompiler = "GCC " __VERSION__;
#else
constexpr std::string_view kCompiler = "unknown";
#endif

std::string build_type() {
  std::string type = HARDBALL_BUILD_TYPE;
  if (type.empty()) type = "none";
#if HARDBALL_VALIDATE
  type += ", with all checks";
#endif
  return type;
}

std::string instruction_sets() {
  std::string names;
  for (std::size_t i = 0; i < kNames<InstructionSet>.size(); ++i) {
    if (!is_compiled_in(static_cast<InstructionSet>(i))) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", kNames<InstructionSet>[i]);
  }
  return fmt::format("{}; {} on this machine", names, name_of(fastest_instruction_set()));
}

}  // namespace

std::string version() {
  return HARDBALL_VERSION;
}

std::string commit() {
  return kCommit;
}

std::string version_text() {
  std::string text = fmt::format("hardball {}\n", version());
  text += table_line("commit", commit());
  text += table_line("compiler", std::string(kCompiler));
  text += table_line("build type", build_type());
  text += table_line("instructions", instruction_sets());
  text.pop_back();
  return text;
}

}  // namespace hardball::cli
