// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace hardball::bench {

/// What the processor counted while this process ran in user mode; nothing where it was not allowed to count,
/// has no such counter, or shared it with others in the meantime.
struct HardwareCounts {
  std::optional<std::uint64_t> cycles;
  std::optional<std::uint64_t> instructions;
};

/// The counters of the processor, for the thread that made them. On other systems than Linux they count
/// nothing.
class HardwareCounters {
 public:
  HardwareCounters();
  HardwareCounters(const HardwareCounters&) = delete;
  HardwareCounters& operator=(const HardwareCounters&) = delete;
  ~HardwareCounters();

  /// Counts from zero.
  void start();
  /// What was counted since `start`.
  HardwareCounts stop();

 private:
  std::array<int, 2> descriptors_{-1, -1};  // of cycles and of instructions; -1 where there is none
};

}  // namespace hardball::bench
