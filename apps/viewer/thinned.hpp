// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "apps/viewer/shared_recording.hpp"

namespace hardball::viewer {

/// What is left out of a recording to make it short.
enum class Thinning {
  motion,  ///< The motion between moments, which are evenly spaced and exact.
  end,     ///< The end; what comes before stays as it is.
};

/// What a thinned recording holds.
struct Thinned {
  std::uint64_t moments = 0;  ///< How many moments, if the motion between them is left out.
  double step = 0;            ///< Between two moments [T].
  double until = 0;           ///< The last time [T].
};

/// Writes what fits into `most_bytes` of a recording that has ended into `path`. Its header says how many
/// contacts of each kind the whole run had if the motion is left out. Error: not even two moments fit, or no
/// contact; the file cannot be written. RunFailure: the recording cannot be read. Cost: that of reading and
/// of writing it.
Thinned write_thinned(const SharedRecording& recording, Thinning thinning, std::uint64_t most_bytes,
                      const std::filesystem::path& path);

}  // namespace hardball::viewer
