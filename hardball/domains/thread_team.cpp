// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/thread_team.hpp"

#include <chrono>
#include <system_error>

#include "hardball/domains/processors.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/platform/processors.hpp"

namespace hardball {
namespace {

// A pause takes some 40 to 140 cycles, so together .05 to .3 ms: longer than it takes to get from one step of
// a window to the next, if no thread is late.
constexpr int kSpins = 4000;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("isb" ::: "memory");
#endif
}

void wait_while(const std::atomic<std::uint32_t>& number, std::uint32_t value) {
  for (int spin = 0; spin < kSpins; ++spin) {
    if (number.load(std::memory_order_acquire) != value) return;
    pause();
  }
  number.wait(value, std::memory_order_acquire);
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ThreadTeam::ThreadTeam(std::size_t threads) : size_(threads), processors_(platform::available_processors()) {
  try {
    for (std::size_t number = 1; number < threads; ++number)
      workers_.emplace_back([this, number] { work(number); });
  } catch (const std::system_error& failed) {
    end();
    throw Error(to_text(threads) + " threads cannot be started: " + failed.code().message(), "threads",
                "give fewer");
  } catch (...) {
    end();
    throw;
  }
}

ThreadTeam::~ThreadTeam() {
  end();
}

void ThreadTeam::end() {
  ends_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadTeam::for_each(std::size_t count, const Function<void(std::size_t)>& work) {
  if (workers_.empty()) {
    for (std::size_t k = 0; k < count; ++k) work(k);
    return;
  }
  task_ = &work;
  count_ = count;
  at_work_.store(static_cast<std::uint32_t>(workers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::size_t k = 0; k < count; k += size()) work(k);
  for (std::uint32_t left = at_work_.load(std::memory_order_acquire); left > 0;
       left = at_work_.load(std::memory_order_acquire))
    wait_while(at_work_, left);
}

void ThreadTeam::work(std::size_t number) {
  pin(number);
  for (std::uint32_t round = 0;; ++round) {
    wait_while(round_, round);
    if (ends_) return;
    for (std::size_t k = number; k < count_; k += size()) (*task_)(k);
    if (at_work_.fetch_sub(1, std::memory_order_acq_rel) == 1) at_work_.notify_all();
  }
}

void ThreadTeam::pin(std::size_t number) const {
  if (may_pin()) platform::run_on(processors_of_thread(processors_, size(), number));
}

// A thread that waits sleeps soon, so it runs less of the time than this only if others are late, or it is.
void ThreadTeam::note_pinned(double elapsed, double processor) {
  constexpr double kPeriod = 0.05;
  constexpr double kHindered = 0.8;
  elapsed_ += elapsed;
  processor_ += processor;
  if (elapsed_ < kPeriod) return;
  is_hindered_ = processor_ < kHindered * elapsed_;
  elapsed_ = processor_ = 0;
}

ThreadTeam::Pinned::Pinned(ThreadTeam& team) : team_(team) {
  if (!team.may_pin()) return;
  before_ = platform::available_processors();
  team.pin(0);
  begin_ = seconds();
  processor_begin_ = platform::thread_seconds();
}

ThreadTeam::Pinned::~Pinned() {
  if (before_.empty()) return;
  team_.note_pinned(seconds() - begin_, platform::thread_seconds() - processor_begin_);
  platform::run_on(before_);
}

}  // namespace hardball
