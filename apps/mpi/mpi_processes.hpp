// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "apps/mpi/plugin.hpp"
#include "hardball/processes/processes.hpp"

namespace hardball {

/// The processes that mpirun has started, which find each other by the plug-in for MPI. One object for the
/// whole life of a program. All functions raise RunFailure where MPI fails. Error: messages are exchanged by
/// another thread than the one that made the object.
class MpiProcesses final : public Processes {
 public:
  /// Loads the plug-in and joins the others if the environment says that mpirun has started several processes
  /// of this program; null if this one is alone. The plug-in is that of the first of the folders that has
  /// one; `build_command` builds it, for messages. Error: there are several processes, and the plug-in is
  /// missing, cannot be loaded, has another version, or belongs to another MPI than mpirun.
  static std::unique_ptr<MpiProcesses> join_others(std::span<const std::filesystem::path> folders,
                                                   const std::string& build_command);

  /// Joins the others. Threads of this process may run, but only the one that calls sends.
  explicit MpiProcesses(const MpiPlugin& plugin);
  MpiProcesses(const MpiProcesses&) = delete;
  MpiProcesses& operator=(const MpiProcesses&) = delete;
  /// Leaves when all do.
  ~MpiProcesses() override { plugin_.leave(); }

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return size_; }
  std::vector<std::string> exchange(std::span<const std::size_t> peers,
                                    std::span<const std::string> outgoing) override;
  /// Whether all processes call this, each within some seconds of the others. It may be called while others
  /// wait for messages of this one.
  bool do_all_end() { return plugin_.do_all_end(); }
  /// Ends all processes at once, with this exit code, as one cannot go on.
  [[noreturn]] void abort(int code);

 private:
  void gather_bytes(const void* own, std::size_t bytes, void* all) override;
  void check_thread() const;

  const MpiPlugin& plugin_;
  std::thread::id thread_ = std::this_thread::get_id();
  std::size_t rank_ = 0;
  std::size_t size_ = 1;
};

}  // namespace hardball
