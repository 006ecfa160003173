// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/hardware_counters.hpp"

#if defined(__linux__)
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace hardball::bench {

#if defined(__linux__)
namespace {

int open_counter(std::uint64_t event) {
  perf_event_attr attributes{};
  attributes.size = sizeof(attributes);
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.config = event;
  attributes.disabled = 1;
  // Most systems let users count only in user mode.
  attributes.exclude_kernel = 1;
  attributes.exclude_hv = 1;
  attributes.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
  constexpr int kThisThread = 0;
  constexpr int kAnyProcessor = -1;
  constexpr int kNoGroup = -1;
  return static_cast<int>(
      syscall(SYS_perf_event_open, &attributes, kThisThread, kAnyProcessor, kNoGroup, PERF_FLAG_FD_CLOEXEC));
}

std::optional<std::uint64_t> read_counter(int descriptor) {
  struct {
    std::uint64_t count, enabled, running;
  } reading{};
  if (descriptor < 0 || read(descriptor, &reading, sizeof(reading)) != sizeof(reading)) return {};
  // A counter that ran only part of the time would have to be extrapolated.
  if (reading.running == 0 || reading.running < reading.enabled) return {};
  return reading.count;
}

}  // namespace

HardwareCounters::HardwareCounters()
    : descriptors_{open_counter(PERF_COUNT_HW_CPU_CYCLES), open_counter(PERF_COUNT_HW_INSTRUCTIONS)} {}

HardwareCounters::~HardwareCounters() {
  for (const int descriptor : descriptors_) {
    if (descriptor >= 0) close(descriptor);
  }
}

void HardwareCounters::start() {
  for (const int descriptor : descriptors_) {
    if (descriptor < 0) continue;
    ioctl(descriptor, PERF_EVENT_IOC_RESET, 0);
    ioctl(descriptor, PERF_EVENT_IOC_ENABLE, 0);
  }
}

HardwareCounts HardwareCounters::stop() {
  for (const int descriptor : descriptors_) {
    if (descriptor >= 0) ioctl(descriptor, PERF_EVENT_IOC_DISABLE, 0);
  }
  return {read_counter(descriptors_[0]), read_counter(descriptors_[1])};
}
#else
HardwareCounters::HardwareCounters() = default;
HardwareCounters::~HardwareCounters() = default;
void HardwareCounters::start() {}
HardwareCounts HardwareCounters::stop() {
  return {};
}
#endif

}  // namespace hardball::bench
