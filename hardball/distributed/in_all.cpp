// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/distributed/in_all.hpp"

#include <cstdint>
#include <string>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

enum class Failure : std::uint8_t { none, bad_input, run };

}  // namespace

void in_all(Processes& processes, const Function<void()>& work) {
  Failure failure = Failure::none;
  std::string what;
  std::string where;
  std::string remedy;
  try {
    work();
  } catch (const Error& error) {
    failure = Failure::bad_input;
    what = error.problem();
    where = error.where();
    remedy = error.remedy();
  } catch (const RunFailure& failed) {
    failure = Failure::run;
    what = failed.what();
  }
  for (const std::string& text : processes.gather(archived(failure, what, where, remedy))) {
    restore(text, "a failure", failure, what, where, remedy);
    if (failure == Failure::bad_input) throw Error(what, where, remedy);
    if (failure == Failure::run) throw RunFailure(what);
  }
}

void in_first(Processes& processes, const Function<void()>& work) {
  in_all(processes, [&] {
    if (processes.is_first()) work();
  });
}

}  // namespace hardball
