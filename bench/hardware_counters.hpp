// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace hardball::bench {

/// Processor counts of this process in user mode; empty if counting is not permitted, the counter does not
/// exist, or it was shared with others meanwhile.
struct HardwareCounts {
  std::optional<std::uint64_t> cycles;
  std::optional<std::uint64_t> instructions;
};

/// The processor's counters for the thread that created them. On systems other than Linux they count nothing.
class HardwareCounters {
 public:
  HardwareCounters();
  HardwareCounters(const HardwareCounters&) = delete;
  HardwareCounters& operator=(const HardwareCounters&) = delete;
  ~HardwareCounters();

  /// Counts from zero.
  void start();
  /// The counts since `start`.
  HardwareCounts stop();

 private:
  std::array<int, 2> descriptors_{-1, -1};  // of cycles and of instructions; -1 if there is none
};

}  // namespace hardball::bench
