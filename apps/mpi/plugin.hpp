// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

// What lies between the program and the plug-in for MPI: names of C and values without constructors, as the
// two may come from different compilers. Neither exceptions nor memory to be freed pass from one to the
// other.
#include <cstddef>
#include <cstdint>

namespace hardball {

/// Counts up with every change of MpiPlugin, of MpiMessage, or of what their members mean.
inline constexpr std::uint32_t kMpiPluginVersion = 1;

/// Bytes that go to another process, and room for those that come from it.
struct MpiMessage {
  std::size_t peer;  ///< The rank of the other process.
  const char* outgoing;
  std::size_t outgoing_size;
  char* incoming;
  std::size_t incoming_size;  ///< As many come, or fewer where one message of MPI holds them.
};

/// The functions of a plug-in for MPI. Those that return a text return null on success; otherwise the text
/// says what has failed, and holds until the next call. Only one thread calls.
struct MpiPlugin {
  /// The version of this interface for which the plug-in was built; the first member in all versions.
  std::uint32_t version;
  /// The implementation of MPI with which the plug-in was built, as in "Open MPI 4.1.4".
  const char* implementation;
  /// Joins the other processes: to be called first, and once.
  const char* (*join)(std::size_t* rank, std::size_t* size);
  /// Leaves when all do: to be called last.
  void (*leave)();
  /// Sends and receives all messages, and returns when all have arrived. Messages between the same two
  /// processes arrive in the order in which they are sent.
  const char* (*exchange)(const MpiMessage* messages, std::size_t count);
  /// Copies `size` bytes of each process to `all`, by rank.
  const char* (*gather)(const void* own, std::size_t size, void* all);
  /// Whether all processes call this, each within some seconds of the others; they need not have received
  /// what was sent to them.
  bool (*do_all_end)();
  /// Ends all processes with this exit code.
  void (*abort)(int exit_code);
};

/// The name of the function by which a plug-in gives its functions, and its type.
inline constexpr const char* kMpiPluginSymbol = "hardball_mpi_plugin";
using GetMpiPlugin = const MpiPlugin*();

}  // namespace hardball
