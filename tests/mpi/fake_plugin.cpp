// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A plug-in that does without MPI: its processes do not find each other. Its version can be another.
#include "apps/mpi/plugin.hpp"

namespace {

const char* join(std::size_t* rank, std::size_t* size) {
  *rank = 0;
  *size = 1;
  return nullptr;
}

void leave() {}

}  // namespace

extern "C" __attribute__((visibility("default"))) const hardball::MpiPlugin* hardball_mpi_plugin() {
  static constexpr hardball::MpiPlugin kPlugin = {
      .version = hardball::kMpiPluginVersion + HARDBALL_VERSIONS_AHEAD,
      .implementation = "Fake MPI 1.0",
      .join = join,
      .leave = leave,
      .exchange = nullptr,
      .gather = nullptr,
      .do_all_end = nullptr,
      .abort = nullptr,
  };
  return &kPlugin;
}
