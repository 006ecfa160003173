// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "hardball/memory/for_each.hpp"
#include "hardball/memory/function.hpp"

namespace hardball {

/// Threads that share work, the caller's among them, no two on the same processor if there are enough.
///
/// A thread that waits long yields its processor, which others may need on a busy machine.
class ThreadTeam {
 public:
  /// Precondition: `threads` is not zero. Error: the system does not start that many.
  explicit ThreadTeam(std::size_t threads);
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ~ThreadTeam();

  std::size_t size() const { return size_; }

  /// Calls work(k) for each k below `count`, and returns when all have returned. Precondition: `work` does
  /// not throw.
  void for_each(std::size_t count, const Function<void(std::size_t)>& work);
  /// for_each as a function, which the team must outlive.
  ForEach as_function() {
    return [this](std::size_t count, const Function<void(std::size_t)>& work) { for_each(count, work); };
  }

  /// Keeps the calling thread on the processors of the first thread, for as long as this exists. Afterwards
  /// it may run where it could before.
  class Pinned {
   public:
    explicit Pinned(ThreadTeam& team);
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;
    ~Pinned();

   private:
    ThreadTeam& team_;
    double begin_ = 0;            // [s]
    double processor_begin_ = 0;  // processor time of the calling thread [s]
    std::vector<int> before_;     // empty if it was not pinned
  };

  /// Whether the calling thread has lately spent much of its time, while it was Pinned, without running: it
  /// waited for another thread, or other programs kept it from running.
  bool is_hindered() const { return is_hindered_; }

 private:
  void end();
  void work(std::size_t number);
  void note_pinned(double elapsed, double processor);
  bool may_pin() const { return size() > 1 && processors_.size() >= size(); }
  void pin(std::size_t number) const;

  std::size_t size_;
  bool is_hindered_ = false;
  double elapsed_ = 0;           // while the calling thread was pinned, lately [s]
  double processor_ = 0;         // its processor time meanwhile [s]
  std::vector<int> processors_;  // on which the process may run
  std::vector<std::thread> workers_;
  const Function<void(std::size_t)>* task_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::uint32_t> round_{0};
  std::atomic<std::uint32_t> at_work_{0};
  std::atomic<bool> ends_{false};
};

}  // namespace hardball
