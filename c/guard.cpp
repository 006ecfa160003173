// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "c/guard.hpp"

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "hardball/version.hpp"

namespace hardball::c {
namespace {

// The strings of the last error of a thread, and pointers to them.
struct LastError {
  std::string message;
  std::string problem;
  std::string where;
  std::string remedy;
  hb_error shown{"", "", "", ""};

  void show() { shown = {message.c_str(), problem.c_str(), where.c_str(), remedy.c_str()}; }
};

LastError& last_error() noexcept {
  thread_local LastError error;
  return error;
}

hb_status keep(hb_status status, const char* message) {
  LastError error{message, message, {}, {}};
  last_error() = std::move(error);
  last_error().show();
  return status;
}

hb_status keep(const Error& thrown) {
  LastError error{thrown.what(), thrown.problem(), thrown.where(), thrown.remedy()};
  last_error() = std::move(error);
  last_error().show();
  return HB_BAD_INPUT;
}

// Precondition: an exception is being handled.
hb_status classify() {
  try {
    throw;
  } catch (const Error& error) {
    return keep(error);
  } catch (const RunFailure& failure) {
    return keep(HB_RUN_FAILED, failure.what());
  } catch (const std::length_error&) {
    throw std::bad_alloc();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& bug) {
    return keep(HB_BROKEN_INVARIANT, bug.what());
  } catch (...) {
    return keep(HB_BROKEN_INVARIANT, "the stop function threw an exception");
  }
}

}  // namespace

hb_status report_failure() noexcept {
  try {
    return classify();
  } catch (const std::bad_alloc&) {
    constexpr const char* kMessage = "there is not enough memory";
    last_error().shown = {kMessage, kMessage, "", ""};
    return HB_NO_MEMORY;
  }
}

}  // namespace hardball::c

std::uint32_t hb_abi() {
  return HB_ABI;
}

const char* hb_version() {
  // So short a string takes no memory that could be missing.
  static const std::string kVersion = hardball::to_text(HARDBALL_VERSION_MAJOR) + "." +
                                      hardball::to_text(HARDBALL_VERSION_MINOR) + "." +
                                      hardball::to_text(HARDBALL_VERSION_PATCH);
  return kVersion.c_str();
}

const hb_error* hb_last_error() {
  return &hardball::c::last_error().shown;
}
