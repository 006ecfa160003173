// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/mpi/mpi_processes.hpp"

// The C++ interface of MPI, which was removed from the standard, is not wanted.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// As many bytes as one message has at most: lengths are int.
constexpr std::size_t kMessage = std::size_t{1} << 30;

void require_success(int code, const char* what) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> reason{};
  int length = 0;
  MPI_Error_string(code, reason.data(), &length);
  throw RunFailure(std::string("MPI failed to ") + what + ": " + reason.data());
}

// Messages between the same two processes arrive in the order in which they were sent.
void start_messages(std::string& text, int peer, bool sends, std::vector<MPI_Request>& requests) {
  for (std::size_t begin = 0; begin < text.size(); begin += kMessage) {
    const auto length = static_cast<int>(std::min(kMessage, text.size() - begin));
    MPI_Request& request = requests.emplace_back();
    char* const data = text.data() + begin;
    require_success(sends ? MPI_Isend(data, length, MPI_BYTE, peer, 1, MPI_COMM_WORLD, &request)
                          : MPI_Irecv(data, length, MPI_BYTE, peer, 1, MPI_COMM_WORLD, &request),
                    "exchange messages");
  }
}

void wait_for(std::vector<MPI_Request>& requests) {
  require_success(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE),
                  "exchange messages");
  requests.clear();
}

}  // namespace

// The communicator of those that end, where no message of a run can be waited for.
struct MpiProcesses::AtEnd {
  MPI_Comm communicator = MPI_COMM_NULL;
};

bool MpiProcesses::may_be_several() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    if (const char* const size = std::getenv(name)) return std::atoi(size) > 1;
  }
  return std::getenv("PMIX_RANK") != nullptr;
}

MpiProcesses::MpiProcesses() {
  int provided = 0;
  require_success(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided), "start");
  if (provided < MPI_THREAD_FUNNELED) throw RunFailure("this MPI does not allow threads");
  // Otherwise MPI itself would end the program where it fails.
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  at_end_ = std::make_unique<AtEnd>();
  require_success(MPI_Comm_dup(MPI_COMM_WORLD, &at_end_->communicator), "start");
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  rank_ = static_cast<std::size_t>(rank);
  size_ = static_cast<std::size_t>(size);
}

MpiProcesses::~MpiProcesses() {
  MPI_Comm_free(&at_end_->communicator);
  MPI_Finalize();
}

std::vector<std::string> MpiProcesses::exchange(std::span<const std::size_t> peers,
                                                std::span<const std::string> outgoing) {
  std::vector<std::uint64_t> sent_lengths(peers.size());
  std::vector<std::uint64_t> lengths(peers.size());
  std::vector<MPI_Request> requests;
  for (std::size_t k = 0; k < peers.size(); ++k) {
    const auto peer = static_cast<int>(peers[k]);
    sent_lengths[k] = outgoing[k].size();
    require_success(
        MPI_Irecv(&lengths[k], 1, MPI_UINT64_T, peer, 0, MPI_COMM_WORLD, &requests.emplace_back()),
        "exchange messages");
    require_success(
        MPI_Isend(&sent_lengths[k], 1, MPI_UINT64_T, peer, 0, MPI_COMM_WORLD, &requests.emplace_back()),
        "exchange messages");
  }
  wait_for(requests);
  std::vector<std::string> incoming(peers.size());
  for (std::size_t k = 0; k < peers.size(); ++k) {
    const auto peer = static_cast<int>(peers[k]);
    incoming[k].resize(lengths[k]);
    start_messages(incoming[k], peer, false, requests);
    // MPI_Isend does not change what it sends.
    start_messages(const_cast<std::string&>(outgoing[k]), peer, true, requests);
  }
  wait_for(requests);
  return incoming;
}

bool MpiProcesses::do_all_end() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kPatience{5};
  MPI_Request request{};
  if (MPI_Ibarrier(at_end_->communicator, &request) != MPI_SUCCESS) return false;
  for (const Clock::time_point deadline = Clock::now() + kPatience; Clock::now() < deadline;) {
    int is_complete = 0;
    if (MPI_Test(&request, &is_complete, MPI_STATUS_IGNORE) != MPI_SUCCESS) return false;
    if (is_complete != 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

void MpiProcesses::abort(int code) {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::abort();
}

void MpiProcesses::gather_bytes(const void* own, std::size_t bytes, void* all) {
  const auto length = static_cast<int>(bytes);
  require_success(MPI_Allgather(own, length, MPI_BYTE, all, length, MPI_BYTE, MPI_COMM_WORLD), "gather");
}

}  // namespace hardball
