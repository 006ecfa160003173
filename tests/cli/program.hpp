// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/scratch_folder.hpp"

/// The real program, started as by a user.
namespace hardball::support {

using Arguments = std::vector<std::string>;

/// The exit code of the program and its output.
struct Outcome {
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

  Outcome wait() const {
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

inline Outcome run_program(const ScratchFolder& folder, const Arguments& arguments) {
  return Program(folder, arguments).wait();
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

}  // namespace hardball::support
