// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hardball::platform {

/// The arguments of main in UTF-8, where main gets them otherwise; those of the caller else. They live as
/// long as the program. Error (std::runtime_error): they cannot be used in names of files.
char** unicode_arguments(int& count, char** arguments);

/// Sees to it that no file that is opened later takes the place of a standard stream that is closed, that
/// these hold bytes as they are, and that a pipe whose reader has gone is an error like any other. To be
/// called first.
void secure_streams();

/// Whether a person sees the standard error stream.
bool shows_messages();

/// From now on the first request to end, by Ctrl-C or from the system, is only noted; a second one ends the
/// program. Exceeding a file size limit becomes an error instead of a signal.
void catch_interruption();
/// Whether such a request has come.
bool was_interrupted();

/// The most memory that the program has had at a time [bytes]; zero where that is not known.
std::uint64_t peak_memory();
/// The memory of the machine [bytes]; zero where that is not known.
std::uint64_t physical_memory();

/// The file of the running program; nothing where that is not known.
std::filesystem::path program_file();

/// Whether there is a display for a browser.
bool has_display();
/// Asks the desktop to open its browser, and does not wait for it; it may fail.
void open_browser(const std::string& url);

/// The file of the first of these programs that the search path of the system has; nothing if it has none.
std::filesystem::path find_program(const std::vector<std::string_view>& names);

/// Another program that runs beside this one, without input, output and messages.
class ChildProgram {
 public:
  /// Starts it: its file, and its arguments.
  ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  /// Ends it, with all that it has started.
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Whether it could be started: it may have ended since.
  bool has_started() const { return has_started_; }
  bool is_running();

 private:
  std::intptr_t process_ = 0;  // none if it is zero
  std::intptr_t group_ = 0;    // what ends with it, where the system has a name for that
  bool has_started_ = false;
};

/// Whether this process may do all that the system allows.
bool is_superuser();

/// Loads a library, for all of the program, and returns what it has under this name; null, with the problem,
/// if that is impossible.
void* symbol_of_library(const std::filesystem::path& library, const char* name, std::string& problem);

}  // namespace hardball::platform
