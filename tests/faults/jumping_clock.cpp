// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Preloaded, it replaces the clocks that tell the time of day by one that jumps by years, back and forth. The
// monotonic clock is left alone. Each call adds a byte to the file that JUMPING_CLOCK_CALLS names.
#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>

namespace {

std::time_t jumping_time() {
  static std::time_t calls = 0;
  ++calls;
  if (const char* const name = std::getenv("JUMPING_CLOCK_CALLS")) {
    const int file = open(name, O_WRONLY | O_CREAT | O_APPEND, 0644);
    if (write(file, "x", 1) == 1) close(file);
  }
  constexpr std::time_t kNow = 1'800'000'000;
  constexpr std::time_t kYears = 300'000'000;
  return kNow + (calls % 2 == 0 ? calls : -calls) % 5 * kYears;
}

}  // namespace

extern "C" {

std::time_t time(std::time_t* result) noexcept {
  const std::time_t now = jumping_time();
  if (result) *result = now;
  return now;
}

int gettimeofday(timeval* result, void* /*zone*/) noexcept {
  *result = {jumping_time(), 0};
  return 0;
}

int clock_gettime(clockid_t clock, timespec* result) noexcept {
  if (clock != CLOCK_REALTIME) return static_cast<int>(syscall(SYS_clock_gettime, clock, result));
  *result = {jumping_time(), 0};
  return 0;
}
}
