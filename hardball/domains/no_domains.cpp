// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What a library has that is configured without HARDBALL_DOMAINS.
#include "hardball/domains/make_domains_engine.hpp"
#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

[[noreturn]] void refuse() {
  throw Error("this library was configured without threads and processes", "threads",
              "use one thread in one process, or configure it with HARDBALL_DOMAINS=ON");
}

}  // namespace

bool has_domains() {
  return false;
}

std::unique_ptr<EngineBase> make_domains_engine(World /*world*/, const PhaseSettings& /*phase*/,
                                                const Division& /*division*/, const Time& /*now*/,
                                                Processes& /*processes*/) {
  refuse();
}

std::unique_ptr<EngineBase> make_domains_engine(World /*empty*/, SphereTransfers /*brought*/,
                                                const PhaseSettings& /*phase*/, const Division& /*division*/,
                                                const Time& /*now*/, Processes& /*processes*/) {
  refuse();
}

}  // namespace hardball
