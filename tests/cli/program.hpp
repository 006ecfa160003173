// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "support/scratch_folder.hpp"

/// The real program, started as by a user.
namespace hardball::support {

using Arguments = std::vector<std::string>;

/// The exit code of the program and its output.
struct ProgramOutcome {
  int exit_code = -1;  ///< -1 if a signal killed it.
  std::string output;
  std::string messages;
};

/// The program running in a folder, which gets its output and its messages.
class Program {
 public:
  /// `executable` is the program itself unless another is given; `most_bytes` limits the size of files.
  explicit Program(const ScratchFolder& folder, const Arguments& arguments,
                   const std::string& executable = HARDBALL_PROGRAM, std::optional<rlim_t> most_bytes = {})
      : output_(folder / "program.stdout"), messages_(folder / "program.stderr") {
    std::vector<char*> words{const_cast<char*>(executable.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    // Whoever waits for the output must not read that of an earlier program.
    std::filesystem::remove(output_);
    process_ = fork();
    if (process_ != 0) return;
    redirect(output_, STDOUT_FILENO);
    redirect(messages_, STDERR_FILENO);
    if (most_bytes) {
      const rlimit limit{*most_bytes, *most_bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (chdir(folder.path().c_str()) == 0) execv(executable.c_str(), words.data());
    _exit(127);
  }

  pid_t process() const { return process_; }

  ProgramOutcome wait() const {
    int status = 0;
    waitpid(process_, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(output_), read_text(messages_)};
  }

 private:
  static void redirect(const std::filesystem::path& path, int descriptor) {
    dup2(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), descriptor);
  }

  std::filesystem::path output_;
  std::filesystem::path messages_;
  pid_t process_ = -1;
};

inline ProgramOutcome run_program(const ScratchFolder& folder, const Arguments& arguments) {
  return Program(folder, arguments).wait();
}

/// Tests of the program in a folder of their own.
class ProgramTest : public testing::Test {
 protected:
  /// Runs the program with `arguments` and `more`.
  ProgramOutcome program(Arguments arguments, const Arguments& more = {}) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder_, arguments);
  }
  /// Runs the program, which must succeed.
  ProgramOutcome succeed(const Arguments& arguments, const Arguments& more = {}) const {
    const ProgramOutcome outcome = program(arguments, more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
    return outcome;
  }
  /// The object that the program prints, which must succeed.
  nlohmann::json json_of(const Arguments& arguments, const Arguments& more = {}) const {
    return nlohmann::json::parse(succeed(arguments, more).output, nullptr, false);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  std::string text(const std::string& name) const { return read_text(folder_ / name); }

  ScratchFolder folder_;
};

/// Expects that the program has refused what it was asked to do, in a line that contains these, in this
/// order.
inline void expect_refusal(const ProgramOutcome& outcome, const std::vector<std::string>& fragments) {
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 1) << outcome.messages;
  EXPECT_TRUE(outcome.messages.starts_with("hardball: ")) << outcome.messages;
  std::size_t at = 0;
  for (const std::string& fragment : fragments) {
    at = outcome.messages.find(fragment, at);
    ASSERT_NE(at, std::string::npos) << "no '" << fragment << "' in: " << outcome.messages;
  }
}

inline void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

/// A gas of 20 spheres in a box with walls.
inline const std::string kSmallGas = R"([box]
size = [10.0, 10.0, 10.0]
boundary = ["wall", "wall", "wall"]

[[spheres]]
count = 20
radius = 0.5
placement = "random"
mean_speed = 1.0

[run]
until = 5.0
seed = 1
)";

/// A periodic gas with diameter and mass one, at kT = 1.
inline std::string gas_in_cube(int count, double edge, const std::string& placement = "random") {
  const std::string size = to_text(edge);
  return "[box]\nsize = [" + size + ", " + size + ", " + size +
         "]\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n[[spheres]]\ncount = " +
         std::to_string(count) + "\nradius = 0.5\nplacement = \"" + placement + "\"\ntemperature = 1.0\n";
}

}  // namespace hardball::support
