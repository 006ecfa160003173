// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/processes/in_all.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/checksum.hpp"

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

void require_same(Processes& processes, const std::string& bytes, const std::string& what,
                  const std::string& remedy) {
  const std::vector<std::uint64_t> sums = processes.gather(checksum_of(bytes));
  for (std::size_t process = 1; process < sums.size(); ++process) {
    if (sums[process] == sums[0]) continue;
    throw Error("process " + to_text(process) + " has another " + what + " than process 0",
                "several processes", remedy);
  }
}

}  // namespace hardball
