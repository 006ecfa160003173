// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/mpi/plugin.hpp"

// The C++ interface of MPI, which was removed from the standard, is not wanted.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace hardball {
namespace {

#define HARDBALL_QUOTED(number) #number
#define HARDBALL_TEXT_OF(macro) HARDBALL_QUOTED(macro)
#if defined(OMPI_MAJOR_VERSION)
constexpr const char* kLibrary = "Open MPI " HARDBALL_TEXT_OF(OMPI_MAJOR_VERSION) "." HARDBALL_TEXT_OF(
    OMPI_MINOR_VERSION) "." HARDBALL_TEXT_OF(OMPI_RELEASE_VERSION);
#elif defined(MPICH_VERSION)
constexpr const char* kLibrary = "MPICH " MPICH_VERSION;
#else
constexpr const char* kLibrary = "another MPI";
#endif

// As many bytes as one message has at most: lengths are int.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

// What MPI says of a failure; null on success.
const char* failure(int code) {
  static std::array<char, MPI_MAX_ERROR_STRING> text;
  if (code == MPI_SUCCESS) return nullptr;
  int length = 0;
  text.fill(0);
  MPI_Error_string(code, text.data(), &length);
  return text.data();
}

// The communicator of the messages of runs: others in the same process may use MPI, too.
MPI_Comm in_runs = MPI_COMM_NULL;
// The communicator of those that end, where no message of a run can be waited for.
MPI_Comm at_end = MPI_COMM_NULL;

const char* join(std::size_t* rank, std::size_t* size) {
  // If another library started MPI, it would also end it, perhaps before `leave`.
  int is_started = 0;
  MPI_Initialized(&is_started);
  if (is_started != 0)
    return "it runs already; join before anything else starts MPI, as importing mpi4py does";
  int provided = 0;
  // Threads may run, but only the one that calls sends.
  if (const char* const text = failure(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided)))
    return text;
  if (provided < MPI_THREAD_FUNNELED) return "it does not allow threads";
  // Otherwise MPI itself would end the program where it fails.
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  int own = 0;
  int all = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &own);
  MPI_Comm_size(MPI_COMM_WORLD, &all);
  *rank = static_cast<std::size_t>(own);
  *size = static_cast<std::size_t>(all);
  if (const char* const text = failure(MPI_Comm_dup(MPI_COMM_WORLD, &in_runs))) return text;
  return failure(MPI_Comm_dup(MPI_COMM_WORLD, &at_end));
}

void leave() {
  MPI_Comm_free(&at_end);
  MPI_Comm_free(&in_runs);
  MPI_Finalize();
}

// Calls start(at, length, request) for each piece that fits a message of MPI.
template <class Start>
int start_in_pieces(std::size_t size, std::vector<MPI_Request>& requests, const Start& start) {
  int code = MPI_SUCCESS;
  for (std::size_t at = 0; at < size && code == MPI_SUCCESS; at += kMostBytes) {
    code = start(at, static_cast<int>(std::min(kMostBytes, size - at)), &requests.emplace_back());
  }
  return code;
}

const char* exchange(const MpiMessage* messages, std::size_t count) {
  std::vector<MPI_Request> requests;
  int code = MPI_SUCCESS;
  for (std::size_t k = 0; k < count && code == MPI_SUCCESS; ++k) {
    const MpiMessage& message = messages[k];
    const auto peer = static_cast<int>(message.peer);
    code = start_in_pieces(
        message.incoming_size, requests, [&](std::size_t at, int length, MPI_Request* request) {
          return MPI_Irecv(message.incoming + at, length, MPI_BYTE, peer, 0, in_runs, request);
        });
    if (code != MPI_SUCCESS) break;
    code = start_in_pieces(
        message.outgoing_size, requests, [&](std::size_t at, int length, MPI_Request* request) {
          return MPI_Isend(message.outgoing + at, length, MPI_BYTE, peer, 0, in_runs, request);
        });
  }
  if (code == MPI_SUCCESS)
    code = MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return failure(code);
}

const char* gather(const void* own, std::size_t size, void* all) {
  const auto length = static_cast<int>(size);
  return failure(MPI_Allgather(own, length, MPI_BYTE, all, length, MPI_BYTE, in_runs));
}

bool do_all_end() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kPatience{5};
  MPI_Request request{};
  if (MPI_Ibarrier(at_end, &request) != MPI_SUCCESS) return false;
  for (const Clock::time_point deadline = Clock::now() + kPatience; Clock::now() < deadline;) {
    int is_complete = 0;
    if (MPI_Test(&request, &is_complete, MPI_STATUS_IGNORE) != MPI_SUCCESS) return false;
    if (is_complete != 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

void abort_all(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
}

}  // namespace
}  // namespace hardball

extern "C" __attribute__((visibility("default"))) const hardball::MpiPlugin* hardball_mpi_plugin() {
  static constexpr hardball::MpiPlugin kPlugin = {
      .version = hardball::kMpiPluginVersion,
      .implementation = hardball::kLibrary,
      .join = hardball::join,
      .leave = hardball::leave,
      .exchange = hardball::exchange,
      .gather = hardball::gather,
      .do_all_end = hardball::do_all_end,
      .abort = hardball::abort_all,
  };
  return &kPlugin;
}
