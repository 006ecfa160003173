// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "hardball/errors/export.hpp"

namespace hardball {

/// The one exception for bad input: what is wrong, where, and the remedy, in one line.
///
/// Thrown by every public function whose doc comment names a precondition on its caller's data. Nothing has
/// changed when it is thrown.
class HARDBALL_EXPORT Error : public std::invalid_argument {
 public:
  /// `where` is file:line:column, an option or an argument; `remedy` says what would be accepted.
  Error(std::string what, std::string where, std::string remedy);

  const std::string& problem() const { return problem_; }
  const std::string& where() const { return where_; }
  const std::string& remedy() const { return remedy_; }

 private:
  std::string problem_;
  std::string where_;
  std::string remedy_;
};

/// A run that started from good input and cannot continue, because of inelastic collapse or a full disk, say.
class HARDBALL_EXPORT RunFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A bug in Hardball: a state that its own rules exclude.
class HARDBALL_EXPORT BrokenInvariant : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws BrokenInvariant, naming the failed condition and its source location.
[[noreturn]] HARDBALL_EXPORT void report_broken_invariant(const char* condition, const char* file, int line);

/// The text as messages quote it: all of it, or its beginning and "..." where it has more than `most` bytes.
HARDBALL_EXPORT std::string shortened(std::string_view text, std::size_t most = 60);

/// The shortest decimal text that reads back as the same number, as in messages and text files.
HARDBALL_EXPORT std::string to_text(double number);
template <std::integral Integer>
std::string to_text(Integer number) {
  return std::to_string(number);
}

}  // namespace hardball

/// Whether whole structures are checked during a run; on in debug and sanitizer builds.
#ifndef HARDBALL_VALIDATE
#define HARDBALL_VALIDATE 0
#endif

/// Checks a cheap invariant in every build.
#define HARDBALL_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::hardball::report_broken_invariant(#condition, __FILE__, __LINE__))
