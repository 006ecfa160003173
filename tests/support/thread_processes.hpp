// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstring>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "hardball/processes/processes.hpp"

namespace hardball::support {

/// What threads that play processes send each other.
class Mail {
 public:
  explicit Mail(std::size_t processes) : boxes_(processes * processes), processes_(processes) {}

  std::size_t processes() const { return processes_; }
  void send(std::size_t from, std::size_t to, std::string text) {
    const std::scoped_lock lock(mutex_);
    boxes_[from * processes_ + to].push_back(std::move(text));
    has_changed_.notify_all();
  }
  std::string receive(std::size_t from, std::size_t to) {
    std::unique_lock lock(mutex_);
    std::deque<std::string>& box = boxes_[from * processes_ + to];
    has_changed_.wait(lock, [&] { return is_over_ || !box.empty(); });
    if (box.empty()) throw std::runtime_error("another process has ended");
    std::string text = std::move(box.front());
    box.pop_front();
    return text;
  }
  void end() {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
    has_changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable has_changed_;
  std::vector<std::deque<std::string>> boxes_;
  std::size_t processes_;
  bool is_over_ = false;
};

/// A process played by a thread.
class ThreadProcess final : public Processes {
 public:
  ThreadProcess(Mail& mail, std::size_t rank) : mail_(mail), rank_(rank) {}

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return mail_.processes(); }
  std::vector<std::string> exchange(std::span<const std::size_t> peers,
                                    std::span<const std::string> outgoing) override {
    for (std::size_t k = 0; k < peers.size(); ++k) mail_.send(rank_, peers[k], outgoing[k]);
    std::vector<std::string> incoming;
    for (const std::size_t peer : peers) incoming.push_back(mail_.receive(peer, rank_));
    return incoming;
  }

 private:
  void gather_bytes(const void* own, std::size_t bytes, void* all) override {
    const std::vector<std::string> texts = gather(std::string(static_cast<const char*>(own), bytes));
    for (std::size_t k = 0; k < size(); ++k)
      std::memcpy(static_cast<char*>(all) + k * bytes, texts[k].data(), bytes);
  }

  Mail& mail_;
  std::size_t rank_;
};

/// Lets so many processes do the same work, and returns when all have. Error: of the first that fails by
/// itself.
inline void in_processes(std::size_t count, const std::function<void(Processes&)>& work) {
  Mail mail(count);
  std::exception_ptr first;
  std::mutex mutex;
  std::vector<std::thread> threads;
  for (std::size_t rank = 0; rank < count; ++rank) {
    threads.emplace_back([&, rank] {
      try {
        ThreadProcess process(mail, rank);
        work(process);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!first) first = std::current_exception();
        mail.end();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  if (first) std::rethrow_exception(first);
}

}  // namespace hardball::support
